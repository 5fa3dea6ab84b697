"""Groups that stand above the people of a list, and not beside each of them.

An office writes "Группа РТК-41" into a row of its own and the people below it, or into the title of
the whole list.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache

from gripcourse.text.spelling import plain
from gripcourse.text.words import Message, message
from gripcourse.variants.headings import declared_names
from gripcourse.variants.sheet import Sheet

_LONGEST = 30  # signs of a group in a row of its own; a longer text is a sentence


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


def group_titles(sheet: Sheet) -> GroupTitles:
    """Find the groups that stand above the rows of a list."""
    in_titles = {one for title in sheet.titles for one in _in_sentence().findall(title)}
    rows = {}
    for row in sheet.rows:
        texts = {cell for cell in row.cells if cell}
        found = _alone().fullmatch(texts.pop()) if len(texts) == 1 else None
        if found is not None:
            rows[row.number] = " ".join(found["group"].split())
    return GroupTitles(in_titles.pop() if len(in_titles) == 1 else "", rows)


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
