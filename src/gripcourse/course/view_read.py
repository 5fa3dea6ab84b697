"""Reading the general view of a scheme, and what several views share."""

from collections.abc import Iterator, Mapping

from gripcourse.course.toml_table import Table
from gripcourse.course.view import (
    CLOSED,
    HATCHES,
    LINES,
    SHAPES,
    SOLID_LINES,
    Expression,
    Face,
    Grade,
    Measure,
    Need,
    Repeat,
    Ring,
    Side,
    View,
    ViewDetail,
    ViewDimension,
    ViewLabel,
    ViewPart,
    ViewShape,
)
from gripcourse.formula.parse import FormulaFault, caret, formula_of
from gripcourse.formula.tree import Formula
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, Texts, message


def read_view(table: Table, shared: Mapping[str, View | None]) -> View | None:
    """Read the view of a scheme, between the shared files that lie `behind` and `before` it.

    None where a shared file could not be read: what it brings would be called unknown.
    """
    table.known_keys()
    named = [*_named(table, "behind", shared), _read(table), *_named(table, "before", shared)]
    views = [one for one in named if one is not None]
    view = View(
        position=table.text("position", ""),
        upright=table.flag("upright"),
        bodies=table.flag("bodies"),
        other=table.text("other", ""),
        measures={name: one for view in views for name, one in view.measures.items()},
        parts=tuple(one for view in views for one in view.parts),
        dimensions=tuple(one for view in views for one in view.dimensions),
        labels=tuple(one for view in views for one in view.labels),
        details=tuple(one for view in views for one in view.details),
        characteristics=table.strings("characteristics"),
        requirements=tuple(one for view in views for one in view.requirements),
        density=table.number("density", 0.0),
        material=_material(table),
        grades=tuple(
            sorted((one for view in views for one in view.grades), key=lambda one: one.yield_stress)
        ),
        strength=_by_name(table, "strength"),
        elastic_modulus=_by_name(table, "elastic_modulus"),
        around=_formula(table, "around", table.text("around")) if table.has("around") else None,
        file=table.file,
    )
    return view if len(views) == len(named) else None


def _named(table: Table, key: str, shared: Mapping[str, View | None]) -> Iterator[View | None]:
    for name in table.strings(key):
        if name in shared:
            yield shared[name]
            continue
        what = message("There is no shared drawing '{name}'.", name=name)
        table.add(key, what, did_you_mean(name, shared))
        yield None


def read_shared(table: Table) -> View:
    """Read a file of parts that several views share."""
    table.known_keys()
    return _read(table)


def _read(table: Table) -> View:
    return View(
        position="",
        upright=False,
        bodies=False,
        other="",
        measures=_measures(table),
        parts=tuple(_part(one) for one in table.tables("part")),
        dimensions=tuple(_dimension(one) for one in table.tables("dimension")),
        labels=tuple(_label(one) for one in table.tables("label")),
        details=tuple(_detail(one) for one in table.tables("detail")),
        characteristics=(),
        requirements=tuple(_requirement(one) for one in table.tables("requirement")),
        density=0.0,
        material=None,
        grades=tuple(_grade(one) for one in table.tables("grade")),
        strength={},
        elastic_modulus={},
        around=None,
        file=table.file,
    )


def _measures(table: Table) -> dict[str, Measure]:
    found: dict[str, Measure] = {}
    for kind, unit in (("length", "mm"), ("angle", "deg"), ("count", "")):
        for name, formulas in _by_name(table, kind).items():
            found[name] = Measure(unit, formulas, table.file, f"{kind}.{name}")
    return found


def _by_name(table: Table, key: str) -> dict[str, tuple[Formula, ...]]:
    inner = table.table(key)
    return {} if inner is None else {name: _alternatives(inner, name) for name in inner.values}


def _alternatives(table: Table, name: str) -> tuple[Formula, ...]:
    texts = table.strings(name) if isinstance(table.values[name], list) else [table.text(name)]
    read = (_formula(table, name, text) for text in texts)
    return tuple(one for one in read if one is not None)


def _part(table: Table) -> ViewPart:
    table.known_keys()
    nameless = table.flag("nameless")
    body = table.flag("body", default=True)
    shapes = tuple(_shape(one, body=body) for one in table.tables("shape"))
    if not shapes:
        table.add("shape", message("This key is missing."), message("Write the shapes."))
    return ViewPart(
        id=table.text("id"),
        title=None if nameless else table.texts("title"),
        mirrored=table.flag("mirror"),
        count=_formula(table, "count", table.text("count")) if table.has("count") else None,
        sizes=table.strings("sizes"),
        material=_material(table),
        mark=() if nameless else _expressions(table, "mark", Need.POINT),
        moves=table.flag("moves"),
        meets=table.strings("meets"),
        touches=table.strings("touches"),
        enters=_formula(table, "enters", table.text("enters")) if table.has("enters") else None,
        positions=table.strings("positions"),
        placed_at=table.text("placed_at", ""),
        depth=_depth(table),
        density=table.number("density", 0.0),
        piece_of=table.text("piece_of", ""),
        shapes=shapes,
        file=table.file,
        key=table.key,
    )


