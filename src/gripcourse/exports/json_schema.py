"""JSON Schema of a TOML file, from the shape that its reader uses: for editors of declarations."""

import math
from collections.abc import Mapping
from typing import Final, TypeAlias

from gripcourse.course.shape import Key, KeySort, Shape
from gripcourse.text.words import LANGUAGES

Schema: TypeAlias = dict[str, object]

DRAFT: Final = "https://json-schema.org/draft/2020-12/schema"
_NUMBERS: Final[Schema] = {"type": "array", "items": {"type": "number"}}
_IN_LANGUAGES: Final[Schema] = {
    "type": "object",
    "properties": {one: {"type": "string"} for one in LANGUAGES},
    "minProperties": 1,
    "additionalProperties": False,
}
_PLAIN: Final[Mapping[KeySort, Schema]] = {
    KeySort.TEXTS: {"anyOf": [{"type": "string"}, _IN_LANGUAGES]},
    KeySort.FLAG: {"type": "boolean"},
    KeySort.NUMBERS: _NUMBERS,
    KeySort.PAIR: _NUMBERS | {"minItems": 2, "maxItems": 2},
}


def json_schema(title: str, shape: Shape) -> Schema:
    """Return the schema of a file.

    Args:
        title: what the file is.
        shape: what its reader knows.
    """
    return {"$schema": DRAFT, "title": title, **_of_shape(shape)}


def _of_shape(shape: Shape) -> Schema:
    """Return the schema of a table; of one with kinds, one alternative for each."""
    if not shape.by:
        return _object(shape.keys, shape.each)
    alternatives = [
        _object({**shape.keys, **keys}, shape.each, {shape.by: kind})
        for kind, keys in shape.kinds.items()
    ]
    return {"type": "object", "oneOf": alternatives}


def _object(
    keys: Mapping[str, Key], each: Key | None, fixed: Mapping[str, str] | None = None
) -> Schema:
    properties = {name: _of_key(key) for name, key in keys.items()}
    for name, value in (fixed or {}).items():
        properties[name] = {"const": str(value), "description": keys[name].meaning}
    return {
        "type": "object",
        "properties": properties,
        "required": [name for name, key in keys.items() if key.required],
        "additionalProperties": False if each is None else _of_key(each),
    }


def _of_key(key: Key) -> Schema:
    return {"description": key.meaning, **_of_sort(key)}


def _of_sort(key: Key) -> Schema:
    match key.sort:
        case KeySort.TEXT | KeySort.STRINGS:
            return _repeated(_text(key)) if key.sort is KeySort.STRINGS else _text(key)
        case KeySort.NUMBER:
            return _number(key)
        case KeySort.TABLE | KeySort.TABLES:
            inside = _of_shape(key.inside or Shape({}))
            return _repeated(inside) if key.sort is KeySort.TABLES else inside
        case KeySort.OTHER:
            return dict(key.form)
        case _:
            return dict(_PLAIN[key.sort])


def _repeated(items: Schema) -> Schema:
    return {"type": "array", "items": items}


def _text(key: Key) -> Schema:
    return (
        {"type": "string", "enum": [str(word) for word in key.words]}
        if key.words
        else {"type": "string"}
    )


def _number(key: Key) -> Schema:
    found: Schema = {"type": "number"}
    if not math.isinf(key.low):
        found["minimum"] = key.low
    if not math.isinf(key.high):
        found["maximum"] = key.high
    return found
