"""Symbols in their places: which letters, where, and the leaders that tell what they name."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final, Literal

import numpy as np
import shapely
from numpy.typing import NDArray

from gripcourse.drawing.diagram.candidates import Candidates, candidates
from gripcourse.drawing.diagram.marks import (
    Chain,
    Fill,
    Letter,
    Mark,
    Path,
    chain,
    corners,
    head,
    moved,
)
from gripcourse.drawing.paper.document import TEXT_HEIGHT, LineKind
from gripcourse.drawing.paper.strokes import Box, box_of
from gripcourse.drawing.paper.text import Point, text_width

SUBSCRIPT: Final = 2.5  # mm, height of capital letters (GOST 2.304)
DROP: Final = 1.1  # of a subscript below the line
GAP: Final = 0.4  # between a letter and what is near it
NEARER: Final = 0.1  # mm that a letter is nearer to what it names than to any other thing

_DESCENT: Final = 0.9  # of letters with a tail
_ROUNDS: Final = 6  # in which letters make room for one another
_PART: Final = 96  # places that are weighed at a time
_GOOD: Final = 14.0  # what a good place costs at most
_ENOUGH: Final = 10  # good places that a letter has to choose from
_KEPT: Final = 60  # places of a letter that are worth a comparison with other letters
_DIGITS: Final = 6  # of what counts against a place
# What counts against a place.
_OUTSIDE: Final = 1e4
_LINE: Final = 30.0  # lines under the letter
_COVERED: Final = 6.0  # each of them, of a few
_FEW: Final = 10
_MISTAKEN: Final = 60.0  # another thing with a symbol is nearer
_CLOSE: Final = 1.0  # a millimetre less than `_APART` to such a thing
_APART: Final = 2.0
_UNDER: Final = 100.0  # another letter under it, or its leader under a letter
_CROSSED: Final = 1.5  # a line that its leader crosses
_BLACK: Final = 12.0  # a leader that its leader crosses


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
        names: what it names, its leader included.
        leader: from what it names to the symbol; empty where it stands beside it.
        has_arrow: whether the leader ends in an arrow.
        is_clear: whether it covers nothing and names the nearest thing.
        is_quantity: whether it is the symbol of a quantity, and not the name of a joint.
    """

    symbol: str
    base: str
    below: str
    at: Point
    offset: float
    box: Box
    names: tuple[Chain, ...]
    leader: Chain
    has_arrow: bool
    is_clear: bool
    is_quantity: bool = True

    def shifted(self, x: float, y: float) -> "Written":
        """Return the symbol moved."""
        return replace(
            self,
            at=(self.at[0] + x, self.at[1] + y),
            box=self.box.moved((x, y)),
            names=tuple(moved(one, x, y) for one in self.names),
            leader=moved(self.leader, x, y),
        )

    @property
    def marks(self) -> tuple[Mark, ...]:
        """Its leader as it is drawn."""
        if not self.leader:
            return ()
        tip, end = self.leader
        arrow = (head(tip, end),) if self.has_arrow else ()
        return (Path((tip, end), LineKind.DIMENSION), *arrow)


def bounds(marks: Iterable[Mark]) -> Box:
    """Return the box round everything drawn."""
    return box_of(point for mark in marks for point in corners(mark))


def strokes_of(marks: Sequence[Mark]) -> shapely.STRtree:
    """Return everything drawn, to be searched: straight pieces, and black shapes as areas."""
    black = [shapely.Polygon(mark.points) for mark in marks if isinstance(mark, Fill)]
    pieces = [pair for mark in marks for pair in pairwise(chain(mark))]
    lines = np.asarray(shapely.linestrings(np.array(pieces).reshape(-1, 2, 2)))
    return shapely.STRtree([*black, *lines])


def boxes_of(boxes: NDArray[np.float64], margin: float = 0.0) -> NDArray[np.object_]:
    """Return rectangles with a margin round them from rows of left, bottom, right, top."""
    left, bottom, right, top = boxes.T
    return np.asarray(shapely.box(left - margin, bottom - margin, right + margin, top + margin))


