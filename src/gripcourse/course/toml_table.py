"""Reading TOML with every fault collected: where it is, what it is, how to correct it.

Getters never raise on content: they add a `Problem` and return something that lets reading go on,
so that an author sees all faults of a course at once.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from gripcourse.course.renaming import WAS_READ, renaming
from gripcourse.course.shape import Key, KeySort, Shape
from gripcourse.course.toml_faults import toml_values
from gripcourse.errors import Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import LANGUAGES, Message, Texts, message


@dataclass(frozen=True, slots=True)
class Table:
    """One TOML table, its place, the list that its faults go to, and what may stand in it.

    `languages` are those that its texts must be written in.
    """

    values: Mapping[str, object]
    file: str
    key: str
    problems: list[Problem]
    shape: Shape | None = None
    languages: Sequence[str] = LANGUAGES

    def add(self, name: str, what: Message, remedy: Message, excerpt: str = "") -> None:
        """Record a fault at a key of this table (the table itself where `name` is empty)."""
        self.problems.append(Problem(self.file, self._place(name), what, remedy, excerpt))

    def _place(self, name: str) -> str:
        return ".".join(part for part in (self.key, name) if part)

    def has(self, name: str) -> bool:
        """Tell whether the key is written."""
        return name in self.values

    def known_keys(self, known: Iterable[str] | None = None) -> None:
        """Report every key that nobody reads: usually a misspelling.

        Args:
            known: keys that only the course tells; None for those of the table's shape.
        """
        if known is None and (self.shape is None or self.shape.each is not None):
            return
        allowed = set(self.shape.of(self.values) if known is None and self.shape else known or ())
        for name in (one for one in self.values if one not in allowed):
            self._report_unread(name, allowed)

    def _report_unread(self, name: str, allowed: Iterable[str]) -> None:
        """Say of a key that nobody reads what it was, or what may be meant."""
        former = None if self.shape is None else self.shape.former_key(name, self.values)
        if former is not None:
            place = self._place(name)
            return self.problems.append(renaming(self.file, place, WAS_READ, former.now))
        return self.add(name, message("This key means nothing here."), did_you_mean(name, allowed))

    def unknown_word(self, name: str, what: Message, known: Iterable[str]) -> None:
        """Record that a text is none of the words that it may be, and what may be meant."""
        key, word = self._declared(name, KeySort.TEXT), self.values.get(name)
        now = None if key is None else key.former.get(str(word))
        if now is None:
            self.add(name, what, did_you_mean(str(word), known))
        else:
            self.problems.append(renaming(self.file, self._place(name), what, now))

    def text(self, name: str, default: str | None = None) -> str:
        """Read a text; required where there is no default."""
        self._declared(name, KeySort.TEXT, required=default is None)
        value = self._required(name, default, message("a text in quotes"))
        if isinstance(value, str):
            return value
        if value is not None:
            self._wrong_type(name, message("a text in quotes"))
        return default or ""

    def number(self, name: str, default: float | None = None, *, within: bool = True) -> float:
        """Read a finite number; required where there is no default; NaN where it cannot be used.

        A number outside the bounds that the shape names is reported, and read nevertheless; with
        `within` false the reader reports it in words of its own.
        """
        value = self._number(name, default)
        key = self._declared(name, KeySort.NUMBER, required=default is None)
        if within and key is not None and name in self.values and not key.low <= value <= key.high:
            self._out_of_bounds(name, value, key)
        return value

    def _out_of_bounds(self, name: str, value: float, key: Key) -> None:
        if math.isnan(value):
            return  # reported as no number
        what = message("The number is {value}.", value=value)
        if math.isinf(key.low):
            self.add(name, what, message("Write {most} or less.", most=key.high))
        elif math.isinf(key.high):
            self.add(name, what, message("Write {least} or more.", least=key.low))
        else:
            between = message("Write a number from {low} to {high}.", low=key.low, high=key.high)
            self.add(name, what, between)

    def _number(self, name: str, default: float | None) -> float:
        value = self._required(name, default, message("a number"))
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
        self._declared(name, KeySort.NUMBER, required=default is None)
        value = self._number(name, default)
        if value < 0 or value > 1:
            self.add(
                name,
                message("The share is {value}.", value=value),
                message("Write a number from 0 to 1."),
            )
        return value

    def at_least(self, name: str, least: float) -> float:
        """Read a number that is not below another; required; `least` where it cannot be used."""
        key = self._declared(name, KeySort.NUMBER, required=True)
        value = self._number(name, None)
        if value >= least:
            if key is not None and value > key.high:
                self._out_of_bounds(name, value, key)
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
        self._declared(name, KeySort.FLAG, required=False)
        value = self.values.get(name, default)
        if not isinstance(value, bool):
            self._wrong_type(name, message("true or false"))
        return value is True

    def texts(self, name: str, *, may_be_empty: bool = False) -> Texts:
        """Read a text in every language; one plain text serves all (a symbol, for example).

        Where the course is not written in a language, its first one that is stands in.
        """
        self._declared(name, KeySort.TEXTS)
        value = self._required(name, None, message("a text, or a table with en, ru and uk"))
        if isinstance(value, str):
            if not (value.strip() or may_be_empty):
                self._missing(name, message("a text, or a table with en, ru and uk"))
            return Texts(dict.fromkeys(LANGUAGES, value))
        if not isinstance(value, dict):
            if value is not None:
                self._wrong_type(name, message("a text, or a table with en, ru and uk"))
            return Texts(dict.fromkeys(LANGUAGES, ""))
        for language in self.languages:
            if not isinstance(value.get(language), str) or not str(value[language]).strip():
                self.add(
                    f"{name}.{language}",
                    message("The text in this language is missing."),
                    message(
                        "Write it: students read all of {all}. A course that is written in fewer "
                        "says so with 'languages' in course.toml.",
                        all=", ".join(self.languages),
                    ),
                )
        for language in value:
            if language not in LANGUAGES:
                self.add(
                    f"{name}.{language}",
                    message("This is no language of the course."),
                    did_you_mean(language, LANGUAGES),
                )
        first = (value[one] for one in (*self.languages, *value) if value.get(one))
        fallback = str(next(first, ""))
        return Texts({one: str(value.get(one) or fallback) for one in LANGUAGES})

    def numbers(self, name: str, default: Mapping[str, float] | None = None) -> dict[str, float]:
        """Read a table of numbers by name."""
        table = self.table(name)
        if table is None:
            if default is None and name not in self.values:
                self._missing(name, message("a table of numbers"))
            return dict(default or {})
        table.known_keys()
        shape, values = table.shape, table.values
        known = (key for key in values if shape is None or shape.key(key, values) is not None)
        return {key: table.number(key) for key in known}

    def strings(self, name: str) -> tuple[str, ...]:
        """Read a list of texts; absent is empty."""
        self._declared(name, KeySort.STRINGS, required=False)
        value = self.values.get(name, [])
        if isinstance(value, list) and all(isinstance(item, str) for item in value):
            return tuple(value)
        self._wrong_type(name, message("a list of texts in quotes"))
        return ()

    def number_list(self, name: str) -> tuple[float, ...]:
        """Read a list of finite numbers; absent is empty."""
        self._declared(name, KeySort.NUMBERS, required=False)
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
        self._declared(name, KeySort.PAIR)
        value = self.values.get(name)
        if value is None:
            return default
        match value:
            case [int() | float() as low, int() | float() as high] if low <= high:
                return (float(low), float(high))
            case [int() | float() as low, int() | float() as high]:
                self.add(
                    name,
                    message("The first number is above the second."),
                    message(
                        "Write the lower first: [{high}, {low}].",
                        # As it can be copied, without the groups and commas of a language.
                        high=f"{high:g}",
                        low=f"{low:g}",
                    ),
                )
                return default
        self._wrong_type(name, message("two numbers, the lower first"))
        return default

    def table(self, name: str) -> "Table | None":
        """Read a table below this one; None where it is absent."""
        key = self._declared(name, KeySort.TABLE)
        value = self.values.get(name)
        if isinstance(value, dict):
            inside = None if key is None else key.inside
            return replace(self, values=value, key=self._below(name), shape=inside)
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
        key = self._declared(name, KeySort.TABLE, required=True)
        if name not in self.values:
            self._missing(name, message("a table"))
        inside = None if key is None else key.inside
        return replace(self, values={}, key=self._below(name), problems=[], shape=inside)

    def tables(self, name: str) -> tuple["Table", ...]:
        """Read an array of tables; absent is empty."""
        key = self._declared(name, KeySort.TABLES, required=False)
        value = self.values.get(name, [])
        if isinstance(value, list) and all(isinstance(item, dict) for item in value):
            inside = None if key is None else key.inside
            return tuple(
                replace(self, values=item, key=f"{self._below(name)}[{number}]", shape=inside)
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

    def _declared(self, name: str, sort: KeySort, *, required: bool | None = None) -> Key | None:
        """Return what the shape says of a key that is read as `sort`; None without a shape.

        Raises:
            TypeError: our own mistake: the shape says something else, or nothing.
        """
        if self.shape is None:
            return None
        key = self.shape.key(name, self.values)
        if key is None or key.sort not in {sort, KeySort.OTHER}:
            raise TypeError(f"{self.file}: {self._below(name)} is read as {sort}, not declared so")
        if required not in {None, key.required} and name not in self.values:
            raise TypeError(f"{self.file}: {self._below(name)} is not declared as it is required")
        return key

    def _required(self, name: str, default: object, wanted: Message) -> object:
        if name not in self.values and default is None:
            self._missing(name, wanted)
        return self.values.get(name, default)

    def _missing(self, name: str, wanted: Message) -> None:
        what = message("This key is missing.")
        self.add(name, what, message("Write '{name}': {wanted}.", name=name, wanted=wanted))

    def _wrong_type(self, name: str, wanted: Message) -> None:
        self.add(
            name,
            message("The value has the wrong type."),
            message("Write {wanted}.", wanted=wanted),
        )


def read_toml(
    path: Path,
    root: Path,
    problems: list[Problem],
    shape: Shape | None = None,
    languages: Sequence[str] = LANGUAGES,
) -> Table | None:
    """Read a TOML file; None (and a problem) where it is missing or not TOML.

    Args:
        path: of the file.
        root: of the course: the file is named from there.
        problems: takes what is wrong.
        shape: what may stand in it; None where the reader checks the keys itself.
        languages: that its texts must be written in.
    """
    file = str(path.relative_to(root)) if path.is_relative_to(root) else str(path)
    values = toml_values(path, file, problems)
    return None if values is None else Table(values, file, "", problems, shape, languages)
