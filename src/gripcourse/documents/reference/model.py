"""What the reference prints of a declaration: sentences and boxes of one language."""

from dataclasses import dataclass

from gripcourse.formula.boxes import Box


@dataclass(frozen=True, slots=True)
class NamedValue:
    """A title in another language, with the symbol where that differs too."""

    language: str
    symbol: Box | None
    title: str


@dataclass(frozen=True, slots=True)
class Link:
    """A quantity elsewhere on the page; `version` is its part where several declare the id."""

    anchor: str
    symbol: Box
    title: str
    version: str


@dataclass(frozen=True, slots=True)
class Citation:
    """A source: title of the work, its equation, a note."""

    work: str
    equation: str
    note: str


@dataclass(frozen=True, slots=True)
class BringingOption:
    """An option and the titles of its choices that bring a declaration."""

    option: str
    choices: str


@dataclass(frozen=True, slots=True)
class EntryRule:
    """The rule of a decision.

    Attributes:
        series, also: preferred and further series, as `catalogue.column`.
        rounding: which entry is the reference.
        steps: how far above it an entry may lie.
        condition: what the chosen entry must satisfy too, None for nothing more.
    """

    series: str
    also: tuple[str, ...]
    rounding: str
    steps: str
    condition: Box | None


@dataclass(frozen=True, slots=True)
class WrongMethod:
    """An anticipated slip: what is computed, and what the student is told."""

    formula: Box
    hint: str
    credit: str


@dataclass(frozen=True, slots=True)
class Printed:
    """A version as a source prints it; `rounding` where only that differs."""

    erratum: str
    formula: Box | None
    rounding: str
    note: str


@dataclass(frozen=True, slots=True)
class ReferenceEntry:
    """One declaration, ready to print.

    Attributes:
        anchor, id: its place on the page and its name in declarations.
        kind, unit, bounds, tolerance: in words; empty where there is none.
        symbol, title, others: in the language of the page and in the others.
        part, when, changed: where it is declared (no part: the scheme, or the course itself),
            what brings it, whether the scheme changes it.
        of_course: whether the course declares it for all schemes.
        formula: what it says, None for given and manual quantities.
        entering: symbol and unit of each bare number of an empirical formula.
        value: of a constant, else empty.
        guard: what a student's value must satisfy to be carried on.
        rule: of a decision.
        rubric: of a manual item, else empty.
        explain: how to think about it, else empty.
        source: where it comes from.
        inputs, users: what it is computed from, and what is computed from it.
        slips, printed: wrong methods and versions as printed.
    """

    anchor: str
    id: str
    kind: str
    unit: str
    bounds: str
    tolerance: str
    symbol: Box | None
    title: str
    others: tuple[NamedValue, ...]
    part: str
    when: tuple[BringingOption, ...]
    changed: bool
    of_course: bool
    formula: Box | None
    entering: tuple[tuple[Box, str], ...]
    value: str
    guard: Box | None
    rule: EntryRule | None
    rubric: str
    explain: str
    source: Citation
    inputs: tuple[Link, ...]
    users: tuple[Link, ...]
    slips: tuple[WrongMethod, ...]
    printed: tuple[Printed, ...]