def _material(table: Table) -> Texts | None:
    return table.texts("material") if table.has("material") else None


def _depth(table: Table) -> tuple[Expression, ...]:
    return _expressions(table, "depth", Need.RANGE) if table.has("depth") else ()


def _shape(table: Table, *, body: bool) -> ViewShape:
    kind = _one_of(table, "kind", tuple(SHAPES), None)
    needs = SHAPES.get(kind, {})
    if needs:
        table.known_keys()
    _check_inside(table, kind)
    line = _one_of(table, "line", LINES, LINES[0])
    is_solid = body and kind in CLOSED and line in SOLID_LINES
    return ViewShape(
        kind=kind,
        needs={name: _expressions(table, name, need) for name, need in needs.items()},
        line=line,
        hatch=_one_of(table, "hatch", HATCHES, ""),
        hidden_edges=table.flag("hidden_edges"),
        face=Face(_one_of(table, "face", tuple(Face), Face.MAIN)),
        repeats=tuple(_repeat(one) for one in table.tables("repeat")),
        body=table.flag("body", default=is_solid),
        void=table.flag("void"),
        whole=table.flag("whole"),
        depth=_depth(table),
        key=table.key,
    )


def _check_inside(table: Table, kind: str) -> None:
    """Note a shape without an inside that is to be solid or cut out."""
    open_kind = kind and kind not in CLOSED
    corners = table.values.get("corners")
    is_flat = kind == "polygon" and isinstance(corners, list) and len(corners) == _TWO
    for key in ("body", "void"):
        if (open_kind and table.flag(key)) or (is_flat and key == "body"):
            what = message("The outline is not closed: a '{kind}' has no inside.", kind=kind)
            known = ", ".join(sorted(CLOSED))
            remedy = message(
                "Take a closed shape with three corners or more: {kinds}.", kinds=known
            )
            table.add(key if open_kind else "corners", what, remedy)


def _repeat(table: Table) -> Repeat | Ring:
    table.known_keys()
    count = _formula(table, "count", table.text("count")) or formula_of("1", {})
    if table.has("about"):
        return Ring(count, _expressions(table, "about", Need.POINT))
    return Repeat(count, _expressions(table, "step", Need.POINT))


def _dimension(table: Table) -> ViewDimension:
    table.known_keys()
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
    table.known_keys()
    values = table.table("values")
    return ViewLabel(
        text=table.texts("text"),
        values={name: values.text(name) for name in values.values} if values else {},
        at=_expressions(table, "at", Need.POINT),
        face=Face(_one_of(table, "face", tuple(Face), Face.END)),
        file=table.file,
        key=table.key,
    )


def _detail(table: Table) -> ViewDetail:
    table.known_keys()
    return ViewDetail(
        at=_expressions(table, "at", Need.POINT),
        reach=_expressions(table, "reach", Need.LENGTH)[0],
        is_section=table.flag("section"),
        file=table.file,
        key=table.key,
    )


def _grade(table: Table) -> Grade:
    table.known_keys()
    return Grade(
        yield_stress=table.number("yield"),
        elastic_modulus=table.number("elastic_modulus", 0.0),
        density=table.number("density"),
        material=table.texts("material"),
    )


def _requirement(table: Table) -> Texts:
    table.known_keys()
    return table.texts("text")


def _expressions(table: Table, name: str, need: Need) -> tuple[Expression, ...]:
    """Read formulas in the order x, y, x, y…; where they cannot be read, as many as are needed."""
    written = _flat(table.values.get(name), need)
    known = all(isinstance(one, str) or one == 0 for one in written)
    if known and _fits(len(written), need):
        return tuple(
            _formula(table, name, one) if isinstance(one, str) else None for one in written
        )
    is_absent = name not in table.values
    what = (
        message("This key is missing.") if is_absent else message("The value has the wrong type.")
    )
    table.add(name, what, _REMEDIES[need])
    return (None,) * (2 * _TWO if need is Need.POINTS else _TWO)


def _flat(value: object, need: Need) -> list[object]:
    """Return what is written one after the other: of points x, y, x, y and so on."""
    written: list[object] = list(value) if isinstance(value, list) else [value]
    points = [one for one in written if isinstance(one, list)] if need is Need.POINTS else []
    return [one for point in points for one in point] if points else written


_REMEDIES: Mapping[Need, Message] = {
    Need.POINT: message("Write two formulas or zeros: ['pin_x', 0]."),
    Need.POINTS: message("Write two points or more: [['pin_x', 0], ['pin_x', 'pin_y']]."),
    Need.RANGE: message("Write two formulas or zeros: ['pin_x', 0]."),
    Need.LENGTH: message("Write a formula: '2*radius'."),
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
        return formula_of(text, {}) if text else None
    except FormulaFault as fault:
        table.add(name, fault.what, message("Correct the formula."), caret(text, fault.span))
        return None


def _one_of(table: Table, name: str, known: tuple[str, ...], default: str | None) -> str:
    written = table.text(name, default)
    if written not in known and written:
        what = message("The name '{name}' is not known.", name=written)
        table.add(name, what, did_you_mean(written, known))
        return default or ""
    return written
