"""The tree of a formula: five frozen nodes.

A node remembers its place in the text (`span`), so that a fault can be shown with a caret. Two
nodes are equal when they say the same, wherever they stand.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias

Span: TypeAlias = tuple[int, int]
"""First and one-past-last character of a node in the formula's text."""

Operator: TypeAlias = Literal["+", "-", "*", "/", "**", "<", "<=", ">", ">=", "==", "and"]

_NOWHERE: Span = (0, 0)
_TWO = 2


@dataclass(frozen=True, slots=True)
class Number:
    """A number as it was typed."""

    value: float
    text: str
    span: Span = field(default=_NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Name:
    """The id of a quantity, or the constant `pi`."""

    id: str
    span: Span = field(default=_NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Negation:
    """Unary minus."""

    operand: "Node"
    span: Span = field(default=_NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Operation:
    """Arithmetic, a comparison, or `and` between comparisons."""

    operator: Operator
    left: "Node"
    right: "Node"
    span: Span = field(default=_NOWHERE, compare=False)


@dataclass(frozen=True, slots=True)
class Call:
    """A registered function; `column` is the `catalogue.column` that it reads, if any."""

    function: str
    arguments: tuple["Node", ...]
    column: str | None = None
    span: Span = field(default=_NOWHERE, compare=False)


Node: TypeAlias = Number | Name | Negation | Operation | Call


@dataclass(frozen=True, slots=True)
class Formula:
    """A formula: its text, its tree, and the units of an empirical one.

    Attributes:
        text: as the author wrote it.
        tree: what it means.
        units: for an empirical formula, the unit in which each name enters; empty otherwise. The
            result of an empirical formula is in the quantity's own unit.
        names: ids of the quantities that it uses, each once, in order of appearance. Kept, because
            a course has hundreds of compositions and each asks for them.
        made: what was made of it once, to compute it: by whoever made it, and never sent away.
    """

    text: str
    tree: Node
    units: Mapping[str, str]
    names: tuple[str, ...] = field(init=False, repr=False, compare=False)
    made: dict[str, Callable[..., Any]] = field(
        init=False, repr=False, compare=False, default_factory=dict
    )

    def __post_init__(self) -> None:
        """Find the names once."""
        object.__setattr__(self, "names", names(self.tree))

    def __reduce__(self) -> tuple[Callable[..., "Formula"], tuple[object, ...]]:
        # Not by a state: Python before 3.11.4 puts its own in the place of ours.
        return with_names, (self.text, self.tree, dict(self.units), self.names)


def with_names(text: str, tree: Node, units: Mapping[str, str], names: tuple[str, ...]) -> Formula:
    """Make a formula whose names are known; a course has thousands, whose trees need no walk."""
    made = object.__new__(Formula)
    values = {"text": text, "tree": tree, "units": units, "names": names, "made": {}}
    for name, value in values.items():
        object.__setattr__(made, name, value)
    return made


CONSTANTS: frozenset[str] = frozenset({"pi"})


def children(node: Node) -> tuple[Node, ...]:
    """Return the nodes directly below a node, left to right."""
    match node:
        case Name() | Number():
            return ()
        case Operation(_, left, right):
            return (left, right)
        case Negation(operand):
            return (operand,)
        case Call(_, arguments):
            return arguments


def walk(node: Node) -> Iterator[Node]:
    """Yield a node and everything below it, in reading order of the parents."""
    waiting = [node]
    while waiting:
        one = waiting.pop()
        yield one
        waiting.extend(reversed(children(one)))


def names(node: Node) -> tuple[str, ...]:
    """Return the ids of the quantities that a formula uses, each once, in order of appearance."""
    found = {part.id: None for part in walk(node) if isinstance(part, Name)}
    return tuple(name for name in found if name not in CONSTANTS)


def form(node: Node) -> tuple[object, ...]:
    """Return what two formulas have in common that compute alike with other quantities.

    Quantities count by their places alone: `a*(b - c)/c` has the form of `d*(e - f)/f`, and not
    that of `a*(b - c)/b`.
    """
    places = {name: place for place, name in enumerate(names(node))}
    return tuple(_said(part, places) for part in walk(node))


def _said(node: Node, places: Mapping[str, int]) -> tuple[object, ...]:
    match node:
        case Name(name):
            return ("name", places.get(name, name))
        case Number(value):
            return ("number", value)
        case Operation(operator, _, _):
            return ("operation", operator)
        case Negation(_):
            return ("negation",)
        case Call(function, arguments, column):
            return ("call", function, len(arguments), column)


def choices_of_two(node: Node) -> Iterator[Call]:
    """Yield the calls that take the greater or lesser of two values, each of other quantities."""
    for part in walk(node):
        if isinstance(part, Call) and part.function in {"max", "min"}:
            used = [set(names(one)) for one in part.arguments]
            if len(used) == _TWO and used[0] - used[1] and used[1] - used[0]:
                yield part
