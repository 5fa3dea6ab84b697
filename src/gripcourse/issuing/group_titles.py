"""Groups that stand above the people of a list, and not beside each of them.

An office writes "Группа РТК-41", or "РТК-41" alone, into a row of its own and the people below it,
or into the title of the whole list, or beside the first of them.
"""

import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import groupby, pairwise

from gripcourse.text.shown import first_of
from gripcourse.text.spelling import plain
from gripcourse.text.words import Message, message
from gripcourse.variants.headings import declared_names
from gripcourse.variants.sheet import Sheet, SheetRow

_LONGEST = 30  # signs of a group in a row of its own; a longer text is a sentence
_FEWEST = 3  # rows for each group that is written: where one has none, that may be meant
_NAMED = 10  # rows that a note names
# The name of a group without the word: letters and digits, РТК-41, МП-21мп, 311, 20 КМ 01.
_CODE = re.compile(r"(?=.*\d)[^\W_]{1,8}(?:[ ./–-]{1,3}[^\W_]{1,6}){0,3}")
_LETTER = re.compile(r"[^\W\d_]")
_DAY = re.compile(r"\d{1,4}[./-]\d{1,2}[./-]\d{1,4}")


@dataclass(frozen=True, slots=True)
class GroupTitles:
    """Which group stands above which rows.

    Attributes:
        title: the one group that the title of the list names; empty for none, or for several.
        rows: groups by the numbers of the rows that hold nothing else, in order.
        sheet: the group that a sheet of several is named after, where nothing else names one.
    """

    title: str = ""
    rows: dict[int, str] = field(default_factory=dict)
    sheet: str = ""

    def above(self, row: int) -> str:
        """Return the group of a row; empty where nothing above it names one."""
        named = next((self.rows[one] for one in reversed(self.rows) if one < row), self.title)
        return named or self.sheet


def groups_note(lists: Iterable[GroupTitles]) -> tuple[Message, ...]:
    """Say which groups were found above the rows of lists."""
    above = [one for groups in lists for one in (groups.title, *groups.rows.values()) if one]
    sheets = [one.sheet for one in lists if one.sheet]
    said = (
        (above, message("No column holds groups; they stand above the names: {groups}.",
                        groups=", ".join(dict.fromkeys(above)))),
        (sheets, message("No column holds groups; they are the titles of sheets: {groups}.",
                         groups=", ".join(sheets))),
    )  # fmt: skip
    return tuple(one for found, one in said if found)


def group_titles(sheet: Sheet, ids: Collection[int] = ()) -> GroupTitles:
    """Find the groups that stand above the rows of a list.

    Args:
        sheet: the list.
        ids: places of columns that hold numbers of people or of rows: what stands there alone is
            the name of a group only if nothing else in them looks so.
    """
    in_titles = {one for title in sheet.titles for one in _in_sentence().findall(title)}
    codes = _Codes.of(sheet.rows, ids)
    named = ((row.number, codes.group_in(row)) for row in sheet.rows)
    rows = {number: group for number, group in named if group}
    return GroupTitles(in_titles.pop() if len(in_titles) == 1 else "", rows)


@dataclass(frozen=True, slots=True)
class _Codes:
    """Where in a list the name of a group may stand without the word.

    Attributes:
        last: number of the last row of a person, above which groups stand; 0 in a list whose rows
            hold one text each.
        numbers: places of ids and of running numbers.
        lettered: those of them where people have letters, as groups do.
    """

    last: int
    numbers: Collection[int]
    lettered: Collection[int]

    @classmethod
    def of(cls, rows: Sequence[SheetRow], numbers: Collection[int]) -> "_Codes":
        people = [row for row in rows if len(only_texts(row)) > 1]
        lettered = {at for at in numbers for row in people if _LETTER.search(row.cells[at])}
        return cls(people[-1].number if people and has_more(rows) else 0, numbers, lettered)

    def group_in(self, row: SheetRow) -> str:
        """Return the group that a row holds and nothing else; empty for any other row."""
        texts = only_texts(row)
        if len(texts) != 1:
            return ""
        ((place, text),) = texts.items()
        found = _alone().fullmatch(text)
        if found is not None:
            return " ".join(found["group"].split())
        is_code = _CODE.fullmatch(text) is not None and _DAY.fullmatch(text) is None
        if not is_code or row.number >= self.last or _begins_a_sum(text):
            return ""
        is_number = place in self.numbers and (text.isdecimal() or place in self.lettered)
        return "" if is_number else " ".join(text.split())


