"""Texts as every database keeps and orders them."""

import re
from typing import Any, Final

from sqlalchemy import ColumnElement, Engine

_NEVER_KEPT: Final = re.compile("[\0\ud800-\udfff]")


def storable(parameters: Any) -> Any:  # noqa: ANN401 (whatever stands in a row)
    """Return parameters of a statement with a mark in the place of what cannot be kept."""
    if isinstance(parameters, str):
        return _NEVER_KEPT.sub("\ufffd", parameters)
    if isinstance(parameters, dict):
        return {name: storable(one) for name, one in parameters.items()}
    if isinstance(parameters, list | tuple):
        return type(parameters)(map(storable, parameters))
    return parameters


def in_code_order(engine: Engine, *columns: ColumnElement[Any]) -> list[ColumnElement[Any]]:
    """Return columns to order by, texts as Python and SQLite order them.

    PostgreSQL orders them by the language that the database was made for: Latin and Cyrillic,
    capitals and marks fall elsewhere, and two databases would give two tables.
    """
    if engine.dialect.name != "postgresql":
        return list(columns)
    return [column.collate("C") if column.type.python_type is str else column for column in columns]
