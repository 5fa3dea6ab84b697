"""How much two variants share: the points that one student would get with the other's answers.

Not every variant is compared with every other. The values of each quantity are sorted; what fits a
variant's band is then a stretch of neighbours, and only these pairs are touched. Their points are
added up in sparse matrices, so many variants at a time that the memory stays bounded.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from gripcourse.policy.bands import SLACK
from gripcourse.policy.model import Policy
from gripcourse.solver.family import Rows
from gripcourse.variants.answers import AnswerItem, Windows, windows_of
from gripcourse.variants.feasible import Array

# scipy.sparse costs 100 ms to import: only an audit pays.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from scipy.sparse import csr_array

BUDGET = 500_000  # coincidences that are held at once, about 30 MB
MOST_TOLD = 200  # pairs above a limit that are kept with their names; all are counted
_BINS = 100  # of a histogram of shares: whole percents


@dataclass(frozen=True, slots=True)
class ApartLimits:
    """What one student may at most get with another's answers, as shares, 0 to 1."""

    whole: float
    section: float


def limits_of(policy: Policy) -> ApartLimits:
    """Return the limits of a policy."""
    return ApartLimits(policy.variants.shared_points, policy.variants.shared_section_points)


@dataclass(frozen=True, slots=True)
class Shares:
    """Shares of a whole table, of the whole assignment or of one section.

    Attributes:
        above: ordered pairs of variants above the limit.
        histogram: ordered pairs by whole percents of the share, shape (101,); those that share
            nothing are in the first place.
        nearest: position of the variant whose answers would bring most, -1 for none, shape (n,).
        share: what they would bring, shape (n,).
    """

    above: int
    histogram: Rows
    nearest: Rows
    share: Array


@dataclass(frozen=True, slots=True)
class Apartness:
    """How far the variants of a table are apart.

    Attributes:
        pairs: ordered pairs of variants: who gets answers, whose they are.
        coincidences: answers of one variant that lie in the band of another; the work that was
            done.
        whole: shares of the points of all computed quantities.
        sections: shares of each section's.
        beyond: positions (who gets answers, whose) of the pairs that are farthest above a limit,
            the worst first, each pair once.
    """

    pairs: int
    coincidences: int
    whole: Shares
    sections: tuple[Shares, ...]
    beyond: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class Chunk:
    """Points that some variants share with all.

    Attributes:
        start, stop: which variants get the answers.
        coincidences: pairs and quantities that were touched.
        points: shape ((stop - start)·sections, n): the points by who gets the answers and section,
            and whose answers they are.
    """

    start: int
    stop: int
    coincidences: int
    points: "csr_array"


def measure(items: Sequence[AnswerItem], totals: Array, limits: ApartLimits) -> Apartness:
    """Measure how far the variants of a table are apart.

    Args:
        items: the quantities that count.
        totals: points by variant and section, shape (n, sections).
        limits: what may be shared.
    """
    size, sections = totals.shape
    whole = _Tally.of(size)
    parts = [_Tally.of(size) for _ in range(sections)]
    beyond = _Beyond(size)
    coincidences = 0
    for chunk in shared_points(items, size, sections):
        coincidences += chunk.coincidences
        own = np.arange(chunk.start, chunk.stop)
        found = whole.add(_whole(chunk, sections), own, totals.sum(axis=1), limits.whole)
        beyond.add(*found, limits.whole)
        for section, tally in enumerate(parts):
            points = chunk.points[section::sections]
            found = tally.add(points, own, totals[:, section], limits.section)
            beyond.add(*found, limits.section)
    pairs = size * (size - 1)
    return Apartness(
        pairs,
        coincidences,
        whole.shares(pairs),
        tuple(tally.shares(pairs) for tally in parts),
        beyond.worst(),
    )


def shared_points(
    items: Sequence[AnswerItem], size: int, sections: int, budget: int = BUDGET
) -> Iterator[Chunk]:
    """Add up the points that variants share, chunk by chunk of those who get the answers.

    Args:
        items: the quantities that count.
        size: how many variants the table has.
        sections: how many sections the course has.
        budget: coincidences to hold at once; a single variant may have more.
    """
    windows = [windows_of(item) for item in items]
    work = np.zeros(size, dtype=np.intp)
    for item, window in zip(items, windows, strict=True):
        work[item.rows] += window.last - window.first
    for start, stop in _stretches(work, budget):
        yield _chunk(items, windows, start, stop, (size, sections))


def _stretches(work: Rows, budget: int) -> Iterator[tuple[int, int]]:
    """Split rows into stretches whose work fits the budget, at least one row each."""
    done = np.concatenate([[0], np.cumsum(work)])
    start = 0
    while start < len(work):
        stop = int(np.searchsorted(done, done[start] + budget, side="right")) - 1
        stop = min(max(stop, start + 1), len(work))
        yield start, stop
        start = stop