def _begins_a_sum(text: str) -> bool:
    return plain(text).split()[0] in declared_names("nobody")


def only_texts(row: SheetRow) -> dict[int, str]:
    """Return the texts of a row by the places where they first stand; a merged one stands once."""
    found: dict[str, int] = {}
    for place, cell in enumerate(row.cells):
        if cell:
            found.setdefault(cell, place)
    return {place: text for text, place in found.items()}


def has_more(rows: Sequence[SheetRow]) -> bool:
    """Tell whether most rows of a list hold more than one text: what stands alone is no person."""
    return 2 * sum(len(only_texts(row)) > 1 for row in rows) >= len(rows)


def with_groups_below(sheet: Sheet, place: int) -> tuple[Sheet, tuple[Message, ...]]:
    """Write the group beside everybody where it stands beside the first of each alone.

    Elsewhere somebody without a group may have none: nothing is filled in, and a note names them.

    Args:
        sheet: the list, with rows of people only.
        place: of the column of groups.
    """
    written = [row for row in sheet.rows if row.cells[place]]
    without = [row for row in sheet.rows if not row.cells[place]]
    if not written or not without:
        return sheet, ()
    if not _begin_blocks(sheet.rows, written, place):
        rows = first_of([sheet.row_name(row.number) for row in without], _NAMED)
        return sheet, (message("No group is written in the rows: {rows}.", rows=rows),)
    filled: list[SheetRow] = []
    group = ""
    for row in sheet.rows:
        group = row.cells[place] or group
        filled.append(replace(row, cells=(*row.cells[:place], group, *row.cells[place + 1 :])))
    blocks = ", ".join(
        f"{name} ({sheet.row_name(first.number)}–{sheet.row_name(last.number)})"
        for name, first, last in _blocks(filled, place)
    )
    said = message(
        "A group that stands in the first row of several is that of the rows below: {groups}.",
        groups=blocks,
    )
    return replace(sheet, rows=tuple(filled)), (said,)


def _begin_blocks(rows: Sequence[SheetRow], written: Sequence[SheetRow], place: int) -> bool:
    """Tell whether each group is written where its people begin, or go on overleaf."""
    names = [name for name, _ in groupby(row.cells[place] for row in written)]
    return (
        bool(rows[0].cells[place])
        and len(rows) >= _FEWEST * len(written)
        and len(set(names)) == len(names)
        and not any(one.cells[place] == other.cells[place] != "" for one, other in pairwise(rows))
    )


def _blocks(rows: Iterable[SheetRow], place: int) -> Iterable[tuple[str, SheetRow, SheetRow]]:
    """Return each group with its first and its last row."""
    for name, found in groupby(rows, key=lambda row: row.cells[place]):
        block = list(found)
        yield name, block[0], block[-1]


@cache
def _alone() -> re.Pattern[str]:
    """A row that is a group: "Группа РТК-41", "гр. 41"."""
    return re.compile(rf"(?:{_words()})[\s:№]+(?P<group>\S.{{0,{_LONGEST}}})", re.IGNORECASE)


@cache
def _in_sentence() -> re.Pattern[str]:
    """A group inside a title: its name has a digit, and other words follow a group as well."""
    return re.compile(rf"\b(?:{_words()})[\s:№]+([\w./-]*\d[\w./-]*)", re.IGNORECASE)


def _words() -> str:
    return "|".join(
        sorted(map(re.escape, map(plain, declared_names("group_title"))), key=len)[::-1]
    )
