"""Reading TOML with every fault collected: where it is, what it is, how to mend it.

Getters never raise on content: they add a `Problem` and return something that lets reading go on,
so that an author sees all faults of a course at once.
"""

import math
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from gripcourse.errors import Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, Message, Texts, message


@dataclass(frozen=True, slots=True)
class Table:
    """One TOML table, its place, and the list that its faults go to."""

    values: Mapping[str, object]
    file: str
    key: str
    problems: list[Problem]

    def add(self, name: str, what: Message, remedy: Message, excerpt: str = "") -> None:
        """Record a fault at a key of this table (the table itself where `name` is empty)."""
        key = ".".join(part for part in (self.key, name) if part)
        self.problems.append(Problem(self.file, key, what, remedy, excerpt))

    def has(self, name: str) -> bool:
        """Tell whether the key is written."""
        return name in self.values

    def known_keys(self, known: Iterable[str]) -> None:
        """Report every key that nobody reads: usually a misspelling."""
        allowed = set(known)
        for name in self.values:
            if name not in allowed:
                self.add(name, message("This key means nothing here."), did_you_mean(name, allowed))

    def text(self, name: str, default: str | None = None) -> str:
        """Read a text; required where there is no default."""
        value = self._required(name, default)
        if isinstance(value, str):
            return value
        if value is not None:
            self._wrong_type(name, message("a text in quotes"))
        return default or ""

    def number(self, name: str, default: float | None = None) -> float:
        """Read a finite number; required where there is no default; NaN where it cannot be used."""
        value = self._required(name, default)
        if name not in self.values:
            return default if default is not None else float("nan")
        match value:
            case bool():
                pass
            case int() | float() if math.isfinite(value):
                return float(value)
        if value is not None:
            self._wrong_type(name, message("a number"))
        return default if default is not None else float("nan")

    def share(self, name: str, default: float | None = None) -> float:
        """Read a number from 0 to 1; required where there is no default."""
        value = self.number(name, default)
        if value < 0 or value > 1:
            self.add(
                name,
                message("The share is {value}.", value=value),
                message("Write a number from 0 to 1."),
            )
        return value

    def at_least(self, name: str, least: float) -> float:
        """Read a number that is not below another; required; `least` where it cannot be used."""
        value = self.number(name)
        if value >= least:
            return value
        if not math.isnan(value):
            self.add(
                name,
                message("The number is {value}.", value=value),
                message("Write {least} or more.", least=least),
            )
        return least

    def flag(self, name: str, *, default: bool = False) -> bool:
        """Read true or false; absent is `default`."""
        value = self.values.get(name, default)
        if not isinstance(value, bool):
            self._wrong_type(name, message("true or false"))
        return value is True

    def texts(self, name: str, *, may_be_empty: bool = False) -> Texts:
        """Read a text in every language; one plain text serves all (a symbol, for example)."""
        value = self._required(name, None)
        if isinstance(value, str):
            if not (value.strip() or may_be_empty):
                self._missing(name)
            return Texts(dict.fromkeys(LANGUAGES, value))
        if not isinstance(value, dict):
            if value is not None:
                self._wrong_type(name, message("a text, or a table with en, ru and uk"))
            return Texts(dict.fromkeys(LANGUAGES, ""))
        for language in LANGUAGES:
            if not isinstance(value.get(language), str) or not str(value[language]).strip():
                self.add(
                    f"{name}.{language}",
                    message("The text in this language is missing."),
                    message("Write it: students read all of {all}.", all=", ".join(LANGUAGES)),
                )
        for language in value:
            if language not in LANGUAGES:
                self.add(
                    f"{name}.{language}",
                    message("This is no language of the course."),
                    did_you_mean(language, LANGUAGES),
                )
        fallback = next((str(text) for text in value.values()), "")
        return Texts({one: str(value.get(one) or fallback) for one in LANGUAGES})

    def numbers(self, name: str, default: Mapping[str, float] | None = None) -> dict[str, float]:
        """Read a table of numbers by name."""
        table = self.table(name)
        if table is None:
            if default is None:
                self._missing(name)
            return dict(default or {})
        return {key: table.number(key) for key in table.values}

    def strings(self, name: str) -> tuple[str, ...]:
        """Read a list of texts; absent is empty."""
        value = self.values.get(name, [])
        if isinstance(value, list) and all(isinstance(item, str) for item in value):
            return tuple(value)
        self._wrong_type(name, message("a list of texts in quotes"))
        return ()

    def number_list(self, name: str) -> tuple[float, ...]:
        """Read a list of finite numbers; absent is empty."""
        value = self.values.get(name, [])
        if isinstance(value, list) and all(
            isinstance(one, int | float) and not isinstance(one, bool) and math.isfinite(one)
            for one in value
        ):
            return tuple(float(one) for one in value)
        self._wrong_type(name, message("a list of numbers"))
        return ()

    def pair(self, name: str, default: tuple[float, float]) -> tuple[float, float]:
        """Read two numbers, the lower first."""
        value = self.values.get(name)
        if value is None:
            return default
        match value:
            case [int() | float() as low, int() | float() as high] if low <= high:
                return (float(low), float(high))
        self._wrong_type(name, message("two numbers, the lower first"))
        return default

    def table(self, name: str) -> "Table | None":
        """Read a table below this one; None where it is absent."""
        value = self.values.get(name)
        if isinstance(value, dict):
            return Table(value, self.file, self._below(name), self.problems)
        if value is not None:
            self._wrong_type(name, message("a table"))
        return None

    def required_table(self, name: str) -> "Table":
        """Read a table that must be there.

        An empty one stands in for a missing one; what it lacks is not reported key by key.
        """
        found = self.table(name)
        if found is not None:
            return found
        if name not in self.values:
            self._missing(name)
        return Table({}, self.file, self._below(name), [])

    def tables(self, name: str) -> tuple["Table", ...]:
        """Read an array of tables; absent is empty."""
        value = self.values.get(name, [])
        if isinstance(value, list) and all(isinstance(item, dict) for item in value):
            return tuple(
                Table(item, self.file, f"{self._below(name)}[{number}]", self.problems)
                for number, item in enumerate(value, 1)
            )
        self._wrong_type(name, message("an array of tables"))
        return ()

    def named_tables(self, name: str) -> Mapping[str, "Table"]:
        """Read a table of tables, for example all quantities by id."""
        outer = self.table(name)
        if outer is None:
            return {}
        inner = {key: outer.table(key) for key in outer.values}
        return {key: table for key, table in inner.items() if table is not None}

    def _below(self, name: str) -> str:
        return f"{self.key}.{name}" if self.key else name

    def _required(self, name: str, default: object) -> object:
        if name not in self.values and default is None:
            self._missing(name)
        return self.values.get(name, default)

    def _missing(self, name: str) -> None:
        self.add(name, message("This key is missing."), message("Write it."))

    def _wrong_type(self, name: str, wanted: Message) -> None:
        self.add(
            name,
            message("The value has the wrong type."),
            message("Write {wanted}.", wanted=wanted),
        )


def read_toml(path: Path, root: Path, problems: list[Problem]) -> Table | None:
    """Read a TOML file; None (and a problem) where it is missing or not TOML."""
    file = str(path.relative_to(root)) if path.is_relative_to(root) else str(path)
    try:
        return Table(tomllib.loads(path.read_text(encoding="utf-8-sig")), file, "", problems)
    except FileNotFoundError:
        problems.append(
            Problem(file, "", message("The file is missing."), message("Write it or restore it."))
        )
    except UnicodeDecodeError:
        problems.append(
            Problem(file, "", message("The file is not UTF-8."), message("Save it as UTF-8."))
        )
    except tomllib.TOMLDecodeError as fault:
        problems.append(
            Problem(
                file,
                "",
                message("This is not valid TOML: {fault}.", fault=str(fault)),
                message("Mend the line that is named."),
            )
        )
    return None
