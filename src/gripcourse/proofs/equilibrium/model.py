"""A mechanism as an author declares it: points, bodies, joints, loads, and what must follow."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final, Literal, TypeAlias

from gripcourse.formula.tree import Formula

GROUND: Final = "ground"
JointKind: TypeAlias = Literal[
    "pin", "weld", "slider", "force", "slot", "contact", "mesh", "link", "couple", "row", "grid"
]


@dataclass(frozen=True, slots=True)
class Place:
    """A point by its coordinates."""

    x: Formula
    y: Formula


@dataclass(frozen=True, slots=True)
class Circles:
    """A point by its distances from two others, on one side of the way between them."""

    around: tuple[str, str]
    radii: tuple[Formula, Formula]
    is_left: bool


Point: TypeAlias = Place | Circles


@dataclass(frozen=True, slots=True)
class Joint:
    """What two bodies do to each other.

    Attributes:
        id: its name; its reactions are named after it.
        kind: what it can carry.
        between: the body on which the forces act, and the one on which their opposites act.
        at, to: points; empty where the kind has none.
        formulas: by key.
    """

    id: str
    kind: JointKind
    between: tuple[str, str]
    at: str
    to: str
    formulas: Mapping[str, Formula]

    @property
    def is_rough(self) -> bool:
        """Whether a contact has a tangential force of its own, below its limit."""
        return "friction" in self.formulas

    @property
    def unknowns(self) -> tuple[str, ...]:
        """The last parts of the names of what it carries independently of each other."""
        if self.is_rough:
            return ("normal", "tangent")
        return _UNKNOWNS[self.kind]

    @property
    def results(self) -> tuple[str, ...]:
        """The last parts of the names of what follows from them."""
        if self.is_rough:
            return ("force",)
        return _RESULTS.get(self.kind, ())


_UNKNOWNS: Final[Mapping[JointKind, tuple[str, ...]]] = {
    "pin": ("x", "y"),
    "weld": ("x", "y", "moment"),
    "slider": ("normal", "moment"),
    "force": ("force",),
    "slot": ("normal",),
    "contact": ("normal",),
    "mesh": ("tangent",),
    "link": ("force",),
    "couple": ("moment",),
    "row": ("mean", "slope"),
    "grid": ("x", "y", "turn"),
}
_RESULTS: Final[Mapping[JointKind, tuple[str, ...]]] = {
    "pin": ("force",),
    "weld": ("force",),
    "slot": ("tangent", "force"),
    "contact": ("tangent", "force"),
    "mesh": ("normal", "force"),
    "row": ("largest",),
    "grid": ("largest",),
}
MOMENTS: Final = frozenset({"moment"})
"""Last parts of the names that measure moments; all others are forces."""


@dataclass(frozen=True, slots=True)
class Load:
    """A known force or moment on a body, from another or from outside.

    Attributes:
        id: its name.
        on, source: bodies; the source is `ground` where nothing else is written.
        at: a point; empty for a moment.
        amount: the force or the moment.
        direction: angle of the force; None for a moment.
    """

    id: str
    on: str
    source: str
    at: str
    amount: Formula
    direction: Formula | None


@dataclass(frozen=True, slots=True)
class Relation:
    """A sum of reactions, each times a factor, and what it gives."""

    id: str
    factors: Mapping[str, Formula]
    gives: Formula


@dataclass(frozen=True, slots=True)
class Claim:
    """A quantity and the reactions that it must be.

    Attributes:
        quantity, actual: formulas that must agree.
        at: the only position it is about; empty for each.
        largest: whether it is about the largest of all positions instead.
        key: where it stands.
    """

    quantity: Formula
    actual: Formula
    at: str
    largest: bool
    key: str


@dataclass(frozen=True, slots=True)
class Condition:
    """A comparison that must hold, at one position or, where `at` is empty, at each."""

    that: Formula
    at: str
    key: str


@dataclass(frozen=True, slots=True)
class Mechanism:
    """Free bodies in given positions, and what must follow from their equilibrium.

    Attributes:
        id: name of the file.
        schemes: empty for all that have its names.
        options: that a composition must have.
        positions: formulas by name, by position; one position without a name where none is written.
        lets, points: by name, in any order.
        bodies: by name.
        joints, loads, relations: in order.
        claims, conditions: what must follow.
        file: where it is declared.
    """

    id: str
    schemes: tuple[str, ...]
    options: Mapping[str, str]
    positions: Mapping[str, Mapping[str, Formula]]
    lets: Mapping[str, Formula]
    points: Mapping[str, Point]
    bodies: tuple[str, ...]
    joints: tuple[Joint, ...]
    loads: tuple[Load, ...]
    relations: tuple[Relation, ...]
    claims: tuple[Claim, ...]
    conditions: tuple[Condition, ...]
    file: str

    @property
    def unknowns(self) -> tuple[str, ...]:
        """Names of all unknown reactions, in the order of the equations' columns."""
        return tuple(f"{one.id}_{last}" for one in self.joints for last in one.unknowns)

    @property
    def equation_count(self) -> int:
        """How many equations there are: three for each body, and the relations."""
        return 3 * len(self.bodies) + len(self.relations)

    @property
    def placed(self) -> frozenset[str]:
        """Names that positions, lets and points give."""
        state = {name for one in self.positions.values() for name in one}
        return frozenset({*state, *self.lets, *(f"{p}_{c}" for p in self.points for c in "xy")})

    @property
    def reactions(self) -> frozenset[str]:
        """Names that the solution gives."""
        return frozenset(
            f"{one.id}_{last}" for one in self.joints for last in (*one.unknowns, *one.results)
        )


