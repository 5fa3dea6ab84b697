"""Boxes: what a printed formula is made of, and the printed forms of functions.

A box knows how a formula looks, not how a page is written: `markup` turns boxes into HTML and text.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal, TypeAlias

from gripcourse.text.conventions import is_english

Kind: TypeAlias = Literal["number", "variable", "upright", "operator", "relation", "times", "mark"]
"""How a run of text is set: `variable` in italics, `operator` and `relation` with spaces round,
`times` a multiplication sign (empty for juxtaposition), `mark` any other sign, without spaces."""


@dataclass(frozen=True, slots=True)
class Text:
    """A run of text of one kind."""

    kind: Kind
    text: str


@dataclass(frozen=True, slots=True)
class Value:
    """A number that stands for a quantity, with its unit as people write it, or none."""

    number: str
    unit: str

    @property
    def negative(self) -> bool:
        """Whether it begins with a minus sign."""
        return self.number.startswith(("-", "−"))


@dataclass(frozen=True, slots=True)
class Row:
    """Boxes side by side."""

    items: tuple["Box", ...]


@dataclass(frozen=True, slots=True)
class Fraction:
    """One box over another with a bar between."""

    top: "Box"
    bottom: "Box"


@dataclass(frozen=True, slots=True)
class Root:
    """A radical; `index` is empty for a square root."""

    body: "Box"
    index: str


@dataclass(frozen=True, slots=True)
class Script:
    """A base with a subscript, a superscript, or both."""

    base: "Box"
    sub: "Box | None"
    sup: "Box | None"


@dataclass(frozen=True, slots=True)
class Fence:
    """A box between brackets or bars."""

    left: str
    body: "Box"
    right: str


@dataclass(frozen=True, slots=True)
class Applied:
    """A function with an upright name: `sin α`, `sin² α`, `max(a; b)`.

    Attributes:
        word: the name.
        arguments: what it is applied to.
        power: exponent between the name and the arguments, None for none.
    """

    word: str
    arguments: tuple["Box", ...]
    power: "Box | None" = None


Box: TypeAlias = Text | Value | Row | Fraction | Root | Script | Fence | Applied

Form: TypeAlias = Callable[[tuple[Box, ...], Box | None, str], Box]
"""Printed form of a function: from the boxes of its arguments, the box of the catalogue's column
that it reads, and the reader's language."""


def inner(box: Box) -> tuple[Box, ...]:
    """Return the boxes directly inside a box, in reading order."""
    match box:
        case Row(items):
            return items
        case Fraction(top, bottom):
            return (top, bottom)
        case Root(body) | Fence(_, body):
            return (body,)
        case Script(base, sub, sup):
            return tuple(part for part in (base, sub, sup) if part is not None)
        case Applied(_, arguments, power):
            return arguments if power is None else (power, *arguments)
        case _:
            return ()


def boxes(box: Box) -> Iterator[Box]:
    """Yield a box and all boxes inside it."""
    yield box
    for part in inner(box):
        yield from boxes(part)


def word(name: str, elsewhere: str = "", **own: str) -> Form:
    """Print a function by an upright name.

    Args:
        name: in English.
        elsewhere: in the other languages where it differs, as in tan and tg.
        own: by language that has a name of its own.
    """

    def form(arguments: tuple[Box, ...], _column: Box | None, language: str) -> Box:
        usual = name if is_english(language) else elsewhere or name
        return Applied(own.get(language, usual), arguments)

    return form


def called(name: str) -> Form:
    """Print a function of one argument by an upright name that nobody knows without brackets."""

    def form(arguments: tuple[Box, ...], _column: Box | None, _language: str) -> Box:
        return Row((Text("upright", name), Fence("(", arguments[0], ")")))

    return form


def root(index: str) -> Form:
    """Print a function as a radical."""

    def form(arguments: tuple[Box, ...], _column: Box | None, _language: str) -> Box:
        return Root(arguments[0], index)

    return form


def bars(arguments: tuple[Box, ...], _column: Box | None, _language: str) -> Box:
    """Print an absolute value."""
    return Fence("|", arguments[0], "|")


def hypotenuse(arguments: tuple[Box, ...], _column: Box | None, _language: str) -> Box:
    """Print the root of a sum of squares."""
    squares = (power_box(part, Text("number", "2")) for part in arguments)
    items: list[Box] = []
    for square in squares:
        items += [Text("operator", "+"), square] if items else [square]
    return Root(Row(tuple(items)), "")


def entry(sign: str, before: str) -> Form:
    """Print the choice of a catalogue's entry, as in `min{D ≥ x}`: no words, so no language."""

    def form(arguments: tuple[Box, ...], column: Box | None, _language: str) -> Box:
        relation = (
            (Text("mark", f"{sign} "),) if column is None else (column, Text("relation", sign))
        )
        fence = Fence("{", Row((*relation, arguments[0])), "}")
        return Row((Text("upright", before), fence)) if before else fence

    return form


def reading(arguments: tuple[Box, ...], column: Box | None, _language: str) -> Box:
    """Print a table's column at a size: `b(D)`."""
    fence = Fence("(", arguments[0], ")")
    return fence if column is None else Row((column, fence))


def power_box(base: Box, exponent: Box) -> Box:
    """Give a box an exponent, with brackets round everything but a lone sign."""
    match base:
        case Script(inner_base, sub, None):
            return Script(inner_base, sub, exponent)
        case Value(_, "") if not base.negative and "·" not in base.number:
            return Script(base, None, exponent)
        case Text(_, text) if "·" not in text:
            return Script(base, None, exponent)
        case Fence():
            return Script(base, None, exponent)
        case _:
            return Script(Fence("(", base, ")"), None, exponent)
