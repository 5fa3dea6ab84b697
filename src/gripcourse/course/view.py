"""What the general view of a scheme shows, as its author declares it.

A view is parts made of plain shapes, dimensions, labels and a list of characteristics. All places
and sizes are formulas of quantities, of the coordinates of the kinematics and of lengths that the
view declares itself. x points along the axis, y across it; a part or a
dimension that needs a quantity which the options of a variant do not bring is not drawn.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.formula.tree import Formula
from gripcourse.text.words import Texts


class Face(StrEnum):
    """The side that something is looked at from."""

    MAIN = "main"
    END = "end"  # along the axis; x is across the plane of the main view
    PLAN = "plan"  # from above; x along, y across


class Side(StrEnum):
    """The side of a view that a dimension stands on."""

    ABOVE = "above"
    BELOW = "below"
    LEFT = "left"
    RIGHT = "right"


class Need(StrEnum):
    """What a shape's key holds."""

    POINT = "point"  # two lengths
    POINTS = "points"  # two points or more
    RANGE = "range"  # two lengths
    LENGTH = "length"
    ANGLES = "angles"  # two angles, degrees, counter-clockwise


# The shapes and what each needs.
SHAPES: Mapping[str, Mapping[str, Need]] = {
    "box": {"x": Need.RANGE, "y": Need.RANGE},
    "circle": {"at": Need.POINT, "diameter": Need.LENGTH},
    "pin": {"at": Need.POINT, "diameter": Need.LENGTH},  # a circle with its axes
    "bar": {"through": Need.POINTS, "width": Need.LENGTH},  # round at its ends and bends
    # round at both ends, each as wide as the first and the second of its `widths`
    "taper": {"start": Need.POINT, "end": Need.POINT, "widths": Need.RANGE},
    "polygon": {"corners": Need.POINTS},
    "line": {"through": Need.POINTS},
    "arc": {"at": Need.POINT, "radius": Need.LENGTH, "angles": Need.ANGLES},
    "sector": {"at": Need.POINT, "radius": Need.LENGTH, "angles": Need.ANGLES},
    # half way along a bar: its cross-section, turned into the view (GOST 2.305)
    "section": {"through": Need.POINTS, "width": Need.LENGTH, "length": Need.LENGTH},
    # a local section, to be hatched: the first of its `x` is the line of break
    "broken": {"x": Need.RANGE, "y": Need.RANGE},
}
# Shapes with an inside: the bodies of a view are made of these.
CLOSED = frozenset({"box", "circle", "pin", "bar", "taper", "polygon", "sector"})
HATCHES = ("", "right", "left", "close_right", "close_left")
SOLID_LINES = frozenset({"outline", "phantom"})  # of a body, unless declared otherwise
LINES = ("outline", "thin", "centre", "hidden", "phantom")

Expression = Formula | None  # None: nothing, zero


@dataclass(frozen=True, slots=True)
class Repeat:
    """A shape again and again: `count` times, each `step` further."""

    count: Formula
    step: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Ring:
    """A shape again and again: `count` times round a point."""

    count: Formula
    about: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class ViewShape:
    """One shape.

    Attributes:
        kind: a key of `SHAPES`.
        needs: the formulas of each key, points as x and y in turn.
        line: one of `LINES`.
        hatch: which way the lines of a cut face lean and how close they are, one of `HATCHES`;
            empty for none.
        hidden_edges: whether what other parts cover of it is shown by dashed lines.
        face: the view that shows it.
        repeats: in rows and columns, or round a point.
        body: whether it is solid, where it has an inside; else it is only drawn.
        void: whether it is cut out of the solid shapes of its part at the same depth.
        whole: whether a section leaves it whole, as teeth (GOST 2.402) or a shaft along its axis
            (GOST 2.305): what of it no other shape of its part fills is not hatched.
        depth: from and to, from the plane of the main view, on both sides of it; empty for that of
            its part.
        key: where it is declared, for messages.
    """

    kind: str
    needs: Mapping[str, tuple[Expression, ...]]
    line: str
    hatch: str
    hidden_edges: bool
    face: Face
    repeats: tuple[Repeat | Ring, ...]
    body: bool
    void: bool
    whole: bool
    depth: tuple[Expression, ...]
    key: str


@dataclass(frozen=True, slots=True)
class Grade:
    """A material that parts are made of, which their strength asks for.

    Attributes:
        yield_stress: MPa.
        elastic_modulus: MPa; 0 where none is told.
        density: kg/m³.
        material: as the parts list names it.
    """

    yield_stress: float
    elastic_modulus: float
    density: float
    material: Texts


