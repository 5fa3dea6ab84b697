"""Proofs that a course declares: `variants/proofs.toml`, which a course may do without.

Each `[[proof]]` states something that its schemes must satisfy whatever the numbers are. It is
tried with drawn variants and must not repeat the formulas that it proves: geometry, equilibrium,
another limit. `[[unshown]]` names flipped operators that no number can show; see `operators`.
The keys stand in `keys`.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TypeAlias

from gripcourse.course.model import Course
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import Problem
from gripcourse.formula.parse import FormulaFault, caret, parse
from gripcourse.formula.tree import Formula
from gripcourse.proofs.keys import PROOFS
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import message

FILE = "proofs.toml"
_EXACT, _DERIVED = 1e-9, 1e-6
_STEP = 0.01


@dataclass(frozen=True, slots=True)
class Scope:
    """What a declared proof is about.

    Attributes:
        id: its name.
        schemes: empty for every scheme that has all its names.
        options: that a composition must have.
        settings: numbers instead of a variant's own, in declared units.
        lets: names for parts of its formulas, in order.
        file, key: where it stands, for messages.
    """

    id: str
    schemes: tuple[str, ...]
    options: Mapping[str, str]
    settings: Mapping[str, float]
    lets: Mapping[str, Formula]
    file: str
    key: str


@dataclass(frozen=True, slots=True)
class IdentityProof:
    """Two formulas that must agree within a relative tolerance."""

    scope: Scope
    left: Formula
    right: Formula
    tolerance: float


@dataclass(frozen=True, slots=True)
class Inequality:
    """A condition that must hold."""

    scope: Scope
    condition: Formula


@dataclass(frozen=True, slots=True)
class VirtualWork:
    """A force ratio and the paths whose derivatives it must be.

    Attributes:
        scope: what it is about.
        ratio: effort of the input over the effort of the output.
        parameter: name of what moves, in `input` and `output`.
        unit: of the parameter.
        at: value of the parameter at which `ratio` is declared.
        input, output: paths.
        step: of the derivative, in `unit`.
        tolerance: relative.
    """

    scope: Scope
    ratio: Formula
    parameter: str
    unit: str
    at: Formula
    input: Formula
    output: Formula
    step: float
    tolerance: float


@dataclass(frozen=True, slots=True)
class Travel:
    """A declared path and the coordinate of `[kinematics]` whose change it must be."""

    scope: Scope
    quantity: Formula
    coordinate: str
    start: str
    end: str
    tolerance: float


DeclaredProof: TypeAlias = IdentityProof | Inequality | VirtualWork | Travel


@dataclass(frozen=True, slots=True)
class Unshown:
    """A flipped operator of a quantity that no number can show, and why."""

    quantity: str
    operator: str
    reason: str
    file: str
    key: str


@dataclass(frozen=True, slots=True)
class DeclaredProofs:
    """Everything that a course declares about its proofs."""

    proofs: tuple[DeclaredProof, ...] = ()
    unshown: tuple[Unshown, ...] = ()


def read_declared_proofs(course: Course) -> tuple[DeclaredProofs, list[Problem]]:
    """Read the proofs that can be read, and list what is wrong with the others."""
    problems: list[Problem] = []
    path = course.root / "variants" / FILE
    if not path.exists():
        return DeclaredProofs(), []
    table = read_toml(path, course.root, problems, PROOFS, course.languages)
    if table is None:
        return DeclaredProofs(), problems
    table.known_keys()
    proofs: dict[str, DeclaredProof] = {}
    for one in table.tables("proof"):
        before = len(problems)
        proof = _proof(course, one)
        if proof is not None and proof.scope.id in proofs:
            one.add(
                "id",
                message("Two proofs are named '{id}'.", id=proof.scope.id),
                message("Give each a name of its own."),
            )
        if proof is not None and len(problems) == before:
            proofs[proof.scope.id] = proof
    unshown = tuple(_unshown(one) for one in table.tables("unshown"))
    return DeclaredProofs(tuple(proofs.values()), unshown), problems


def _proof(course: Course, table: Table) -> DeclaredProof | None:
    table.known_keys()
    kind = table.text("kind")
    match kind:
        case "identity":
            return IdentityProof(
                _scope(course, table),
                _formula(table, "left"),
                _formula(table, "right"),
                table.number("tolerance", _EXACT),
            )
        case "inequality":
            return Inequality(_scope(course, table), _formula(table, "condition"))
        case "virtual_work":
            return VirtualWork(
                scope=_scope(course, table),
                ratio=_formula(table, "ratio"),
                parameter=table.text("parameter"),
                unit=_unit(table),
                at=_formula(table, "at"),
                input=_formula(table, "input"),
                output=_formula(table, "output"),
                step=table.number("step", _STEP),
                tolerance=table.number("tolerance", _DERIVED),
            )
        case "travel":
            return Travel(
                scope=_scope(course, table),
                quantity=_formula(table, "quantity"),
                coordinate=table.text("coordinate"),
                start=table.text("start"),
                end=table.text("end"),
                tolerance=table.number("tolerance", _DERIVED),
            )
    if kind:
        table.add(
            "kind",
            message("There is no kind of proof '{kind}'.", kind=kind),
            did_you_mean(kind, ("identity", "inequality", "virtual_work", "travel")),
        )
    return None


def _scope(course: Course, table: Table) -> Scope:
    schemes = table.strings("schemes")
    for name in schemes:
        if name not in course.schemes:
            table.add(
                "schemes",
                message("The course has no scheme '{scheme}'.", scheme=name),
                did_you_mean(name, course.schemes),
            )
    options = table.table("options")
    lets = table.table("let")
    return Scope(
        id=table.text("id"),
        schemes=schemes,
        options={} if options is None else {name: options.text(name) for name in options.values},
        settings=table.numbers("set", {}),
        lets={} if lets is None else {name: _formula(lets, name) for name in lets.values},
        file=table.file,
        key=table.key,
    )


def _formula(table: Table, name: str) -> Formula:
    text = table.text(name)
    try:
        return Formula(text, parse(text), {})
    except FormulaFault as fault:
        if text:
            table.add(name, fault.what, message("Correct the formula."), caret(text, fault.span))
        return Formula("0", parse("0"), {})


def _unit(table: Table) -> str:
    unit = table.text("unit")
    if known_unit(unit):
        return unit
    table.add(
        "unit",
        message("The unit '{unit}' is not known.", unit=unit),
        message("Write it as on the page that 'gripcourse schema' makes, for example 'N*m'."),
    )
    return ""


def _unshown(table: Table) -> Unshown:
    table.known_keys()
    return Unshown(
        table.text("quantity"),
        table.text("operator"),
        table.text("reason"),
        table.file,
        table.key,
    )


def formulas_of(proof: DeclaredProof) -> Iterator[tuple[str, Formula]]:
    """Yield every formula of a proof with its key; the names that it lets stand come first."""
    for name, formula in proof.scope.lets.items():
        yield f"let.{name}", formula
    match proof:
        case IdentityProof(_, left, right):
            yield "left", left
            yield "right", right
        case Inequality(_, condition):
            yield "condition", condition
        case VirtualWork():
            yield "ratio", proof.ratio
            yield "at", proof.at
            yield "input", proof.input
            yield "output", proof.output
        case Travel(_, quantity):
            yield "quantity", quantity


def names_used(proof: DeclaredProof) -> frozenset[str]:
    """Return the ids of the quantities that a proof uses or sets."""
    own = {*proof.scope.lets}
    if isinstance(proof, VirtualWork):
        own.add(proof.parameter)
    used = {name for _, formula in formulas_of(proof) for name in formula.names}
    return frozenset({*(used - own), *proof.scope.settings})
