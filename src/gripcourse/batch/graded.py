"""What the files of a batch came to, of any number of them; see `machine.shelf`."""

import pickle
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Final, TypeAlias

from gripcourse.grading.folded import ReportShelf, digest_of_report
from gripcourse.grading.model import Report
from gripcourse.machine.shelf import Shelved, Viewed


@dataclass(frozen=True, slots=True)
class Stated:
    """What follows from a report as a whole, worked out by who made it.

    Attributes:
        digest: of all that it says.
        line: the report but for its findings in one line, as tables have it.
    """

    digest: str
    line: str


@dataclass(frozen=True, slots=True)
class Graded:
    """What a file came to.

    Attributes:
        report: of the file.
        incident: the trace of what failed on our side; empty for nothing.
        taken_over: whether the report was found out by an earlier run.
        stated: of just this report; None where nobody has worked it out.
    """

    report: Report
    incident: str
    taken_over: bool = False
    stated: Stated | None = field(default=None, compare=False)

    @property
    def digest(self) -> str:
        """A digest of all that the report says."""
        return digest_of_report(self.report) if self.stated is None else self.stated.digest

    def with_report(self, report: Report) -> "Graded":
        """Return the same with another report."""
        return replace(self, report=report, stated=None)


_NEWEST: Final = pickle.HIGHEST_PROTOCOL
_STAY: Final = 1000  # in memory, without their findings: three kilobytes each

Changes: TypeAlias = Iterable[tuple[int, Report]]
"""Reports that stand in the place of others, with their places in the batch."""


@dataclass(frozen=True, slots=True, eq=False)
class _Folding:
    """How what a file came to lies on a shelf, and its findings on another one."""

    shelf: ReportShelf = field(default_factory=ReportShelf)

    def dump(self, one: Graded) -> bytes:
        said = None if one.stated is None else (one.stated.digest, one.stated.line)
        plain = self.shelf.plain(one.report)
        return pickle.dumps((one.incident, one.taken_over, said, *plain), _NEWEST)

    def load(self, packed: bytes) -> Graded:
        incident, taken_over, said, *plain = pickle.loads(packed)  # noqa: S301 (written above)
        stated = None if said is None else Stated(*said)
        return Graded(self.shelf.report(tuple(plain)), incident, taken_over, stated)


def on_a_shelf(graded: Iterable[Graded] = ()) -> Shelved[Graded]:
    """Put what files came to on a shelf; each is loaded anew by who asks for it."""
    folding = _Folding()
    return Shelved(graded, dump=folding.dump, load=folding.load, stay=_STAY)


def reports_of(graded: Sequence[Graded]) -> Sequence[Report]:
    """Return the reports of a batch, in the order of its files."""
    return Viewed(graded, _report)


def with_reports(graded: Sequence[Graded], changes: Changes) -> Shelved[Graded]:
    """Return the same batch with some other reports."""
    before = graded if isinstance(graded, Shelved) else on_a_shelf(graded)
    return changed(
        before, ((number, before[number].with_report(report)) for number, report in changes)
    )


def changed(graded: Sequence[Graded], changes: Iterable[tuple[int, Graded]]) -> Shelved[Graded]:
    """Return the same batch where some files came to something else."""
    before = graded if isinstance(graded, Shelved) else on_a_shelf(graded)
    return before.with_changes(changes)


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
