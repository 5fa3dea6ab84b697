"""Overrides: single keys of a shared declaration that a scheme, or one of its parts, changes.

A change holds in whichever part declares the quantity: of several parts, among which options
choose, each keeps what is not changed. Where the change is right for some of them only, it names
those under `parts`. What a part changes that an option brings holds for variants with that choice.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from gripcourse.course.declare import declare
from gripcourse.course.kinematics import Kinematics
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.course.toml_table import Table
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

_OF_GIVENS = frozenset({"default", "range"})
_ONLY_IN = "parts"  # the key of an override that names the parts it holds in


@dataclass(frozen=True, slots=True)
class RawPart:
    """A part as it is written: schemes may change single keys of it.

    Attributes:
        quantities: the tables of its own declarations.
        overrides: what it changes in other parts of a scheme.
        kinematics: how the links move that it describes; None for a part without links.
    """

    quantities: Mapping[str, Table]
    overrides: Mapping[str, Table]
    kinematics: Kinematics | None


@dataclass(frozen=True, slots=True)
class _Change:
    """The keys that change a quantity, and whether the scheme itself says so or a part of it."""

    name: str
    keys: Table
    is_own: bool


def read_overrides(
    table: Table,
    part_ids: Sequence[str],
    raw_parts: Mapping[str, RawPart],
    *,
    complete: bool,
) -> dict[str, dict[str, Quantity]]:
    """Declare again what a scheme changes: its keys over the keys of the shared declaration.

    Args:
        table: of the scheme. What its fixed parts change comes first, in their order.
        part_ids: every part that the scheme uses with any options.
        raw_parts: all parts of the course.
        complete: whether all options could be read; else nothing is called unknown.

    Returns:
        The changed declarations by part and quantity.
    """
    declared: dict[str, dict[str, Quantity]] = {}
    written: dict[tuple[str, str], Table] = {}
    readable = complete and all(part in raw_parts for part in part_ids)  # else that is reported
    for change in _changes(table, raw_parts):
        parts = _declaring(change.name, part_ids, raw_parts)
        if readable:
            _report_unknown_parts(change, parts)
        if not parts and readable:
            _report_unknown(change, table, part_ids, raw_parts)
        for part in _chosen(change, parts):
            key = (part, change.name)
            shared = written.get(key, raw_parts[part].quantities[change.name])
            written[key] = _laid_over(shared, change.keys)
            declared.setdefault(part, {})[change.name] = _declare(
                change.name, shared, written[key], change.keys
            )
    return declared


def read_optional_overrides(
    table: Table,
    optional: Sequence[str],
    raw_parts: Mapping[str, RawPart],
) -> dict[str, dict[str, dict[str, Quantity]]]:
    """Declare again what parts change that options bring, over what the scheme always changes.

    Args:
        table: of the scheme.
        optional: the parts that its options bring.
        raw_parts: all parts of the course.

    Returns:
        The changed declarations by the part that changes them, the changed part, and quantity.
    """
    part_ids = [*table.strings("parts"), *optional]
    changed: dict[str, dict[str, dict[str, Quantity]]] = {}
    for bringing in dict.fromkeys(optional):
        fixed = bringing in table.strings("parts")
        for name, keys in () if fixed else _overrides_of(bringing, raw_parts):
            change = _Change(name, keys, is_own=False)
            parts = _declaring(name, part_ids, raw_parts)
            _report_unknown_parts(change, parts)
            if not parts:
                _report_unknown(change, table, part_ids, raw_parts)
            for part in _chosen(change, parts):
                shared = _always(part, name, table, raw_parts)
                quantity = _declare(name, shared, _laid_over(shared, keys), keys)
                changed.setdefault(bringing, {}).setdefault(part, {})[name] = quantity
    return changed


def _overrides_of(part: str, raw_parts: Mapping[str, RawPart]) -> Iterable[tuple[str, Table]]:
    return raw_parts[part].overrides.items() if part in raw_parts else ()


def _always(part: str, name: str, table: Table, raw_parts: Mapping[str, RawPart]) -> Table:
    """Return the declaration of a quantity in a part with what the scheme always changes of it."""
    shared = raw_parts[part].quantities[name]
    for change in _changes(table, raw_parts):
        named = change.keys.strings(_ONLY_IN) if change.keys.has(_ONLY_IN) else (part,)
        if change.name == name and part in named:
            shared = _laid_over(shared, change.keys)
    return shared


def _changes(table: Table, raw_parts: Mapping[str, RawPart]) -> Iterator[_Change]:
    for part in table.strings("parts"):
        if part in raw_parts:
            for name, keys in raw_parts[part].overrides.items():
                yield _Change(name, keys, is_own=False)
    for name, keys in table.named_tables("override").items():
        yield _Change(name, keys, is_own=True)


def _declaring(
    name: str, part_ids: Sequence[str], raw_parts: Mapping[str, RawPart]
) -> tuple[str, ...]:
    """Return the parts that declare a quantity, each once."""
    return tuple(
        part
        for part in dict.fromkeys(part_ids)
        if part in raw_parts and name in raw_parts[part].quantities
    )


def _chosen(change: _Change, parts: Sequence[str]) -> Sequence[str]:
    """Return the parts that a change holds in: all that declare its quantity, or the named ones."""
    if not change.keys.has(_ONLY_IN):
        return parts
    named = change.keys.strings(_ONLY_IN)
    return [part for part in parts if part in named]


def _report_unknown_parts(change: _Change, parts: Sequence[str]) -> None:
    """Report the parts that a change names though they do not declare its quantity."""
    named = change.keys.strings(_ONLY_IN) if change.keys.has(_ONLY_IN) else ()
    for part in named:
        if part not in parts:
            change.keys.add(
                _ONLY_IN,
                message("The part '{part}' declares no '{name}'.", part=part, name=change.name),
                did_you_mean(part, parts),
            )


def _report_unknown(
    change: _Change, table: Table, part_ids: Sequence[str], raw_parts: Mapping[str, RawPart]
) -> None:
    if not raw_parts.keys() >= set(part_ids):
        return  # a part that cannot be read, a problem of its own, may declare it
    known = {one for part in part_ids for one in raw_parts[part].quantities}
    what = (
        message("No part of the scheme declares '{name}'.", name=change.name)
        if change.is_own
        else message(
            "No part of the scheme '{scheme}' declares '{name}'.",
            scheme=table.text("id"),
            name=change.name,
        )
    )
    remedy = message(
        "{near} A constant, and what the scheme itself declares, is changed where it stands.",
        near=did_you_mean(change.name, known),
    )
    change.keys.add("", what, remedy)


def _laid_over(shared: Table, changes: Table) -> Table:
    changed = {name: value for name, value in changes.values.items() if name != _ONLY_IN}
    # What is not given any more has no default and is not drawn.
    gone = _OF_GIVENS if changes.values.get("kind", Kind.GIVEN) != Kind.GIVEN else frozenset()
    kept = {name: value for name, value in shared.values.items() if name not in gone}
    return replace(changes, values={**kept, **changed}, problems=[], shape=shared.shape)


def _declare(name: str, shared: Table, merged: Table, changes: Table) -> Quantity:
    """Declare a changed quantity; what was wrong with it before is not reported again."""
    declared = declare(name, merged)
    if declared.range is not None and not changes.has("range"):
        declared = replace(declared, range=shared.table("range"))  # told where it is written
    repeated = replace(shared, file=changes.file, key=changes.key, problems=[])
    declare(name, repeated)
    known = (*repeated.problems, *changes.problems)
    changes.problems.extend(one for one in merged.problems if one not in known)
    return declared
