"""Results as plain values for other programs and back, and the JSON Schema of both.

A result is a frozen dataclass of numbers, texts, dates, enumerations, tuples, mappings and other
such dataclasses. One that has a `SCHEMA`, as `gripcourse/report/1`, carries it in its plain form
under `schema`: the number grows when a key changes its meaning or goes, not when one is added.
"""

import inspect
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from datetime import date, datetime
from enum import StrEnum
from functools import cache
from types import NoneType, UnionType
from typing import Any, Final, TypeVar, get_args, get_origin, get_type_hints

from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import Message, message

KEY: Final = "schema"

Result = TypeVar("Result")

_SCALARS: Final[Mapping[object, tuple[str, tuple[type, ...], Message]]] = {
    str: ("string", (str,), message("A text is wanted.")),
    bool: ("boolean", (bool,), message("Yes or no (true or false) is wanted.")),
    int: ("integer", (int,), message("A whole number is wanted.")),
    float: ("number", (int, float), message("A number is wanted.")),
    date: ("string", (str,), message("A date such as 2026-09-30 is wanted.")),
    datetime: ("string", (str,), message("A date such as 2026-09-30 is wanted.")),
}
_PLAIN: Final = frozenset({str, bool, int, float, NoneType})
_ENTRY: Final = re.compile(r"^    (\w[\w, ]*): (.+(?:\n {8}.+)*)", re.MULTILINE)


def to_plain(value: object) -> Any:  # noqa: ANN401 (whatever JSON can hold)
    """Return a result as dictionaries, lists, texts and numbers that JSON can hold."""
    if type(value) in _PLAIN:
        return value
    if is_dataclass(value) and not isinstance(value, type):
        named = {name: to_plain(getattr(value, name)) for name in _names_of(type(value))}
        schema = getattr(value, "SCHEMA", "")
        return {KEY: schema, **named} if schema else named
    if isinstance(value, StrEnum | date):
        return value.value if isinstance(value, StrEnum) else value.isoformat()
    if isinstance(value, Mapping):
        return {name: to_plain(one) for name, one in value.items()}
    if isinstance(value, tuple):
        return [to_plain(one) for one in value]
    return value


@cache
def _names_of(kind: type[Any]) -> tuple[str, ...]:
    return tuple(one.name for one in fields(kind))


def from_plain(kind: type[Result], plain: object) -> Result:
    """Return the result that a plain form was made of.

    Args:
        kind: of the result.
        plain: as `to_plain` made it; keys that are not known are left aside.

    Raises:
        UsageError: it is of another kind or version, or with every value that cannot be used.
    """
    problems: list[Problem] = []
    made = _read(kind, plain, "", problems)
    if problems:
        raise UsageError(problems)
    return made  # type: ignore[no-any-return]


def json_schema(kind: type[object]) -> dict[str, Any]:
    """Return the JSON Schema (2020-12) of a result's plain form."""
    definitions: dict[str, Any] = {}
    made = _schema_of(kind, definitions)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": getattr(kind, "SCHEMA", kind.__name__),
        **made,
        "$defs": definitions,
    }


def _read(kind: Any, plain: Any, place: str, problems: list[Problem]) -> Any:  # noqa: ANN401
    """Read a value of a kind; what is wrong is recorded with its place."""
    if isinstance(kind, UnionType):
        return None if plain is None else _read(_without_none(kind), plain, place, problems)
    if is_dataclass(kind):
        return _read_fields(kind, plain, place, problems)
    if get_origin(kind) is not None:
        return _read_many(kind, plain, place, problems)
    return _read_scalar(kind, plain, place, problems)


def _read_many(kind: Any, plain: Any, place: str, problems: list[Problem]) -> Any:  # noqa: ANN401
    if get_origin(kind) is tuple:
        if not isinstance(plain, list | tuple):
            return _refuse(place, message("A list is wanted."), problems)
        inner = get_args(kind)[0]
        return tuple(_read(inner, v, f"{place}[{i}]", problems) for i, v in enumerate(plain))
    if not isinstance(plain, Mapping):
        return _refuse(place, message("Names with values are wanted."), problems)
    inner = get_args(kind)[1]
    return {k: _read(inner, v, _below(place, k), problems) for k, v in plain.items()}


