"""What stands beside an asked quantity: what decides its answer."""

from dataclasses import replace

import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Rounding
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.solver.asked import cited_works, deciding
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.words import LANGUAGES, Words

ENGLISH = Words("en")


def beside(plan: Plan, quantity: str, words: Words = ENGLISH) -> str:
    return deciding(plan.quantities[quantity], plan, words)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_declared_text_stands_there_in_the_readers_language(plan: Plan, language: str) -> None:
    declared = plan.quantities["pin_length"].decides
    assert declared is not None
    assert beside(plan, "pin_length", Words(language)).startswith(declared.of(language))


def test_a_choice_has_its_series_and_its_rule(plan: Plan) -> None:
    said = beside(plan, "pin_diameter_first")
    assert said == "GOST 9650-80, below 3 mm GOST 3128-70; one of the first 3 sizes not below d_req"
    assert beside(plan, "rod").endswith("any size not below 0.3 · D; d_r ≤ 0.7 · D")


@pytest.mark.parametrize("steps", [None, 0])
def test_without_steps_only_the_nearest_size_is_asked_for(plan: Plan, steps: int | None) -> None:
    bore = plan.quantities["bore"]
    assert bore.choice is not None
    rule = replace(bore.choice, rounding=Rounding.NEAREST, steps=steps)
    said = deciding(replace(bore, choice=rule), plan, ENGLISH)
    assert "the size of the series nearest to " in said
    assert "any size" not in said


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "nearest to 3, or one within 2 places of it"),
        (
            "ru",
            "или отстоящее от него в ряду не более чем на 2 места",
        ),
        (
            "uk",
            "або віддалене від нього в ряду не більше ніж на 2 місця",
        ),
    ],
)
def test_with_steps_the_nearest_size_has_neighbours_on_either_side(
    plan: Plan, language: str, said: str
) -> None:
    bore = plan.quantities["bore"]
    assert bore.choice is not None
    rule = replace(bore.choice, rounding=Rounding.NEAREST, steps=2, condition=None)
    chosen = replace(bore, choice=rule, formula=Formula("3", parse("3"), {}))
    assert said in deciding(chosen, plan, Words(language))


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "the first size for which rod d ≥ 3"),
        ("ru", "первое значение ряда из тех, для которых шток d ≥ 3"),
        ("uk", "перше значення ряду з тих, для яких шток d ≥ 3"),
    ],
)
def test_a_size_that_a_table_is_searched_for_is_told_with_the_column_and_what_it_must_reach(
    plan: Plan, language: str, said: str
) -> None:
    bore = plan.quantities["bore"]
    assert bore.choice is not None
    written = 'at_least("bore_pneumatic.rod", 3)'
    rule = replace(bore.choice, steps=0, condition=None)
    source = replace(bore.source, note=None)
    searched = replace(
        bore, choice=rule, source=source, formula=Formula(written, parse(written), {})
    )
    assert said in deciding(searched, plan, Words(language)).replace("\u00a0", " ")
    told = replace(searched, decides=bore.title)  # the author has said it in other words
    assert " ≥ " not in deciding(told, plan, Words(language))


def test_a_verdict_has_the_note_of_its_source(plan: Plan) -> None:
    verdict = plan.quantities["grip_holds"]
    assert verdict.kind is Kind.VERDICT
    assert verdict.source.note is not None
    assert not verdict.note_decides
    for language in LANGUAGES:
        assert verdict.source.note.of(language) in beside(plan, "grip_holds", Words(language))


def test_every_choice_names_its_series(plan: Plan) -> None:
    for quantity in plan.answered:
        if quantity.kind is Kind.CHOICE:
            assert quantity.source.note is not None or quantity.source.equation, quantity.id


def test_an_equation_is_cited_with_the_number_of_its_work(plan: Plan) -> None:
    works = [one.id for one in cited_works(plan)]
    assert works == ["guide", "gost_26063"]
    assert beside(plan, "bearing_stress").endswith("[1, (45)]")
    assert beside(plan, "flange_diameter") == "[2, table 7]"


def test_an_overall_size_has_its_formula(plan: Plan) -> None:
    assert beside(plan, "mechanism_length") == "L_m = l + R + H_r + s"


def test_nothing_stands_beside_what_its_title_says_already(plan: Plan) -> None:
    assert not beside(plan, "arm_angle_at_max")


def test_how_far_a_source_was_read_stands_beside_no_question(course: Course) -> None:
    example = course.schemes["screw"].example
    assert example is not None
    plan = make_plan(course, "screw", example.options)
    marked = {one.id: one.source.mark for one in plan.answered if one.source.mark is not None}
    assert marked
    assert not [name for name, mark in marked.items() if mark.of("en") in beside(plan, name)]
    assert all(plan.quantities[name].source.told("en").endswith(mark.of("en"))
               for name, mark in marked.items())  # fmt: skip
