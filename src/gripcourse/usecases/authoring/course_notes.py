"""What an author should know of a valid course: what nothing uses in it, and what nothing proves.

None of it is wrong: a rubric may wait for its drawing, a table for its formula. It is a note, and
hinders nothing; but whoever misspelt a name, or took a formula out, learns of what was left behind.
"""

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from gripcourse.course.compose import all_part_ids
from gripcourse.course.implied_series import is_implied
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Quantity
from gripcourse.course.toml_faults import toml_values
from gripcourse.errors import Problem
from gripcourse.machine.resources import REQUIRED_FOLDERS, VARIANTS
from gripcourse.policy.rubric_load import rubric_folder
from gripcourse.proofs.published_cases import read_published_cases
from gripcourse.text.words import LANGUAGES, Message, message

_COURSE: Final = f"{VARIANTS}/course.toml"
_PROSE: Final = frozenset({*LANGUAGES, "explain", "hint", "symbol", "text", "title", "unit"})
_WORDS: Final = re.compile(r"\w+")
_COLUMNS: Final = re.compile(r"(\w+)\.\w")


@dataclass(frozen=True, slots=True)
class _Written:
    """A text of a file that is no sentence: a formula, a name, a word of ours.

    Attributes:
        file: in the course.
        key: that holds it, without those above.
        text: itself.
    """

    file: str
    key: str
    text: str


def course_notes(course: Course) -> list[Problem]:
    """Return what of a course without problems nothing uses, and the schemes that nothing proves.

    Args:
        course: as it was read from its folder.
    """
    written = tuple(_written_in(course.root))
    return [*example_notes(course, course.schemes.values()), *_unused(course, written)]


def example_notes(course: Course, schemes: Iterable[Scheme]) -> Iterator[Problem]:
    """Yield the schemes without a worked example that says what comes out.

    Args:
        course: without problems.
        schemes: some of its own.
    """
    cases, _ = read_published_cases(course)
    proved = {one.scheme for one in cases}
    for scheme in schemes:
        file = f"{scheme.file.removesuffix('scheme.toml')}worked_example.toml"
        if scheme.example is not None:
            if scheme.id not in proved and not any(scheme.example.expected.values()):
                what = message("The example expects no number: nothing proves the formulas.")
                remedy = message("Write under [corrected.expected] what comes out.")
                yield Problem(file, "corrected.expected", what, remedy)
            continue
        what = message("The scheme has no worked example: no document is tried with it.")
        if scheme.id not in proved:
            what = message(
                "The scheme has no worked example: nothing proves its formulas, and no document is"
                " tried with it."
            )
        remedy = message(
            "Write this file from a published calculation, or from one that was made by another way"
            " than the formulas; `gripcourse schema` lists its keys."
        )
        yield Problem(file, "", what, remedy)


def _unused(course: Course, written: Collection[_Written]) -> Iterator[Problem]:
    declared = tuple(course.declarations())
    yield from _unused_files(course, declared, written)
    yield from _unused_errata(course, declared)
    named = {word for one in written for word in _WORDS.findall(one.text)}
    yield from _unnamed(
        ((f"constant.{name}", one.file) for name, one in course.constants.items()),
        named,
        message("No formula uses this constant."),
    )
    cited = {one.text for one in written if one.key == "work"}
    works = ((f"work.{name}", _COURSE) for name in course.works)
    yield from _unnamed(works, cited, message("Nothing cites this work."))
    moving = (one.kinematics for one in course.schemes.values() if one.kinematics is not None)
    taken = {position for motion in moving for position in motion.at}
    positions = ((f"position.{name}", _COURSE) for name in course.positions)
    yield from _unnamed(positions, taken, message("No scheme has this position."))
    yield from _unprinted(course)


