"""What a column of a table is: ids, titles and symbols in any language, with or without a unit.

A heading is `mass`, `mass [kg]`, `Масса, кг` or `m (kg)`. What people call the columns that every
table has is in `headings.toml`.
"""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import lru_cache
from importlib.resources import files
from typing import Final

import tomli

from gripcourse.course.compose import compose
from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.text.spelling import LOST_SIGN, may_have_been, plain
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import dimension, read_unit, unit_text
from gripcourse.text.words import LANGUAGES, Message, Texts, message
from gripcourse.variants.sheet import Sheet, SheetRow, column_name

_LISTED: Final = 100  # names of columns, at most, of which it helps to be shown the first
_REMEMBERED: Final = 4  # courses
_WORD: Final = re.compile(r"[^\W_]+(?:'[^\W_]+)?|[№#]")
_NOBODYS: Final = frozenset(
    {"ordinal", "student", "variant", "role"}
)  # columns of no person's words
_NUMBER_SIGNS: Final = frozenset("№#")
_WITH_UNIT = (
    re.compile(r"(?P<name>.+?)\s*\[(?P<unit>[^\[\]]*)\]"),
    re.compile(r"(?P<name>.+?)\s*\((?P<unit>[^()]*)\)"),
    re.compile(r"(?P<name>.+),\s*(?P<unit>[^,]+)"),
)


@dataclass(frozen=True, slots=True)
class TableColumn:
    """A column that is understood.

    Attributes:
        position: from 0.
        name: what a person calls it.
        unit: that its heading names, None where it names none.
    """

    position: int
    name: str
    unit: str | None


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """What the columns of one kind of table may be called.

    Attributes:
        ids: ids by themselves and by the words of `headings.toml`, in small letters.
        titles: ids by titles in any language, in small letters.
        symbols: ids by symbols, in which capitals count.
        quantities: those of the ids that carry a unit.
        spoken: ids by their words alone, however dots, commas and strokes stand between them.
    """

    ids: Mapping[str, frozenset[str]]
    titles: Mapping[str, frozenset[str]]
    symbols: Mapping[str, frozenset[str]]
    quantities: Mapping[str, Quantity]
    spoken: Mapping[str, frozenset[str]] = field(default_factory=dict)

    def is_heading(self, text: str) -> bool:
        """Tell whether a text, with or without a unit, is the name of a column."""
        return bool(column_of(text, self))

    def find(self, name: str) -> frozenset[str]:
        """Return the ids that a name may mean: ids go before titles, titles before symbols.

        A title with its symbol behind a comma means what both mean.
        """
        small = plain(name)
        title, _, symbol = name.rpartition(",")
        both = self.titles.get(plain(title), frozenset()) & self._of_damaged_symbol(symbol)
        exact = both or self.ids.get(small) or self.titles.get(small) or self._of_symbol(name)
        return exact or self.spoken.get(_spoken(name), frozenset())

    def _of_symbol(self, text: str) -> frozenset[str]:
        return self.symbols.get(text.strip(), frozenset())

    def _of_damaged_symbol(self, text: str) -> frozenset[str]:
        """Return the ids of a symbol some of whose letters a code page may have lost."""
        if LOST_SIGN not in text:
            return self._of_symbol(text)
        found = (ids for one, ids in self.symbols.items() if may_have_been(one, text.strip()))
        return frozenset().union(*found)


@lru_cache(maxsize=1)
def _declared() -> Mapping[str, Mapping[str, tuple[str, ...]]]:
    source = files("gripcourse") / "variants" / "headings.toml"
    read = tomli.loads(source.read_text(encoding="utf-8"))
    return {table: {id_: tuple(names) for id_, names in ids.items()} for table, ids in read.items()}


@lru_cache
def declared_names(table: str) -> Mapping[str, frozenset[str]]:
    """Return the ids of a table of `headings.toml` by what people call them."""
    pairs = ((plain(name), id_) for id_, names in _declared()[table].items() for name in names)
    return _grouped(pairs)


def roster_vocabulary() -> Vocabulary:
    """Return what the columns of a roster may be called."""
    ids = declared_names("roster")
    pairs = [(name, id_) for name, found in ids.items() for id_ in found]
    pairs += [
        (f"{name} {whose}", id_)
        for name, id_ in pairs
        if id_ not in _NOBODYS
        for whose in declared_names("whose")
    ]
    spoken = _grouped((_spoken(name), id_) for name, id_ in pairs)
    return Vocabulary(ids, {}, {}, {}, spoken)


