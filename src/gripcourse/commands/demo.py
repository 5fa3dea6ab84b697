"""The whole main job on a small course, with scripted students: issue, fill in, grade, report."""

import secrets
import shutil
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from datetime import date
from pathlib import Path

from gripcourse.assignment.issue import workbook_path
from gripcourse.assignment.register import read_register, register_path
from gripcourse.assignment.roster import read_roster
from gripcourse.cohort.one import Desk
from gripcourse.commands.grade import Outcome, grade, write_results
from gripcourse.commands.issue import Issuing, Order, issue_order
from gripcourse.commands.students import fill_workbooks
from gripcourse.course.load import load_course
from gripcourse.course.policy_load import load_policy
from gripcourse.errors import Problem, UsageError
from gripcourse.files import write_text
from gripcourse.init import init_course
from gripcourse.variants.model import Issued
from gripcourse.words import Words, message

# The demo tells the same story every day.
ISSUED_ON = date(2026, 9, 7)
DEADLINE = date(2026, 12, 1)
GRADED_ON = date(2026, 12, 2)
# Tells a folder of the demo, which may be made again, from a folder of somebody's own.
_MARK = ".gripcourse-demo"


@dataclass(frozen=True, slots=True)
class Demo:
    """Where the demo left what: folders and files by purpose, and who did what."""

    course: Path
    assignments: Path
    submissions: Path
    graded: Path
    students: Mapping[str, str]
    issuing: Issuing
    outcome: Outcome


def run_demo(
    source: Path,
    out: Path,
    words: Words,
    workers: int,
    step: Callable[[str, int], Callable[[], None]],
) -> Demo:
    """Run the whole main job in a folder of its own.

    Args:
        source: the course to copy.
        out: folder to write to; what an earlier demo left in it is replaced.
        words: language of the short guide in the course's copy.
        workers: how many processes.
        step: called with the name of a step and its number of items; returns what to call after
            each item.

    Raises:
        UsageError: the folder holds such folders already, and no demo made them.
    """
    folders = {name: out / name for name in ("course", "assignments", "submissions", "graded")}
    _clear(out, folders.values())
    # The key is fresh every time: a demo must not teach that a key may be known.
    init_course(folders["course"], secrets.token_bytes(32), words, source)
    course = load_course(folders["course"])
    policy = load_policy(course)
    variants = course.root / "variants"
    order = Order(
        roster=variants / "roster.csv",
        table=variants / "tables" / "main.csv",
        out=folders["assignments"],
        today=ISSUED_ON,
        deadline=DEADLINE,
    )
    tick = step(words.say(message("Issuing")), len(read_roster(order.roster)))
    issuing = issue_order(course, policy, order, workers, lambda _: tick())
    register = read_register(register_path(course.root), course.id).by_student()
    stories = fill_workbooks(
        course, register, workbooks(folders["assignments"], register), folders["submissions"]
    )
    files = sorted(folders["submissions"].glob("*.xlsx"))
    desk = Desk(course, policy, register)
    tick = step(words.say(message("Grading")), len(files))
    graded = grade(files, desk, workers, lambda _: tick())
    tick = step(words.say(message("Writing reports")), len(files))
    outcome = write_results(graded, desk, folders["graded"], GRADED_ON, workers, lambda _: tick())
    return Demo(students=stories, issuing=issuing, outcome=outcome, **folders)


def _clear(out: Path, folders: Iterable[Path]) -> None:
    """Remove what an earlier demo left; folders that no demo made are somebody's work."""
    mark = out / _MARK
    if not mark.is_file() and any(folder.exists() for folder in folders):
        what = message("This folder is not empty.")
        remedy = message("Name a new or empty folder: nothing is ever overwritten.")
        raise UsageError([Problem(str(out), "--out", what, remedy)])
    for folder in folders:
        shutil.rmtree(folder, ignore_errors=True)
    write_text(mark, "")


def workbooks(assignments: Path, register: Mapping[str, Issued]) -> dict[str, Path]:
    """Return the issued workbook of every student."""
    return {student: workbook_path(assignments, student) for student in register}
