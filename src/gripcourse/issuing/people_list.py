"""The lists of people in a file: the one table, or of a workbook each sheet that is such a list.

An office keeps the groups of a year on a sheet each, beside a title page and notes of its own.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from gripcourse.errors import Problem
from gripcourse.issuing.group_titles import GroupTitles, group_titles, with_groups_below
from gripcourse.issuing.list_columns import with_whole_names, without_doubles
from gripcourse.issuing.marked_left import said_of_left
from gripcourse.issuing.office_list import (
    PARTS_OF_NAME,
    with_addresses,
    with_names,
    with_somebody,
    without_numbers,
    without_remarks,
    without_staff,
)
from gripcourse.machine.content import Readable
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message
from gripcourse.variants.headings import (
    TableColumn,
    Vocabulary,
    column_of,
    find_columns,
    roster_vocabulary,
    without_strange,
)
from gripcourse.variants.sheet import Sheet, read_sheets

# What spreadsheet programs call a sheet that nobody has named.
_NAMED_BY_NOBODY: Final = re.compile(r"(?:sheet|лист|аркуш)\s*\d*", re.IGNORECASE)

_OF_NUMBERS: Final = frozenset({"ordinal", "student"})


@dataclass(frozen=True, slots=True)
class PeopleList:
    """A table of people as it was understood.

    Attributes:
        sheet: its columns that are asked for and its rows that name somebody.
        columns: where they are, by id.
        groups: that stand above the rows.
        problems: of its headings.
        left_out: what was passed over.
    """

    sheet: Sheet
    columns: Mapping[str, TableColumn]
    groups: GroupTitles
    problems: tuple[Problem, ...]
    left_out: tuple[Message, ...]

    @property
    def has_names(self) -> bool:
        """Tell whether anything in it can be a name."""
        return bool(self.columns.keys() & {"name", *PARTS_OF_NAME})


def lists_in(source: Readable) -> tuple[tuple[PeopleList, ...], tuple[Message, ...]]:
    """Return the lists of people in a file, one at least, and notes on which sheets they are.

    Raises:
        TableError: it cannot be read, or is blank.
    """
    vocabulary = roster_vocabulary()
    book = read_sheets(source, vocabulary.is_heading)
    # As if each were the only one: the title of a sheet says nothing where there is no other list.
    alone = [_understood(replace(one, title=""), vocabulary) for one in book.sheets]
    places = [place for place, one in enumerate(alone) if one.has_names] or [0]
    whole, only = book.sheets[places[0]], alone[places[0]]
    titles = (one.title for place, one in enumerate(book.sheets) if place not in places)
    others = [*book.others, *titles]
    if len(places) > 1:
        lists = [_understood(book.sheets[place], vocabulary) for place in places]
        filled = tuple(one for one in lists if one.sheet.rows)
        return filled or tuple(lists[:1]), (_said_of_several(lists, others),)
    if not others:
        return (only,), ()
    said = message(
        "{file}: only the sheet '{sheet}' was read; there is also: {others}.",
        file=whole.file,
        sheet=whole.title,
        others=", ".join(others),
    )
    return (only,), (said,)


def _understood(whole: Sheet, vocabulary: Vocabulary) -> PeopleList:
    """Find the columns and the people of a table."""
    whole = with_whole_names(whole, vocabulary)
    named = with_names(without_strange(whole, vocabulary), vocabulary)
    named, doubles = without_doubles(named, vocabulary)
    problems: list[Problem] = []
    columns = find_columns(named, vocabulary, problems)
    if not columns.keys() & {"name", *PARTS_OF_NAME}:
        problems.append(_without_names(whole, columns))
    if whole.title:
        problems = [replace(one, file=f"{whole.file} [{whole.title}]") for one in problems]
    groups = _groups(whole, vocabulary)
    if "group" in columns:
        groups = GroupTitles(rows=groups.rows)
    rows = tuple(row for row in named.rows if row.number not in groups.rows)
    sheet, staff = without_staff(replace(named, rows=rows), columns)
    sheet, nobody = with_somebody(sheet, columns, vocabulary)
    sheet, remarks = without_remarks(without_numbers(sheet, columns), columns)
    sheet, no_addresses = with_addresses(sheet, columns)
    below: tuple[Message, ...] = ()
    if "group" in columns:
        sheet, below = with_groups_below(sheet, columns["group"].position)
    left = said_of_left(whole, sheet, columns)
    left_out = (*left, *doubles, *staff, *nobody, *remarks, *no_addresses, *below)
    return PeopleList(sheet, columns, groups, tuple(problems), left_out)


def _groups(whole: Sheet, vocabulary: Vocabulary) -> GroupTitles:
    """Return the groups above the rows; the title of one of several sheets is one as well."""
    numbers = {
        place
        for place, heading in enumerate(whole.header)
        if column_of(heading, vocabulary) & _OF_NUMBERS
    }
    groups = group_titles(whole, numbers)
    is_named = whole.title and not _NAMED_BY_NOBODY.fullmatch(whole.title)
    is_needed = is_named and not groups.title and not groups.rows
    return replace(groups, sheet=whole.title) if is_needed else groups


def _said_of_several(lists: Sequence[PeopleList], others: Sequence[str]) -> Message:
    counted = ", ".join(f"{one.sheet.title} ({len(one.sheet.rows)})" for one in lists)
    file = lists[0].sheet.file
    if not others:
        return message("{file}: a list was read from each of the sheets {sheets}.",
                       file=file, sheets=counted)  # fmt: skip
    return message(
        "{file}: a list was read from each of the sheets {sheets}; no list is: {others}.",
        file=file,
        sheets=counted,
        others=", ".join(others),
    )


def _without_names(whole: Sheet, columns: Mapping[str, TableColumn]) -> Problem:
    if columns:
        what = message("There is no column '{column}'.", column="name")
        return Problem(whole.file, "", what, did_you_mean("name", whole.header))
    return Problem(
        whole.file,
        "",
        message("No row of the roster has headings."),
        message("Write a row above the names, for example: name, group, e-mail."),
    )