def table_vocabulary(course: Course) -> Vocabulary:
    """Return what the columns of a variant table may be called.

    Options are found as `option:<id>`, so that no quantity of the same name is in their way.
    """
    givens = given_quantities(course)
    options = [option for scheme in course.schemes.values() for option in scheme.options]
    ids = [(name, id_) for name, found in declared_names("table").items() for id_ in found]
    ids += [(plain(option.id), f"option:{option.id}") for option in options]
    ids += [(plain(id_), id_) for id_ in givens]
    titles = [
        (plain(one), f"option:{option.id}") for option in options for one in _all(option.title)
    ]
    # Schemes may call one given by other names: each of them is its column's.
    every = [(id_, one) for id_, declared in _declarations(course).items() for one in declared]
    titles += [(plain(one), id_) for id_, given in every for one in _all(given.title)]
    symbols = [(one, id_) for id_, given in every for one in _all(given.symbol)]
    symbols += [
        (symbol.replace("_", as_typed), id_) for symbol, id_ in symbols for as_typed in ("", " ")
    ]
    return Vocabulary(_grouped(ids), _grouped(titles), _grouped(symbols), givens)


def given_quantities(course: Course) -> dict[str, Quantity]:
    """Return the given quantities of all schemes by id; of one id the first declaration."""
    return {id_: declared[0] for id_, declared in _declarations(course).items()}


@lru_cache(_REMEMBERED)
def _declarations(course: Course) -> Mapping[str, tuple[Quantity, ...]]:
    """Return every declaration of each given, by id, in the order of schemes."""
    found: dict[str, dict[int, Quantity]] = {}
    for scheme in course.schemes.values():
        for options in pair_option_sets(scheme):
            for quantity in compose(course, scheme, options).values():
                if quantity.kind is Kind.GIVEN:
                    found.setdefault(quantity.id, {}).setdefault(id(quantity), quantity)
    return {id_: tuple(declared.values()) for id_, declared in found.items()}


def words_vocabulary(
    table: str, ids: Iterable[str] = (), titles: Iterable[tuple[str, str]] = ()
) -> Vocabulary:
    """Return what the columns of a table of `headings.toml` may be called.

    Args:
        table: its name there.
        ids: of more columns; they go before the words that are declared there.
        titles: other names of these columns, each with its id.
    """
    more = {plain(one): frozenset({one}) for one in ids}
    found = _grouped((plain(name), id_) for name, id_ in titles)
    return Vocabulary({**declared_names(table), **more}, found, {}, {})


def by_ids(sheet: Sheet, vocabulary: Vocabulary) -> tuple[Sheet, Mapping[str, str]]:
    """Return a table whose known headings are ids, and by id what a person calls the column.

    A heading that is not known, or may mean several columns, stays as it was written.
    """
    ids = [vocabulary.find(name) for name in sheet.header]
    header = tuple(
        next(iter(found)) if len(found) == 1 else name
        for name, found in zip(sheet.header, ids, strict=True)
    )
    return replace(sheet, header=header), dict(zip(header, sheet.header, strict=True))


def column_of(heading: str, vocabulary: Vocabulary) -> frozenset[str]:
    """Return the ids that a heading, with or without a unit, may mean."""
    return vocabulary.find(_split(heading, vocabulary)[0]) if heading else frozenset()


def without_strange(sheet: Sheet, vocabulary: Vocabulary) -> Sheet:
    """Return a table without the columns that nobody here asked for, and with a note of them.

    An office's list has more columns than are wanted. A column without a heading is left out too.
    """
    kept = [place for place, one in enumerate(sheet.header) if vocabulary.is_heading(one)]
    left = [column_name(place, sheet.header) for place in range(len(sheet.header))]
    left = [name for place, name in enumerate(left) if place not in kept]
    if not left:
        return sheet
    note = message(
        "{file}: these columns were not used: {columns}.",
        file=sheet.file,
        columns=", ".join(left),
    )
    return replace(
        sheet,
        header=tuple(sheet.header[place] for place in kept),
        rows=tuple(
            SheetRow(row.number, tuple(row.cells[place] for place in kept)) for row in sheet.rows
        ),
        notes=(*sheet.notes, note),
    )


