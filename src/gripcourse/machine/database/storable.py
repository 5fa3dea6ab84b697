"""Texts as every database keeps and orders them."""

import re
from types import NoneType
from typing import Any, Final

from sqlalchemy import ColumnElement, Engine

_SCALARS: Final = frozenset({int, float, bool, NoneType})
_NEVER_KEPT: Final = re.compile("[\0\ud800-\udfff]")


def storable(parameters: Any) -> Any:  # noqa: ANN401 (whatever stands in a row)
    """Return parameters of a statement with a mark in the place of what cannot be kept."""
    if isinstance(parameters, str):
        return _kept(parameters)
    if isinstance(parameters, dict):
        return {name: _kept(one) if isinstance(one, str) else storable(one)
                for name, one in parameters.items()}  # fmt: skip
    if isinstance(parameters, list | tuple):
        # A batch has some hundred thousand cells: no call of this for most of them.
        return type(parameters)([
            _kept(one) if isinstance(one, str) else one if type(one) in _SCALARS else storable(one)
            for one in parameters
        ])  # fmt: skip
    return parameters


def _kept(text: str) -> str:
    plain = text.isascii() and "\0" not in text
    return text if plain else _NEVER_KEPT.sub("\ufffd", text)


def in_code_order(engine: Engine, *columns: ColumnElement[Any]) -> list[ColumnElement[Any]]:
    """Return columns to order by, texts as Python and SQLite order them.

    PostgreSQL orders them by the language that the database was made for: Latin and Cyrillic,
    capitals and marks fall elsewhere, and two databases would give two tables.
    """
    if engine.dialect.name != "postgresql":
        return list(columns)
    return [column.collate("C") if column.type.python_type is str else column for column in columns]
