"""Loading the policy of a head of course from `grader/policy.toml`."""

import math
from collections.abc import Mapping
from pathlib import Path

from gripcourse.course.declare import tolerance
from gripcourse.course.model import Course, Kind, Tolerance
from gripcourse.course.policy import FigureRule, LikenessRule, Policy, Reveal
from gripcourse.course.toml_table import Table, did_you_mean, read_toml
from gripcourse.errors import CourseError, Problem
from gripcourse.units import known as known_unit
from gripcourse.words import message

_MARKED = [kind for kind in Kind if kind.answered or kind is Kind.MANUAL]


def load_policy(course: Course) -> Policy:
    """Load and check the policy of a course.

    Raises:
        CourseError: with all problems of the policy.
    """
    policy, problems = read_policy(course)
    if policy is None or problems:
        raise CourseError(problems)
    return policy


def read_policy(course: Course) -> tuple[Policy | None, list[Problem]]:
    """Read the policy with all its problems."""
    problems: list[Problem] = []
    table = read_toml(policy_path(course.root), course.root, problems)
    if table is None:
        return None, problems
    table.known_keys(
        {
            *("points", "weight", "tolerance", "quantity_tolerance", "credit", "report"),
            *("figures", "likeness"),
        }
    )
    points = table.required_table("points")
    weight = table.required_table("weight")
    bands = table.required_table("tolerance")
    credit = table.required_table("credit")
    total = points.number("total")
    policy = Policy(
        total=total,
        section_points=_section_points(points, total, course),
        weights=_weights(weight, "quantity", _quantity_ids(course)),
        kind_weights=_weights(weight, "kind", set(_MARKED)),
        tolerance=_default_tolerance(bands),
        floors=_floors(bands),
        tolerances=_tolerances(table, course),
        carried_credit=_share(credit, "carried"),
        printed_credit=None if credit.values.get("printed") is False else _share(credit, "printed"),
        wrong_unit_credit=_share(credit, "wrong_unit"),
        reveal=_reveal(table.required_table("report")),
        figures=_figures(table.table("figures")),
        likeness=_likeness(table.table("likeness")),
    )
    credit.known_keys({"carried", "printed", "wrong_unit"})
    return policy, problems


def policy_path(root: Path) -> Path:
    """Where a course keeps its policy."""
    return root / "grader" / "policy.toml"


def _section_points(points: Table, total: float, course: Course) -> Mapping[str, float]:
    points.known_keys({"total", "section"})
    sections = points.numbers("section")
    ids = {section.id for section in course.sections}
    for name in sorted(ids - set(sections)):
        points.add(
            f"section.{name}",
            message("The section '{name}' has no points.", name=name),
            message("Write its points, 0 where it is not marked."),
        )
    for name in sorted(set(sections) - ids):
        points.add(
            f"section.{name}",
            message("The course has no section '{name}'.", name=name),
            did_you_mean(name, ids),
        )
    known = not math.isnan(total + sum(sections.values()))
    if known and not math.isclose(sum(sections.values()), total, rel_tol=1e-9):
        points.add(
            "section",
            message(
                "The points of the sections add up to {sum}, the total is {total}.",
                sum=float(sum(sections.values())),
                total=total,
            ),
            message("Change a section or the total."),
        )
    for name, value in sections.items():
        if value < 0:
            points.add(
                f"section.{name}",
                message("The points are negative."),
                message("Write 0 or a positive number."),
            )
    return sections


def _weights(weight: Table, name: str, known: set[str]) -> Mapping[str, float]:
    weight.known_keys({"kind", "quantity"})
    weights = weight.numbers(name, {})
    for key, value in weights.items():
        if key not in known:
            weight.add(
                f"{name}.{key}",
                message("There is no '{name}' in the course.", name=key),
                did_you_mean(key, known),
            )
        if value < 0:
            weight.add(
                f"{name}.{key}",
                message("The weight {value} is negative.", value=value),
                message("Write 0 or a positive number."),
            )
    if name == "kind":
        for kind in sorted(known - set(weights)):
            weight.add(
                f"kind.{kind}",
                message("This key is missing."),
                message("Write the weight of a quantity of this kind."),
            )
    return weights


def _quantity_ids(course: Course) -> set[str]:
    ids = {name for part in course.parts.values() for name in part.quantities}
    return ids | {name for scheme in course.schemes.values() for name in scheme.quantities}


def _floors(bands: Table) -> Mapping[str, float]:
    floors = bands.numbers("floor", {})
    for unit, value in floors.items():
        if not known_unit(unit):
            bands.add(
                f"floor.{unit}",
                message("The unit '{unit}' is not known.", unit=unit),
                message("Write it as in units.csv of the package, for example 'N*m'."),
            )
        if value < 0:
            bands.add(
                f"floor.{unit}",
                message("The tolerance {value} is negative.", value=value),
                message("Write 0 or a positive number."),
            )
    return floors


def _default_tolerance(bands: Table) -> Tolerance:
    bands.known_keys({"relative", "absolute", "floor"})
    return tolerance(bands)


def _tolerances(table: Table, course: Course) -> Mapping[str, Tolerance]:
    known = _quantity_ids(course)
    named = table.named_tables("quantity_tolerance")
    for name in named:
        if name not in known:
            table.add(
                f"quantity_tolerance.{name}",
                message("There is no '{name}' in the course.", name=name),
                did_you_mean(name, known),
            )
    for inner in named.values():
        inner.known_keys({"relative", "absolute"})
    return {name: tolerance(inner) for name, inner in named.items()}


def _figures(table: Table | None) -> FigureRule:
    """Read how many figures answers should have; a policy that says nothing asks for nothing."""
    if table is None:
        return FigureRule(0, 0, 1.0)
    table.known_keys({"least", "most", "credit"})
    least, most = (_whole(table, name) for name in ("least", "most"))
    if 0 < most < least:
        table.add(
            "most",
            message(
                "At most {most} figures are fewer than at least {least}.", most=most, least=least
            ),
            message("Write a larger number, or 0 for no bound."),
        )
    return FigureRule(least, most, _share(table, "credit") if table.has("credit") else 1.0)


def _likeness(table: Table | None) -> LikenessRule:
    """Read when copying is suspected; a policy that says nothing has our defaults."""
    if table is None:
        return LikenessRule(1e3, 3, 3)
    table.known_keys({"odds", "answers", "same_creator"})
    odds = table.number("odds")
    if odds != 0 and odds < 1:
        table.add(
            "odds",
            message("Odds of {odds} to one speak against copying.", odds=odds),
            message("Write a large number, for example 1e3, or 0 to look for nothing."),
        )
    answers, same_creator = _whole(table, "answers"), _whole(table, "same_creator")
    return LikenessRule(odds, answers, same_creator)


def _whole(table: Table, name: str) -> int:
    value = table.number(name, 0.0)
    if value < 0 or value != int(value):
        table.add(
            name,
            message("The number is {value}.", value=value),
            message("Write a whole number from 0 on."),
        )
        return 0
    return int(value)


def _share(table: Table, name: str) -> float:
    value = table.number(name)
    if value < 0 or value > 1:
        table.add(
            name,
            message("The share is {value}.", value=value),
            message("Write a number from 0 to 1."),
        )
    return value


def _reveal(table: Table) -> Reveal:
    table.known_keys({"reveal"})
    written = table.text("reveal")
    if written in list(Reveal):
        return Reveal(written)
    table.add(
        "reveal",
        message("There is no level '{level}'.", level=written),
        did_you_mean(written, list(Reveal)),
    )
    return Reveal.NOTHING
