"""A file of unknown origin → the named cells of an answer workbook, or the reason why not.

Only the parts that names, answers and identity need are unpacked, and of sheets only named cells
are kept: the size that a sheet claims to have is never walked through, and damage to what else a
workbook holds refuses nothing.
"""

import hashlib
import re
import zipfile
import zlib
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import Final, TypeVar
from xml.etree.ElementTree import Element

from gripcourse.machine.content import (
    Readable,
    content_of,
    digest_of_content,
    is_larger,
    pure_path,
    shown_name,
)
from gripcourse.machine.spreadsheet.addresses import Place, address, place_of
from gripcourse.machine.spreadsheet.package import UNSOUND, Package
from gripcourse.machine.spreadsheet.preflight import LARGEST_FILE, read_checked
from gripcourse.machine.spreadsheet.sheet_cells import (
    EMPTY,
    StoredCell,
    first_of_merged,
    stored_cells,
)
from gripcourse.submission.copied_sheets import about_copies
from gripcourse.submission.harmless import about_damage, about_lost_formats
from gripcourse.submission.identity import creator_of, identity_of
from gripcourse.submission.looks import looks_of
from gripcourse.submission.model import Rejected, WhyRefused
from gripcourse.submission.named_places import NamedPlace, places_beside
from gripcourse.submission.other_workbooks import about_other_workbooks
from gripcourse.submission.raw import RawCell, RawWorkbook
from gripcourse.text.words import Message, message
from gripcourse.workbook import names
from gripcourse.workbook.layout import SheetColumn

_NAME: Final = re.compile(r"(answer|given|meta)[._](\w{1,100})", re.ASCII)
_LONGEST_REFERENCE: Final = 300  # characters of where one of our names points to
_LONGEST_LABEL: Final = 500  # characters; one text of megabytes may be the label of every row
_MOST_NAMES: Final = 10_000  # of ours

_FAULTS: Final[tuple[tuple[tuple[type[Exception], ...], WhyRefused], ...]] = (
    ((zipfile.BadZipFile, zlib.error, EOFError), WhyRefused.DAMAGED),
    ((OverflowError, RecursionError), WhyRefused.TOO_LARGE),
    ((MemoryError,), WhyRefused.TOO_COSTLY),
    ((KeyError,), WhyRefused.PART_MISSING),
    (UNSOUND, WhyRefused.INVALID_XML),
)

_SUFFIXES: Final = frozenset({".xlsx", ".xlsm"})
_ANSWER: Final = names.cell_name(names.ANSWER, "")
_Held = TypeVar("_Held")
# Columns from a title to its answer.
_TO_TITLE: Final = SheetColumn.VALUE - SheetColumn.TITLE
# Columns behind an answer that somebody may have taken for its own: of the checks, and the next.
_ASIDE: Final = (SheetColumn.CHECK - SheetColumn.VALUE, SheetColumn.CHECK - SheetColumn.VALUE + 1)


@dataclass(frozen=True, slots=True)
class _Located:
    """A sheet with the cells that our names point to, by the place where a name puts them."""

    stored: Mapping[Place, tuple[Place, StoredCell]]


@dataclass(frozen=True, slots=True)
class _NamedCells:
    """What the cells of a workbook hold.

    Attributes:
        named: by our names.
        beside: of the columns of answers, in rows with a label, that no name points to.
        nowhere: by our names the title of a sheet that is not there.
        remarks: about what of their looks is lost.
    """

    named: Mapping[str, RawCell]
    beside: tuple[RawCell, ...]
    nowhere: Mapping[str, str]
    remarks: tuple[Message, ...]


def read_workbook(source: Readable) -> RawWorkbook | Rejected:
    """Read the named cells of a workbook.

    Args:
        source: a file of any content, or its bytes.

    Returns:
        The cells, or why the file cannot be used. Whatever the content is, nothing is raised.

    Raises:
        OSError: there is no such file, or it may not be read.
        ImportError: this program cannot be read as a whole.
    """
    file = shown_name(source)
    if is_larger(source, LARGEST_FILE):
        # Whoever packed it has no claim on this machine's memory.
        return Rejected.because(file, digest_of_content(source), WhyRefused.TOO_LARGE)
    data = content_of(source)
    digest = hashlib.sha256(data).hexdigest()
    try:
        read = read_checked(
            pure_path(source).name, data, lambda package: _read(package, file, digest)
        )
    except (OSError, ImportError):  # bytes in memory make nothing raise these
        raise
    except Exception as fault:  # noqa: BLE001 (whatever the bytes make a library raise)
        read = _fault_of(fault)
    return read if isinstance(read, RawWorkbook) else Rejected.because(file, digest, read)


