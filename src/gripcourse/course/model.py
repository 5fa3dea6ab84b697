"""A course after loading: frozen values, nothing computed yet.

Values of quantities are kept in the declared unit (as people wrote them); the solver works in SI.
"""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.diagram import Diagram
from gripcourse.course.equations import Equations
from gripcourse.course.errata import Erratum
from gripcourse.course.kinematics import JointPosition, Kinematics
from gripcourse.course.note import CourseNote
from gripcourse.course.option_rule import OptionRule
from gripcourse.course.quantity import Convention, Quantity, Source
from gripcourse.course.view import View
from gripcourse.text.words import Texts


@dataclass(frozen=True, slots=True)
class OptionChoice:
    """One value of an option and the parts that it brings."""

    id: str
    title: Texts
    parts: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Option:
    """Something that a variant chooses, for example the drive; it selects among shared parts.

    Its rules say which choices go with those of other options; they count in the schemes that have
    all of these options.
    """

    id: str
    title: Texts
    choices: tuple[OptionChoice, ...]
    rules: tuple[OptionRule, ...]


@dataclass(frozen=True, slots=True)
class Part:
    """A file of declarations that many schemes share.

    Attributes:
        id: the name of the file.
        quantities: that it declares.
        file: in the course.
        is_empty: whether it says nothing at all: no quantity, no change of one, no kinematics.
    """

    id: str
    quantities: Mapping[str, Quantity]
    file: str
    is_empty: bool = False


@dataclass(frozen=True, slots=True)
class WorkedExample:
    """A calculation published elsewhere, as data.

    Attributes:
        source: where it is printed.
        options: the options it uses.
        given: values of givens and constants, in declared units.
        chosen: design decisions it takes, in declared units, by convention.
        expected: value and tolerated difference of each quantity, in declared units, by convention.
    """

    source: Source
    options: Mapping[str, str]
    given: Mapping[str, float]
    chosen: Mapping[Convention, Mapping[str, float]]
    expected: Mapping[Convention, Mapping[str, tuple[float, float]]]


@dataclass(frozen=True, slots=True)
class Scheme:
    """A kinematic scheme: what it shares, what it declares, what a variant of it chooses.

    Attributes:
        id: name of its folder.
        title: in full.
        task: a sentence for the assignment.
        parts: ids of the parts that every variant has.
        options: what a variant chooses.
        own_rules: rules among its options that it declares itself.
        quantities: its own declarations.
        overrides: declarations of parts as it changes them, by part and quantity.
        optional_overrides: those that parts change which its options bring, by the part that brings
            them besides.
        kinematics: how its links move, its own or that of a part; None where nothing moves.
        example: None where there is none.
        file: the file that declares it, for messages.
    """

    id: str
    title: Texts
    task: Texts
    parts: tuple[str, ...]
    options: tuple[Option, ...]
    own_rules: tuple[OptionRule, ...]
    quantities: Mapping[str, Quantity]
    overrides: Mapping[str, Mapping[str, Quantity]]
    optional_overrides: Mapping[str, Mapping[str, Mapping[str, Quantity]]]
    kinematics: Kinematics | None
    diagram: Diagram | None
    view: View | None
    example: WorkedExample | None
    file: str

    @property
    def rules(self) -> tuple[OptionRule, ...]:
        """The rules among its options: its own, and those that the options bring."""
        mine = {option.id for option in self.options}
        brought = (rule for option in self.options for rule in option.rules)
        return (*self.own_rules, *(one for one in brought if mine.issuperset(one.options)))

    @property
    def changed(self) -> tuple[Mapping[str, Quantity], ...]:
        """Declarations of parts as it or any of its options changes them, part by part."""
        optional = (one for parts in self.optional_overrides.values() for one in parts.values())
        return (*self.overrides.values(), *optional)


@dataclass(frozen=True, slots=True)
class SectionDetail:
    """A sentence of a section's task for variants that have one of some quantities.

    Who takes a scheme out of a course need not touch it: a quantity may be no scheme's.
    """

    quantities: tuple[str, ...]
    text: Texts


@dataclass(frozen=True, slots=True)
class Section:
    """A section of the assignment, in the order in which it is handed out.

    Attributes:
        id: name in declarations.
        title: in full.
        short: what fits a tab of a workbook or a column of a table.
        task: what is to be done in it, whatever the variant.
        details: what is to be done besides, for variants that have it.
    """

    id: str
    title: Texts
    short: Texts
    task: Texts
    details: tuple[SectionDetail, ...] = ()

    def task_of(self, quantities: Collection[str], language: str) -> str:
        """Return what is to be done in a variant with these quantities."""
        details = (
            one.text for one in self.details if not set(one.quantities).isdisjoint(quantities)
        )
        return " ".join(text.of(language) for text in (self.task, *details))


@dataclass(frozen=True, slots=True)
class Work:
    """A work that declarations cite.

    Attributes:
        id: short name in declarations.
        title: of a published work the same in every language, which is the work's own.
        equations: its numbered equations, none where the course does not list them.
        at_hand: whether students have it; what is cited from another is printed for them.
    """

    id: str
    title: Texts
    equations: Equations
    at_hand: bool


@dataclass(frozen=True, slots=True)
class Catalogue:
    """A table of standard sizes.

    Attributes:
        id: its name in formulas.
        columns: in SI, one array per column, all of one length; the first is the size itself.
        units: declared unit of each column.
        source: standard and edition, and how the numbers were obtained.
        file: where it was read.
        title: what students call it, None where nobody wrote it.
        headings: what students call its columns, by name; none for a column that is not theirs.
    """

    id: str
    columns: Mapping[str, NDArray[np.float64]]
    units: Mapping[str, str]
    source: Texts
    file: str
    title: Texts | None
    headings: Mapping[str, Texts]


@dataclass(frozen=True, slots=True, eq=False)
class Course:
    """Everything that an instructor wrote, loaded.

    Two courses are never the same one, so that what was made of one can be remembered by it.

    Attributes:
        id: short name that goes into signatures.
        title: of the course or the assignment.
        language: default language of students' documents.
        languages: that it is written in.
        sections: in order.
        works, errata: cited works, and what is wrong in them.
        constants: quantities every scheme knows, for example gravity.
        parts, schemes, catalogues: by id.
        convention: whose version of a formula is the reference.
        positions: of the drive, that schemes may have, by id in order.
        notes: sentences that its documents print.
        root: the folder with `variants`, `templates` and `grader`.
        address: of its page in the web, that the code on a sheet leads to; empty for none.
    """

    id: str
    title: Texts
    language: str
    languages: tuple[str, ...]
    sections: tuple[Section, ...]
    works: Mapping[str, Work]
    errata: Mapping[str, Erratum]
    constants: Mapping[str, Quantity]
    parts: Mapping[str, Part]
    schemes: Mapping[str, Scheme]
    catalogues: Mapping[str, Catalogue]
    convention: Convention
    positions: Mapping[str, JointPosition]
    notes: tuple[CourseNote, ...]
    root: Path
    address: str

    @property
    def conventions(self) -> tuple[Convention, ...]:
        """Those that differ in this course: without errata nothing is printed otherwise."""
        return tuple(Convention) if self.errata else (Convention.CORRECTED,)

    def declarations(self) -> Iterator[Quantity]:
        """Yield every declaration of parts and schemes; one id may be declared several times."""
        for part in self.parts.values():
            yield from part.quantities.values()
        for scheme in self.schemes.values():
            for own in (scheme.quantities, *scheme.changed):
                yield from own.values()