def find_columns(
    sheet: Sheet, vocabulary: Vocabulary, problems: list[Problem]
) -> dict[str, TableColumn]:
    """Return the columns of a sheet by id.

    Args:
        sheet: the table.
        vocabulary: what its columns may be called.
        problems: where unknown, ambiguous and doubled headings and unfit units are recorded.
    """
    found: dict[str, TableColumn] = {}
    for position, heading in enumerate(sheet.header):
        column = column_name(position, sheet.header)
        key = message("column {column}", column=column)
        if not heading:
            what = message("The column has values but no heading.")
            problems.append(Problem(sheet.file, key, what, message("Write one, or clear it.")))
            continue
        name, unit_text = _split(heading, vocabulary)
        ids = vocabulary.find(name)
        if len(ids) != 1:
            problems.append(_unknown(sheet, key, ids, name, vocabulary))
            continue
        id_ = next(iter(ids))
        if id_ in found:
            what = message("The columns '{first}' and '{second}' mean the same.",
                           first=found[id_].name, second=heading)  # fmt: skip
            problems.append(Problem(sheet.file, key, what, message("Keep one of the two.")))
            continue
        unit = None
        if unit_text is not None and id_ in vocabulary.quantities:
            unit = _unit(sheet, key, unit_text, vocabulary.quantities[id_], problems)
        found[id_] = TableColumn(position, column, unit)
    return found


def _split(heading: str, vocabulary: Vocabulary) -> tuple[str, str | None]:
    """Split a heading into name and unit; a title with a comma of its own stays whole."""
    if vocabulary.find(heading):
        return heading, None
    for pattern in _WITH_UNIT:
        match = pattern.fullmatch(heading)
        if match is not None and vocabulary.find(match["name"]):
            return match["name"], match["unit"]
    match = _WITH_UNIT[0].fullmatch(heading)
    return (match["name"], match["unit"]) if match is not None else (heading, None)


def _unknown(
    sheet: Sheet, key: Message, ids: Iterable[str], name: str, vocabulary: Vocabulary
) -> Problem:
    several = sorted(ids)
    if several:
        return Problem(
            sheet.file,
            key,
            message("'{name}' may mean {ids}.", name=name, ids=", ".join(several)),
            message("Write the id instead."),
        )
    known = {*vocabulary.ids, *vocabulary.titles}
    what = message("There is no quantity or option '{name}'.", name=name)
    # Hundreds of names, listed from their first letter, help nobody.
    if len(known) <= _LISTED or get_close_matches(plain(name), known, n=1):
        return Problem(sheet.file, key, what, did_you_mean(plain(name), known))
    remedy = message("Clear the column, or head it as `gripcourse variants template` does.")
    return Problem(sheet.file, key, what, remedy)


def _unit(
    sheet: Sheet, key: Message, text: str, quantity: Quantity, problems: list[Problem]
) -> str | None:
    unit = read_unit(text)
    if unit is None and LOST_SIGN in text:
        written = (unit_text(quantity.unit, language) for language in LANGUAGES)
        unit = quantity.unit if any(may_have_been(one, text) for one in written) else None
    if unit is None:
        problems.append(
            Problem(
                sheet.file,
                key,
                message("The unit '{unit}' is not known.", unit=text),
                message("Write '{unit}'.", unit=quantity.unit or "1"),
            )
        )
        return None
    if dimension(unit) != dimension(quantity.unit):
        problems.append(
            Problem(
                sheet.file,
                key,
                message("'{unit}' does not measure {quantity}.", unit=text,
                        quantity=quantity.title),
                message("Write the numbers in '{unit}'.", unit=quantity.unit or "1"),
            )
        )  # fmt: skip
        return None
    return unit


def _spoken(name: str) -> str:
    """Return the words of a heading: offices put dots, commas and number signs where they like."""
    first, *words = _WORD.findall(plain(name)) or [""]
    return " ".join([first, *words[: -1 if words and words[-1] in _NUMBER_SIGNS else None]])


def _all(texts: Texts) -> tuple[str, ...]:
    return tuple(texts.of(language) for language in LANGUAGES)


def _grouped(pairs: Iterable[tuple[str, str]]) -> Mapping[str, frozenset[str]]:
    grouped: dict[str, set[str]] = {}
    for name, id_ in pairs:
        grouped.setdefault(name, set()).add(id_)
    return {name: frozenset(ids) for name, ids in grouped.items()}