def covered_lengths(boxes: NDArray[np.float64], strokes: shapely.STRtree) -> NDArray[np.float64]:
    """Return how much line runs under each box, mm.

    Args:
        boxes: rows of left, bottom, right, top.
        strokes: see `strokes_of`.
    """
    shapes = boxes_of(boxes)
    found, lines = strokes.query(shapes, predicate="intersects")
    under = shapely.length(shapely.intersection(shapes[found], strokes.geometries[lines]))
    return np.asarray(np.bincount(found, weights=under, minlength=len(boxes)), dtype=float)


def write_letters(
    letters: Sequence[Letter], strokes: shapely.STRtree, sheet: Box
) -> tuple[Written, ...]:
    """Find a place for every letter: first one after the other, then each beside all others.

    Args:
        letters: with their places in order of preference.
        strokes: what they should not cover.
        sheet: what they must not leave.
    """
    sizes = [_size(letter.symbol) for letter in letters]
    things = [_joined(letter.thing) for letter in letters]
    fields = [
        _Field.of(letter, size, strokes, things[:k] + things[k + 1 :], sheet)
        for k, (letter, size) in enumerate(zip(letters, sizes, strict=True))
    ]
    places = _arranged(fields)
    return tuple(
        _written(letter, field.choices.one(where), cost)
        for letter, field, (where, cost) in zip(letters, fields, places, strict=True)
    )


def _arranged(fields: Sequence["_Field"]) -> list[tuple[int, float]]:
    """Return the place of each letter and what it costs there, in the best arrangement found.

    A letter that finds no room takes its best place all the same; the others then make room.
    """
    # Who has the least choice comes first.
    order = sorted(range(len(fields)), key=lambda k: -fields[k].dearness)
    chosen: dict[int, int] = {}
    best: list[tuple[int, float]] = []
    for _ in range(_ROUNDS):
        for k in order:
            weighed = fields[k].beside(_placed(fields, chosen, k))
            is_free = weighed.min() < _LINE
            chosen[k] = int(np.argmin(weighed if is_free else fields[k].costs))
        costs = [
            float(one.beside(_placed(fields, chosen, k))[chosen[k]]) for k, one in enumerate(fields)
        ]
        if not best or sum(costs) < sum(cost for _, cost in best):
            best = [(chosen[k], cost) for k, cost in enumerate(costs)]
        if max(costs, default=0.0) < _LINE:
            break
    return best


def _placed(fields: Sequence["_Field"], chosen: Mapping[int, int], but: int) -> list[Candidates]:
    """Return where all letters but one stand."""
    return [fields[one].choices.one(where) for one, where in chosen.items() if one != but]


