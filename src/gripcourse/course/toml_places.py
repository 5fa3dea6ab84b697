"""Where keys and values stand in the text of a TOML file: one is changed, and the rest stays.

The text is known to be TOML: a parser has read it. A path names tables and keys from the top of the
file, and the elements of arrays by their numbers from 0.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, TypeAlias

KeyPath: TypeAlias = tuple[str | int, ...]
Span: TypeAlias = tuple[int, int]

_BARE: Final = re.compile(r"[A-Za-z0-9_-]+")
_BLANK: Final = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_INLINE_BLANK: Final = re.compile(r"[ \t]*")
_SCALAR: Final = re.compile(r"[^,\]}#\r\n]+")
_TEXT: Final = re.compile(
    r'"""(?:\\.|[^\\])*?"{3,5}|' r"'''.*?'{3,5}|" r'"(?:\\.|[^"\\\n])*"|' r"'[^'\n]*'", re.DOTALL
)


@dataclass(frozen=True, slots=True)
class KeyPlace:
    """A name of a key or of a table, where it is written.

    Attributes:
        path: what it names.
        span: of the name itself, with its quotes.
        value: of what is written behind it; None in the heading of a table, and where further
            names of a key follow.
        statement: of the line or lines that say nothing else; None inside of braces.
    """

    path: KeyPath
    span: Span
    value: Span | None
    statement: Span | None


def key_places(text: str) -> list[KeyPlace]:
    """Return the places of all names of keys and tables in a text that is TOML, in order."""
    return list(_Scanner(text).places())


class _Scanner:
    """Goes through a text once."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0
        self._last: dict[KeyPath, int] = {}  # number of the last table of each array of tables

    def places(self) -> Iterator[KeyPlace]:
        table: KeyPath = ()
        self._skip(_BLANK)
        while self._at < len(self._text):
            if self._text[self._at] == "[":
                names = self._heading()
                table = names[-1].path
                yield from names
                if self._last.get(table) is not None:
                    table = (*table, self._last[table])
            else:
                yield from self._assignment(table, is_statement=True)
            self._skip(_BLANK)

    def _heading(self) -> list[KeyPlace]:
        is_array = self._text.startswith("[[", self._at)
        self._at += 2 if is_array else 1
        names = [KeyPlace(path, span, None, None) for path, span in self._names(())]
        self._at += 2 if is_array else 1
        if is_array:
            path = names[-1].path
            self._last[path] = self._last.get(path, -1) + 1
        return names

    def _names(self, table: KeyPath) -> list[tuple[KeyPath, Span]]:
        """Read names with dots between; what names an array of tables means the last of these."""
        found: list[tuple[KeyPath, Span]] = []
        path = table
        while True:
            self._skip(_INLINE_BLANK)
            begin = self._at
            self._skip(_BARE if self._text[begin] not in "\"'" else _TEXT)
            name = self._text[begin : self._at].strip("\"'")
            path = (*path, name)
            found.append((path, (begin, self._at)))
            self._skip(_INLINE_BLANK)
            if self._text[self._at] != ".":
                return found
            self._at += 1
            if path in self._last:
                path = (*path, self._last[path])

    def _assignment(self, table: KeyPath, *, is_statement: bool) -> Iterator[KeyPlace]:
        begin = self._at
        names = self._names(table)
        self._at += 1  # the equals sign
        self._skip(_INLINE_BLANK)
        start = self._at
        inside = self._value(names[-1][0])
        value = (start, self._at)
        statement = (begin, self._at) if is_statement else None
        *tables, (path, span) = names
        yield from (KeyPlace(one, where, None, None) for one, where in tables)
        yield KeyPlace(path, span, value, statement)
        yield from inside

    def _value(self, path: KeyPath) -> list[KeyPlace]:
        """Go through a value; return the names that stand inside of it."""
        found: list[KeyPlace] = []
        match self._text[self._at]:
            case "{":
                self._at += 1
                self._skip(_BLANK)
                while self._text[self._at] != "}":
                    found += self._assignment(path, is_statement=False)
                    self._skip_comma()
                self._at += 1
            case "[":
                self._at += 1
                self._skip(_BLANK)
                number = 0
                while self._text[self._at] != "]":
                    found += self._value((*path, number))
                    number += 1
                    self._skip_comma()
                self._at += 1
            case '"' | "'":
                self._skip(_TEXT)
            case _:
                scalar = _SCALAR.match(self._text, self._at)
                self._at += len(scalar[0].rstrip()) if scalar else 0
        return found

    def _skip_comma(self) -> None:
        self._skip(_BLANK)
        if self._text[self._at] == ",":
            self._at += 1
            self._skip(_BLANK)

    def _skip(self, pattern: re.Pattern[str]) -> None:
        found = pattern.match(self._text, self._at)
        self._at = self._at if found is None else found.end()
