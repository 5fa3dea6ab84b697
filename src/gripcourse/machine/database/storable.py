"""Texts as every database keeps and orders them."""

import re
from collections.abc import Sequence
from itertools import chain
from types import NoneType
from typing import Any, Final

from sqlalchemy import ColumnElement, Engine

_SCALARS: Final = frozenset({int, float, bool, NoneType})
_PLAIN: Final = _SCALARS | {str}
_NEVER_KEPT: Final = re.compile("[\0\ud800-\udfff]")


def storable(parameters: Any) -> Any:  # noqa: ANN401 (whatever stands in a row)
    """Return parameters of a statement with a mark in the place of what cannot be kept."""
    if isinstance(parameters, str):
        return _kept(parameters)
    if isinstance(parameters, dict):
        return {name: _kept(one) if isinstance(one, str) else storable(one)
                for name, one in parameters.items()}  # fmt: skip
    if isinstance(parameters, list | tuple):
        if _is_plain_table(parameters):
            return parameters
        # A batch has some hundred thousand cells: no call of this for most of them.
        return type(parameters)([
            _kept(one) if isinstance(one, str) else one if type(one) in _SCALARS else storable(one)
            for one in parameters
        ])  # fmt: skip
    return parameters


def _is_plain_table(rows: Sequence[Any]) -> bool:
    """Tell whether rows hold numbers and plain texts alone: most of their texts are the same."""
    if not rows or any(type(row) is not tuple for row in rows):
        return False
    if not set(map(type, chain.from_iterable(rows))) <= _PLAIN:
        return False
    return all(_is_plain(one) for one in set(chain.from_iterable(rows)) if type(one) is str)


def _is_plain(text: str) -> bool:
    return text.isascii() and "\0" not in text


def _kept(text: str) -> str:
    return text if _is_plain(text) else _NEVER_KEPT.sub("\ufffd", text)


def in_code_order(engine: Engine, *columns: ColumnElement[Any]) -> list[ColumnElement[Any]]:
    """Return columns to order by, texts as Python and SQLite order them.

    PostgreSQL orders them by the language that the database was made for: Latin and Cyrillic,
    capitals and marks fall elsewhere, and two databases would give two tables.
    """
    if engine.dialect.name != "postgresql":
        return list(columns)
    return [column.collate("C") if column.type.python_type is str else column for column in columns]