def _fault_of(fault: Exception) -> WhyRefused:
    found = (refused for kinds, refused in _FAULTS if isinstance(fault, kinds))
    return next(found, WhyRefused.UNREADABLE_CONTENT)


def _read(package: Package, file: str, digest: str) -> RawWorkbook | WhyRefused:
    workbook = package.workbook_part()
    named, copies = _named(package, workbook)
    if not any(name.startswith(names.cell_name(names.ANSWER, "")) for name in named):
        return WhyRefused.FOREIGN
    found = _cells(package, workbook, named, copies)
    answers = _of_role(found.named, names.ANSWER)
    identity, about_identity = identity_of(_of_role(found.named, names.META), package)
    creator = creator_of(package)
    remarks = (
        *about_identity,
        *_about_name(file),
        *about_other_workbooks(answers.values()),
        *found.remarks,
        *about_damage(package.check_others()),
    )
    return RawWorkbook(
        file=file,
        digest=digest,
        identity=identity,
        creator=creator,
        givens=_of_role(found.named, names.GIVEN),
        answers=answers,
        remarks=remarks,
        beside=found.beside,
        nowhere=_of_role(found.nowhere, names.ANSWER),
    )


def _named(
    package: Package, workbook: str
) -> tuple[dict[str, NamedPlace], dict[str, set[NamedPlace]]]:
    """Find where our names point to; the workbook's own names win over those of single sheets.

    Returns:
        That, and where an answer stands on copies of its sheet: they get names of their own.
    """
    found: dict[str, NamedPlace] = {}
    more: dict[str, set[NamedPlace]] = {}
    for name, reference in _definitions(package, workbook):
        sheet, _, cells = reference.rpartition("!")
        place = place_of(cells.partition(":")[0])
        if place is not None:
            title = sheet.removeprefix("'").removesuffix("'").replace("''", "'")
            where = NamedPlace(title, place)
            if found.setdefault(name, where) != where and name.startswith(_ANSWER):
                more.setdefault(name, set()).add(where)
    return found, more


def _definitions(package: Package, workbook: str) -> Iterator[tuple[str, str]]:
    ours: list[tuple[bool, str, str]] = []
    for element in package.elements(workbook, "definedName"):
        found = _NAME.fullmatch(element.get("name", "").lower())
        text = (element.text or "").strip()
        if found and len(text) <= _LONGEST_REFERENCE:
            of_sheet = element.get("localSheetId") is not None
            ours.append((of_sheet, names.cell_name(found[1], found[2]), text))
    if len(ours) > _MOST_NAMES:
        raise OverflowError(len(ours))
    return ((name, text) for _, name, text in sorted(ours, key=lambda one: one[0]))


