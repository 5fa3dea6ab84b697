"""Catalogues: CSV files of standard sizes, with their source and mark on top.

Two lines `# source: …` and `# mark: …`, in other languages too if somebody translated them
(`# source.ru: …`); what students call it, `# title: …`, and its columns, `# column.mass: …`; a
heading such as `size [mm],mass [kg]`, then the rows. `# title.en: …` is as good as `# title: …`.
"""

import csv
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.model import Catalogue
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import Column
from gripcourse.text.number_text import is_lost
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import factor
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import LANGUAGES, Message, Texts, message

_REMARKS = ("source", "mark")
# Three letters or more that are no index, no function, and no name such as HRC.
_WORD: Final = re.compile(r"(?<![\w_])(?!(?:sin|cos|tan|max|min)\b|[A-Z]+\b)[^\W\d_]{3,}")
_CYRILLIC: Final = re.compile(r"[а-яёіїєґ]", re.IGNORECASE)


def read_catalogue(
    path: Path, root: Path, problems: list[Problem], languages: Sequence[str] = LANGUAGES
) -> Catalogue | None:
    """Read a catalogue; None (and problems) where not even its columns are known.

    What students call it and its columns must be written in all `languages` of the course.
    """
    file = str(path.relative_to(root))
    lines = _lines(path, file, problems)
    if lines is None:
        return None
    written = _remarks(lines)
    remarks = _served(written, languages)
    problems += [*_sourceless(file, remarks), *_untranslated(file, written, languages)]
    rows = _rows(lines, file, problems)
    if rows is None:
        return None
    before = len(problems)
    units = _header(file, rows, problems)
    problems += _strays(file, written, units)
    if len(problems) > before:
        return None
    values = _values(file, rows, len(units), problems)
    _check_order(file, units, values, problems)
    columns = {
        name: values[:, number] * factor(unit) for number, (name, unit) in enumerate(units.items())
    }
    source = Texts({language: _source(remarks, language) for language in LANGUAGES})
    named = {name: _written(remarks, f"column.{name}") for name in units}
    return Catalogue(
        id=path.stem,
        columns=columns,
        units=units,
        source=source,
        file=file,
        title=_written(remarks, "title"),
        headings={name: written for name, written in named.items() if written is not None},
    )


def _lines(path: Path, file: str, problems: list[Problem]) -> list[str] | None:
    """Read the lines; None (and a problem) for what Excel saves where commas are decimal."""
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except UnicodeDecodeError:
        problems.append(_problem(file, "", message("The file is not UTF-8."), _SAVE))
        return None
    heading = next((line for line in lines if line.strip() and not line.startswith("#")), "")
    if ";" in heading or "\t" in heading:
        what = message("The columns are not divided by commas.")
        problems.append(Problem(file, "", what, _DIVIDE, f"  {heading}"))
        return None
    return lines


def _rows(lines: Sequence[str], file: str, problems: list[Problem]) -> list[list[str]] | None:
    """Read the heading and the rows; None (and a problem) where a quotation mark has no end."""
    written = (line for line in lines if line.strip() and not line.startswith("#"))
    try:
        return list(csv.reader(written))
    except csv.Error as fault:
        what = message("The rows cannot be told apart: {fault}.", fault=fault)
        remedy = message("Look for a quotation mark that is opened and never closed.")
        problems.append(_problem(file, "", what, remedy))
        return None


def _source(remarks: Mapping[str, str], language: str) -> str:
    source, mark = (remarks.get(f"{name}.{language}", remarks[name]) for name in _REMARKS)
    return f"{source} ({mark})"


def _written(remarks: Mapping[str, str], name: str) -> Texts | None:
    """Return a remark in every language, in English where nobody translated it."""
    if not remarks.get(name):
        return None
    return Texts({one: remarks.get(f"{name}.{one}", remarks[name]) for one in LANGUAGES})


def _untranslated(
    file: str, written: Mapping[str, str], languages: Sequence[str]
) -> Iterator[Problem]:
    """Yield a problem for each text that students read and that lacks a language of the course.

    The line without a language serves one that lacks its own: one of its letters, if there is one.
    A heading may be a symbol and serve all: one that is a word, or is partly translated, does not.
    """
    for name, text in _served(written, languages).items():
        missing = [one for one in languages if not written.get(f"{name}.{one}")]
        is_heading = name.startswith("column.") and name.count(".") == 1
        in_words = len(missing) < len(languages) or _WORD.search(text) is not None
        if name != "title" and not (is_heading and in_words):
            continue
        fitting = [one for one in missing if (one == "en") is not bool(_CYRILLIC.search(text))]
        served = next(iter([*fitting, *missing]), languages[0])
        for language in missing:
            if text and (language != served or name not in written):
                key = f"{name}.{language}"
                what = message("The text in this language is missing.")
                yield _problem(
                    file, key, what, message("Write a line '# {name}: …' on top.", name=key)
                )


