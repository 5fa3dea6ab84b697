"""The whole main job on a small course: issue, fill in, grade, mark a drawing, report.

Students and teacher are scripted; everything else is the real thing.
"""

import secrets
import shutil
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from datetime import UTC, date, datetime
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.cli.demo.classroom import sample_roster, sample_table
from gripcourse.cli.demo.students import COPIED, fill_workbooks
from gripcourse.course.load import load_course
from gripcourse.errors import Problem, UsageError
from gripcourse.gradebook.enter import Draft
from gripcourse.issuing.roster import read_roster
from gripcourse.issuing.store import read_register
from gripcourse.machine.database.home import home_of
from gripcourse.machine.files import write_text
from gripcourse.policy.load import load_policy
from gripcourse.policy.rubric import RubricLine
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words, message
from gripcourse.usecases.authoring.init import init_course
from gripcourse.usecases.grading.grade import GradingOutcome, grade, write_results
from gripcourse.usecases.issuing.handout import workbook_path
from gripcourse.usecases.issuing.issue import Issuing, Order, issue_order
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.mark import Marking, enter_mark
from gripcourse.variants.model import Issued

# The demo tells the same story every day.
ISSUED_ON = date(2026, 9, 7)
DEADLINE = date(2026, 12, 1)
GRADED_ON = date(2026, 12, 2)
MARKED_AT = datetime(2026, 12, 2, 9, tzinfo=UTC)
# Whose drawing the teacher marks where there is one, and how: the lines of its rubric in turn.
MARKED_STORY = "early_slip"
_CREDITS = (1.0, 0.5)
_WITHOUT_DRAWING = ("blank", COPIED)
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
    marking: Marking | None
    outcome: GradingOutcome


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
    table = sample_table(course)
    order = Order(
        roster=sample_roster(source, course, table, words),
        table=table,
        out=folders["assignments"],
        today=ISSUED_ON,
        deadline=DEADLINE,
    )
    tick = step(words.say(message("Issuing")), len(read_roster(order.roster).students))
    issuing = issue_order(course, policy, order, workers, lambda _: tick())
    register = read_register(course.root, course.id).by_student()
    stories = fill_workbooks(
        course, register, workbooks(folders["assignments"], register), folders["submissions"]
    )
    files = sorted(folders["submissions"].glob("*.xlsx"))
    tick = step(words.say(message("Grading")), len(files))
    context = GradingContext(course, policy, register)
    graded = grade(files, context, workers, lambda _: tick())
    place = home_of(course.root)
    keep(graded, context, place, MARKED_AT)
    marked = marked_student(stories, context)
    marking = None if marked is None else mark_drawing(marked, context, place)
    graded = keep(graded, context, place, MARKED_AT)
    tick = step(words.say(message("Writing reports")), len(files))
    outcome = write_results(
        graded, context, folders["graded"], GRADED_ON, workers, lambda _: tick()
    )
    return Demo(students=stories, issuing=issuing, marking=marking, outcome=outcome, **folders)


def _clear(out: Path, folders: Iterable[Path]) -> None:
    """Remove what an earlier demo left; folders that no demo made are somebody's work."""
    mark = out / _MARK
    if not mark.is_file() and any(folder.exists() for folder in folders):
        what = message("This folder is not empty.")
        remedy = message("Name a new or empty folder: nothing is ever overwritten.")
        raise UsageError([Problem(str(out), "", what, remedy, parameter="out")])
    for folder in folders:
        shutil.rmtree(folder, ignore_errors=True)
    write_text(mark, "")


def workbooks(assignments: Path, register: Mapping[str, Issued]) -> dict[str, Path]:
    """Return the issued workbook of every student."""
    return {student: workbook_path(assignments, student) for student in register}


def marked_student(stories: Mapping[str, str], context: GradingContext) -> str | None:
    """Return whose drawing is marked: who slips early, else who has one; None where nobody has."""
    ordered = sorted(stories, key=lambda student: stories[student] != MARKED_STORY)
    for student in ordered:
        variant = context.register[student].variant
        handed_in = stories[student] not in _WITHOUT_DRAWING
        if handed_in and plan_of(context.course, variant.composition).manual:
            return student
    return None


def mark_drawing(student: str, context: GradingContext, place: str) -> Marking:
    """Let a teacher mark the last item of a student that a person marks, line by line."""
    issued = context.register[student]
    plan = plan_of(context.course, issued.variant.composition)
    item = plan.manual[-1]
    words = Words(issued.student.language or context.course.language)
    draft = Draft(
        student=student,
        quantity=item.id,
        lines={
            line.id: _credit(line, _CREDITS[number % len(_CREDITS)])
            for number, line in enumerate(context.policy.rubrics[item.rubric].lines)
        },
        comment=words.say(message("One more view is needed.")),
    )
    return enter_mark(draft, context, place, words.say(message("the teacher")), MARKED_AT)


def _credit(line: RubricLine, wanted: float) -> float:
    """Return the credit, or that of the nearest level where the line has levels."""
    levels = [level.credit for level in line.levels]
    return min(levels, key=lambda level: abs(level - wanted), default=wanted)
