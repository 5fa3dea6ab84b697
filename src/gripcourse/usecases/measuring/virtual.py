"""Measuring the grader with simulated students, whose mistakes are known."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.errors import Problem, UsageError
from gripcourse.issuing.register_file import read_register_file
from gripcourse.machine.files import expect_file, expect_folder, write_text
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.confusion import GraderEvaluation, evaluate
from gripcourse.simulation.foreign.misses import foreign_misses_csv
from gripcourse.simulation.misses import misses_csv
from gripcourse.simulation.mix import load_mix
from gripcourse.simulation.on_disk import grade_cohort, register_of, write_cohort
from gripcourse.simulation.parts import Bench, CohortPart, Doers, measure_parts, together
from gripcourse.text.words import message
from gripcourse.variants.model import Issued

MISSES = "misses.csv"

_TOGETHER = 1000  # students whose works are compared with each other
_APART = 1_000_003  # between the seeds of cohorts


@dataclass(frozen=True, slots=True)
class Cohort:
    """Which virtual students are asked for: how many, from which seed, of which scheme."""

    count: int
    seed: int
    scheme: str | None


def simulate(
    course: Course,
    policy: Policy,
    cohort: Cohort,
    out: Path,
    workers: int,
    on_done: Callable[[], None],
) -> int:
    """Make up a cohort and write its workbooks and what it did.

    Args:
        course: whose schemes are drawn.
        policy: by which slips are made where they can be seen.
        cohort: how many students, of what.
        out: new or empty folder.
        workers: how many processes.
        on_done: called after each student.

    Returns:
        How many workbooks were written.

    Raises:
        GripcourseError: the folder is in use, or the cohort cannot be made.
    """
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        what = message("This folder is not empty.")
        remedy = message("Name a new or empty folder: nothing is ever overwritten.")
        raise UsageError([Problem(str(out), "", what, remedy, parameter="out")])
    expect_folder(out)
    room = make_classroom(
        course, policy, load_mix(course), cohort.count, cohort.seed, cohort.scheme
    )
    return len(write_cohort(room, out, workers, on_done))


def evaluate_folder(
    course: Course, policy: Policy, folder: Path, workers: int, on_done: Callable[[], None]
) -> GraderEvaluation:
    """Grade a cohort's workbooks, measure, and write every miss beside them.

    Args:
        course: that the cohort was issued.
        policy: that is measured.
        folder: that `simulate` wrote.
        workers: how many processes.
        on_done: called after each workbook.

    Raises:
        GripcourseError: the folder holds no cohort of this course.
        OSError: nothing can be written there.
    """
    if folder.is_dir():
        expect_file(folder / MISSES)
    found = evaluate(grade_cohort(folder, course, policy, workers, on_done), load_mix(course))
    register = read_register_file(register_of(folder), course.id).by_student()
    write_text(folder / MISSES, _misses(found, register))
    return found


def evaluate_in_memory(
    course: Course,
    policy: Policy,
    cohort: Cohort,
    misses: Path | None,
    workers: int,
    on_done: Callable[[], None],
) -> GraderEvaluation:
    """Make up a cohort, judge it without files, and measure.

    Args:
        course: whose schemes are drawn.
        policy: that is measured.
        cohort: how many students, of what.
        misses: file to write every miss to; None for none.
        workers: how many processes.
        on_done: called after each student.

    Raises:
        OSError: the misses cannot be written there.
    """
    if misses is not None:
        expect_file(misses)
        expect_file(foreign_misses_path(misses))
    mix = load_mix(course)
    # A strategy needs no large sample, and what it hands in takes longest to judge.
    parts = [CohortPart(Doers.NOBODY, next(_sizes(cohort.count)), cohort.seed)]
    for place, size in enumerate(_sizes(cohort.count)):
        seed = cohort.seed + _APART * place
        parts += [CohortPart(Doers.FOREIGN, size, seed), CohortPart(Doers.OWN, size, seed)]
    measured = measure_parts(parts, Bench(course, policy, mix, cohort.scheme), workers, on_done)
    total = together(measured)
    if misses is not None:
        tables = [one.table for one in measured if one.own is not None]
        write_text(misses, "".join(_below_one_heading(tables)))
        others = () if total is None or total.foreign is None else total.foreign.misses
        write_text(foreign_misses_path(misses), foreign_misses_csv(others))
    return total if total is not None else evaluate((), mix)


def foreign_misses_path(misses: Path) -> Path:
    """Return where the misses of the second generator stand, beside those of the first."""
    return misses.with_name(f"{misses.stem}_foreign{misses.suffix}")


def works_in_memory(cohort: Cohort) -> int:
    """Return how many works a measurement in memory judges: both generators have as many."""
    return 2 * cohort.count


def _sizes(count: int) -> Iterator[int]:
    """Divide students into cohorts as they are graded: together they are compared in pairs."""
    parts = max(1, math.ceil(count / _TOGETHER))
    for part in range(parts):
        yield count * (part + 1) // parts - count * part // parts


def _misses(found: GraderEvaluation, register: Mapping[str, Issued]) -> str:
    schemes = {name: issued.variant.scheme for name, issued in register.items()}
    return misses_csv(found.misses, schemes)


def _below_one_heading(tables: Sequence[str]) -> Iterator[str]:
    for place, table in enumerate(tables):
        yield table if not place else table.partition("\n")[2]
