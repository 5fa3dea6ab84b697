"""Tracing numbers through a table or the register."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.cli.trace import trace_text
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.errors import UsageError
from gripcourse.issuing.register import Register
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.number_text import format_number
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.usecases.issuing.trace import (
    Sought,
    Traced,
    among_issued,
    in_register,
    in_table,
    trace,
)
from gripcourse.variants.model import Variant

if TYPE_CHECKING:
    from support.classroom import Classroom


@pytest.fixture(scope="module")
def table(course: Course, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Every fourth variant of the course's table: each number is sought in all of them."""
    head, *rows = (course.root / "variants" / "tables" / "main.csv").read_bytes().splitlines(True)
    made = tmp_path_factory.mktemp("table") / "few.csv"
    made.write_bytes(b"".join((head, *rows[::4])))
    return made


@pytest.fixture(scope="module")
def sought(table: Path, course: Course) -> Sought:
    return in_table(table, course)


def answers(course: Course, variant: Variant) -> tuple[Plan, dict[str, float]]:
    plan = make_plan(course, variant.scheme, variant.options)
    values = solve_variant(plan, variant.given)
    computed = [one.id for one in plan.answered if one.kind is Kind.FORMULA]
    return plan, {name: values[name] for name in computed}


def _some(course: Course, sought: Sought) -> list[float]:
    variant = next(iter(sought.variants.values()))
    return list(answers(course, variant)[1].values())[:6]


def refused(
    course: Course, sought: Sought, numbers: Sequence[str], named: Sequence[tuple[str, str]]
) -> list[str]:
    with pytest.raises(UsageError) as caught:
        trace(numbers, named, course, sought)
    return [problem.say(Words("en")) for problem in caught.value.problems]


@pytest.mark.parametrize(("number", "language"), [(1, "en"), (8, "ru"), (15, "uk")])
def test_some_answers_as_people_write_them_lead_to_their_variant(
    course: Course, sought: Sought, number: int, language: str
) -> None:
    variant = list(sought.variants.values())[number]
    _, values = answers(course, variant)
    numbers = [format_number(value, language, 4) for value in list(values.values())[:8]]
    traced = trace(numbers, (), course, sought)
    assert traced.origins[0].owner == variant.id
    assert traced.origins[0].odds > 1000


def test_a_unit_says_what_a_number_can_be(course: Course, sought: Sought) -> None:
    plan, values = answers(course, next(iter(sought.variants.values())))
    force = next(one for name, one in values.items() if plan.quantities[name].unit == "N")
    written = format_number(force / 1000, "ru", 3)
    traced = trace([f"{written} кН"], (), course, sought)
    assert traced.origins
    for origin in traced.origins:
        quantity = traced.declared[origin.owner][origin.matches[0].quantity]
        expected = {"N": force, "kN": force / 1000}[quantity.unit]
        assert origin.matches[0].value == pytest.approx(expected, rel=0.01)


def test_a_named_number_is_that_quantity(course: Course, sought: Sought) -> None:
    variant = next(iter(sought.variants.values()))
    _, values = answers(course, variant)
    name, value = next(iter(values.items()))
    traced = trace((), [(name, format_number(value, "ru"))], course, sought)
    found = {one.owner: one.matches[0].quantity for one in traced.origins}
    assert found[variant.id] == name
    assert set(found.values()) == {name}


def test_all_that_cannot_be_traced_is_told_at_once(course: Course, sought: Sought) -> None:
    said = refused(course, sought, ["12-13", "5 Н/м2/м"], [("drive_forc", "3"), ("mass", "3 m")])
    assert len(said) == 4
    assert said[0].startswith("12-13")
    assert "One number is needed" in said[0]
    assert "The unit fits no quantity" in said[1]
    assert "Did you mean 'drive_force'?" in said[2]
    assert "The unit fits no quantity" in said[3]


def test_nothing_to_trace_is_told(course: Course, sought: Sought) -> None:
    assert "There is no number to trace" in refused(course, sought, (), ())[0]


def test_the_register_names_the_students(issued: "Classroom") -> None:
    sought = in_register(issued.course.root, issued.course)
    entry = issued.register["s02"]
    _, values = answers(issued.course, entry.variant)
    numbers = [format_number(value, "ru", 4) for value in list(values.values())[:10]]
    traced = trace(numbers, (), issued.course, sought)
    text = trace_text(traced, Words("uk"))
    assert traced.students[traced.origins[0].owner] == ("Шевченко Оксана (s02)",)
    assert "Шевченко" in text.splitlines()[3]


def test_a_variant_issued_again_with_other_numbers_bears_the_number_of_its_version(
    issued: "Classroom",
) -> None:
    first = issued.register["s02"]
    heavier = {**first.variant.given, "mass": first.variant.given["mass"] + 1}
    third = replace(first, variant=replace(first.variant, given=heavier), version=3)
    register = Register(issued.course.id, (third,), (first,))
    sought = among_issued(register, {}, first.declarations)
    name = first.variant.id
    assert sought.variants == {name: first.variant, f"{name}/3": third.variant}


def test_a_replaced_version_is_computed_by_its_own_declarations_and_that_is_said(
    course: Course, sought: Sought
) -> None:
    (old, variant), (other, changed) = list(sought.variants.items())[:2]
    numbers = [format_number(one, "en", 4) for one in answers(course, variant)[1].values()][:8]
    today = replace(course, schemes={changed.scheme: course.schemes[changed.scheme]})
    both = Sought({old: variant, other: changed}, {}, {old: course}, (other,))
    traced = trace(numbers, (), today, both)
    assert traced.origins[0].owner == old
    assert traced.origins[0].matches[0].quantity in traced.declared[old]
    said = trace_text(traced, Words("en"))
    assert f"were replaced since: {old}." in said


def test_where_nothing_was_issued_nothing_can_be_traced(course: Course, tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        in_register(tmp_path, course)
    assert "Nothing was issued" in caught.value.problems[0].say(Words("en"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_odds_are_written_without_a_verdict(course: Course, sought: Sought, language: str) -> None:
    numbers = ["123456789", *(f"{value:.4g}" for value in _some(course, sought))]
    shown = trace_text(trace(numbers, (), course, sought), Words(language))
    assert "123456789 = —" in shown
    assert " : 1" in shown


def test_numbers_of_no_variant_are_told() -> None:
    said = trace_text(Traced((), {}, {}, {}), Words("en"))
    assert "None of the variants" in said
