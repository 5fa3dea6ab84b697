"""Loading the policy of a head of course: `grader/policy.toml` and the rubrics beside it."""

import math
from collections.abc import Iterator, Mapping
from pathlib import Path

from gripcourse.course.compose import all_part_ids
from gripcourse.course.declare import tolerance
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Kind, Quantity, Tolerance
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.course.unit_words import unit_remedy
from gripcourse.errors import CourseError, Problem
from gripcourse.policy.keys import POLICY
from gripcourse.policy.lenient import lenient_numbers
from gripcourse.policy.model import Policy, Reveal
from gripcourse.policy.points import main_points_by_section
from gripcourse.policy.rubric_load import read_rubrics
from gripcourse.policy.rules import read_check_rule, read_figure_rule, read_likeness_rule
from gripcourse.policy.scales import read_scales
from gripcourse.policy.slips_load import read_slip_policy
from gripcourse.policy.time_rules import AttemptRule, read_attempt_rule, read_late_rule
from gripcourse.policy.variant_rules import read_variant_rules
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import factor
from gripcourse.text.units import known as known_unit
from gripcourse.text.words import message

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
    rubrics = read_rubrics(course, problems)
    table = read_toml(policy_path(course.root), course.root, problems, POLICY, course.languages)
    slips = read_slip_policy(course, problems)
    if table is None or slips is None:
        return None, problems
    table.known_keys()
    points = table.required_table("points")
    weight = table.required_table("weight")
    bands = table.required_table("tolerance")
    credit = table.required_table("credit")
    rounding = table.required_table("rounding")
    total = points.number("total")
    policy = Policy(
        total=total,
        section_points=_section_points(points, total, course),
        main_points=_main_points(points, course),
        weights=_weights(weight, "quantity", _quantity_ids(course)),
        kind_weights=_weights(weight, "kind", set(_MARKED)),
        tolerance=_default_tolerance(bands),
        floors=_floors(bands),
        tolerances=_tolerances(table, course),
        carried_credit=credit.share("carried"),
        printed_credit=None if credit.values.get("printed") is False else credit.share("printed"),
        wrong_unit_credit=credit.share("wrong_unit"),
        rough_credit=credit.share("rough", 0.5),
        calculated_share=credit.share("calculated", 0.65),
        last_digit=rounding.at_least("last_digit", 0.0),
        figures=int(rounding.at_least("figures", 1.0)),
        habits=_habits(rounding, course),
        widest=rounding.at_least("widest", 0.0),
        reveal=_reveal(table.required_table("report")),
        slips=slips,
        variants=read_variant_rules(table.required_table("variants")),
        figure_rule=read_figure_rule(table.table("figures")),
        likeness=read_likeness_rule(table.table("likeness")),
        check=read_check_rule(table.table("check")),
        rubrics=rubrics,
        scales=read_scales(table, points.numbers("section", {})),
        late=read_late_rule(table.table("late")),
        attempts=read_attempt_rule(table.table("attempts")),
    )
    credit.known_keys()
    rounding.known_keys()
    named = [one.key for one in problems]
    file = policy_path(course.root).relative_to(course.root).as_posix()
    problems += [one for one in lenient_numbers(policy, file) if one.key not in named]
    return policy, problems


def attempt_rule_of(root: Path) -> AttemptRule | None:
    """Return which of several works counts, whatever else of a course is wrong; None for no rule.

    Raises:
        CourseError: the file of the policy cannot be read, or says this of attempts wrongly.
    """
    problems: list[Problem] = []
    table = read_toml(policy_path(root), root, problems, POLICY)
    found = None if table is None else read_attempt_rule(table.table("attempts"))
    if problems:
        raise CourseError(problems)
    return found


def policy_path(root: Path) -> Path:
    """Where a course keeps its policy."""
    return root / "grader" / "policy.toml"


def _section_points(points: Table, total: float, course: Course) -> Mapping[str, float]:
    points.known_keys()
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
    if sections and not any(value > 0 for value in sections.values()):
        points.add(
            "section",
            message("No section has points."),
            message("Write a positive number for one at least."),
        )
    marked = _marked_sections(course)
    for name in sorted(ids & set(sections) - marked):
        if sections[name] > 0:
            points.add(
                f"section.{name}",
                message("No scheme has anything to mark in the section '{name}'.", name=name),
                message("Declare a quantity in it, or write 0."),
            )
    return sections


def _main_points(points: Table, course: Course) -> Mapping[str, float]:
    """Read the points of main results; every section must leave something for the rest."""
    declared = points.numbers("quantity", {})
    known = _quantity_ids(course)
    for name in sorted(set(declared) - known):
        points.add(
            f"quantity.{name}",
            message("There is no '{name}' in the course.", name=name),
            did_you_mean(name, known),
        )
    sections = points.numbers("section", {})
    for scheme in course.schemes.values():
        for section, sum_ in main_points_by_section(
            _quantities_of(course, scheme), declared
        ).items():
            if sum_ >= sections.get(section, math.inf) > 0:
                points.add(
                    "quantity",
                    message(
                        "In the scheme '{scheme}' the main results of the section '{section}' have"
                        " {sum} points, the section has {points}.",
                        scheme=scheme.id,
                        section=section,
                        sum=sum_,
                        points=sections[section],
                    ),
                    message("Leave points for the other quantities of the section."),
                )
    return declared


def _quantities_of(course: Course, scheme: Scheme) -> Iterator[Quantity]:
    """Yield what any variant of a scheme may have; of options, all choices.

    A part that there is not is told where the scheme names it.
    """
    for part in all_part_ids(scheme):
        if part in course.parts:
            yield from course.parts[part].quantities.values()
    yield from scheme.quantities.values()


def _marked_sections(course: Course) -> set[str]:
    """Return the sections in which some scheme has something to mark."""
    scopes = (
        *(part.quantities for part in course.parts.values()),
        *(scheme.quantities for scheme in course.schemes.values()),
    )
    return {one.section for scope in scopes for one in scope.values() if one.kind in _MARKED}


def _weights(weight: Table, name: str, known: set[str]) -> Mapping[str, float]:
    weight.known_keys()
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
                unit_remedy(unit),
            )
        if value < 0:
            bands.add(
                f"floor.{unit}",
                message("The tolerance {value} is negative.", value=value),
                message("Write 0 or a positive number."),
            )
    return floors


def _default_tolerance(bands: Table) -> Tolerance:
    bands.known_keys()
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
        inner.known_keys()
    return {name: tolerance(inner) for name, inner in named.items()}


def _habits(rounding: Table, course: Course) -> Mapping[str, tuple[float, ...]]:
    """Read shortened constants, written in the unit that the constant is declared in.

    A constant whose unit nobody knows is told where it is declared; it has no habits.
    """
    table = rounding.table("habits")
    if table is None:
        return {}
    units = {name: one.unit for name, one in course.constants.items()} | {"pi": ""}
    table.known_keys(units)
    return {
        name: tuple(value * factor(units[name]) for value in table.number_list(name))
        for name in table.values.keys() & units.keys()
        if known_unit(units[name])
    }


def _reveal(table: Table) -> Reveal:
    table.known_keys()
    written = table.text("reveal")
    if written in list(Reveal):
        return Reveal(written)
    table.add(
        "reveal",
        message("There is no level '{level}'.", level=written),
        did_you_mean(written, list(Reveal)),
    )
    return Reveal.NOTHING