def _unused_files(
    course: Course, declared: Iterable[Quantity], written: Collection[_Written]
) -> Iterator[Problem]:
    """Yield the rubrics, catalogues and shared drawings that nothing names."""
    asked = {one.rubric for one in declared}
    for path in sorted(rubric_folder(course.root).glob("*.toml")):
        if path.stem not in asked:
            what = message("No item is marked by this rubric.")
            remedy = message("Name it as `rubric` of an item, or remove the file.")
            yield Problem(path.relative_to(course.root).as_posix(), "", what, remedy)
    read = {name for one in written for name in _COLUMNS.findall(one.text)}
    for catalogue in course.catalogues.values():
        if catalogue.id not in read and not is_implied(catalogue):
            what = message("Nothing reads this table.")
            remedy = message("Read it in a series or a formula, or remove the file.")
            yield Problem(catalogue.file, "", what, remedy)
    for folder, file, keys in (
        ("drawing", "drawing.toml", ("behind", "before")),
        ("diagram", "diagram.toml", ("shared",)),
    ):
        taken = {one.text for one in written if one.key in keys and one.file.endswith(f"/{file}")}
        for path in sorted((course.root / VARIANTS / folder).glob("*.toml")):
            if path.stem not in taken:
                what = message("No {file} takes this shared file.", file=file)
                remedy = message(
                    "Name it under {keys} of a scheme's {file}, or remove it.",
                    keys=" / ".join(f"`{one}`" for one in keys),
                    file=file,
                )
                yield Problem(path.relative_to(course.root).as_posix(), "", what, remedy)


def _unused_errata(course: Course, declared: Iterable[Quantity]) -> Iterator[Problem]:
    versions = {printed.erratum for one in declared for printed in one.as_printed}
    for name, erratum in course.errata.items():
        if name not in versions and erratum.no_version is None:
            what = message("No quantity declares what is printed by this erratum.")
            remedy = message(
                "Declare it with [[quantity.….as_printed]], or say under `no_version` why none"
                " does."
            )
            yield Problem(f"{VARIANTS}/errata.toml", f"erratum.{name}", what, remedy)


def _unnamed(
    places: Iterable[tuple[str, str]], named: Collection[str], what: Message
) -> Iterator[Problem]:
    """Yield what nobody names, of things by key and file whose key ends with their name."""
    for key, file in places:
        if key.partition(".")[2] not in named:
            yield Problem(file, key, what, message("Use it, or remove it."))


def _unprinted(course: Course) -> Iterator[Problem]:
    """Yield the sentences that no variant prints, as no scheme has the quantities they wait for."""
    remedy = message("Name quantities that a scheme has, or remove the sentence.")
    had = {name: set(_quantities_of(course, one)) for name, one in course.schemes.items()}
    for note in course.notes:
        schemes = note.schemes or tuple(had)
        if note.quantities and all(had[one].isdisjoint(note.quantities) for one in schemes):
            what = message("No scheme that the note concerns has one of these quantities.")
            yield Problem(_COURSE, f"{note.key}.quantities", what, remedy)
    every = set[str]().union(*had.values())
    for at, section in enumerate(course.sections, 1):
        for number, detail in enumerate(section.details, 1):
            if every.isdisjoint(detail.quantities):
                key = f"section[{at}].detail[{number}].quantities"
                what = message("No scheme has one of these quantities.")
                yield Problem(_COURSE, key, what, remedy)


def _quantities_of(course: Course, scheme: Scheme) -> Iterator[str]:
    yield from scheme.quantities
    for part in all_part_ids(scheme):
        yield from course.parts[part].quantities


def _written_in(root: Path) -> Iterator[_Written]:
    for folder in REQUIRED_FOLDERS:
        for path in sorted((root / folder).rglob("*.toml")):
            file = path.relative_to(root).as_posix()
            values = dict(toml_values(path, file, []) or {})
            if file == _COURSE:
                values.pop("constant", None)  # what a constant says of itself does not use it
            yield from _texts(values, file, "")


def _texts(value: object, file: str, key: str) -> Iterator[_Written]:
    """Yield the texts of a value but those for people: prose may hold any word."""
    if isinstance(value, Mapping):
        for name, inside in value.items():
            if name not in _PROSE:
                yield from _texts(inside, file, name)
    elif isinstance(value, list):
        for inside in value:
            yield from _texts(inside, file, key)
    elif isinstance(value, str):
        yield _Written(file, key, value)
