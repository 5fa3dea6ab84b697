"""Leader lines from parts to a row of shelves above a view, none crossing another.

Lengths are millimetres of paper, in the coordinates of the face.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain, combinations, pairwise
from typing import TYPE_CHECKING, TypeVar

from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Box, Line, runs_through
from gripcourse.drawing.paper.text import Point, add_text, text_width
from gripcourse.drawing.view.shelves import LeaderShelf, Places, apart, places_in

if TYPE_CHECKING:
    from ezdxf.layouts.layout import Modelspace

_Way = TypeVar("_Way")

ABOVE = 10.0  # from what stands below to the shelves
_BETWEEN = 4.0  # from one shelf to the next
_SHORTEST = 7.0
_AWAY = 6.0  # along x, from the part to its shelf where there is room
_OVER = 1.3  # the words over their shelf: tails of letters reach 1.05 below their line
_DOT = 0.6  # radius of the end of a leader
_SHIFTS = (0.0, *(side * step for step in range(3, 40, 3) for side in (1.0, -1.0)))
_GAPS = 9  # of the shifts, that a gap in a row is as wide as


@dataclass(frozen=True, slots=True)
class Note:
    """Words about a point, which is marked by a dot unless it lies on a line."""

    text: str
    height: float
    at: Point
    has_dot: bool = True

    @property
    def width(self) -> float:
        """Length of its shelf."""
        return max(_SHORTEST, text_width(self.text, self.height) + 1.0)


@dataclass(frozen=True, slots=True)
class Leader:
    """A note with its shelf: `left` is where the shelf begins, `level` its height."""

    note: Note
    left: float
    level: float

    @property
    def knee(self) -> Point:
        """Where the leader line meets the shelf."""
        right = self.left + self.note.width
        nearer_left = abs(self.note.at[0] - self.left) <= abs(self.note.at[0] - right)
        return (self.left if nearer_left else right), self.level

    @property
    def line(self) -> Line:
        """The leader line, from the part to the shelf."""
        return Line(self.note.at, self.knee)

    @property
    def box(self) -> Box:
        """The box round shelf and words."""
        top = self.level + _OVER + self.note.height
        return Box(self.left, self.level, self.left + self.note.width, top)


def place_leaders(
    notes: Iterable[Note], below: Box, numbers: Sequence[Box] = (), marks: Sequence[Box] = ()
) -> list[Leader]:
    """Give each note a shelf in one row above a box, if possible no farther right than it.

    Args:
        notes: what is written.
        below: what the row stands above.
        numbers: what no leader line should run through.
        marks: what none runs through if there is another way.
    """
    leaders = _uncrossed(notes, below)
    every = [*numbers, *marks]
    rows = (one for one in _moved_along(leaders) if _is_clear(one, every))
    found = next(rows, None) or _apart(leaders, numbers, marks)
    if found is None:
        ways = chain(_moved_along(leaders), _opened(leaders))
        found = next((one for one in ways if _is_clear(one, numbers)), leaders)
    return found


def _apart(
    leaders: Sequence[Leader], numbers: Sequence[Box], marks: Sequence[Box]
) -> list[Leader] | None:
    """Move each shelf by itself, and let two neighbours change places where a mark asks for it.

    None where lines cross then, or run through numbers.
    """
    if not leaders:
        return None
    places = places_in(leaders[0].level, numbers, marks)
    moved = (_moved_apart(one, numbers, places) for one in _orders(leaders))
    found = (one for one in moved if one is not None)
    first = next(found, None)
    return None if first is None else fewest(first, found, lambda one: through(one, marks))


def _orders(leaders: Sequence[Leader]) -> Iterator[Sequence[Leader]]:
    """Yield a row as it is, then with each pair of neighbours the other way round."""
    yield leaders
    for number, (one, other) in enumerate(pairwise(leaders)):
        after = one.left + other.note.width + _BETWEEN
        swapped = (replace(other, left=one.left), replace(one, left=after))
        yield [*leaders[:number], *swapped, *leaders[number + 2 :]]


def _moved_apart(
    leaders: Sequence[Leader], numbers: Sequence[Box], places: Callable[[LeaderShelf], Places]
) -> list[Leader] | None:
    """Move each shelf of a row by itself; None where lines cross then, or run through numbers."""
    shelves = [LeaderShelf(one.note.at, one.note.width, one.left) for one in leaders]
    lefts = apart(shelves, leaders[0].level, _BETWEEN, places)
    if lefts is None:
        return None
    found = [replace(one, left=left) for one, left in zip(leaders, lefts, strict=True)]
    return found if _is_clear(found, numbers) else None


def through(leaders: Iterable[Leader], boxes: Sequence[Box]) -> int:
    """Return how many leader lines run through boxes."""
    return sum(runs_through(one.line, boxes) for one in leaders)


def fewest(first: _Way, others: Iterable[_Way], faults: Callable[[_Way], int]) -> _Way:
    """Return the first way without faults, else the first of those with the fewest."""
    best, least = first, faults(first)
    ways = iter(others)
    while least and (way := next(ways, None)) is not None:
        if (found := faults(way)) < least:
            best, least = way, found
    return best


def _moved_along(leaders: Sequence[Leader]) -> Iterator[list[Leader]]:
    """Yield the row at other places, the nearest first."""
    for shift in _SHIFTS:
        yield _shifted(leaders, shift)


def _shifted(leaders: Sequence[Leader], shift: float) -> list[Leader]:
    return [Leader(one.note, one.left + shift, one.level) for one in leaders]


def _opened(leaders: Sequence[Leader]) -> Iterator[list[Leader]]:
    """Yield rows with a gap somewhere between two shelves."""
    for shift in _SHIFTS[1:_GAPS]:
        for place in range(1, len(leaders)):
            first, rest = leaders[:place], leaders[place:]
            if shift < 0:
                yield [*_shifted(first, shift), *rest]
            else:
                yield [*first, *_shifted(rest, shift)]


def _is_clear(leaders: Sequence[Leader], numbers: Sequence[Box]) -> bool:
    through = (runs_through(one.line, numbers) for one in leaders)
    return not any(through) and not any(
        cross(*pair) for pair in combinations([one.line for one in leaders], 2)
    )


def _uncrossed(notes: Iterable[Note], below: Box) -> list[Leader]:
    ordered = sorted(notes, key=lambda one: (one.at[0], -one.at[1], one.text))
    for _ in range(len(ordered) ** 2):
        leaders = _in_row(ordered, below)
        lines = [one.line for one in leaders]
        crossing = next(
            (
                (first, second)
                for first, second in combinations(range(len(lines)), 2)
                if cross(lines[first], lines[second])
            ),
            None,
        )
        if crossing is None:
            return leaders
        first, second = crossing
        ordered[first], ordered[second] = ordered[second], ordered[first]
    return _in_row(ordered, below)


def cross(first: Line, second: Line) -> bool:
    """Tell whether two leader lines cross."""
    a, b, c, d = first.start, first.end, second.start, second.end
    return _left(a, b, c) * _left(a, b, d) < 0 and _left(c, d, a) * _left(c, d, b) < 0


def draw_leaders(layout: "Modelspace", leaders: Sequence[Leader], by: Point) -> None:
    """Draw leaders on paper moved by `by`."""
    thin = {"layer": LineKind.THIN}
    for one in leaders:
        at, knee = _moved(one.note.at, by), _moved(one.knee, by)
        left, right = _moved((one.left, one.level), by), one.left + one.note.width + by[0]
        layout.add_line(at, knee, dxfattribs=thin)
        layout.add_line(left, (right, left[1]), dxfattribs=thin)
        if one.note.has_dot:
            dot = layout.add_hatch(dxfattribs=thin)
            ring = [(at[0] - _DOT, at[1], 1.0), (at[0] + _DOT, at[1], 1.0)]
            dot.paths.add_polyline_path(ring, is_closed=True)
        middle = ((left[0] + right) / 2, left[1] + _OVER)
        add_text(layout, one.note.text, middle, one.note.height, align="CENTER")


def _in_row(ordered: Sequence[Note], below: Box) -> list[Leader]:
    lefts: list[float] = []
    for note in ordered:
        free = lefts[-1] + ordered[len(lefts) - 1].width + _BETWEEN if lefts else note.at[0] + _AWAY
        lefts.append(max(free, note.at[0] + _AWAY))
    pushed = [left - note.at[0] - _AWAY for left, note in zip(lefts, ordered, strict=True)]
    back = sum(pushed) / len(pushed) if pushed else 0.0
    if ordered:
        too_far = lefts[-1] + ordered[-1].width - back - below.right
        room = lefts[0] - back - below.left
        back += max(0.0, min(too_far, room))
    return [
        Leader(note, left - back, below.top + ABOVE)
        for note, left in zip(ordered, lefts, strict=True)
    ]


def _left(a: Point, b: Point, c: Point) -> float:
    """Return a positive number where c lies on the left of the line from a to b."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _moved(point: Point, by: Point) -> Point:
    return point[0] + by[0], point[1] + by[1]
