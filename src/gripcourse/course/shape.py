"""What may stand in a table of a TOML file: each key once, with its sort and its meaning.

Readers ask a `Table` for keys of its shape; one that the shape does not know, or knows to be of
another sort, is our own mistake and raises. Unknown keys of an author, the JSON Schema for editors
and the page of all keys follow from the same shapes, so none of them can differ from what is read.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum


class KeySort(StrEnum):
    """What a key holds."""

    TEXT = "text"
    TEXTS = "text in every language"
    NUMBER = "number"
    FLAG = "true or false"
    STRINGS = "list of texts"
    NUMBERS = "list of numbers"
    PAIR = "two numbers"
    TABLE = "table"
    TABLES = "array of tables"
    OTHER = "a form of its own"  # read by its own reader; `Key.form` says how it is written


@dataclass(frozen=True, slots=True)
class Key:
    """One key.

    Attributes:
        sort: what it holds.
        meaning: a sentence for an author.
        required: whether it must be written.
        inside: what a TABLE, or each of TABLES, holds.
        words: a text is one of these; empty for any.
        low, high: a number lies between them.
        form: JSON Schema of what is written in a form of its own (OTHER).
        former: words of earlier programs, by what is written for them now.
    """

    sort: KeySort
    meaning: str
    required: bool = False
    inside: "Shape | None" = None
    words: tuple[str, ...] = ()
    low: float = float("-inf")
    high: float = float("inf")
    form: Mapping[str, object] = field(default_factory=dict)
    former: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Former:
    """What became of a key that an earlier program read.

    Attributes:
        now: where it stands now, seen from its table, with dots between; empty for what is gone.
        adds: texts of other keys that must be said now, as the earlier program took them so.
    """

    now: str
    adds: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Shape:
    """The keys of a table.

    Attributes:
        keys: by name.
        each: what any other name holds, where the author chooses the names; None for no others.
        by: the key whose text decides which further keys there are; empty for none.
        kinds: these keys by that text.
        former: keys of earlier programs. An author of a course that is written for one is told so.
        former_kinds: such keys of tables of one kind, by that text.
    """

    keys: Mapping[str, Key]
    each: Key | None = None
    by: str = ""
    kinds: Mapping[str, Mapping[str, Key]] = field(default_factory=dict)
    former: Mapping[str, Former] = field(default_factory=dict)
    former_kinds: Mapping[str, Mapping[str, Former]] = field(default_factory=dict)

    def former_key(self, name: str, values: Mapping[str, object]) -> Former | None:
        """Return what became of a name in a table with these values; None where it never was."""
        kind = values.get(self.by)
        further = self.former_kinds.get(kind) if isinstance(kind, str) else None
        return (further or {}).get(name) or self.former.get(name)

    def of(self, values: Mapping[str, object]) -> Mapping[str, Key]:
        """Return the keys that a table with these values may have, but for free names."""
        kind = values.get(self.by)
        return {**self.keys, **self.kinds.get(kind, {})} if isinstance(kind, str) else self.keys

    def key(self, name: str, values: Mapping[str, object]) -> Key | None:
        """Return what a name means in a table with these values; None where it means nothing."""
        kind = values.get(self.by)
        further = self.kinds.get(kind) if isinstance(kind, str) else None
        own = further.get(name) if further is not None else None
        return own or self.keys.get(name, self.each)


def text(meaning: str, *words: str, required: bool = False) -> Key:
    """Make a key that holds a text, one of some words if they are named."""
    return Key(KeySort.TEXT, meaning, required, words=words)


def texts(meaning: str, *, required: bool = False) -> Key:
    """Make a key that holds a text in every language of the course."""
    return Key(KeySort.TEXTS, meaning, required)


def number(
    meaning: str,
    low: float = float("-inf"),
    high: float = float("inf"),
    *,
    required: bool = False,
) -> Key:
    """Make a key that holds a number, between bounds if they are named."""
    return Key(KeySort.NUMBER, meaning, required, low=low, high=high)


def flag(meaning: str) -> Key:
    """Make a key that holds true or false; absent is false."""
    return Key(KeySort.FLAG, meaning)


def strings(meaning: str, *words: str) -> Key:
    """Make a key that holds a list of texts; absent is empty."""
    return Key(KeySort.STRINGS, meaning, words=words)


def table(meaning: str, inside: Shape | Mapping[str, Key], *, required: bool = False) -> Key:
    """Make a key that holds a table."""
    return Key(KeySort.TABLE, meaning, required, inside=_shape(inside))


def tables(meaning: str, inside: Shape | Mapping[str, Key]) -> Key:
    """Make a key that holds an array of tables; absent is empty."""
    return Key(KeySort.TABLES, meaning, inside=_shape(inside))


def by_name(meaning: str, each: Key, *, required: bool = False) -> Key:
    """Make a key that holds a table whose names the author chooses."""
    return Key(KeySort.TABLE, meaning, required, inside=Shape({}, each))


def other(meaning: str, form: Mapping[str, object], *, required: bool = False) -> Key:
    """Make a key that is written in a form of its own."""
    return Key(KeySort.OTHER, meaning, required, form=form)


def needed(key: Key) -> Key:
    """Return a key as one that must be written."""
    return replace(key, required=True)


def _shape(inside: Shape | Mapping[str, Key]) -> Shape:
    return inside if isinstance(inside, Shape) else Shape(inside)
