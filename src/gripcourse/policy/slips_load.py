"""Loading the generic slips of a head of course from `grader/slips.toml`."""

import string
from typing import Final

from gripcourse.course.model import Course
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.course.unit_words import unit_remedy
from gripcourse.errors import Problem
from gripcourse.policy.keys import SLIPS
from gripcourse.policy.slips import GenericSlip, SlipKind, SlipPolicy
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import LANGUAGES, message

_PLACES: Final = frozenset({"quantity", "other", "unit", "asked", "number", "function", "right"})


def read_slip_policy(course: Course, problems: list[Problem]) -> SlipPolicy | None:
    """Read the generic slips; None where the file cannot be read at all.

    Args:
        course: whose file it is.
        problems: takes every fault of the file.
    """
    table = read_toml(
        course.root / "grader" / "slips.toml", course.root, problems, SLIPS, course.languages
    )
    if table is None:
        return None
    table.known_keys()
    naming = table.required_table("naming")
    naming.known_keys()
    named = table.named_tables("kind")
    for name in sorted(named.keys() - set(SlipKind)):
        table.add(
            f"kind.{name}",
            message("There is no kind of slip '{name}'.", name=name),
            did_you_mean(name, list(SlipKind)),
        )
    kinds = {kind: _kind(kind, named[kind]) for kind in SlipKind if kind in named}
    return SlipPolicy(
        kinds=kinds,
        unexplained=_above(naming, "unexplained", 0.0),
        declared=_above(naming, "declared", 0.0),
        certain=_certain(naming),
        tie=_above(naming, "tie", 1.0),
        spread=_above(naming, "spread", 0.0),
    )


def _kind(kind: SlipKind, table: Table) -> GenericSlip:
    table.known_keys()
    hint = table.texts("hint")
    for language in LANGUAGES:
        _check_places(table, f"hint.{language}", hint.of(language))
    return GenericSlip(
        kind=kind,
        prior=_above(table, "prior", 0.0),
        credit=table.share("credit"),
        names=table.strings("names"),
        pairs=_pairs(table),
        units=_units(table),
        title=table.texts("title"),
        hint=hint,
    )


def _above(table: Table, name: str, least: float) -> float:
    value = table.number(name)
    if value <= least:
        table.add(
            name,
            message("The number is {value}.", value=value),
            message("Write a number above {least}.", least=least),
        )
    return value


def _certain(table: Table) -> float:
    value = table.number("certain")
    if not 0.5 <= value < 1:  # noqa: PLR2004 (below one half another slip would be likelier)
        table.add(
            "certain",
            message("The number is {value}.", value=value),
            message("Write a number from 0.5, below 1."),
        )
    return value


def _pairs(table: Table) -> tuple[tuple[str, str], ...]:
    written = table.values.get("pairs", [])
    match written:
        case list():
            pairs = [tuple(one) for one in written if isinstance(one, list)]
            if len(pairs) == len(written) and all(
                len(one) == 2 and all(isinstance(end, str) for end in one)  # noqa: PLR2004 (a pair)
                for one in pairs
            ):
                return tuple((str(one), str(other)) for one, other in pairs)
    table.add(
        "pairs",
        message("The value has the wrong type."),
        message('Write pairs of endings, for example [["_min", "_max"]].'),
    )
    return ()


def _units(table: Table) -> tuple[str, ...]:
    units = table.strings("units")
    for unit in units:
        if not known_unit(unit):
            table.add(
                "units",
                message("The unit '{unit}' is not known.", unit=unit),
                unit_remedy(unit),
            )
    return tuple(unit for unit in units if known_unit(unit))


def _check_places(table: Table, key: str, text: str) -> None:
    """A place that nobody fills would stop the report of the student who needs the hint."""
    try:
        places = {name for _, name, _, _ in string.Formatter().parse(text) if name is not None}
    except ValueError:
        places = {"{"}
    for place in sorted(places - _PLACES):
        table.add(
            key,
            message("The hint has a place '{place}' that nothing fills.", place=place),
            did_you_mean(place, _PLACES),
        )
