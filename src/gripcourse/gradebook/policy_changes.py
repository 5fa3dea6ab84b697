"""Which lines of a policy say something else than those of an earlier one. Pure.

Values are compared, not bytes: comments, layout, the order of keys, and how a number is written
change nothing.
"""

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from itertools import chain
from typing import Final

import tomli

_BARE: Final = re.compile(r"[A-Za-z0-9_-]+")
_NOWHERE: Final = object()  # what is not written, beside anything that may be


@dataclass(frozen=True, slots=True)
class PolicyLine:
    """A key of a policy with another value than before.

    Attributes:
        file: relative to the folder of the course.
        key: dotted, as it is written; a table of a list is named by its id or its number. Empty for
            the file itself: it came, it went, or it is no TOML and cannot be compared.
        before, after: values as TOML; None where there is none, empty of a file that is there.
    """

    file: str
    key: str
    before: str | None
    after: str | None


def changed_lines(
    before: Mapping[str, bytes], after: Mapping[str, bytes]
) -> tuple[PolicyLine, ...]:
    """Return what differs between two policies; nothing where only comments or layout do.

    Args:
        before: contents of the files, by path relative to the folder of the course.
        after: the same of the later policy.
    """
    names = sorted({*before, *after})
    pairs = ((name, before.get(name), after.get(name)) for name in names)
    return tuple(chain.from_iterable(_of_file(*pair) for pair in pairs))


def _of_file(file: str, before: bytes | None, after: bytes | None) -> Iterator[PolicyLine]:
    if before is None or after is None:
        yield PolicyLine(file, "", *(None if one is None else "" for one in (before, after)))
        return
    old, new = _values(before), _values(after)
    if old is not None and new is not None:
        yield from _differing(file, "", old, new)
    elif before != after:
        yield PolicyLine(file, "", "", "")


def _values(content: bytes) -> dict[str, object] | None:
    """Read a file; None where it is no TOML. Numbers stay as they are written."""
    try:
        return tomli.loads(content.decode("utf-8-sig"), parse_float=Decimal)
    except (ValueError, ArithmeticError, RecursionError):
        return None


def _differing(file: str, key: str, before: object, after: object) -> Iterator[PolicyLine]:
    tables = _table(before), _table(after)
    old, new = (_named(one) for one in (before, after))
    if old is not None and new is not None:
        # What came or went of a list is one thing, whatever it consists of.
        for name in dict.fromkeys((*old, *new)):
            place = f"{key}[{name}]"
            if name in old and name in new:
                yield from _differing(file, place, old[name], new[name])
            else:
                yield PolicyLine(file, place, _written(old.get(name)), _written(new.get(name)))
    elif any(tables) and all(one is not None for one in tables):
        first, second = (one or {} for one in tables)
        for name in dict.fromkeys((*first, *second)):
            place = ".".join(filter(None, (key, _bare(name))))
            pair = first.get(name, _NOWHERE), second.get(name, _NOWHERE)
            yield from _differing(file, place, *pair)
    elif _plain(before) != _plain(after):
        yield PolicyLine(file, key, _written(before), _written(after))


def _table(value: object) -> dict[str, object] | None:
    """Return a table; an empty one where nothing is written, None for anything else."""
    if value is _NOWHERE:
        return {}
    return value if isinstance(value, dict) else None


def _named(value: object) -> dict[str, dict[str, object]] | None:
    """Return the tables of a list by their ids, or by their numbers; None for anything else."""
    if not isinstance(value, list) or not all(isinstance(one, dict) for one in value):
        return None
    ids = [one.get("id") for one in value]
    if len({*map(str, ids)}) < len(ids) or not all(isinstance(one, str) for one in ids):
        ids = [str(number) for number in range(1, len(ids) + 1)]
    return dict(zip(map(str, ids), value, strict=True))


def _plain(value: object) -> object:
    """Return a value that is equal to what means the same; true is not 1."""
    match value:
        case bool():
            return "true or false", value
        case dict():
            return {name: _plain(one) for name, one in value.items()}
        case list():
            return [_plain(one) for one in value]
    return value


def _written(value: object) -> str | None:
    """Return a value as it is written in TOML, on one line; None where there is none."""
    match value:
        case None:
            return None
        case bool():
            return str(value).lower()
        case str():
            return json.dumps(value, ensure_ascii=False)
        case dict():
            pairs = ", ".join(f"{_bare(name)} = {_written(one)}" for name, one in value.items())
            return f"{{ {pairs} }}" if pairs else "{}"
        case list():
            return f"[{', '.join(str(_written(one)) for one in value)}]"
    return None if value is _NOWHERE else str(value).lower()


def _bare(name: str) -> str:
    """Return a key as TOML has it: in quotes where it is no word."""
    return name if _BARE.fullmatch(name) else json.dumps(name, ensure_ascii=False)
