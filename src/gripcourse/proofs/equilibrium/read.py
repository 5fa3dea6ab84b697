"""Reading `variants/equilibrium/*.toml`: every fault with its file, key and remedy."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import cast, get_args

from gripcourse.course.model import Course
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import Problem
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula
from gripcourse.proofs.equilibrium.keys import EQUILIBRIUM, JOINTS, POINTS
from gripcourse.proofs.equilibrium.model import (
    GROUND,
    Circles,
    Claim,
    Condition,
    Joint,
    JointKind,
    Load,
    Mechanism,
    Place,
    Point,
    Relation,
)
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

FOLDER = "equilibrium"
_ZERO = Formula("0", parse("0"), {})
_PAIR = 2


def read_mechanisms(course: Course) -> tuple[tuple[Mechanism, ...], list[Problem]]:
    """Read the mechanisms that can be read, and list what is wrong with the others."""
    problems: list[Problem] = []
    folder = course.root / "variants" / FOLDER
    found = [_mechanism(course, path, problems) for path in sorted(folder.glob("*.toml"))]
    return tuple(one for one in found if one is not None), problems


def _mechanism(course: Course, path: Path, problems: list[Problem]) -> Mechanism | None:
    before = len(problems)
    table = read_toml(path, course.root, problems, EQUILIBRIUM, course.languages)
    if table is None:
        return None
    table.known_keys()
    schemes = table.strings("schemes")
    for name in schemes:
        _known(table, "schemes", name, course.schemes)
    options = table.table("options")
    positions = _positions(course, table)
    points = {name: _point(one) for name, one in table.named_tables("point").items()}
    bodies = table.strings("bodies")
    found = Mechanism(
        id=path.stem,
        schemes=schemes,
        options={} if options is None else {name: options.text(name) for name in options.values},
        positions=positions,
        lets=_formulas(table.table("let")),
        points={name: one for name, one in points.items() if one is not None},
        bodies=bodies,
        joints=tuple(
            joint
            for name, one in table.named_tables("joint").items()
            if (joint := _joint(name, one, bodies, points)) is not None
        ),
        loads=tuple(
            _load(name, one, bodies, points) for name, one in table.named_tables("load").items()
        ),
        relations=tuple(
            _relation(name, one) for name, one in table.named_tables("relation").items()
        ),
        claims=tuple(_claim(one, positions) for one in table.tables("claim")),
        conditions=tuple(_condition(one, positions) for one in table.tables("condition")),
        file=table.file,
    )
    return found if len(problems) == before else None


def _positions(course: Course, table: Table) -> Mapping[str, Mapping[str, Formula]]:
    found: dict[str, dict[str, Formula]] = {}
    names: set[str] = set()
    for name, one in table.named_tables("position").items():
        _known(one, "", name, course.positions)
        found[name] = _formulas(one)
        if len(found) > 1 and found[name].keys() != names:
            one.add(
                "",
                message("The positions do not give the same names."),
                message("Give each of them a formula of {names}.", names=", ".join(sorted(names))),
            )
        names = names or set(found[name])
    return found or {"": {}}


def _point(table: Table) -> Point | None:
    table = table if table.has("kind") else _with_kind(table)
    table.known_keys()
    match table.text("kind"):
        case "place":
            return Place(_formula(table, "x"), _formula(table, "y"))
        case "circles":
            radii = _pair(table, "radii")
            side = table.text("side")
            _known(table, "side", side, ("left", "right"))
            return Circles(
                around=_pair(table, "around"),
                radii=(_parsed(table, "radii", radii[0]), _parsed(table, "radii", radii[1])),
                is_left=side == "left",
            )
        case kind:
            _known(table, "kind", kind, POINTS)
            return None


def _with_kind(table: Table) -> Table:
    values = {"kind": "place", **table.values}
    return replace(table, values=values)


def _joint(
    name: str, table: Table, bodies: Iterable[str], points: Mapping[str, object]
) -> Joint | None:
    table.known_keys()
    kind = table.text("kind")
    if kind not in JOINTS or kind not in get_args(JointKind):
        _known(table, "kind", kind, JOINTS)
        return None
    between = _pair(table, "between")
    for body in between:
        _known(table, "between", body, (*bodies, GROUND))
    if between[0] == between[1]:
        table.add(
            "between",
            message("A joint connects two bodies."),
            message("Name two different ones, or `ground`."),
        )
    keys = JOINTS[kind]
    if table.has("friction") and table.has("friction_angle"):
        table.add(
            "friction",
            message("Friction is either at its limit or found."),
            message("Write 'friction_angle' or 'friction', not both."),
        )
    places = {key: table.text(key) for key in ("at", "to") if key in keys}
    for key, point in places.items():
        _known(table, key, point, points)
    formulas = {
        key: _formula(table, key)
        for key, one in keys.items()
        if key not in places and (one.required or table.has(key))
    }
    return Joint(
        id=name,
        kind=cast("JointKind", kind),
        between=between,
        at=places.get("at", ""),
        to=places.get("to", ""),
        formulas=formulas,
    )


def _load(name: str, table: Table, bodies: Iterable[str], points: Mapping[str, object]) -> Load:
    table.known_keys()
    on, source = table.text("on"), table.text("from", GROUND)
    _known(table, "on", on, bodies)
    _known(table, "from", source, (*bodies, GROUND))
    if table.has("force") == table.has("moment"):
        table.add(
            "",
            message("A load is a force or a moment."),
            message("Write 'force' with 'at' and 'direction', or 'moment'."),
        )
    if not table.has("force"):
        return Load(name, on, source, "", _formula(table, "moment", required=False), None)
    for key in ("at", "direction"):
        if not table.has(key):
            table.add(
                key,
                message("This key is missing."),
                message("Write 'force' with 'at' and 'direction', or 'moment'."),
            )
    at = table.text("at", "")
    if at:
        _known(table, "at", at, points)
    force = _formula(table, "force", required=False)
    return Load(name, on, source, at, force, _formula(table, "direction", required=False))


def _relation(name: str, table: Table) -> Relation:
    table.known_keys()
    return Relation(name, _formulas(table.required_table("of")), _formula(table, "gives"))


def _claim(table: Table, positions: Mapping[str, object]) -> Claim:
    table.known_keys()
    at = table.text("at", "")
    if at:
        _known(table, "at", at, positions)
    largest = table.flag("largest")
    if at and largest:
        table.add(
            "at",
            message("The largest of all positions has no position."),
            message("Write 'at' or 'largest', not both."),
        )
    return Claim(_formula(table, "quantity"), _formula(table, "is"), at, largest, table.key)


def _condition(table: Table, positions: Mapping[str, object]) -> Condition:
    table.known_keys()
    at = table.text("at", "")
    if at:
        _known(table, "at", at, positions)
    return Condition(_formula(table, "that"), at, table.key)


def _known(table: Table, key: str, name: str, known: Iterable[str]) -> None:
    """Report a name that is none of those that there are."""
    known = tuple(known)
    if name and name not in known:
        table.add(
            key, message("The name '{name}' is not known.", name=name), did_you_mean(name, known)
        )


def _pair(table: Table, key: str) -> tuple[str, str]:
    value = table.values.get(key)
    match value:
        case [str() as first, str() as second]:
            return first, second
        case None:
            what = message("This key is missing.")
        case _:
            what = message("The value has the wrong type.")
    table.add(key, what, message('Write two texts in quotes: ["…", "…"].'))
    return "", ""


def _formulas(table: Table | None) -> dict[str, Formula]:
    return {} if table is None else {name: _formula(table, name) for name in table.values}


def _formula(table: Table, key: str, *, required: bool = True) -> Formula:
    text = table.text(key, None if required else "")
    return _parsed(table, key, text)


def _parsed(table: Table, key: str, text: str) -> Formula:
    if not text:
        return _ZERO
    try:
        return Formula(text, parse(text), {})
    except FormulaFault as fault:
        table.add(key, fault.what, message("Correct the formula."), caret(text, fault.span))
        return _ZERO
