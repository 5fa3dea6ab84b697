"""The vocabulary of diagrams: what an element is called and what it must say (GOST 2.770).

Angles are measured in the picture, counter-clockwise from the axis of the picture, which
runs to the right. Numbers are millimetres of paper, unless the role is a count.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum, auto
from typing import Final


class Sort(Enum):
    """What a role of an element holds."""

    POINT = auto()  # the name of a point
    POINTS = auto()  # names of two points or more
    LENGTH = auto()  # a formula, drawn to scale
    ANGLE = auto()  # a formula
    NUMBER = auto()  # a formula without unit
    WORD = auto()  # one of several words
    QUANTITY = auto()  # the id of a quantity


@dataclass(frozen=True, slots=True)
class Role:
    """What an element says under one key.

    Attributes:
        sort: what it holds.
        default: where it is not written; None where it must be, empty where it may be absent:
            a size may then also name quantities that not all variants have, and a point is none.
        words: of a WORD, the first is the default.
    """

    sort: Sort
    default: str | None = None
    words: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Word:
    """An element's keys, and how it is drawn unless the author says otherwise.

    Attributes:
        roles: by key.
        paired: whether it is on both sides of a mechanism that its diagram calls symmetric.
        moves: whether it is drawn at every position that the course shows, or at the first only.
    """

    roles: Mapping[str, Role]
    paired: bool
    moves: bool


MIRRORS: Final = ("none", "both", "only")

_POINT: Final = Role(Sort.POINT)
_POINTS: Final = Role(Sort.POINTS)
_LENGTH: Final = Role(Sort.LENGTH)
_ANGLE: Final = Role(Sort.ANGLE)
_SYMBOL: Final = Role(Sort.QUANTITY)
# Which side of the piston is under pressure while the drive works.
_PRESSED: Final = Role(Sort.WORD, words=("pushes", "pulls"))
_SURFACES: Final = Role(Sort.WORD, words=("flat", "convex", "concave", "crossed"))
_LINES: Final = Role(Sort.WORD, words=("outline", "thin", "centre", "hidden"))

# Every element may be repeated along and across the picture: so many times, so far apart.
_ROW: Final = {
    "repeat": Role(Sort.NUMBER, "1"),
    "pitch": Role(Sort.LENGTH, "0"),
    "rows": Role(Sort.NUMBER, "1"),
    "row_pitch": Role(Sort.LENGTH, "0"),
}


def _number(default: float) -> Role:
    return Role(Sort.NUMBER, str(default))


def _if_any(sort: Sort) -> Role:
    """Make a role that only some variants have a size for."""
    return Role(sort, "")


def _turn(default: str) -> Role:
    return Role(Sort.ANGLE, default)


def _moving(**roles: Role) -> Word:
    """Make a word for a part of the mechanism: wherever the drive stands."""
    return Word(roles | _ROW, paired=True, moves=True)


def _fixed(**roles: Role) -> Word:
    """Make a word for what does not move."""
    return Word(roles | _ROW, paired=True, moves=False)


def _single(**roles: Role) -> Word:
    """Make a word for what is there once, in a symmetric mechanism too."""
    return Word(roles | _ROW, paired=False, moves=False)


VOCABULARY: Final[Mapping[str, Word]] = {
    # Links and joints.
    "link": _moving(through=_POINTS, line=_LINES, corner=Role(Sort.WORD, words=("rigid", "none"))),
    "pivot": _moving(at=_POINT),
    "pin": _moving(at=_POINT),
    "fixed_pivot": _fixed(at=_POINT, turn=_turn("pi/2"), size=_number(1)),
    "slider": _moving(at=_POINT, turn=_turn("0"), long=_number(6), wide=_number(4)),
    "slot": _moving(through=_POINTS, wide=_number(2.6)),
    "guide": _fixed(at=_POINT, turn=_turn("0"), long=_number(6), gap=_number(2.4)),
    "ground": _fixed(through=_POINTS, side=Role(Sort.WORD, words=("left", "right"))),
    # Gears and screws.
    "rack": _moving(through=_POINTS, module=_LENGTH, thick=_LENGTH,
                    side=Role(Sort.WORD, words=("left", "right"))),
    "gear": _moving(at=_POINT, radius=_LENGTH, module=_LENGTH, start=_turn("0"),
                    sweep=_turn("2*pi"), mesh=_if_any(Sort.ANGLE),
                    has=Role(Sort.WORD, words=("gap", "tooth"))),
    "worm": _single(at=_POINT, radius=_LENGTH, length=_LENGTH, turn=_turn("0")),
    "screw": _fixed(through=_POINTS, diameter=_LENGTH),
    "nut": _moving(at=_POINT, length=_LENGTH, diameter=_LENGTH, turn=_turn("pi/2")),
    # Bodies.
    "plate": _moving(through=_POINTS, line=_LINES, hatch=Role(Sort.WORD, words=("none", "hatch"))),
    "roller": _moving(at=_POINT, diameter=_LENGTH),
    "contact": _moving(at=_POINT, holds=_POINT, surface=_SURFACES, radius=_if_any(Sort.LENGTH),
                   angle=_if_any(Sort.ANGLE), mouth=_if_any(Sort.LENGTH), smallest=_LENGTH,
                   largest=_LENGTH, long=_number(14), thick=_number(2.5)),
    "vee": _moving(at=_POINT, turn=_turn("-pi/2"), angle=_ANGLE, length=_LENGTH,
                     diameter=_LENGTH, radius=_if_any(Sort.LENGTH)),
    "object": Word({"at": _POINT, "diameter": _LENGTH} | _ROW, paired=False, moves=True),
    "cup": _fixed(at=_POINT, diameter=_LENGTH, height=_LENGTH),
    "coil": _fixed(through=_POINTS),
    "spring": _fixed(through=_POINTS, diameter=_if_any(Sort.LENGTH), coils=_number(4)),
    # Drives.
    "cylinder": _single(at=_POINT, turn=_turn("0"), base=Role(Sort.WORD, words=("fixed", "free")),
                        rod=_PRESSED, quantity=Role(Sort.QUANTITY, "")),
    "floating_cylinder": Word({"through": _POINTS, "rod": _PRESSED,
                               "quantity": Role(Sort.QUANTITY, "")} | _ROW,
                              paired=False, moves=False),
    "motor": _single(at=_POINT, turn=_turn("pi"), shaft=_number(6)),
    # Forces, sizes and letters.
    "force": _single(at=_POINT, turn=_ANGLE, quantity=_SYMBOL, long=_number(11), shift=_number(0),
                     most=_if_any(Sort.LENGTH), end=Role(Sort.WORD, words=("tip", "tail"))),
    "moment": _single(at=_POINT, quantity=_SYMBOL, radius=_number(5), start=_turn("-pi/3"),
                      sweep=_turn("1.5*pi")),
    "length": _single(through=_POINTS, quantity=_SYMBOL, shift=_number(0),
                      past=_if_any(Sort.POINT),
                      along=Role(Sort.WORD, words=("line", "x", "y"))),
    "angle": _single(at=_POINT, start=_ANGLE, sweep=_ANGLE, quantity=_SYMBOL,
                     radius=_number(12)),
    "radius": _single(at=_POINT, radius=_LENGTH, turn=_ANGLE, quantity=_SYMBOL),
    "diameter": _single(at=_POINT, diameter=_LENGTH, turn=_ANGLE, quantity=_SYMBOL,
                        long=_number(6)),
    "letter": _single(at=_POINT, quantity=_SYMBOL),
    "joint_name": _single(at=_POINT, name=Role(Sort.WORD, words=("A", "B", "C", "D"))),
    "end_view": _single(count=_number(3), quantity=Role(Sort.QUANTITY, "")),
}  # fmt: skip