def _read_scalar(kind: Any, plain: Any, place: str, problems: list[Problem]) -> Any:  # noqa: ANN401
    if isinstance(kind, type) and issubclass(kind, StrEnum):
        if plain not in list(kind):
            known = ", ".join(kind)
            return _refuse(
                place, message("One of these is wanted: {known}.", known=known), problems
            )
        return kind(plain)
    _, accepted, wanted = _SCALARS[kind]
    if not isinstance(plain, accepted) or (isinstance(plain, bool) and kind is not bool):
        return _refuse(place, wanted, problems)
    read: Callable[[Any], Any] = getattr(kind, "fromisoformat", kind)
    try:
        found = read(plain)
    except (ValueError, OverflowError):
        return _refuse(place, wanted, problems)
    # What JSON does not have, Python writes and reads all the same.
    endless = isinstance(found, float) and not math.isfinite(found)
    return _refuse(place, wanted, problems) if endless else found


def _read_fields(kind: Any, plain: Any, place: str, problems: list[Problem]) -> Any:  # noqa: ANN401
    schema = getattr(kind, "SCHEMA", "")
    if not isinstance(plain, Mapping) or (schema and plain.get(KEY) != schema):
        found = plain.get(KEY) if isinstance(plain, Mapping) else None
        return _refuse(_below(place, KEY), _other_schema(found, schema), problems)
    hints = get_type_hints(kind)
    before = len(problems)
    values: dict[str, Any] = {}
    for one in fields(kind):
        if one.name in plain:
            values[one.name] = _read(
                hints[one.name], plain[one.name], _below(place, one.name), problems
            )
        elif _is_required(one):
            _refuse(_below(place, one.name), message("It is missing."), problems)
    return kind(**values) if len(problems) == before else None


def _other_schema(found: object, known: str) -> Message:
    if isinstance(found, str) and found:
        return message(
            "This has the form '{found}'; this version of gripcourse reads '{known}'.",
            found=found,
            known=known,
        )
    return message("This does not say its form; '{known}' is wanted.", known=known)


def _refuse(place: str, what: Message, problems: list[Problem]) -> None:
    remedy = message("Read what gripcourse wrote, with the version that wrote it or a newer one.")
    problems.append(Problem("", place, what, remedy))


def _below(place: str, name: object) -> str:
    return f"{place}.{name}" if place else str(name)


def _without_none(kind: UnionType) -> Any:  # noqa: ANN401
    (inner,) = (one for one in get_args(kind) if one is not NoneType)
    return inner


def _is_required(one: "Field[Any]") -> bool:
    return one.default is MISSING and one.default_factory is MISSING


def _schema_of(kind: Any, definitions: dict[str, Any]) -> dict[str, Any]:  # noqa: ANN401
    if isinstance(kind, UnionType):
        return {"anyOf": [_schema_of(_without_none(kind), definitions), {"type": "null"}]}
    if is_dataclass(kind):
        name = getattr(kind, "__name__", "")
        if name not in definitions:
            definitions[name] = {}  # a place of its own, also for what holds itself
            definitions[name] = _schema_of_fields(kind, definitions)
        return {"$ref": f"#/$defs/{name}"}
    origin = get_origin(kind)
    if origin is tuple:
        return {"type": "array", "items": _schema_of(get_args(kind)[0], definitions)}
    if origin is not None:
        inner = _schema_of(get_args(kind)[1], definitions)
        return {"type": "object", "additionalProperties": inner}
    if issubclass(kind, StrEnum):
        return {"enum": [one.value for one in kind]}
    form = {date: {"format": "date"}, datetime: {"format": "date-time"}}.get(kind, {})
    return {"type": _SCALARS[kind][0], **form}


def _schema_of_fields(kind: Any, definitions: dict[str, Any]) -> dict[str, Any]:  # noqa: ANN401
    hints, told = get_type_hints(kind), _descriptions(kind)
    properties: dict[str, Any] = {}
    required = [one.name for one in fields(kind) if _is_required(one)]
    schema = getattr(kind, "SCHEMA", "")
    if schema:
        properties[KEY] = {"const": schema}
        required.insert(0, KEY)
    for one in fields(kind):
        said = {"description": told[one.name]} if one.name in told else {}
        properties[one.name] = {**_schema_of(hints[one.name], definitions), **said}
    summary = (inspect.getdoc(kind) or "").partition("\n")[0]
    return {
        "type": "object",
        "description": summary,
        "properties": properties,
        "required": required,
    }


def _descriptions(kind: type[object]) -> dict[str, str]:
    """Read what the docstring of a class says of its attributes."""
    _, _, attributes = (inspect.getdoc(kind) or "").partition("Attributes:\n")
    return {
        name.strip(): " ".join(text.split())
        for names, text in _ENTRY.findall(attributes)
        for name in names.split(",")
    }
