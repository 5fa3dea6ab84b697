"""Where a symbol may stand: boxes round the places that it names, with leaders where it is far."""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
import shapely
from numpy.typing import NDArray

from gripcourse.drawing.diagram.marks import Letter
from gripcourse.drawing.paper.strokes import DIGITS

_DISTANCES: Final = np.array((0.9, 1.6, 2.3, 3.0, 4.5, 6.5, 9.0, 12.0, 16.0))
_BARE: Final = 3.0  # mm from what it names that a symbol stands without a leader, at most
_DEGREES: Final = (90, 270, 0, 180, 45, 135, 225, 315, 67, 112, 247, 292, 22, 157, 202, 337)
_DIRECTIONS: Final = np.radians(_DEGREES)  # the best first
_UPRIGHT_ONES: Final = [k for k, one in enumerate(_DEGREES) if one % 90 == 0]
_LONGER: Final = np.array((0.0, 2.0, 4.5, 8.0, 12.0, 17.0, 23.0))  # of a leader than it was asked
_SPREAD: Final = np.radians((0, 25, -25, 50, -50))  # from its end to the symbol
_SHORT: Final = 0.5  # between a leader's end and the symbol
# What counts against a place.
_FAR: Final = 0.35  # a millimetre of distance
_LATER: Final = 0.04  # one direction later in the order of preference
_LATER_PLACE: Final = 0.15  # one place later
_TURNED: Final = 0.6  # a tip later
_UPRIGHT: Final = 5.0  # a leader along the axis or across it: it looks like an edge or a dimension
_LEADER: Final = 4.0  # a leader of a symbol that might stand beside what it names

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Candidates:
    """Places of one symbol.

    Attributes:
        boxes: rows of left, bottom, right, top, mm; shape (n, 4).
        leaders: lines from what is named to the symbol, None where none is needed; shape (n,).
        far: what counts against each of them: distance, and how late it comes; shape (n,).
    """

    boxes: Array
    leaders: NDArray[Any]
    far: Array

    def some(self, rows: NDArray[np.intp]) -> "Candidates":
        """Return some of the places."""
        return Candidates(self.boxes[rows], self.leaders[rows], self.far[rows])

    def one(self, row: int) -> "Candidates":
        """Return one of the places."""
        return self.some(np.array([row]))


def candidates(letter: Letter, size: tuple[float, float]) -> Candidates:
    """Return where a symbol of some width and height may stand, the nearest places first."""
    found = _at_leaders(letter, size) if letter.tips else _beside(letter, size)
    return found.some(np.argsort(found.far, kind="stable"))


def _beside(letter: Letter, size: tuple[float, float]) -> Candidates:
    """Return places round those of a letter: in each direction, at each distance."""
    late, later, step = (
        one.ravel() for one in np.indices((len(letter.places), len(_DIRECTIONS), len(_DISTANCES)))
    )
    places, turns, distances = np.array(letter.places)[late], _DIRECTIONS[later], _DISTANCES[step]
    boxes = _boxes(places, turns, distances, size)
    leaders = _lines(places, _polar(places, distances - _SHORT, turns))
    is_bare = distances <= _BARE
    leaders[is_bare] = None
    led = _LEADER + _UPRIGHT * np.isin(later, _UPRIGHT_ONES)
    far = _FAR * distances + _LATER * later + _LATER_PLACE * late + np.where(is_bare, 0, led)
    return Candidates(boxes, leaders, far)


def _at_leaders(letter: Letter, size: tuple[float, float]) -> Candidates:
    """Return places at the ends of leaders."""
    late, longer, spread = (
        one.ravel() for one in np.indices((len(letter.tips), len(_LONGER), len(_SPREAD)))
    )
    tips = np.array([tip for tip, _ in letter.tips])[late]
    turns = np.array([turn for _, turn in letter.tips])[late]
    ends = _polar(tips, letter.long + _LONGER[longer], turns)
    boxes = _boxes(ends, turns + _SPREAD[spread], np.full(len(ends), _SHORT), size)
    far = _FAR * _LONGER[longer] + _TURNED * late + _LATER * spread
    return Candidates(boxes, _lines(tips, ends), far)


def _lines(starts: Array, ends: Array) -> NDArray[np.object_]:
    return np.asarray(shapely.linestrings(np.stack((starts, ends), 1)))


def _polar(places: Array, distances: Array, turns: Array) -> Array:
    ends = places + distances[:, None] * np.stack((np.cos(turns), np.sin(turns)), 1)
    return np.asarray(np.round(ends, DIGITS))


def _boxes(places: Array, turns: Array, distances: Array, size: tuple[float, float]) -> Array:
    """Return the boxes that are so far from points in a direction."""
    half = np.array(size) / 2
    along = np.stack((np.cos(turns), np.sin(turns)), 1)
    # As far as the box reaches towards the point, so that it never covers it.
    reach = (half / np.maximum(np.abs(along), 1e-9)).min(axis=1)
    middles = places + (distances + reach)[:, None] * along
    boxes = np.concatenate((middles - half, middles + half), axis=1)
    return np.asarray(np.round(boxes, DIGITS))
