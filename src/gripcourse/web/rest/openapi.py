"""The OpenAPI 3.1 document, made from the declarations of the operations and of the results."""

import inspect
from collections.abc import Iterable, Sequence
from itertools import groupby
from types import NoneType
from typing import Any, Final

from gripcourse import __version__
from gripcourse.exports.plain import json_schema
from gripcourse.machine.content import NamedBytes
from gripcourse.text.words import LANGUAGES
from gripcourse.web.acts import LONGEST_SENTENCE
from gripcourse.web.refusals import STATUS, Code
from gripcourse.web.rest.declare import FILES, PLACES, ApiOperation, TokenRole
from gripcourse.web.rest.problems import MEDIA, RefusalResult
from gripcourse.web.rest.wishes import RegradeWish

_COMPONENTS: Final = "#/components/schemas/"
_FILE: Final = {
    "type": "object",
    "properties": {
        "file": {
            "type": "string",
            "format": "binary",
            "contentMediaType": "application/octet-stream",
        }
    },
    "required": ["file"],
}
_TOKENS: Final = {
    TokenRole.STUDENT: "The part of a personal link behind `/s/`; who has it is that student.",
    TokenRole.SIGN_IN: "The part of a link of `gripcourse sign-in` behind `/desk/sign-in/`.",
    TokenRole.INSTRUCTOR: "What signing in gave back.",
}
_LANGUAGE: Final = {
    "name": "Accept-Language",
    "in": "header",
    "description": f"Language of sentences, the first that is named of: {', '.join(LANGUAGES)}.",
    "schema": {"type": "string"},
}
_LIMITS: Final = {
    (RegradeWish, "sentence"): {"pattern": r"\S", "maxLength": LONGEST_SENTENCE},
}
"""What a body must be besides its types; `acts` refuses the same."""


def description(operations: Sequence[ApiOperation], base: str) -> dict[str, Any]:
    """Return the document.

    Args:
        operations: all that there are, those of a path one after the other.
        base: path of the server below which they stand.
    """
    schemas: dict[str, Any] = {}
    paths = {
        PLACES.sub(r"{\1}", path): {one.method.lower(): _operation(one, schemas) for one in same}
        for path, same in groupby(operations, key=lambda one: one.path)
    }
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "gripcourse",
            "version": __version__,
            "description": "Checking and handing in for a student's program, the desk for an"
            " instructor's. Whatever is refused comes with a code and a sentence.",
        },
        "servers": [{"url": base}],
        "paths": paths,
        "components": {
            "schemas": dict(sorted(schemas.items())),
            "securitySchemes": {
                role.value: {"type": "http", "scheme": "bearer", "description": said}
                for role, said in _TOKENS.items()
            },
        },
    }


def _operation(one: ApiOperation, schemas: dict[str, Any]) -> dict[str, Any]:
    made: dict[str, Any] = {
        "operationId": one.answer.__name__,
        "summary": (inspect.getdoc(one.answer) or "").partition("\n")[0],
        "tags": ["student" if one.role is TokenRole.STUDENT else "desk"],
        "security": [{one.role.value: []}],
        "parameters": [*_in_path(one.path), *_in_query(one.searches), _LANGUAGE],
        "responses": {
            str(one.status.value): _gives(one, schemas),
            **_refusals(one.refusals, schemas),
        },
    }
    if one.takes is NamedBytes:
        made["requestBody"] = _content("multipart/form-data", _FILE, required=True)
    elif one.takes is not None:
        schema = _body(one.takes)
        made["requestBody"] = _content(
            "application/json", schema, required=bool(schema["required"])
        )
    return made


def _gives(one: ApiOperation, schemas: dict[str, Any]) -> dict[str, Any]:
    said = {"description": one.status.phrase}
    if one.gives is NoneType:
        return said
    if one.gives in FILES:
        return {**said, "content": {one.media: {"schema": {"type": "string", "format": "binary"}}}}
    return {**said, "content": {one.media: {"schema": _named(one.gives, schemas)}}}


def _refusals(codes: Iterable[Code], schemas: dict[str, Any]) -> dict[str, Any]:
    """Describe refusals by status, with the codes that each may have."""
    by_status: dict[int, list[str]] = {}
    for code in codes:
        by_status.setdefault(STATUS[code].value, []).append(code.value)
    form = _named(RefusalResult, schemas)
    return {
        str(status): {
            "description": ", ".join(found),
            "content": {
                MEDIA: {"schema": {**form, "properties": {"code": {"enum": found}}}},
            },
        }
        for status, found in sorted(by_status.items())
    }


def _in_path(path: str) -> list[dict[str, Any]]:
    number = {"type": "integer", "minimum": 1}
    return [
        {
            "name": name,
            "in": "path",
            "required": True,
            "schema": number if kind else {"type": "string", "minLength": 1},
        }
        for name, kind in PLACES.findall(path)
    ]


def _in_query(kind: type[Any] | None) -> list[dict[str, Any]]:
    if kind is None:
        return []
    form = _inline(kind)
    return [
        {
            "name": name,
            "in": "query",
            "required": name in form["required"],
            "description": schema.pop("description", ""),
            "schema": schema,
        }
        for name, schema in form["properties"].items()
    ]


def _body(kind: type[Any]) -> dict[str, Any]:
    form = _inline(kind)
    for name, schema in form["properties"].items():
        schema.update(_LIMITS.get((kind, name), {}))
    return {**form, "additionalProperties": False}


def _inline(kind: type[Any]) -> dict[str, Any]:
    """Return the schema of a kind that holds no other."""
    made = json_schema(kind)
    found: dict[str, Any] = made["$defs"][kind.__name__]
    return found


def _named(kind: type[Any], schemas: dict[str, Any]) -> dict[str, Any]:
    """Return a reference to the schema of a kind, which is kept with all that it holds."""
    made = json_schema(kind)
    schemas.update(_moved(made["$defs"]))
    reference: dict[str, Any] = _moved({"$ref": made["$ref"]})
    return reference


def _moved(schema: Any) -> Any:  # noqa: ANN401 (whatever JSON can hold)
    """Let references lead to the document's components."""
    if isinstance(schema, dict):
        return {
            name: value.replace("#/$defs/", _COMPONENTS) if name == "$ref" else _moved(value)
            for name, value in schema.items()
        }
    return [_moved(one) for one in schema] if isinstance(schema, list) else schema


def _content(media: str, schema: dict[str, Any], *, required: bool) -> dict[str, Any]:
    return {"required": required, "content": {media: {"schema": schema}}}
