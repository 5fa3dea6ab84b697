"""What an office writes into a list of people besides people: sums, signatures, headings again."""

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Final

from gripcourse.issuing.group_titles import has_more, only_texts
from gripcourse.text.shown import one_line
from gripcourse.text.spelling import plain
from gripcourse.text.words import Message, message
from gripcourse.variants.headings import TableColumn, Vocabulary, declared_names
from gripcourse.variants.sheet import Sheet, SheetRow

PARTS_OF_NAME: Final = ("surname", "first", "patronymic")
"""In the order in which they are printed."""

_OF_NAMES: Final = ("name", *PARTS_OF_NAME)
_SHOWN: Final = 40  # signs of a row that is left out
# Behind the first words of a sum or a signature: nothing, a colon or a dash, a number. Somebody's
# surname may be such a word; a first name follows it.
_BEHIND: Final = re.compile(r"\s*(?:$|[-:(]|\d|студент|чел|student|осіб)")
_IN_BRACKETS: Final = re.compile(r"\s*\(([^()]*)\)\s*$")
_BLANK: Final = re.compile(r"\s")
_NUMBERED: Final = re.compile(r"\s*\d{1,4}\s*[.)]\s*(?=\w)")
# What stands in a line that a form asks somebody to fill in, or before a note; in nobody's name.
_OF_A_FORM: Final = re.compile(r":|_{3}|\.{4}|…{2}|^\s*[*†]")


def with_names(sheet: Sheet, vocabulary: Vocabulary) -> Sheet:
    """Return a list in which the column `Student` is the names, where it cannot be the ids.

    Platforms head the names so and have ids besides; offices write whole names under it.
    """
    found = [vocabulary.find(one) for one in sheet.header]
    if any(ids & set(_OF_NAMES) for ids in found):
        return sheet
    called = declared_names("people")
    at = next((at for at, one in enumerate(sheet.header) if plain(one) in called), None)
    if at is None:
        return sheet
    has_ids = sum("student" in ids for ids in found) > 1
    if not has_ids and not any(" " in row.cells[at] for row in sheet.rows):
        return sheet
    header = tuple("name" if place == at else one for place, one in enumerate(sheet.header))
    return replace(sheet, header=header)


def with_somebody(
    sheet: Sheet, columns: Mapping[str, TableColumn], vocabulary: Vocabulary
) -> tuple[Sheet, tuple[Message, ...]]:
    """Leave out the rows of a list that name nobody; a note says which, and what stands there.

    Args:
        sheet: the list.
        columns: of it, by id.
        vocabulary: what columns may be called: a long list repeats its headings.
    """
    places = {id_: one.position for id_, one in columns.items()}
    ordinal = places.get("ordinal")
    is_numbered = ordinal is not None and any(_is_number(row.cells[ordinal]) for row in sheet.rows)
    reader = _Rows(places, vocabulary, is_numbered, has_more(sheet.rows))
    nobody: list[SheetRow] = []
    kept: list[SheetRow] = []
    for row in sheet.rows:
        (nobody if reader.names_nobody(row) else kept).append(row)
    if not nobody:
        return sheet, ()
    said = message(
        "Rows that name nobody were passed over: {rows}.",
        rows=", ".join(
            row_shown(sheet, row, (one for one in row.cells if not one.isdecimal()))
            for row in nobody
        ),
    )
    return replace(sheet, rows=tuple(kept)), (said,)


def without_staff(
    sheet: Sheet, columns: Mapping[str, TableColumn]
) -> tuple[Sheet, tuple[Message, ...]]:
    """Leave out whom a platform lists beside the students: who teaches, assists or looks on.

    Args:
        sheet: the list.
        columns: of it, by id.
    """
    role = columns.get("role")
    if role is None:
        return sheet, ()
    staff = [row for row in sheet.rows if _is_staff(row.cells[role.position])]
    if not staff:
        return sheet, ()
    said = message(
        "Rows of people whose role is not a student's were passed over: {rows}.",
        rows=", ".join(
            row_shown(sheet, row, [*names_in(row, columns), row.cells[role.position]])
            for row in staff
        ),
    )
    return replace(sheet, rows=tuple(row for row in sheet.rows if row not in staff)), (said,)


def _is_staff(cell: str) -> bool:
    """Tell whether all roles in a cell are known and none is a student's."""
    known, roles = declared_names("staff"), [plain(one) for one in re.split(r"[,;/]", cell)]
    return bool(cell) and all(role in known for role in roles)


def names_in(row: SheetRow, columns: Mapping[str, TableColumn]) -> list[str]:
    """Return the name in a row, or its parts, as they are written."""
    return [row.cells[columns[one].position] for one in _OF_NAMES if one in columns]


def row_shown(sheet: Sheet, row: SheetRow, cells: Iterable[str]) -> str:
    """Return the number of a row and what stands in it."""
    text = one_line(" ".join(filter(None, cells)))
    text = text if len(text) <= _SHOWN else f"{text[: _SHOWN - 1]}…"
    number = sheet.row_name(row.number)
    return f"{number} ({text})" if text else number


