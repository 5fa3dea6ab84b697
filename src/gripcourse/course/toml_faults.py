"""What is wrong with a file that is no TOML: in the author's language, with the line."""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import tomli

from gripcourse.course.toml_bounds import shorten_long
from gripcourse.errors import Problem
from gripcourse.text.number_text import is_lost
from gripcourse.text.words import Message, message

_PLACE: Final = re.compile(
    r"^(?P<what>.*) \(at (?:line (?P<line>\d+), column (?P<column>\d+)|end.*)\)$"
)
_NAMES: Final = re.compile(r"'([^']*)'")
_DECIMAL_COMMA: Final = re.compile(r"=\s*[-+]?\d+,\d")


@dataclass(frozen=True, slots=True)
class _Kind:
    """A sort of fault: how the library begins to say it, and what we say."""

    begins: tuple[str, ...]
    what: Message
    remedy: Message


_KINDS: Final = (
    _Kind(
        ("Illegal character '\\n'", "Illegal character '\\r", "Unterminated string"),
        message("A text in quotes does not end on its line."),
        message('Write the closing quote, or three quotes """ around a text of several lines.'),
    ),
    _Kind(
        ("Illegal character", "Unescaped", "Invalid hex", "Escaped character"),
        message("A character in this text cannot be written so."),
        message("Write the text in single quotes: '\\alpha', or double the backslash."),
    ),
    _Kind(
        ("Cannot declare", "Cannot overwrite", "Cannot redefine", "Duplicate inline table key",
         "Cannot mutate"),
        message("Something is declared twice in this file."),
        message("Keep one of the two."),
    ),
    _Kind(
        ("Unclosed array", "Unclosed inline table", "Expected newline or end of document",
         "Invalid initial character", "Expected ']'"),
        message("A bracket, a comma or a quote is missing, or there is too much of something."),
        message("Compare this line and the one before with a table that is right."),
    ),
    _Kind(
        ("Expected '='",),
        message("There is no '=' after a key."),
        message("Write key = value; a comment begins with #."),
    ),
    _Kind(
        ("Invalid value",),
        message("This is not a value."),
        message('Write a text in quotes: "mm"; a number with a point: 0.75; true or false.'),
    ),
)  # fmt: skip
_OTHER: Final = _Kind(
    (),
    message("This is no TOML."),
    message("Compare this line and the one before with a table that is right."),
)
_COMMA: Final = _Kind(
    (),
    message("A number is written with a decimal point, not a comma."),
    message("Write a point: 0.75."),
)


def toml_values(path: Path, file: str, problems: list[Problem]) -> dict[str, object] | None:
    """Read a TOML file; None (and a problem) where it is missing or not TOML.

    Args:
        path: of the file.
        file: its name for messages.
        problems: takes what is wrong.
    """
    try:
        text = path.read_text(encoding="utf-8-sig")
        values = tomli.loads(text, parse_float=_number)
    except FileNotFoundError:
        what, remedy = message("The file is missing."), message("Write it or restore it.")
        problems.append(Problem(file, "", what, remedy))
    except UnicodeDecodeError:
        what, remedy = message("The file is not UTF-8."), message("Save it as UTF-8.")
        problems.append(Problem(file, "", what, remedy))
    except (ValueError, RecursionError) as fault:  # digits or brackets without end, too
        problems.append(toml_problem(file, text, str(fault)))
    else:
        shorten_long(values, file, problems)
        return values
    return None


def _number(written: str) -> float:
    """Read a number; one so small that it would be taken as 0 is none."""
    value = float(written)
    return math.nan if is_lost(written, value) else value


def toml_problem(file: str, text: str, fault: str) -> Problem:
    """Say what is wrong with a text that is no TOML.

    Args:
        file: for the message.
        text: of the file.
        fault: what the library says, with line and column.
    """
    found = _PLACE.match(fault)
    said = found["what"] if found else fault
    lines = text.splitlines()
    at_end = found is None or found["line"] is None
    number = len(lines) if at_end or found is None else int(found["line"])
    kind = _kind_of(said, lines, number)
    if kind is _KINDS[2]:
        number = _line_of_second(said, lines, number)
    line = lines[number - 1] if 0 < number <= len(lines) else ""
    if kind is _KINDS[2] and (name := _doubled(said, line)):
        kind = _Kind(
            (), message("'{name}' is declared twice in this file.", name=name), kind.remedy
        )
    return Problem(
        file, message("line {line}", line=number), kind.what, kind.remedy, f"  {line.strip()}"
    )


def _kind_of(said: str, lines: Sequence[str], number: int) -> _Kind:
    line = lines[number - 1] if 0 < number <= len(lines) else ""
    if _DECIMAL_COMMA.search(line):
        return _COMMA
    return next((one for one in _KINDS if said.startswith(one.begins)), _OTHER)


def _line_of_second(said: str, lines: Sequence[str], number: int) -> int:
    """Return the line of the heading that comes again; the library names the line after it."""
    name = ".".join(_NAMES.findall(said))
    places = [place for place, line in enumerate(lines, 1) if line.strip() == f"[{name}]"]
    return places[1] if name and len(places) > 1 else number


def _doubled(said: str, line: str) -> str:
    """Return the name of what is declared twice: of a table, or of a key on its line."""
    return ".".join(_NAMES.findall(said)) or line.partition("=")[0].strip().strip("[]")
