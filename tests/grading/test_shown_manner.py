"""How a student writes the right answers tells which wrong method a wrong one comes of."""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.grading.manner import UNKNOWN, Manner
from gripcourse.grading.rounding import figure_half_unit
from gripcourse.grading.shortened import uses_constant, with_constants
from gripcourse.grading.shown_manner import in_own_manner, manner_of
from gripcourse.grading.submission_case import judge_answer, make_case
from gripcourse.solver.solve import to_si
from gripcourse.submission.model import Answer
from gripcourse.text.units import factor

if TYPE_CHECKING:
    from conftest import Case


def cut(value: float, figures: int) -> float:
    unit = 2 * figure_half_unit(value, figures)
    return float(f"{math.trunc(value / unit * (1 + 1e-12)) * unit:.{figures}g}") if unit else value


def rounded(value: float, figures: int) -> float:
    return float(f"{value:.{figures}g}")


@pytest.fixture
def written(typed: Callable[[str, float, int], Answer]) -> Callable[[str, float, int], Answer]:
    """An answer that shows all its figures, zeros among them."""

    def make(quantity: str, value: float, figures: int) -> Answer:
        return replace(typed(quantity, value, figures), figures=figures)

    return make


def manner(case: "Case", answers: Mapping[str, Answer]) -> Manner:
    submission = case.submission(answers)
    on_table = make_case(submission, case.issued, case.plan, case.policy, lambda _: ())
    return manner_of(
        [judge_answer(on_table, one, answers.get(one.id)) for one in case.plan.answered]
    )


def computed(case: "Case") -> dict[str, float]:
    """The reference answers of formulas."""
    kinds = {one.id: one.kind for one in case.plan.answered}
    return {name: one for name, one in case.answers.items() if kinds[name] is Kind.FORMULA and one}


def test_who_cuts_digits_off_and_who_rounds_is_seen(
    hydraulic: "Case", written: Callable[[str, float, int], Answer]
) -> None:
    for write, cuts_off in ((cut, True), (rounded, False)):
        answers = {
            name: written(name, write(value, 4), 4) for name, value in computed(hydraulic).items()
        }
        shown = manner(hydraulic, answers)
        assert shown.figures == 4
        assert shown.constants == {}
        assert shown.cuts_off > 0.9 if cuts_off else shown.cuts_off < 0.05


def test_who_carries_on_the_calculators_number_is_seen(
    hydraulic: "Case", written: Callable[[str, float, int], Answer]
) -> None:
    answers = {
        name: written(name, rounded(value, 4), 4) for name, value in computed(hydraulic).items()
    }
    assert manner(hydraulic, answers).carries_typed < UNKNOWN.carries_typed / 2


def test_a_shortened_constant_is_seen_where_several_answers_show_it(
    hydraulic: "Case", written: Callable[[str, float, int], Answer]
) -> None:
    plan, values = hydraulic.plan, computed(hydraulic)
    numbers = to_si(plan, {**hydraulic.given, **hydraulic.reference})
    shown = [name for name in values if uses_constant(plan, name, ("pi",))]
    assert len(shown) > 2
    for count, constants in ((len(shown), {"pi": 3.14}), (1, {})):
        taken = dict(values)
        for name in shown[:count]:
            formula, unit = with_constants(plan, name, {"pi": 3.14}), plan.quantities[name].unit
            assert formula is not None
            taken[name] = evaluate_number(formula, unit, numbers, plan.columns) / factor(unit)
        answers = {name: written(name, rounded(value, 6), 6) for name, value in taken.items()}
        assert manner(hydraulic, answers).constants == constants


def test_a_work_without_a_wrong_answer_is_not_looked_at(hydraulic: "Case") -> None:
    submission = hydraulic.submission(hydraulic.answers)
    case = make_case(submission, hydraulic.issued, hydraulic.plan, hydraulic.policy, lambda _: ())
    judged = [
        judge_answer(case, one, submission.answers[one.id]) for one in hydraulic.plan.answered
    ]
    after, same = in_own_manner(case, judged)
    assert after is case
    assert same == judged
    assert after.manner == UNKNOWN


def telling_digits(case: "Case") -> tuple[float, int] | None:
    """A wrap angle that one wrong method rounds to, and that both come to if digits are cut off."""
    lean = math.radians(180 - case.reference["wrap_angle"]) / 2
    by_ratio, by_radians = 180 - 2 * math.sin(lean), 180 - 2 * lean
    for figures in range(4, 8):
        both = cut(by_radians, figures)
        beyond = by_ratio - both > 1.001 * figure_half_unit(both, figures)
        is_one = rounded(by_radians, figures) == both and beyond
        if is_one and cut(by_ratio, figures) == both:
            return both, figures
    return None


def test_of_a_ratio_and_its_angle_both_are_named_to_who_cuts_digits_off(
    belt_table: "tuple[Case, ...]", written: Callable[[str, float, int], Answer]
) -> None:
    """180° less twice the ratio, or less twice the radians: alike but for the last digits."""
    cases = [(case, found) for case in belt_table if (found := telling_digits(case)) is not None]
    assert cases
    for case, (angle, figures) in cases[:3]:
        named = {}
        for write in (cut, rounded):
            others = {
                other: written(other, write(value, figures), figures)
                for other, value in computed(case).items()
            }
            wrong = {"wrap_angle": written("wrap_angle", angle, figures)}
            found = case.findings({**case.answers, **others, **wrong})["wrap_angle"]
            named[write] = {str(one) for one in (found.slip, *found.tied)}
        assert named[cut] == {"angle_unit:given", "ratio_for_angle:7,deg"}
        assert named[rounded] == {"angle_unit:given"}
