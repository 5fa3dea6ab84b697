"""A file of unknown origin → the named cells of an answer workbook, or the reason why not.

Only named cells are read: the size that a sheet claims to have is never walked through.
"""

import hashlib
import io
import re
import zipfile
import zlib
from collections.abc import Iterable, Iterator, Mapping
from contextlib import redirect_stdout
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final

from gripcourse.machine.content import Readable, content_of, pure_path, shown_name
from gripcourse.machine.process_wide import without_warnings
from gripcourse.submission.model import Identity, Rejected
from gripcourse.submission.preflight import DAMAGED, NO_WORKBOOK, refusal
from gripcourse.submission.raw import RawCell, RawWorkbook
from gripcourse.submission.sheet_xml import Place, formulas, with_false_numbers_as_text
from gripcourse.text.words import Message, message
from gripcourse.workbook import names

if TYPE_CHECKING:
    from openpyxl import Workbook
    from openpyxl.cell.cell import Cell, MergedCell
    from openpyxl.worksheet.worksheet import Worksheet

_REFERENCE: Final = re.compile(r"\$?([A-Za-z]{1,3})\$?(\d{1,7})(?::.{1,20})?")
_NAME: Final = re.compile(r"(answer|given|meta)[._](\w{1,100})", re.ASCII)

_COPY: Final = message("Copy the answers into the workbook that was issued and send that.")
_FAULTS: Final[tuple[tuple[tuple[type[Exception], ...], Message], ...]] = (
    ((zipfile.BadZipFile, zlib.error, EOFError), DAMAGED),
    (
        (MemoryError, OverflowError, RecursionError),
        message("The workbook is too large to be read. {remedy}", remedy=_COPY),
    ),
    (
        (KeyError,),
        message("A part of the workbook is missing. {remedy}", remedy=_COPY),
    ),
    (
        (SyntaxError, ValueError),
        message(
            "The workbook holds content that cannot be read, for example a cell whose number is "
            "not a number. {remedy}",
            remedy=_COPY,
        ),
    ),
    ((OSError,), NO_WORKBOOK),
)
_UNKNOWN_CONTENT: Final = message(
    "The workbook holds something that cannot be read, for example a pivot table or a damaged "
    "style. {remedy}",
    remedy=_COPY,
)
_FOREIGN: Final = message(
    "The workbook has none of the answer cells: it is not the workbook that was issued. {remedy}",
    remedy=_COPY,
)


@dataclass(frozen=True, slots=True)
class _Place:
    """Where a name points to."""

    sheet: str
    column: str
    row: int


def read_workbook(source: Readable) -> RawWorkbook | Rejected:
    """Read the named cells of a workbook.

    Args:
        source: a file of any content, or its bytes.

    Returns:
        The cells, or why the file cannot be used. Whatever the content is, nothing is raised.

    Raises:
        OSError: there is no such file, or it may not be read.
    """
    data, file = content_of(source), shown_name(source)
    digest = hashlib.sha256(data).hexdigest()
    reason = refusal(pure_path(source).name, data)
    if reason is not None:
        return Rejected(file, digest, reason)
    book = _load(data)
    if isinstance(book, Message):
        return Rejected(file, digest, book)
    places = _places(book)
    answers = _cells(book, places, names.ANSWER)
    if not answers:
        return Rejected(file, digest, _FOREIGN)
    computed = formulas(data)
    identity, remarks = _identity(book, places)
    return RawWorkbook(
        file=file,
        digest=digest,
        identity=identity,
        creator=book.properties.lastModifiedBy or book.properties.creator or "",
        givens=_cells(book, places, names.GIVEN),
        answers={name: _with_formula(cell, computed) for name, cell in answers.items()},
        remarks=remarks,
    )


def _load(data: bytes) -> "Workbook | Message":
    """Open a workbook, with the values that are stored for its formulas."""
    try:
        return _opened(data)
    except ValueError:  # perhaps of one cell, whose number is not a number
        pass
    except Exception as fault:  # noqa: BLE001 - the parser raises nearly every class there is
        return _said_of(fault)
    try:
        return _opened(with_false_numbers_as_text(data))
    except Exception as fault:  # noqa: BLE001 - as above
        return _said_of(fault)


def _opened(data: bytes) -> "Workbook":
    # A fifth of a second to import: only those who read a workbook pay for it.
    from openpyxl import load_workbook  # noqa: PLC0415

    # The library prints of styles that are not there: into our output, if it may. It warns of
    # features that are lost on saving: nothing is saved.
    with without_warnings(), redirect_stdout(io.StringIO()):
        return load_workbook(io.BytesIO(data), data_only=True, keep_links=False)