def judged_of(mechanism: Mechanism) -> tuple[Claim | Condition, ...]:
    """Return the claims and conditions of a mechanism."""
    return (*mechanism.claims, *mechanism.conditions)


def placing_formulas(mechanism: Mechanism) -> Iterator[tuple[str, Formula]]:
    """Yield the formulas of positions, lets and points with their keys."""
    for position, state in mechanism.positions.items():
        for name, formula in state.items():
            yield f"position.{position}.{name}", formula
    for name, formula in mechanism.lets.items():
        yield f"let.{name}", formula
    for name, point in mechanism.points.items():
        yield from formulas_of_point(name, point)


def formulas_of_point(name: str, point: Point) -> Iterator[tuple[str, Formula]]:
    """Yield the formulas that place a point, with their keys."""
    match point:
        case Place(x, y):
            yield f"point.{name}.x", x
            yield f"point.{name}.y", y
        case Circles(_, radii):
            for radius in radii:
                yield f"point.{name}.radii", radius


def acting_formulas(mechanism: Mechanism) -> Iterator[tuple[str, Formula]]:
    """Yield the formulas of joints, loads and relations with their keys."""
    for joint in mechanism.joints:
        for key, formula in joint.formulas.items():
            yield f"joint.{joint.id}.{key}", formula
    for load in mechanism.loads:
        yield f"load.{load.id}.{'moment' if load.direction is None else 'force'}", load.amount
        if load.direction is not None:
            yield f"load.{load.id}.direction", load.direction
    for relation in mechanism.relations:
        for name, formula in relation.factors.items():
            yield f"relation.{relation.id}.of.{name}", formula
        yield f"relation.{relation.id}.gives", relation.gives


def judging_formulas(one: Claim | Condition) -> tuple[tuple[str, Formula], ...]:
    """Return the formulas of a claim or a condition with their keys."""
    match one:
        case Claim(quantity, actual):
            return (f"{one.key}.quantity", quantity), (f"{one.key}.is", actual)
        case Condition(that):
            return ((f"{one.key}.that", that),)


def names_used(mechanism: Mechanism, one: Claim | Condition | None = None) -> frozenset[str]:
    """Return the ids of the quantities that a mechanism needs, and one of its claims with it."""
    formulas = [*placing_formulas(mechanism), *acting_formulas(mechanism)]
    if one is not None:
        formulas += judging_formulas(one)
    used = {name for _, formula in formulas for name in formula.names}
    return frozenset(used - mechanism.placed - mechanism.reactions)