def without_numbers(sheet: Sheet, columns: Mapping[str, TableColumn]) -> Sheet:
    """Take the running numbers away that stand before all names, as in `1. Smith`."""
    first = next((columns[one] for one in _OF_NAMES if one in columns), None)
    if first is None or not sheet.rows:
        return sheet
    place = first.position
    if not all(_NUMBERED.match(row.cells[place]) for row in sheet.rows):
        return sheet
    return _with_cells(sheet, place, lambda text: _NUMBERED.sub("", text))


def without_remarks(
    sheet: Sheet, columns: Mapping[str, TableColumn]
) -> tuple[Sheet, tuple[Message, ...]]:
    """Leave out what an office writes in brackets behind names, as `(monitor)`; a note says so.

    A former surname in brackets stays: it is a name.
    """
    known = declared_names("remark")
    places = [columns[one].position for one in _OF_NAMES if one in columns]
    found: dict[str, None] = {}

    def bare(text: str) -> str:
        end = _IN_BRACKETS.search(text)
        if end is None or plain(end[1]) not in known:
            return text
        found[one_line(text)] = None
        return text[: end.start()]

    for place in places:
        sheet = _with_cells(sheet, place, bare)
    if not found:
        return sheet, ()
    said = message(
        "What stands in brackets behind these names was left out: {names}. Look whether all of"
        " them are to have a variant.",
        names=", ".join(found),
    )
    return sheet, (said,)


def with_addresses(
    sheet: Sheet, columns: Mapping[str, TableColumn]
) -> tuple[Sheet, tuple[Message, ...]]:
    """Leave out what stands among mail addresses and is none, such as `no`; a note says what."""
    if "email" not in columns:
        return sheet, ()
    place = columns["email"].position
    written = (one_line(row.cells[place]).strip() for row in sheet.rows)
    none = dict.fromkeys(one[:_SHOWN] for one in written if one and "@" not in one)
    if not none:
        return sheet, ()
    said = message("These are no mail addresses and were left out: {texts}.", texts=", ".join(none))
    return _with_cells(sheet, place, lambda text: text if "@" in text else ""), (said,)


def _with_cells(sheet: Sheet, place: int, changed: Callable[[str], str]) -> Sheet:
    """Return a list with other texts in one of its columns."""

    def row_of(row: SheetRow) -> SheetRow:
        cells = list(row.cells)
        cells[place] = changed(cells[place])
        return replace(row, cells=tuple(cells))

    return replace(sheet, rows=tuple(map(row_of, sheet.rows)))


def _is_number(ordinal: str) -> bool:
    return ordinal.strip().rstrip(".").isdecimal()


@dataclass(frozen=True, slots=True)
class _Rows:
    """How the rows of a list are looked at.

    Attributes:
        places: of its columns, by id.
        vocabulary: what columns may be called.
        is_numbered: whether people have running numbers.
        has_more: whether most rows hold more than a name.
    """

    places: Mapping[str, int]
    vocabulary: Vocabulary
    is_numbered: bool
    has_more: bool

    def names_nobody(self, row: SheetRow) -> bool:
        """Tell whether a row is of the form, a sum, a signature or headings once more."""
        own = {id_: row.cells[at].strip() for id_, at in self.places.items()}
        ordinal = own.pop("ordinal", "")
        if not any(own.values()) or self._repeats_headings(own):
            return True
        name = " ".join(filter(None, (own.get(one) for one in _OF_NAMES)))
        if not name:
            # An id of several words is none; without a name it is what somebody wrote below.
            texts = [ordinal, *(text for id_, text in own.items() if id_ != "email")]
            return " " in own.get("student", "") or any(self._is_closing(one) for one in texts)
        if _is_number(ordinal) and any(map(str.isalpha, name)):
            return False
        if own.get("email"):
            return False
        # "Monitor Smith" is somebody's name, but not below people who have numbers.
        is_below = self.is_numbered and self._is_closing(name, _BLANK)
        is_without_id = is_below or not any(map(str.isalpha, name))
        if self._is_title(row, name, own):
            return True
        is_closing = self._is_closing(ordinal) or self._is_closing(name)
        return is_closing or (is_without_id and not own.get("student"))

    def _is_title(self, row: SheetRow, name: str, own: Mapping[str, str]) -> bool:
        """Tell whether a row is a title of those below, `Subgroup 1`: one text, and no name."""
        if not self.has_more or len(only_texts(row)) != 1 or own.get("student"):
            return False
        is_word = " " not in name and ("name" in own or self.is_numbered)
        return is_word or any(map(str.isdigit, name))

    def _repeats_headings(self, own: Mapping[str, str]) -> bool:
        cells = [(id_, text) for id_, text in own.items() if text]
        return all(id_ in self.vocabulary.find(text) for id_, text in cells)

    @staticmethod
    def _is_closing(text: str, behind: re.Pattern[str] = _BEHIND) -> bool:
        """Tell whether a text begins as a sum or a signature does, or is a line of a form."""
        written = plain(text)
        return _OF_A_FORM.search(text) is not None or any(
            written.startswith(word) and behind.match(written, len(word)) is not None
            for word in declared_names("nobody")
        )
