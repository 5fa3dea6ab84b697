"""The page of all keys of a course's files, as Markdown, from the shapes that their readers use."""

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final

from gripcourse.course.shape import Key, KeySort, Shape
from gripcourse.exports.formula_page import formula_lines

_HEAD: Final = (
    "| key | holds | must be written | meaning |",
    "|---|---|---|---|",
)
_CATALOGUE: Final = (
    "",
    "## A catalogue",
    "",
    "`variants/catalogues/*.csv`",
    "",
    "Commas between columns, points in numbers, UTF-8. Lines that begin with `#` stand on top:",
    "",
    "| line | must be written | meaning |",
    "|---|---|---|",
    "| `# source: …` | yes | Where the numbers come from. |",
    "| `# mark: …` | yes | How far that was read: for the reference, never on what is issued. |",
    "| `# title: …` | where answers are taken from it | What students call it. |",
    (
        "| `# column.NAME: …` | of several columns, for those that students need |"
        " What they call the column; the others are not shown to them. |"
    ),
    (
        "| `# title.uk: …` and so on | where the plain line is not of that language |"
        " The same in another language of the course. A symbol for a heading, `d_1`, serves all. |"
    ),
    "",
    (
        "Then the names of the columns with units, `size [mm],mass [kg],count`, and the rows. The"
        " first column is the size, which grows from row to row; `CATALOGUE.NAME` in formulas is a"
        " column of `CATALOGUE.csv`."
    ),
)


@dataclass(frozen=True, slots=True)
class FileKind:
    """A kind of TOML file of a course.

    Attributes:
        name: short name, of its schema too.
        places: patterns of the files from the folder of the course.
        title: what it is, in a few words.
        shape: what may stand in it.
    """

    name: str
    places: tuple[str, ...]
    title: str
    shape: Shape


def key_page(kinds: Iterable[FileKind]) -> str:
    """Return the page: each kind of file with its keys; then catalogues, and the formulas."""
    lines = [
        "# Keys of the files of a course",
        "",
        "`gripcourse schema` makes this page from the readers. `*`: a name of the author's.",
    ]
    seen: list[Shape] = []
    for kind in kinds:
        places = ", ".join(f"`{place}`" for place in kind.places)
        lines += ["", f"## {kind.title}", "", places]
        for heading, meaning, keys in _tables("", "", kind.shape, seen):
            named = [f"### `{heading}`", ""] if heading else []
            lines += ["", *named, *([meaning, ""] if meaning else []), *_HEAD]
            lines += [_row(name, key) for name, key in keys.items()]
    return "\n".join((*lines, *_CATALOGUE, *formula_lines(), ""))


def _tables(
    heading: str, meaning: str, shape: Shape, seen: list[Shape]
) -> Iterator[tuple[str, str, Mapping[str, Key]]]:
    """Yield the tables of a shape, outer ones first, with meanings and the keys that stand in them.

    Args:
        heading: where the shape stands, its names joined by points.
        meaning: of the table.
        shape: its keys.
        seen: shapes that stand on the page already, as the declaration of a quantity does for parts
            and for schemes: they are not repeated.
    """
    if any(one is shape for one in seen):
        return
    seen.append(shape)
    shared = _shared(shape)
    own = shared if shape.each is None else shared | {"*": shape.each}
    leaves = {name: key for name, key in own.items() if not _is_only_names(key)}
    if leaves:
        yield heading, meaning, leaves
    below = own
    for kind, keys in shape.kinds.items():
        further = {name: key for name, key in keys.items() if name not in shared}
        if further:
            yield f'{heading} with {shape.by} = "{kind}"', "", further
        below = below | further
    for name, key in below.items():
        if key.inside is not None:
            place = f"{heading}.{name}" if heading else name
            inner = f"{place}[]" if key.sort is KeySort.TABLES else place
            meant = "" if name == "*" else key.meaning
            yield from _tables(inner, meant, key.inside, seen)


def _shared(shape: Shape) -> dict[str, Key]:
    """Return the keys of a shape that every kind of it has."""
    first, *others = shape.kinds.values() or ({},)
    common = {n: k for n, k in first.items() if all(one.get(n) == k for one in others)}
    return {**shape.keys, **common}


def _is_only_names(key: Key) -> bool:
    """Tell whether a key holds nothing but tables by name: they have headings of their own."""
    inside = key.inside
    return (
        inside is not None
        and not inside.keys
        and inside.each is not None
        and (inside.each.sort is KeySort.TABLE)
    )


def _row(name: str, key: Key) -> str:
    required = "yes" if key.required else ""
    return f"| `{name}` | {_holds(key)} | {required} | {key.meaning.replace('|', '¦')} |"


def _holds(key: Key) -> str:
    if key.words:
        words = ", ".join(f"`{word}`" if word else "nothing" for word in key.words)
        return f"{'list of' if key.sort is KeySort.STRINGS else 'one of'} {words}"
    if key.sort is KeySort.NUMBER and not math.isinf(key.low):
        return f"number from {key.low:g}" + ("" if math.isinf(key.high) else f" to {key.high:g}")
    return f"`{_form(key.form)}`" if key.sort is KeySort.OTHER else str(key.sort)


def _form(form: Mapping[str, Any]) -> str:
    """Write a JSON Schema as a pattern of what stands in the file: `["…" or 0, "…" or 0]`."""
    if "const" in form:
        return json.dumps(form["const"])
    if "enum" in form:
        return " or ".join(json.dumps(one) for one in form["enum"])
    if "anyOf" in form:
        return " or ".join(_form(one) for one in form["anyOf"])
    sorts = form["type"] if isinstance(form["type"], list) else [form["type"]]
    return " or ".join(_of_sort(sort, form) for sort in sorts)


def _of_sort(sort: str, form: Mapping[str, Any]) -> str:
    if sort == "array":
        one, least = _form(form["items"]), form.get("minItems", 1)
        more = [] if form.get("maxItems") == least else ["…"]
        return f"[{', '.join([one] * least + more)}]"
    if sort == "object":
        return "{ … }"
    return {"string": '"…"', "boolean": "true"}.get(sort, "0.5")