def _said_of(fault: Exception) -> Message:
    return next((told for kinds, told in _FAULTS if isinstance(fault, kinds)), _UNKNOWN_CONTENT)


def _places(book: "Workbook") -> dict[str, _Place]:
    """Find where our names point to; the workbook's own names win over those of single sheets."""
    found: dict[str, _Place] = {}
    for name, reference in _definitions(book):
        ours = _NAME.fullmatch(name.lower())
        sheet, _, address = reference.rpartition("!")
        cell = _REFERENCE.fullmatch(address)
        if ours is None or cell is None:
            continue
        title = sheet.removeprefix("'").removesuffix("'").replace("''", "'")
        place = _Place(title, cell[1].upper(), int(cell[2]))
        found.setdefault(names.cell_name(ours[1], ours[2]), place)
    return found


def _definitions(book: "Workbook") -> Iterator[tuple[str, str]]:
    for name, defined in book.defined_names.items():
        yield name, defined.value or ""
    for sheet in book.worksheets:
        for name, defined in sheet.defined_names.items():
            yield name, defined.value or ""


def _cells(book: "Workbook", places: Mapping[str, _Place], role: str) -> dict[str, RawCell]:
    """Read the cells of one role by the id of their quantity; cells that are gone are left out."""
    prefix = names.cell_name(role, "")
    cells = (
        (name.removeprefix(prefix), _raw(book, place))
        for name, place in places.items()
        if name.startswith(prefix)
    )
    return {identifier: cell for identifier, cell in cells if cell is not None}


def _raw(book: "Workbook", place: _Place) -> RawCell | None:
    cell = _cell(book, place)
    if cell is None:
        return None
    value: Any = cell.value  # formulas too have been computed
    return RawCell(
        value=value,
        number_format=cell.number_format or "",
        error=cell.data_type == "e",
        formula="",
        cell=f"{place.sheet}!{cell.coordinate}",
    )


def _cell(book: "Workbook", place: _Place) -> "Cell | None":
    """Return the cell of a place, or the first cell of the merged range that it is in."""
    # The classes exist once a workbook is open.
    from openpyxl.cell.cell import Cell, MergedCell  # noqa: PLC0415

    sheet = next((sheet for sheet in book.worksheets if sheet.title == place.sheet), None)
    if sheet is None:
        return None
    try:
        cell = sheet[f"{place.column}{place.row}"]
    except ValueError:  # outside of any sheet
        return None
    if isinstance(cell, MergedCell):
        cell = _first_of_merged(sheet, cell)
    return cell if isinstance(cell, Cell) else None


def _first_of_merged(sheet: "Worksheet", cell: "MergedCell") -> object:
    inside = (area for area in sheet.merged_cells.ranges if cell.coordinate in area)
    area = next(inside, None)
    return None if area is None else sheet.cell(area.min_row, area.min_col)


def _with_formula(raw: RawCell, computed: Mapping[Place, str]) -> RawCell:
    """Say which formula a cell holds: one without a stored value is not an empty cell."""
    sheet, _, address = raw.cell.rpartition("!")
    return replace(raw, formula=computed.get((sheet, address), ""))


def _identity(
    book: "Workbook", places: Mapping[str, _Place]
) -> tuple[Identity, tuple[Message, ...]]:
    """Read whose workbook it is: from the hidden sheet, else from the document's properties."""
    cells = _cells(book, places, names.META)
    hidden = {name: str(cell.value) for name, cell in cells.items() if cell.value is not None}
    stored = dict(_properties(book))
    fields = {name: hidden.get(name) or stored.get(name, "") for name in names.FIELDS}
    identity = Identity(
        student=fields[names.STUDENT],
        variant=fields[names.VARIANT],
        scheme=fields[names.SCHEME],
        options=names.read_options(fields[names.OPTIONS]),
        signature=fields[names.SIGNATURE],
    )
    if hidden:
        return identity, ()
    return identity, (
        message("The hidden sheet that says whose workbook this is has been removed."),
    )


def _properties(book: "Workbook") -> Iterable[tuple[str, str]]:
    prefix = names.cell_name(names.PROPERTY, "")
    untyped: Any = book  # published types of the library do not know these properties
    for stored in untyped.custom_doc_props.props:
        if (stored.name or "").startswith(prefix):
            yield str(stored.name).removeprefix(prefix), str(stored.value)