def columns_of(catalogues: Mapping[str, Catalogue]) -> dict[str, Column]:
    """Return every `catalogue.column` in SI, as formulas look it up."""
    return {
        f"{catalogue.id}.{name}": Column(next(iter(catalogue.columns.values())), values)
        for catalogue in catalogues.values()
        for name, values in catalogue.columns.items()
    }


_SAVE = message(
    "Save it as 'CSV UTF-8', with commas between columns and points in numbers: '6.3,10'."
)
_DIVIDE = message("Write commas between columns and points in numbers: '6.3,10', not '6,3;10'.")


def _remarks(lines: Sequence[str]) -> dict[str, str]:
    """Return what the lines on top say, by name."""
    found: dict[str, str] = dict.fromkeys(_REMARKS, "")
    for line in lines:
        name, colon, text = line.removeprefix("#").partition(":")
        if line.startswith("#") and colon:
            found[name.strip()] = text.strip()
    return found


def _served(written: Mapping[str, str], languages: Sequence[str]) -> dict[str, str]:
    """Add the line without a language where there is one in the language that it would serve.

    Where a title has lines of other languages only, the first stands for it: what is missing is a
    translation, and no title.
    """
    named: dict[str, str] = {}
    for language in (_plain(languages), *languages):
        for name, one in written.items():
            stands_in = language == _plain(languages) or not name.startswith(_REMARKS)
            if name.endswith(f".{language}") and stands_in:
                named.setdefault(name.removesuffix(f".{language}"), one)
    return named | {name: one for name, one in written.items() if one or name not in named}


def _plain(languages: Sequence[str]) -> str:
    """Return the language of a line without one: English, or the first of a course without it."""
    return "en" if "en" in languages else languages[0]


def _sourceless(file: str, remarks: Mapping[str, str]) -> Iterator[Problem]:
    for name in _REMARKS:
        if not remarks[name]:
            what = message("The catalogue does not say where its numbers come from.")
            remedy = message("Write a line '# {name}: …' on top.", name=name)
            yield _problem(file, name, what, remedy)


def _header(file: str, rows: list[list[str]], problems: list[Problem]) -> dict[str, str]:
    units: dict[str, str] = {}
    for cell in rows[0] if rows else []:
        name, _, unit = cell.strip().removesuffix("]").partition(" [")
        if not name.isidentifier() or not known_unit(unit) or name in units:
            problems.append(
                _problem(
                    file,
                    message("column {column}", column=cell),
                    message("The heading of the column cannot be used."),
                    message("Write a new name and a known unit: 'size [mm]'."),
                )
            )
        units[name] = unit
    if len(rows) < 2:  # noqa: PLR2004 (the heading and at least one size)
        problems.append(
            _problem(file, "", message("The catalogue is empty."), message("Write its rows."))
        )
    return units


def _strays(file: str, written: Mapping[str, str], units: Mapping[str, str]) -> Iterator[Problem]:
    """Yield lines on top that are about a column which is not there: one of both is misspelt."""
    named = {
        name.split(".")[1]: name for name in reversed(list(written)) if name.startswith("column.")
    }
    for column, line in named.items():
        if units and column not in units:
            what = message("There is no column '{column}' for this line.", column=column)
            yield _problem(file, line, what, did_you_mean(column, units))


def _values(
    file: str, rows: list[list[str]], width: int, problems: list[Problem]
) -> NDArray[np.float64]:
    values: list[list[float]] = []
    for number, row in enumerate(rows[1:], 1):
        try:
            numbers = [float(cell) for cell in row]
        except ValueError:
            numbers = []
        is_held = all(np.isfinite(numbers)) and not any(map(is_lost, row, numbers))
        if len(numbers) != width or not is_held:
            problems.append(
                _problem(
                    file,
                    message("row {row}", row=number),
                    message("The row does not hold a number in each column."),
                    message("Write a number with a point in every column."),
                )
            )
        else:
            values.append(numbers)
    return np.asarray(values, dtype=np.float64).reshape(len(values), width)


def _check_order(
    file: str, units: Mapping[str, str], values: NDArray[np.float64], problems: list[Problem]
) -> None:
    """Sizes must grow strictly: a look-up by size must find one row."""
    if units and len(values) and not np.all(np.diff(values[:, 0]) > 0):
        problems.append(
            _problem(
                file,
                message("column {column}", column=next(iter(units))),
                message("The sizes do not grow from row to row."),
                message("Sort the rows by the first column and remove doubled sizes."),
            )
        )


def _problem(file: str, key: str | Message, what: Message, remedy: Message) -> Problem:
    return Problem(file, key, what, remedy)
