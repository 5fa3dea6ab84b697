"""Figures of a group while the term runs: how scores are spread, which sections are hard."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from statistics import mean, median
from typing import Final

from gripcourse.gradebook.model import Attempt, GradebookEntry, latest_marks_of_all
from gripcourse.gradebook.store import Gradebook
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.usecases.serving.counted import counted_works
from gripcourse.usecases.serving.desk import DeskContext

BINS: Final = 10
_JUST_BELOW: Final = 1e-9  # a score of 70 % belongs to the bin that begins there, whatever its bits


@dataclass(frozen=True, slots=True)
class Facility:
    """How much of its points a part of the assignment earned.

    Attributes:
        id: of the section or the quantity.
        share: mean over the works, 0…1.
        works: in which it was asked and is decided.
    """

    id: str
    share: float
    works: int


@dataclass(frozen=True, slots=True)
class GroupFigures:
    """What the works of a group that count came to, with the marks of persons.

    Attributes:
        works: how many have points.
        scores: how many of them earned a tenth of the points each, after lateness: 0…10 %, …,
            90…100 %.
        mean, median: of the shares after lateness, 0…1; None where there is no work.
        sections: in the order of the course; before lateness.
        items: quantities, the hardest first; before lateness.
    """

    works: int
    scores: tuple[int, ...]
    mean: float | None
    median: float | None
    sections: tuple[Facility, ...]
    items: tuple[Facility, ...]


@dataclass(frozen=True, slots=True)
class _Share:
    student: str
    section: str
    quantity: str
    points: float
    most: float


def group_figures(context: DeskContext) -> GroupFigures:
    """Return the figures of everybody in the register.

    Raises:
        RegisterError: the register cannot be used.
        GradebookError: the gradebook cannot be used.
    """
    register, book = context.register(), Gradebook(context.desk.engine, context.joins())
    marked = latest_marks_of_all(book.entries())
    counted = counted_works(context)
    scores = [one.earned / one.sums.max_score for one in counted.values() if one.sums.max_score > 0]
    works = {student: one.attempt for student, one in counted.items()}
    plans = {
        student: plan_of(context.course, register[student].variant.composition) for student in works
    }
    shares = [
        share
        for student, attempt in works.items()
        for share in _shares(student, attempt, marked.get(student, {}), plans[student])
    ]
    sections = {one.id: one for one in _facilities((one.section, one) for one in shares)}
    items = _facilities((one.quantity, one) for one in shares)
    return GroupFigures(
        works=len(scores),
        scores=tuple(_binned(scores)),
        mean=mean(scores) if scores else None,
        median=median(scores) if scores else None,
        sections=tuple(sections[one.id] for one in context.course.sections if one.id in sections),
        items=tuple(sorted(items, key=lambda one: (one.share, one.id))),
    )


def _binned(scores: Iterable[float]) -> list[int]:
    counts = [0] * BINS
    for share in scores:
        counts[min(max(int(share * BINS + _JUST_BELOW), 0), BINS - 1)] += 1
    return counts


def _shares(
    student: str, attempt: Attempt, marked: Mapping[str, GradebookEntry], plan: Plan
) -> Iterator[_Share]:
    """Yield what each item earned that has points and waits for nobody."""
    for one in attempt.results:
        quantity, entry = plan.quantities.get(one.quantity), marked.get(one.quantity)
        if quantity is None or not one.max_points:
            continue
        credit = None if entry is None else entry.mark.credit
        if credit is None and one.outcome.traits.waits:
            continue
        points = one.points if credit is None else credit * one.max_points
        yield _Share(student, quantity.section, one.quantity, points, one.max_points)


def _facilities(shares: Iterable[tuple[str, _Share]]) -> list[Facility]:
    """Return for each id the mean over the works of what it earned there."""
    sums: dict[str, dict[str, tuple[float, float]]] = defaultdict(dict)
    for id_, one in shares:
        points, most = sums[id_].get(one.student, (0.0, 0.0))
        sums[id_][one.student] = points + one.points, most + one.most
    return [
        Facility(id_, mean(points / most for points, most in works.values()), len(works))
        for id_, works in sums.items()
    ]