def _chunk(
    items: Sequence[AnswerItem],
    windows: Sequence[Windows],
    start: int,
    stop: int,
    shape: tuple[int, int],
) -> Chunk:
    from scipy.sparse import coo_array

    size, sections = shape
    found = [
        _coincidences(item, window, start, stop, sections)
        for item, window in zip(items, windows, strict=True)
    ]
    own, other, points = (np.concatenate(one) for one in zip(*found, strict=True))
    height = (stop - start) * sections
    matrix = coo_array((points, (own, other)), shape=(height, size)).tocsr()
    return Chunk(start, stop, len(points), matrix)


def _coincidences(
    item: AnswerItem, window: Windows, start: int, stop: int, sections: int
) -> tuple[Rows, Rows, Array]:
    """List who gets whose answer right, and its points, for some of those who get answers."""
    low, high = np.searchsorted(item.rows, [start, stop])
    first = window.first[low:high]
    lengths = window.last[low:high] - first
    entry = np.repeat(np.arange(low, high), lengths)
    ends = np.cumsum(lengths)
    place = np.arange(len(entry)) + np.repeat(first - (ends - lengths), lengths)
    own, other = item.rows[entry], window.order[place]
    foreign = own != other
    entry, own, other = entry[foreign], own[foreign], other[foreign]
    return (own - start) * sections + item.sections[entry], other, item.points[entry]


def _whole(chunk: Chunk, sections: int) -> "csr_array":
    """Add the sections of each variant up."""
    from scipy.sparse import csr_array

    height = chunk.stop - chunk.start
    columns = np.arange(height * sections)
    starts = np.arange(height + 1) * sections
    fold = csr_array((np.ones(height * sections), columns, starts), shape=(height, len(columns)))
    return fold @ chunk.points


@dataclass(slots=True)
class _Tally:
    """Shares that are being counted, chunk by chunk."""

    above: int
    histogram: Rows
    nearest: Rows
    share: Array

    @staticmethod
    def of(size: int) -> "_Tally":
        """Begin with nothing shared."""
        counts = np.zeros(_BINS + 1, dtype=np.intp)
        return _Tally(0, counts, np.full(size, -1, dtype=np.intp), np.zeros(size))

    def add(
        self, points: "csr_array", own: Rows, totals: Array, limit: float
    ) -> tuple[Rows, Rows, Array]:
        """Count a chunk's shares; return the pairs above the limit: who, whose, and the share."""
        lengths = np.diff(points.indptr)
        who = np.repeat(own, lengths)
        # A section without points shares none; an answer in it is worth nothing.
        worth = totals[who]
        share = np.divide(points.data, worth, out=np.zeros(len(who)), where=worth > 0)
        self.histogram += np.bincount((share * _BINS).astype(np.intp), minlength=_BINS + 1)[
            : _BINS + 1
        ]
        some = lengths > 0
        if some.any():
            best = np.maximum.reduceat(share, points.indptr[:-1][some])
            self.share[own[some]] = best
            is_best = np.flatnonzero(share == np.repeat(best, lengths[some]))
            rows, places = np.unique(who[is_best], return_index=True)
            self.nearest[rows] = points.indices[is_best[places]]
        above = share > limit * SLACK
        self.above += int(above.sum())
        return who[above], points.indices[above].astype(np.intp), share[above]

    def shares(self, pairs: int) -> Shares:
        """Finish: pairs that were never touched share nothing."""
        histogram = self.histogram.copy()
        histogram[0] += pairs - histogram.sum()
        return Shares(self.above, histogram, self.nearest, self.share)


@dataclass(slots=True)
class _Beyond:
    """The pairs farthest above a limit so far."""

    size: int
    excess: dict[tuple[int, int], float]

    def __init__(self, size: int) -> None:
        self.size = size
        self.excess = {}

    def add(self, own: Rows, other: Rows, share: Array, limit: float) -> None:
        """Take in pairs above a limit, then drop all but the worst."""
        worst = np.argsort(limit - share, kind="stable")[:MOST_TOLD]
        for place in worst:
            pair = (int(own[place]), int(other[place]))
            back = (pair[1], pair[0])
            far = float(share[place]) - limit
            if far > max(self.excess.get(pair, 0.0), self.excess.get(back, 0.0)):
                self.excess.pop(back, None)
                self.excess[pair] = far
        self.excess = dict(self._sorted()[:MOST_TOLD])

    def worst(self) -> tuple[tuple[int, int], ...]:
        """Return the pairs, the worst first."""
        return tuple(pair for pair, _ in self._sorted())

    def _sorted(self) -> list[tuple[tuple[int, int], float]]:
        return sorted(self.excess.items(), key=lambda one: (-one[1], one[0]))
