"""What the files of a batch came to, of any number of them; see `machine.shelf`."""

import pickle
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final, TypeAlias

from gripcourse.grading.folded import ReportShelf
from gripcourse.grading.model import Report
from gripcourse.machine.shelf import Shelved, Viewed


@dataclass(frozen=True, slots=True)
class Graded:
    """What a file came to.

    Attributes:
        report: of the file.
        incident: the trace of what failed on our side; empty for nothing.
        taken_over: whether the report was found out by an earlier run.
    """

    report: Report
    incident: str
    taken_over: bool = False


_NEWEST: Final = pickle.HIGHEST_PROTOCOL
_STAY: Final = 1000  # in memory, without their findings: two kilobytes each

Changes: TypeAlias = Iterable[tuple[int, Report]]
"""Reports that stand in the place of others, with their places in the batch."""


def on_a_shelf(graded: Iterable[Graded] = ()) -> Shelved[Graded]:
    """Put what files came to on a shelf; each is loaded anew by who asks for it."""
    shelf = ReportShelf()

    def dump(one: Graded) -> bytes:
        return pickle.dumps((one.incident, one.taken_over, *shelf.plain(one.report)), _NEWEST)

    def load(packed: bytes) -> Graded:
        incident, taken_over, *plain = pickle.loads(packed)  # noqa: S301 (written above)
        return Graded(shelf.report(tuple(plain)), incident, taken_over)

    return Shelved(graded, dump=dump, load=load, stay=_STAY)


def reports_of(graded: Sequence[Graded]) -> Sequence[Report]:
    """Return the reports of a batch, in the order of its files."""
    return Viewed(graded, _report)


def with_reports(graded: Sequence[Graded], changes: Changes) -> Shelved[Graded]:
    """Return the same batch with some other reports."""
    before = graded if isinstance(graded, Shelved) else on_a_shelf(graded)
    return before.with_changes(
        (number, replace(before[number], report=report)) for number, report in changes
    )


def changed_where(
    reports: Sequence[Report], change: Callable[[Report], Report]
) -> Iterator[tuple[int, Report]]:
    """Yield the reports that a function changes, changed."""
    for number, report in enumerate(reports):
        after = change(report)
        if after is not report:
            yield number, after


def _report(graded: Graded) -> Report:
    return graded.report
