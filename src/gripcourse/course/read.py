"""Reading the files of a course: what cannot be read is a problem, and everything is looked at."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from gripcourse.course.catalogue import read_catalogue
from gripcourse.course.compose import inherited
from gripcourse.course.dashes import without_dashes
from gripcourse.course.declare import declare
from gripcourse.course.diagram import Element, read_elements
from gripcourse.course.equations import read_equations
from gripcourse.course.errata import Erratum, read_errata
from gripcourse.course.implied_series import with_implied_series
from gripcourse.course.keys import COURSE, PART, SHARED_DIAGRAM
from gripcourse.course.kinematics import read_kinematics, read_positions
from gripcourse.course.model import Catalogue, Course, Part, Scheme, Section, SectionDetail, Work
from gripcourse.course.note import read_notes
from gripcourse.course.options import read_options, spare_options
from gripcourse.course.override import RawPart
from gripcourse.course.quantity import Convention, Quantity
from gripcourse.course.scheme import Shared, read_scheme
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.course.view import View
from gripcourse.course.view_keys import SHARED_VIEW
from gripcourse.course.view_read import read_shared
from gripcourse.errors import CourseError, Problem
from gripcourse.machine.enclosed import strange_files
from gripcourse.machine.resources import COURSE_FOLDERS, VARIANTS
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, message


def read_course(root: Path) -> tuple[Course | None, list[Problem]]:
    """Read all files of a course; what cannot be read is a problem, not an exception.

    Returns:
        The course, None where a file could not be read at all (whoever checked a course with such a
        gap would report everything that uses what is missing); and all problems of single files.
    """
    problems = strange_files(root, COURSE_FOLDERS)
    if problems:
        return None, problems
    folder = root / VARIANTS
    table = read_toml(folder / "course.toml", root, problems, COURSE)
    if table is None:
        return None, problems
    languages = _languages(table)
    table = replace(table, languages=languages)
    table.known_keys()
    parts, raw = _parts(folder / "sections", root, languages, problems)
    errata = read_errata(folder / "errata.toml", root, problems, languages)
    course = inherited(
        Course(
            id=table.text("id"),
            title=table.texts("title"),
            language=_language(table),
            languages=languages,
            sections=_sections(table),
            works=_works(table),
            errata=errata or {},
            constants=_quantities(table.named_tables("constant"), constant=True),
            parts=parts,
            schemes=_schemes(folder, root, raw, languages, problems),
            catalogues=_catalogues(folder / "catalogues", root, languages, problems),
            convention=_convention(table, errata),
            positions=read_positions(table),
            notes=read_notes(table),
            root=root,
            address=table.text("address", ""),
        )
    )
    is_whole = errata is not None and _is_whole(course, folder)
    return with_implied_series(course) if is_whole else None, problems


def course_id(root: Path) -> str:
    """Return the id of a course, whatever else of it is wrong.

    Raises:
        CourseError: its main file cannot be read, or has no id.
    """
    return _of_main_file(root, lambda table: table.text("id"))


def course_address(root: Path) -> str:
    """Return the address of a course's page, whatever else of it is wrong; empty for none.

    Raises:
        CourseError: its main file cannot be read, or the address is no text.
    """
    return _of_main_file(root, lambda table: table.text("address", ""))


def _of_main_file(root: Path, read: Callable[[Table], str]) -> str:
    problems: list[Problem] = []
    table = read_toml(root / VARIANTS / "course.toml", root, problems, COURSE)
    found = "" if table is None else read(table)
    if problems:
        raise CourseError(problems)
    return found


def _is_whole(course: Course, folder: Path) -> bool:
    """Tell whether every file of the course could be read."""
    return (
        bool(course.schemes)
        and len(course.parts) == len(list((folder / "sections").glob("*.toml")))
        and len(course.catalogues) == len(list((folder / "catalogues").glob("*.csv")))
        and all(path.name in course.schemes for path in _scheme_folders(folder / "schemes"))
    )


def _parts(
    folder: Path, root: Path, languages: Sequence[str], problems: list[Problem]
) -> tuple[dict[str, Part], dict[str, RawPart]]:
    """Read the shared parts; the raw tables too, because a scheme may override single keys."""
    parts: dict[str, Part] = {}
    raw: dict[str, RawPart] = {}
    for path in sorted(folder.glob("*.toml")):
        table = read_toml(path, root, problems, PART, languages)
        if table is None:
            continue
        table.known_keys()
        motion = table.table("kinematics")
        written = table.named_tables("quantity")
        changes = table.named_tables("override")
        raw[path.stem] = RawPart(
            {without_dashes(name): one for name, one in written.items()},
            changes,
            None if motion is None else read_kinematics(motion),
        )
        is_empty = not (written or changes or motion)
        parts[path.stem] = Part(path.stem, _quantities(written), table.file, is_empty)
    return parts, raw


def _quantities(tables: Mapping[str, Table], *, constant: bool = False) -> dict[str, Quantity]:
    declared = (declare(name, table, constant=constant) for name, table in tables.items())
    return {one.id: one for one in declared}


def _scheme_folders(folder: Path) -> list[Path]:
    return sorted(path for path in folder.iterdir() if path.is_dir()) if folder.is_dir() else []


def _schemes(
    folder: Path,
    root: Path,
    raw: Mapping[str, RawPart],
    languages: Sequence[str],
    problems: list[Problem],
) -> dict[str, Scheme]:
    options = folder / "options"
    shared = Shared(
        parts=raw,
        options=read_options(options, root, problems, languages),
        drawings=_drawings(folder / "drawing", root, languages, problems),
        symbols=_symbols(folder / "diagram", root, problems),
        languages=languages,
    )
    paths = _scheme_folders(folder / "schemes")
    found = (read_scheme(path, root, shared, problems) for path in paths)
    schemes = {scheme.id: scheme for scheme in found if scheme is not None}
    if paths and len(schemes) == len(paths):  # else one that is not read may list it
        problems += spare_options(
            shared.options, schemes.values(), options.relative_to(root).as_posix()
        )
    if not paths:
        problems.append(
            Problem(
                str((folder / "schemes").relative_to(root)),
                "",
                message("The course has no scheme."),
                message("Write at least one folder with a scheme.toml."),
            )
        )
    return schemes


def _drawings(
    folder: Path, root: Path, languages: Sequence[str], problems: list[Problem]
) -> dict[str, View | None]:
    """Read what several general views share, by the names of the files; None: cannot be read."""
    found = (
        (path.stem, read_toml(path, root, problems, SHARED_VIEW, languages))
        for path in sorted(folder.glob("*.toml"))
    )
    return {name: None if table is None else read_shared(table) for name, table in found}


def _symbols(
    folder: Path, root: Path, problems: list[Problem]
) -> dict[str, tuple[Element, ...] | None]:
    """Read what several diagrams share, by the names of the files; None: cannot be read."""
    found = (
        (path.stem, read_toml(path, root, problems, SHARED_DIAGRAM))
        for path in sorted(folder.glob("*.toml"))
    )
    return {name: None if table is None else read_elements(table) for name, table in found}


def _catalogues(
    folder: Path, root: Path, languages: Sequence[str], problems: list[Problem]
) -> dict[str, Catalogue]:
    paths = sorted(folder.glob("*.csv"))
    found = (read_catalogue(path, root, problems, languages) for path in paths)
    return {catalogue.id: catalogue for catalogue in found if catalogue is not None}


def _sections(table: Table) -> tuple[Section, ...]:
    found = tuple(_section(one) for one in table.tables("section"))
    if not found and table.values.get("section", []) == []:
        table.add(
            "section",
            message("The course has no section."),
            message("Write at least one [[section]] with id, title, short and task."),
        )
    for number, one in enumerate(found, 1):
        if one.id and one.id in {earlier.id for earlier in found[: number - 1]}:
            table.add(
                f"section[{number}].id",
                message("Two sections have the id '{id}'.", id=one.id),
                message("Give each section an id of its own."),
            )
    return found


def _section(table: Table) -> Section:
    table.known_keys()
    return Section(
        table.text("id"),
        table.texts("title"),
        table.texts("short"),
        table.texts("task"),
        tuple(_detail(one) for one in table.tables("detail")),
    )


def _detail(table: Table) -> SectionDetail:
    table.known_keys()
    return SectionDetail(table.strings("quantities"), table.texts("text"))


def _works(table: Table) -> dict[str, Work]:
    return {
        name: Work(
            name,
            inner.texts("title"),
            read_equations(inner.table("equations")),
            at_hand=inner.flag("at_hand", default=True),
        )
        for name, inner in table.named_tables("work").items()
    }


def _languages(table: Table) -> tuple[str, ...]:
    """Read the languages that a course is written in, the one that stands in for others first."""
    written = table.strings("languages")
    for language in written:
        if language not in LANGUAGES:
            table.add(
                "languages",
                message("There is no language '{language}'.", language=language),
                did_you_mean(language, LANGUAGES),
            )
    own = table.values.get("language")
    known = dict.fromkeys(one for one in written if one in LANGUAGES)
    return tuple(sorted(known, key=lambda one: one != own)) or LANGUAGES


def _language(table: Table) -> str:
    language = table.text("language")
    if language in table.languages:
        return language
    what = (
        message("This is no language of the course.")
        if language in LANGUAGES
        else message("There is no language '{language}'.", language=language)
    )
    if language:  # else the key is missing, which is said
        table.add("language", what, did_you_mean(language, table.languages))
    return table.languages[0]


def _convention(table: Table, errata: Mapping[str, Erratum] | None) -> Convention:
    written = table.text("convention", Convention.CORRECTED)
    if written in list(Convention):
        if written == Convention.AS_PRINTED and errata == {}:
            table.add(
                "convention",
                message("The course lists no errata: nothing is printed otherwise."),
                message("Write '{corrected}', or list the errata in variants/errata.toml.",
                        corrected=Convention.CORRECTED),
            )  # fmt: skip
        return Convention(written)
    table.add(
        "convention",
        message("There is no convention '{convention}'.", convention=written),
        did_you_mean(written, list(Convention)),
    )
    return Convention.CORRECTED
