"""Placing symbols where they cover neither each other nor, if that can be, any line."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.drawing.diagram.marks import Fill, Letter, Mark, Path, chain
from gripcourse.drawing.paper.document import TEXT_HEIGHT, LineKind
from gripcourse.drawing.paper.text import Point, text_width

SUBSCRIPT: Final = 2.5  # mm, height of capital letters (GOST 2.304)
DROP: Final = 1.1  # of a subscript below the line
_DESCENT: Final = 0.9  # of letters with a tail
_GAP: Final = 0.5  # between a letter and what is near it
_DISTANCES: Final = (0.4, 1.6, 3.2, 5.2, 8.0, 12.0)
_DEGREES: Final = (90, 270, 0, 180, 45, 135, 225, 315, 67, 112, 247, 292, 22, 157, 202, 337)
_DIRECTIONS: Final = tuple(map(math.radians, _DEGREES))  # the best first
_LIGHT: Final = 0.3  # how much an axis under a letter counts
_COVERED: Final = 40.0  # how much a square millimetre of another letter counts
_FAR: Final = 0.25  # how much a millimetre of distance counts
_OUTSIDE: Final = 1e4
_FREE: Final = 0.05  # mm of line under a letter that nobody sees


@dataclass(frozen=True, slots=True)
class LetterBox:
    """A rectangle."""

    left: float
    low: float
    right: float
    high: float

    def wider(self, by: float) -> "LetterBox":
        """Return the box with a margin round it."""
        return LetterBox(self.left - by, self.low - by, self.right + by, self.high + by)

    def overlap(self, other: "LetterBox") -> float:
        """Return the area that two boxes share."""
        width = min(self.right, other.right) - max(self.left, other.left)
        height = min(self.high, other.high) - max(self.low, other.low)
        return max(width, 0.0) * max(height, 0.0)

    def holds(self, other: "LetterBox") -> bool:
        """Tell whether another box lies inside."""
        return (
            self.left <= other.left and other.right <= self.right
            and self.low <= other.low and other.high <= self.high
        )  # fmt: skip


@dataclass(frozen=True, slots=True)
class Written:
    """A symbol in its place.

    Attributes:
        symbol: as declared.
        base: the letter, without its subscript.
        below: the subscript, maybe empty.
        at: left end of its base line.
        offset: from there to the subscript.
        box: what it covers.
    """

    symbol: str
    base: str
    below: str
    at: Point
    offset: float
    box: LetterBox

    def shifted(self, x: float, y: float) -> "Written":
        """Return the symbol moved."""
        box = LetterBox(self.box.left + x, self.box.low + y, self.box.right + x, self.box.high + y)
        return replace(self, at=(self.at[0] + x, self.at[1] + y), box=box)


@dataclass(frozen=True, slots=True)
class Lines:
    """Straight pieces of everything drawn: ends as rows of x, y, x, y; weights of the rows."""

    ends: NDArray[np.float64]
    weights: NDArray[np.float64]


def bounds(marks: Iterable[Mark]) -> LetterBox:
    """Return the box round everything drawn."""
    points = [point for mark in marks for point in chain(mark)]
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return LetterBox(min(xs), min(ys), max(xs), max(ys))


def lines_of(marks: Iterable[Mark]) -> Lines:
    """Return everything drawn as straight pieces."""
    rows: list[tuple[float, float, float, float]] = []
    weights: list[float] = []
    for mark in marks:
        points = chain(mark)
        light = isinstance(mark, Path) and mark.line is LineKind.CENTRE
        for a, b in pairwise(points):
            rows.append((*a, *b))
            weights.append(_LIGHT if light else 1.0)
        if isinstance(mark, Fill):
            rows.append((*points[0], *points[len(points) // 2]))
            weights.append(1.0)
    return Lines(np.array(rows).reshape(-1, 4), np.array(weights))


def write_letters(letters: Sequence[Letter], lines: Lines, sheet: LetterBox) -> tuple[Written, ...]:
    """Find a place for every letter, one after the other.

    Args:
        letters: with their places in order of preference.
        lines: what they should not cover.
        sheet: what they must not leave.
    """
    written: list[Written] = []
    for letter in letters:
        written.append(_best(letter, lines, sheet, written))
    return tuple(written)


def _best(letter: Letter, lines: Lines, sheet: LetterBox, others: Sequence[Written]) -> Written:
    base, _, below = letter.symbol.partition("_")
    offset = text_width(base, TEXT_HEIGHT)
    width = offset + (text_width(below, SUBSCRIPT) if below else 0.0)
    depth = DROP + 0.5 if below else _DESCENT
    size = (width, TEXT_HEIGHT + depth)
    around = _Around(lines, sheet, others)
    best: tuple[float, LetterBox] | None = None
    for distance, boxes in _candidates(letter.places, size):
        best = _cheapest(boxes, _FAR * distance, around, best)
        if best is not None and best[0] <= _FAR * distance:
            break
    assert best is not None  # noqa: S101 (a letter names one place at least)
    box = best[1]
    return Written(letter.symbol, base, below, (box.left, box.low + depth), offset, box)


@dataclass(frozen=True, slots=True)
class _Around:
    """What a letter should not cover, and what it must not leave."""

    lines: Lines
    sheet: LetterBox
    others: Sequence[Written]

    def disturbed(self, box: LetterBox) -> float:
        """Return the cost of other letters under a box, and of leaving the sheet."""
        covered = _COVERED * sum(box.wider(_GAP).overlap(one.box) for one in self.others)
        return covered + (0.0 if self.sheet.holds(box) else _OUTSIDE)


def _cheapest(
    boxes: Sequence[LetterBox],
    far: float,
    around: _Around,
    best: tuple[float, LetterBox] | None,
) -> tuple[float, LetterBox] | None:
    """Return the cheapest of some boxes that are equally far, or the best so far, with its cost."""
    covered = covered_lengths([box.wider(_GAP) for box in boxes], around.lines)
    for box, line in zip(boxes, covered, strict=True):
        seen = float(line) if line > _FREE else 0.0
        if best is not None and seen + far >= best[0]:
            continue
        cost = seen + around.disturbed(box) + far
        if best is None or cost < best[0]:
            best = cost, box
    return best


def _candidates(
    places: Sequence[Point], size: tuple[float, float]
) -> Iterator[tuple[float, list[LetterBox]]]:
    """Yield boxes round the places, the nearest first."""
    for distance in _DISTANCES:
        for x, y in places:
            yield distance, [_box_beside(x, y, turn, distance, size) for turn in _DIRECTIONS]


def _box_beside(
    x: float, y: float, turn: float, distance: float, size: tuple[float, float]
) -> LetterBox:
    """Return the box that touches a point from a side, at a distance."""
    cos, sin = math.cos(turn), math.sin(turn)
    half, tall = size[0] / 2, size[1] / 2
    # As far as the box reaches towards the point, so that it never covers it.
    reach = distance + min(half / max(abs(cos), 1e-9), tall / max(abs(sin), 1e-9))
    x, y = x + reach * cos, y + reach * sin
    return LetterBox(x - half, y - tall, x + half, y + tall)


def covered_lengths(boxes: Sequence[LetterBox], lines: Lines) -> NDArray[np.float64]:
    """Return how much line runs under each box, mm; thin axes count less.

    The lines are cut as Liang and Barsky do.
    """
    if not len(lines.ends):
        return np.zeros(len(boxes))
    sides = np.array([(one.left, one.low, one.right, one.high) for one in boxes])
    reach = (sides[:, :2].min(axis=0), sides[:, 2:].max(axis=0))
    x, y = lines.ends[:, 0::2], lines.ends[:, 1::2]
    near = ((x.max(axis=1) >= reach[0][0]) & (x.min(axis=1) <= reach[1][0])
            & (y.max(axis=1) >= reach[0][1]) & (y.min(axis=1) <= reach[1][1]))  # fmt: skip
    ends, weights = lines.ends[near], lines.weights[near]
    start, along = ends[:, :2], ends[:, 2:] - ends[:, :2]
    with np.errstate(divide="ignore", invalid="ignore"):
        first = (sides[:, None, :2] - start) / along
        second = (sides[:, None, 2:] - start) / along
    # A line along an axis is inside for ever, or never.
    inside = (sides[:, None, :2] <= start) & (start <= sides[:, None, 2:])
    still = np.broadcast_to(along == 0, first.shape)
    enter = np.where(still, np.where(inside, -np.inf, np.inf), np.minimum(first, second))
    leave = np.where(still, np.where(inside, np.inf, -np.inf), np.maximum(first, second))
    last = np.minimum(leave[:, :, 0], leave[:, :, 1])
    share = np.clip(last, 0, 1) - np.clip(np.maximum(enter[:, :, 0], enter[:, :, 1]), 0, 1)
    length = np.hypot(along[:, 0], along[:, 1]) * weights
    return np.asarray((np.maximum(share, 0) * length).sum(axis=1))