def _cells(
    package: Package,
    workbook: str,
    named: Mapping[str, NamedPlace],
    copies: Mapping[str, set[NamedPlace]],
) -> _NamedCells:
    """Read the cells that our names point to, and those of their columns that none points to.

    An answer that is blank and stands on a copy of its sheet is taken from there.

    Cells whose sheet is gone are left out; where it only has another name, its rows are among those
    that none points to.

    Raises:
        KeyError: a sheet is listed that has no cells, not even blank ones, and answers were there.
    """
    answers = {one for name, one in named.items() if name.startswith(_ANSWER)}
    if lost := package.lost_sheets(workbook) & {one.sheet for one in answers}:
        raise KeyError(*lost)
    parts = package.sheets(workbook)
    beside = places_beside(answers, set(named.values()), parts)
    copied = set[NamedPlace]().union(*copies.values())
    labels = {one: _label_of(one) for one in (*answers, *beside, *copied)}
    wanted = _by_part({*named.values(), *copied, *beside, *labels.values()}, parts)
    answered = _by_part(answers, parts)
    located = {
        part: _located(package.tree(part), places, answered.get(part, frozenset()))
        for part, places in wanted.items()
    }
    sheets = {title: located[part] for title, part in parts.items() if part in located}
    stored = [cell for sheet in located.values() for _, cell in sheet.stored.values()]
    look = looks_of(package, workbook, stored)

    def raw(where: NamedPlace, label: str = "") -> RawCell:
        place, cell = sheets[where.sheet].stored[where.place]
        content, number_format = look.shown(cell)
        return RawCell(
            value=content.value,
            number_format=number_format,
            error=content.error,
            formula=cell.formula,
            cell=f"{where.sheet}!{address(place)}",
            label=label,
        )

    def label_of(where: NamedPlace) -> str:
        sheet, place = labels[where]
        _, cell = sheets[sheet].stored[place]
        if cell is EMPTY:
            return ""
        label = look.shown(cell)[0].value
        return " ".join(label[:_LONGEST_LABEL].split()) if isinstance(label, str) else ""

    def with_aside(where: NamedPlace, cell: RawCell) -> RawCell:
        if cell.is_filled or where not in answers:
            return cell
        read = sheets[where.sheet].stored
        behind = (NamedPlace(where.sheet, one) for one in _behind(where.place) if one in read)
        return replace(cell, aside=tuple(map(raw, behind)))

    there = {name: where for name, where in named.items() if where.sheet in sheets}
    cells = {
        name: with_aside(where, raw(where, label_of(where) if where in answers else ""))
        for name, where in there.items()
    }
    on_copies = {
        name: [raw(one, label_of(one)) for one in sorted(places) if one.sheet in sheets]
        for name, places in copies.items()
        if name not in cells or not cells[name].is_filled
    }
    filled = {name: [one for one in found if one.is_filled] for name, found in on_copies.items()}
    cells |= {name: found[0] for name, found in filled.items() if len(found) == 1}
    others = ((one, label_of(one)) for one in sorted(beside, key=_order) if one.sheet in sheets)
    counting = [sheets[where.sheet].stored[where.place][1] for where in there.values()]
    return _NamedCells(
        cells,
        tuple(raw(one, label) for one, label in others if label),
        {name: where.sheet for name, where in named.items() if where.sheet not in parts},
        (*about_lost_formats(look, counting), *about_copies(filled.values())),
    )


def _label_of(where: NamedPlace) -> NamedPlace:
    """Return where the title of a quantity stands, by the place of its answer."""
    row, column = where.place
    return NamedPlace(where.sheet, (row, max(column - _TO_TITLE, 1)))


def _behind(answer: Place) -> tuple[Place, ...]:
    """Return the places behind an answer, the nearest first."""
    row, column = answer
    return tuple((row, column + further) for further in _ASIDE)


def _order(where: NamedPlace) -> tuple[str, Place]:
    return where.sheet, where.place


def _by_part(places: Iterable[NamedPlace], parts: Mapping[str, str]) -> dict[str, set[Place]]:
    """Return places of sheets that there are, by the part of their sheet."""
    found: dict[str, set[Place]] = {}
    for one in places:
        if one.sheet in parts:
            found.setdefault(parts[one.sheet], set()).add(one.place)
    return found


def _located(sheet: Element, places: set[Place], answers: Collection[Place]) -> _Located:
    """Read what shows at some places, and behind those answers among them that are blank."""
    found = _shown_at(sheet, places)
    behind = {one for answer in answers if _is_blank(found[answer][1]) for one in _behind(answer)}
    return _Located(found | _shown_at(sheet, behind) if behind else found)


def _shown_at(sheet: Element, places: set[Place]) -> dict[Place, tuple[Place, StoredCell]]:
    shown = first_of_merged(sheet, places)
    cells = stored_cells(sheet, set(shown.values()))
    return {place: (at, cells.get(at, EMPTY)) for place, at in shown.items()}


def _is_blank(cell: StoredCell) -> bool:
    return cell.text is None and not cell.formula


def _of_role(named: Mapping[str, _Held], role: str) -> dict[str, _Held]:
    """Return what is held of the names of one role by the id of their quantity."""
    prefix = names.cell_name(role, "")
    return {
        name.removeprefix(prefix): one for name, one in named.items() if name.startswith(prefix)
    }


def _about_name(file: str) -> tuple[Message, ...]:
    """Say that a workbook was read whose name does not say that it is one."""
    name = PurePath(file).name
    if PurePath(name).suffix.lower() in _SUFFIXES:
        return ()
    return (
        message(
            "The file {name} is a workbook, though its name does not end in .xlsx. It was read as"
            " what it is; call it .xlsx next time.",
            name=name,
        ),
    )