@dataclass(frozen=True, slots=True)
class _Field:
    """Where a letter may stand, the cheapest places first.

    Attributes:
        choices: n places.
        own: how far each of them is from what the letter names, mm.
        costs: whatever the other letters do, shape (n,).
    """

    choices: Candidates
    own: NDArray[np.float64]
    costs: NDArray[np.float64]

    @classmethod
    def of(
        cls,
        letter: Letter,
        size: tuple[float, float],
        strokes: shapely.STRtree,
        others: Sequence[shapely.Geometry],
        sheet: Box,
    ) -> "_Field":
        """Weigh the places of a letter, the nearest first, until there are enough good ones."""
        nearest = candidates(letter, size)
        thing, around = _joined(letter.thing), shapely.union_all(others)
        shapely.prepare([thing, around])
        own: list[float] = []
        costs: list[float] = []
        for start in range(0, len(nearest.far), _PART):
            part = nearest.some(np.arange(start, min(start + _PART, len(nearest.far))))
            shapes = boxes_of(part.boxes)
            line = _touched(boxes_of(part.boxes, GAP), "intersects", strokes)
            beside = np.fmin(
                shapely.distance(shapes, thing), shapely.distance(shapes, part.leaders)
            )
            other = np.nan_to_num(shapely.distance(shapes, around), nan=np.inf)
            own += beside.tolist()
            costs += (
                part.far
                + np.where(line > 0, _LINE + _COVERED * np.minimum(line, _FEW), 0.0)
                + np.where(other < beside + NEARER, _MISTAKEN, 0.0)
                + _CLOSE * np.clip(_APART - other, 0.0, None)
                + _OUTSIDE * _leaves(part, sheet)
                + _CROSSED * _touched(part.leaders, "crosses", strokes)
            ).tolist()
            if sum(cost < _GOOD for cost in costs) >= _ENOUGH:
                break
        # Of places that cost the same the first is taken, on whatever processor.
        rounded = np.round(costs, _DIGITS)
        kept = np.argsort(rounded, kind="stable")[:_KEPT]
        return cls(nearest.some(kept), np.array(own)[kept], rounded[kept])

    @property
    def dearness(self) -> float:
        """What its tenth place costs: a letter with little choice is dear."""
        return float(self.costs[min(9, len(self.costs) - 1)])

    def beside(self, others: Sequence["Candidates"]) -> NDArray[np.float64]:
        """Return what the places cost beside other letters where they stand."""
        if not others:
            return self.costs
        boxes = boxes_of(np.concatenate([one.boxes for one in others]))
        wide = boxes_of(self.choices.boxes, GAP)
        leaders = np.concatenate([one.leaders for one in others])
        mine = self.choices.leaders
        costs = self.costs + _UNDER * shapely.intersects(wide[:, None], boxes).sum(axis=1)
        costs = costs + _UNDER * shapely.intersects(mine[:, None], boxes).sum(axis=1)
        costs = costs + _UNDER * shapely.intersects(wide[:, None], leaders).sum(axis=1)
        costs = costs + _BLACK * shapely.intersects(mine[:, None], leaders).sum(axis=1)
        shapes = boxes_of(self.choices.boxes)
        near = np.nan_to_num(shapely.distance(shapes[:, None], leaders), nan=np.inf)
        return np.asarray(costs + _MISTAKEN * (near.min(axis=1) < self.own + NEARER))


def _leaves(choices: Candidates, sheet: Box) -> NDArray[np.bool_]:
    """Tell which places are not wholly on the sheet."""
    left, bottom, right, top = choices.boxes.T
    return np.asarray(
        (left < sheet.left) | (bottom < sheet.bottom) | (right > sheet.right) | (top > sheet.top)
    )


def _touched(
    shapes: NDArray[np.object_], how: Literal["intersects", "crosses"], strokes: shapely.STRtree
) -> NDArray[np.int64]:
    """Return how many lines each shape meets."""
    found, _ = strokes.query(shapes, predicate=how)
    return np.bincount(found, minlength=len(shapes))


def _joined(thing: Sequence[Chain]) -> shapely.Geometry:
    return shapely.union_all(
        [shapely.LineString(one) if len(one) > 1 else shapely.Point(one[0]) for one in thing]
    )


def _size(symbol: str) -> tuple[float, float]:
    """Return width and height of a symbol on the sheet, mm."""
    base, _, below = symbol.partition("_")
    width = text_width(base, TEXT_HEIGHT) + (text_width(below, SUBSCRIPT) if below else 0.0)
    return width, TEXT_HEIGHT + _depth(below)


def _depth(below: str) -> float:
    return DROP + 0.5 if below else _DESCENT


def _written(letter: Letter, place: Candidates, cost: float) -> Written:
    base, _, below = letter.symbol.partition("_")
    left, bottom, right, top = map(float, place.boxes[0])
    leader = tuple((float(x), float(y)) for x, y in shapely.get_coordinates(place.leaders))
    return Written(
        symbol=letter.symbol,
        base=base,
        below=below,
        at=(left, bottom + _depth(below)),
        offset=text_width(base, TEXT_HEIGHT),
        box=Box(left, bottom, right, top),
        names=(*letter.thing, *([leader] if leader else [])),
        leader=leader,
        has_arrow=bool(letter.tips),
        is_clear=cost < _LINE,
        is_quantity=letter.is_quantity,
    )