@dataclass(frozen=True, slots=True)
class ViewPart:
    """A part of what is drawn.

    Attributes:
        id: its name in the declarations.
        title: in the parts list; None for what has no position: the object, another position.
        mirrored: whether it stands on both sides of the axis; what stands round a point is not
            mirrored.
        count: how many there are; None for one, or two where it is mirrored.
        sizes: quantities that the parts list shows.
        material: as the parts list names it; None for that of the view.
        mark: where the leader of its position ends, in the main view.
        moves: whether the other position of the view shows it too.
        meets: parts that it may overlap: a pin in its hole, teeth in mesh.
        touches: parts that it may press into by a fraction of a millimetre: what it holds.
        enters: how much deeper than that it may, in millimetres; None for no deeper.
        positions: of the kinematics, in which it is there; empty for all.
        depth: of those of its shapes that declare none; empty for all of the view.
        density: kg/m³ of what its outline holds; 0 for that of the view.
        piece_of: the part that it is one piece with; empty for a piece of its own.
        placed_at: the position whose coordinates place it in all of them; empty for each its own.
        shapes: in the order in which they cover each other. Of parts, the later covers the
            earlier; from the end, which is looked at from behind, the earlier the later.
        file, key: where it is declared.
    """

    id: str
    title: Texts | None
    mirrored: bool
    count: Formula | None
    sizes: tuple[str, ...]
    material: Texts | None
    mark: tuple[Expression, ...]
    moves: bool
    meets: tuple[str, ...]
    touches: tuple[str, ...]
    enters: Formula | None
    positions: tuple[str, ...]
    placed_at: str
    depth: tuple[Expression, ...]
    density: float
    piece_of: str
    shapes: tuple[ViewShape, ...]
    file: str
    key: str


@dataclass(frozen=True, slots=True)
class ViewDimension:
    """A dimension: the quantity that it shows, the two points between which it is measured."""

    quantity: str
    start: tuple[Expression, ...]
    end: tuple[Expression, ...]
    side: Side
    face: Face
    sign: str
    at_other: bool
    file: str
    key: str


@dataclass(frozen=True, slots=True)
class ViewLabel:
    """Words on a leader line; in the places of the text stand quantities or measures by name."""

    text: Texts
    values: Mapping[str, str]
    at: tuple[Expression, ...]
    face: Face
    file: str
    key: str


@dataclass(frozen=True, slots=True)
class ViewDetail:
    """A place of the main view that is shown again at a larger scale, where the sheet has room.

    Attributes:
        at: its middle.
        reach: half of what is shown.
        is_section: whether it is cut across the axis there; else it is what the main view shows.
        file, key: where it is declared.
    """

    at: tuple[Expression, ...]
    reach: Formula | None
    is_section: bool
    file: str
    key: str


@dataclass(frozen=True, slots=True)
class Measure:
    """A length or an angle of the drawing: the first of its formulas whose names are known."""

    unit: str
    formulas: tuple[Formula, ...]
    file: str
    key: str


@dataclass(frozen=True, slots=True)
class View:
    """The general view of a scheme.

    Attributes:
        position: of the kinematics, in which it is drawn.
        upright: whether the axis stands upright in the main face; else it lies.
        bodies: whether the parts are bodies that must not go through one another; else they are a
            picture only.
        other: position that moving parts are shown in by thin lines too; empty for none.
        measures: by name.
        parts, dimensions, labels, details: in order.
        characteristics: quantities that stand beside the drawing.
        requirements: sentences that stand there.
        density: of what the bodies are made of, kg/m³; 0 where the mass is not told.
        material: of parts that declare none, as the parts list names it; None for none.
        grades: materials by their strength, the weakest first.
        strength: yield stresses that a part needs, by its id, of which the greatest that a variant
            has counts; the part is of the first grade that has it.
        elastic_modulus: that a part was calculated with, by its id: it chooses among the grades
            before their strength does.
        around: how many of what is mirrored stand round the axis; None for two.
        file: of the scheme's own declarations.
    """

    position: str
    upright: bool
    bodies: bool
    other: str
    measures: Mapping[str, Measure]
    parts: tuple[ViewPart, ...]
    dimensions: tuple[ViewDimension, ...]
    labels: tuple[ViewLabel, ...]
    details: tuple[ViewDetail, ...]
    characteristics: tuple[str, ...]
    requirements: tuple[Texts, ...]
    density: float
    material: Texts | None
    grades: tuple[Grade, ...]
    strength: Mapping[str, tuple[Formula, ...]]
    elastic_modulus: Mapping[str, tuple[Formula, ...]]
    around: Formula | None
    file: str
