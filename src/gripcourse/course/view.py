"""What the general view of a scheme shows, as its author declares it.

A view is parts made of plain shapes, dimensions, labels and a list of characteristics. All places
and sizes are formulas of quantities, of the coordinates of the kinematics and of lengths that the
view declares itself. x points along the gripper's axis towards the object, y across it; a part or a
dimension that needs a quantity which the options of a variant do not bring is not drawn.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum

from gripcourse.course.kinematics import POSITIONS
from gripcourse.course.toml_table import Table, did_you_mean
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula
from gripcourse.words import Message, Texts, message


class Face(StrEnum):
    """The side that something is looked at from."""

    MAIN = "main"
    END = "end"  # from the flange; x is across the plane of the main view
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
    "bar": {"through": Need.POINTS, "width": Need.LENGTH},  # round at its ends
    "polygon": {"corners": Need.POINTS},
    "line": {"through": Need.POINTS},
    "arc": {"at": Need.POINT, "radius": Need.LENGTH, "angles": Need.ANGLES},
    "sector": {"at": Need.POINT, "radius": Need.LENGTH, "angles": Need.ANGLES},
}
HATCHES = ("", "right", "left")
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
class Shape:
    """One shape.

    Attributes:
        kind: a key of `SHAPES`.
        needs: the formulas of each key, points as x and y in turn.
        line: one of `LINES`.
        hatch: which way the lines of a cut face lean, one of `HATCHES`; empty for none.
        face: the view that shows it.
        repeats: in rows and columns, or round a point.
        key: where it is declared, for messages.
    """

    kind: str
    needs: Mapping[str, tuple[Expression, ...]]
    line: str
    hatch: str
    face: Face
    repeats: tuple[Repeat | Ring, ...]
    key: str


@dataclass(frozen=True, slots=True)
class ViewPart:
    """A part of the gripper.

    Attributes:
        id: its name in the declarations.
        title: in the parts list; None for what has no position: the object, another position.
        mirrored: whether it stands on both sides of the axis.
        count: how many there are; None for one, or two where it is mirrored.
        sizes: quantities that the parts list shows.
        mark: where the leader of its position ends, in the main view.
        moves: whether the other position of the view shows it too.
        shapes: in the order in which they cover each other.
        file, key: where it is declared.
    """

    id: str
    title: Texts | None
    mirrored: bool
    count: Formula | None
    sizes: tuple[str, ...]
    mark: tuple[Expression, ...]
    moves: bool
    shapes: tuple[Shape, ...]
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
        position: of the kinematics, in which the gripper is drawn.
        upright: whether the gripper's axis stands upright in the main face, the object below; else it
            lies, the object on the right.
        other: position that moving parts are shown in by thin lines too; empty for none.
        measures: by name.
        parts, dimensions, labels: in order.
        characteristics: quantities that stand beside the drawing.
        file: of the scheme's own declarations.
    """

    position: str
    upright: bool
    other: str
    measures: Mapping[str, Measure]
    parts: tuple[ViewPart, ...]
    dimensions: tuple[ViewDimension, ...]
    labels: tuple[ViewLabel, ...]
    characteristics: tuple[str, ...]
    file: str


def read_view(table: Table, shared: Mapping[str, View]) -> View:
    """Read the view of a scheme: what `behind` names lies behind its parts, `before` before them."""
    keys = {"behind", "before", "position", "upright", "other", "characteristics"}
    table.known_keys(keys | _SHARED_KEYS)
    views = (*_named(table, "behind", shared), _read(table), *_named(table, "before", shared))
    return View(
        position=_one_of(table, "position", ("", *POSITIONS), ""),
        upright=table.flag("upright"),
        other=_one_of(table, "other", ("", *POSITIONS), ""),
        measures={name: one for view in views for name, one in view.measures.items()},
        parts=tuple(one for view in views for one in view.parts),
        dimensions=tuple(one for view in views for one in view.dimensions),
        labels=tuple(one for view in views for one in view.labels),
        characteristics=table.strings("characteristics"),
        file=table.file,
    )


def _named(table: Table, key: str, shared: Mapping[str, View]) -> Iterator[View]:
    for name in table.strings(key):
        if name in shared:
            yield shared[name]
            continue
        what = message("There is no shared drawing '{name}'.", name=name)
        table.add(key, what, did_you_mean(name, shared))


def read_shared(table: Table) -> View:
    """Read a file of parts that several views share."""
    table.known_keys(_SHARED_KEYS)
    return _read(table)


_SHARED_KEYS = {"length", "angle", "count", "part", "dimension", "label"}


def _read(table: Table) -> View:
    return View(
        position="",
        upright=False,
        other="",
        measures=_measures(table),
        parts=tuple(_part(one) for one in table.tables("part")),
        dimensions=tuple(_dimension(one) for one in table.tables("dimension")),
        labels=tuple(_label(one) for one in table.tables("label")),
        characteristics=(),
        file=table.file,
    )


def _measures(table: Table) -> dict[str, Measure]:
    found: dict[str, Measure] = {}
    for kind, unit in (("length", "mm"), ("angle", "deg"), ("count", "")):
        inner = table.table(kind)
        for name in inner.values if inner is not None else ():
            formulas = _alternatives(inner, name) if inner is not None else ()
            found[name] = Measure(unit, formulas, table.file, f"{kind}.{name}")
    return found


