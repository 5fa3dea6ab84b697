"""What a cohort's works say about the assignment, as tables; headings are ids."""

from collections import Counter, defaultdict
from collections.abc import Container, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from gripcourse.exports.report_result import GradesResult, ReportResult
from gripcourse.gradebook.journal import Regrade
from gripcourse.gradebook.model import Attempt
from gripcourse.gradebook.works import in_order, standing_of, works_of
from gripcourse.grading.analytics.difficulty import difficulty_table
from gripcourse.grading.analytics.reliability import reliability_table
from gripcourse.grading.analytics.shares import item_table, score_table, share_table
from gripcourse.grading.model import FlagCode

# pandas takes 400 ms to import.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    import pandas as pd

_Key: TypeAlias = tuple[str, str]


def analysis_tables(grades: GradesResult) -> "dict[str, pd.DataFrame]":
    """Return the tables `items`, `slips`, `reliability` and `difficulty` of a batch.

    Of a student's attempts the one that counts is asked: one person's works are not independent.
    """
    import pandas as pd

    counting = [one for one in grades.reports if one.counts]
    shares = share_table(counting)
    return {
        "items": item_table(shares),
        "slips": pd.DataFrame(
            _slips(counting),
            columns=["quantity", "slip", "students", "wrong", "share_of_wrong"],
        ),
        "reliability": reliability_table(shares),
        "difficulty": difficulty_table(score_table(shares)),
    }


def history_tables(
    attempts: Sequence[Attempt], regrades: Sequence[Regrade]
) -> "dict[str, pd.DataFrame]":
    """Return the tables `times` and `regrades` of a gradebook.

    Args:
        attempts: all that were kept, oldest first.
        regrades: that were applied or take one back.
    """
    import pandas as pd

    undone = {one.undoes for one in regrades if one.undoes is not None}
    return {
        "times": pd.DataFrame(
            _times(attempts, undone),
            columns=["student", "work", "of", "handed_in", "said", "graded_at"],
        ),
        "regrades": pd.DataFrame(
            _regrades(attempts, undone),
            columns=["regrade", "undone", "quantity", "works", "before", "after", "changed"],
        ),
    }


def _slips(reports: Sequence[ReportResult]) -> list[tuple[Any, ...]]:
    """Count each slip once a work, where it was made; an empty slip is a mistake unexplained."""
    found = {
        (place, *mistake)
        for place, report in enumerate(reports)
        if all(flag.code != FlagCode.ISSUED_TO_OTHER for flag in report.flags)
        for mistake in _mistakes(report)
    }
    wrong = Counter(quantity for _, quantity in {(place, quantity) for place, quantity, _ in found})
    counts = Counter((quantity, slip) for _, quantity, slip in found)
    order = sorted(counts, key=lambda one: (-counts[one], one))
    return [
        (quantity, slip, counts[quantity, slip], wrong[quantity],
         counts[quantity, slip] / wrong[quantity])
        for quantity, slip in order
    ]  # fmt: skip


def _mistakes(report: ReportResult) -> Iterator[tuple[str, str]]:
    for one in report.findings:
        if one.outcome.traits.mistake:
            yield one.quantity, one.slip
        elif one.outcome.traits.follows and one.slip and one.roots:
            yield one.roots[0], one.slip  # a step that was left out: its slip shows here


def _times(attempts: Sequence[Attempt], undone: Container[int | None]) -> list[tuple[Any, ...]]:
    """Return a row for each work, in the order in which a student's works came."""
    # A regrade does not know when a work came: what was found first or said last does.
    said: set[_Key] = {(one.student, one.digest) for one in attempts if one.handed_in_said}
    return [
        (
            student,
            number,
            len(works),
            "" if work.handed_in is None else work.handed_in.isoformat(),
            (student, work.digest) in said,
            work.attempt.graded_at.isoformat(),
        )
        for student, works in sorted(works_of(standing_of(attempts, undone)).items())
        for number, work in enumerate(in_order(works), start=1)
    ]


def _regrades(attempts: Sequence[Attempt], undone: set[int]) -> list[tuple[Any, ...]]:
    """Return what each regrade did to each quantity: its mean share, before and after."""
    stands: dict[_Key, Attempt] = {}
    told: set[tuple[int, _Key]] = set()
    pairs: dict[tuple[int, str], list[tuple[float, float]]] = defaultdict(list)
    for one in attempts:
        key = one.student, one.digest
        before = stands.get(key)
        # A time that was said after it is kept with the results of the regrade once more.
        if one.regrade is not None and before is not None and (one.regrade, key) not in told:
            told.add((one.regrade, key))
            old, new = _shares(before), _shares(one)
            for quantity in old.keys() & new.keys():
                pairs[one.regrade, quantity].append((old[quantity], new[quantity]))
        if one.regrade not in undone and not one.outranked:
            stands[key] = one
    return [
        (
            number,
            number in undone,
            quantity,
            len(found),
            sum(old for old, _ in found) / len(found),
            sum(new for _, new in found) / len(found),
            sum(old != new for old, new in found),
        )
        for (number, quantity), found in sorted(pairs.items())
    ]


def _shares(attempt: Attempt) -> Mapping[str, float]:
    # What a person marks has no share here: no regrade changes it.
    return {
        one.quantity: one.points / one.max_points
        for one in attempt.results
        if one.max_points and not one.outcome.traits.by_rubric
    }
