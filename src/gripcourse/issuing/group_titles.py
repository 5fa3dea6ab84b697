"""Groups that stand above the people of a list, and not beside each of them.

An office writes "Группа РТК-41" into a row of its own and the people below it, or into the title of
the whole list.
"""

import re
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
    """

    title: str = ""
    rows: dict[int, str] = field(default_factory=dict)

    def above(self, row: int) -> str:
        """Return the group of a row; empty where nothing above it names one."""
        return next((self.rows[one] for one in reversed(self.rows) if one < row), self.title)

    def note(self) -> tuple[Message, ...]:
        """Say which groups were found."""
        found = dict.fromkeys(filter(None, (self.title, *self.rows.values())))
        if not found:
            return ()
        return (
            message("No column holds groups; they stand above the names: {groups}.",
                    groups=", ".join(found)),
        )  # fmt: skip


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
