"""Measuring the grader with students whose doings are known."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.course.policy import Policy
from gripcourse.files import write_text
from gripcourse.virtual.cohort import make_classroom
from gripcourse.virtual.confusion import Evaluation, evaluate
from gripcourse.virtual.in_memory import judge_in_memory
from gripcourse.virtual.misses import misses_csv
from gripcourse.virtual.mix import load_mix

MISSES = "misses.csv"


@dataclass(frozen=True, slots=True)
class Cohort:
    """Which virtual students are asked for: how many, from which seed, of which scheme."""

    count: int
    seed: int
    scheme: str | None


def evaluate_in_memory(
    course: Course,
    policy: Policy,
    cohort: Cohort,
    misses: Path | None,
    workers: int,
    on_done: Callable[[], None],
) -> Evaluation:
    """Make up a cohort, judge it without files, and measure.

    Args:
        course: whose schemes are drawn.
        policy: that is measured.
        cohort: how many students, of what.
        misses: file to write every miss to; None for none.
        workers: how many processes.
        on_done: called after each student.
    """
    mix = load_mix(course)
    room = make_classroom(course, policy, mix, cohort.count, cohort.seed, cohort.scheme)
    found = evaluate(judge_in_memory(room, workers, on_done), mix)
    if misses is not None:
        schemes = {name: one.variant.scheme for name, one in room.desk.register.items()}
        write_text(misses, misses_csv(found.misses, schemes))
    return found