def _alternatives(table: Table, name: str) -> tuple[Formula, ...]:
    texts = table.strings(name) if isinstance(table.values[name], list) else [table.text(name)]
    read = (_formula(table, name, text) for text in texts)
    return tuple(one for one in read if one is not None)


def _part(table: Table) -> ViewPart:
    table.known_keys(
        {"id", "title", "nameless", "mirror", "count", "sizes", "mark", "moves", "shape"}
    )
    nameless = table.flag("nameless")
    shapes = tuple(_shape(one) for one in table.tables("shape"))
    if not shapes:
        table.add("shape", message("This key is missing."), message("Write the shapes."))
    return ViewPart(
        id=table.text("id"),
        title=None if nameless else table.texts("title"),
        mirrored=table.flag("mirror"),
        count=_formula(table, "count", table.text("count")) if table.has("count") else None,
        sizes=table.strings("sizes"),
        mark=() if nameless else _expressions(table, "mark", Need.POINT),
        moves=table.flag("moves"),
        shapes=shapes,
        file=table.file,
        key=table.key,
    )


def _shape(table: Table) -> Shape:
    kind = _one_of(table, "kind", tuple(SHAPES), None)
    needs = SHAPES.get(kind, {})
    if needs:
        table.known_keys({"kind", "line", "hatch", "face", "repeat", *needs})
    return Shape(
        kind=kind,
        needs={name: _expressions(table, name, need) for name, need in needs.items()},
        line=_one_of(table, "line", LINES, LINES[0]),
        hatch=_one_of(table, "hatch", HATCHES, ""),
        face=Face(_one_of(table, "face", tuple(Face), Face.MAIN)),
        repeats=tuple(_repeat(one) for one in table.tables("repeat")),
        key=table.key,
    )


def _repeat(table: Table) -> Repeat | Ring:
    table.known_keys({"count", "step", "about"})
    count = _formula(table, "count", table.text("count")) or Formula("1", parse("1"), {})
    if table.has("about"):
        return Ring(count, _expressions(table, "about", Need.POINT))
    return Repeat(count, _expressions(table, "step", Need.POINT))


def _dimension(table: Table) -> ViewDimension:
    table.known_keys({"quantity", "from", "to", "side", "face", "sign", "at_other"})
    return ViewDimension(
        quantity=table.text("quantity"),
        start=_expressions(table, "from", Need.POINT),
        end=_expressions(table, "to", Need.POINT),
        side=Side(_one_of(table, "side", tuple(Side), None) or Side.BELOW),
        face=Face(_one_of(table, "face", tuple(Face), Face.MAIN)),
        sign=table.text("sign", ""),
        at_other=table.flag("at_other"),
        file=table.file,
        key=table.key,
    )


def _label(table: Table) -> ViewLabel:
    table.known_keys({"text", "values", "at", "face"})
    values = table.table("values")
    return ViewLabel(
        text=table.texts("text"),
        values={name: values.text(name) for name in values.values} if values else {},
        at=_expressions(table, "at", Need.POINT),
        face=Face(_one_of(table, "face", tuple(Face), Face.END)),
        file=table.file,
        key=table.key,
    )


def _expressions(table: Table, name: str, need: Need) -> tuple[Expression, ...]:
    """Read formulas in the order x, y, x, y…; where they cannot be read, as many as are needed."""
    value = table.values.get(name)
    written = list(value) if isinstance(value, list) else [value]
    if need is Need.POINTS and all(isinstance(one, list) for one in written):
        written = [one for point in written for one in point]
    known = all(isinstance(one, str) or one == 0 for one in written)
    if known and _fits(len(written), need):
        return tuple(
            _formula(table, name, one) if isinstance(one, str) else None for one in written
        )
    if name in table.values:
        table.add(name, message("The value has the wrong type."), _REMEDIES[need])
    else:
        table.add(name, message("This key is missing."), _REMEDIES[need])
    return (None, None, None, None) if need is Need.POINTS else (None, None)


_REMEDIES: Mapping[Need, Message] = {
    Need.POINT: message("Write two formulas or zeros: ['pin_x', 0]."),
    Need.POINTS: message("Write two points or more: [['pin_x', 0], ['pin_x', 'pin_y']]."),
    Need.RANGE: message("Write two formulas or zeros: ['pin_x', 0]."),
    Need.LENGTH: message("Write a formula: 'pin_diameter'."),
    Need.ANGLES: message("Write two formulas or zeros: ['pin_x', 0]."),
}
_TWO = 2


def _fits(count: int, need: Need) -> bool:
    if need is Need.LENGTH:
        return count == 1
    if need is Need.POINTS:
        return count >= 2 * _TWO and count % _TWO == 0
    return count == _TWO


def _formula(table: Table, name: str, text: str) -> Formula | None:
    try:
        return Formula(text, parse(text), {}) if text else None
    except FormulaFault as fault:
        table.add(name, fault.what, message("Mend the formula."), caret(text, fault.span))
        return None


def _one_of(table: Table, name: str, known: tuple[str, ...], default: str | None) -> str:
    written = table.text(name, default)
    if written not in known and written:
        what = message("The name '{name}' is not known.", name=written)
        table.add(name, what, did_you_mean(written, known))
        return default or ""
    return written
