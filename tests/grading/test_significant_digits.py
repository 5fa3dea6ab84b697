"""Significant figures: what was typed, and what the policy makes of it."""

from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.significant_digits import figures_remark
from gripcourse.policy.model import FigureRule, Policy
from gripcourse.solver.plan import Plan
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Answer, Identity
from gripcourse.submission.raw import CellValue, RawCell, RawWorkbook

if TYPE_CHECKING:
    from .conftest import Case

BORE = "bore_required"


def typed(
    plan: Plan, value: CellValue, number_format: str = "General", *, formula: str = ""
) -> Answer:
    """What is read of a cell."""
    cell = RawCell(value, number_format, False, formula, "2!E6")
    raw = RawWorkbook("a.xlsx", "", Identity("", "", "", {}, ""), "", {}, {BORE: cell}, ())
    return interpret(raw, plan.quantities.values()).answers[BORE]


@pytest.mark.parametrize(
    ("text", "least", "most"),
    [
        ("12,5", 3, 3),
        ("12,50", 4, 4),
        ("0,050", 2, 2),
        ("5,00", 3, 3),
        ("1 250,0 мм", 5, 5),
        ("1500", 2, 4),  # its zeros may only fill the places
        ("100", 1, 3),
        ("1,50·10^3", 3, 3),
        ("-22,6", 3, 3),
        ("6,0 см", 2, 2),
        ("60 Н", 1, 2),
    ],
)
def test_figures_of_a_text_are_those_that_were_typed(
    plan: Plan, text: str, least: int, most: int
) -> None:
    answer = typed(plan, text)
    assert (answer.figures, answer.figures_at_most) == (least, most)


@pytest.mark.parametrize(
    ("value", "number_format", "least"),
    [
        (12.5, "General", 3),
        (5, "General", 1),
        (5, "0.00", 3),
        (5.0, "#,##0.00", 3),
        (12.3456, "0.00", 6),  # what is stored was typed, whatever is shown
        (1500, "General", 2),
        (1500, "0.0", 5),
        (1500, "0.00E+00", 3),
        (0.05, "0.000", 2),
        (0.05, "0.0%", 2),
        (5, '0.0" мм";[Red]-0.00', 2),
        (5, "0", 1),
        (22.6, "@", 3),
    ],
)
def test_a_number_has_at_least_the_figures_that_are_stored_or_shown(
    plan: Plan, value: float, number_format: str, least: int
) -> None:
    answer = typed(plan, value, number_format)
    assert (answer.figures, answer.figures_at_most) == (least, None)


@pytest.mark.parametrize("value", [0, 0.0, "0", "0,00", "10³", None, "много", 100 / 3])
def test_where_figures_say_nothing_none_are_counted(plan: Plan, value: CellValue) -> None:
    assert typed(plan, value).figures is None


def test_nobody_typed_the_figures_of_a_formula_s_result(plan: Plan) -> None:
    assert typed(plan, 12.5, formula="=100/8").figures is None


def rule(policy: Policy, least: int = 0, most: int = 0, credit: float = 0.5) -> Policy:
    return replace(policy, figure_rule=FigureRule(least, most, credit))


def said(
    plan: Plan, policy: Policy, answer: Answer, expected: float | None = None
) -> tuple[float, str] | None:
    found = figures_remark(plan.quantities[answer.quantity], answer, policy, expected)
    return None if found is None else (found[0], str(found[1]))


def test_figures_are_not_judged_unless_a_policy_asks(plan: Plan, policy: Policy) -> None:
    assert policy.figure_rule == FigureRule(0, 0, 1.0)
    for value in ("5", "5,123456789", 5, 5.123456789):
        assert said(plan, policy, typed(plan, value), 5.1234) is None


def test_too_many_figures_keep_the_share_of_the_policy(plan: Plan, policy: Policy) -> None:
    asked = rule(policy, most=4)
    share, sentence = said(plan, asked, typed(plan, 60.0812)) or (1.0, "")
    assert share == 0.5
    assert "6 significant figures; at most 4" in sentence
    assert said(plan, asked, typed(plan, 60.08)) is None
    assert said(plan, asked, typed(plan, "150000")) is None  # perhaps two figures


def test_too_few_figures_of_a_text_are_certain(plan: Plan, policy: Policy) -> None:
    asked = rule(policy, least=3)
    share, sentence = said(plan, asked, typed(plan, "60")) or (1.0, "")
    assert share == 0.5
    assert "2 significant figures; at least 3" in sentence
    assert said(plan, asked, typed(plan, "60,1")) is None
    assert said(plan, asked, typed(plan, "5,00")) is None


def test_zeros_that_a_cell_may_have_lost_are_never_missed(plan: Plan, policy: Policy) -> None:
    asked = rule(policy, least=3)
    five = typed(plan, 5)
    assert said(plan, asked, five) is None  # nothing to compare with: perhaps 5,00
    assert said(plan, asked, five, 5.0012) is None  # rounds to 5,00
    assert said(plan, asked, five, 5.013) is None  # 5,01, or 5,00 from rounded inputs
    assert said(plan, asked, typed(plan, 60), 59.93) is None


def test_a_number_that_rounding_to_the_asked_figures_cannot_give_has_too_few(
    plan: Plan, policy: Policy
) -> None:
    asked = rule(policy, least=3)
    assert said(plan, asked, typed(plan, 60), 60.37) is not None  # 60,4 has three figures
    assert said(plan, asked, typed(plan, 23), 22.63) is not None
    assert said(plan, asked, typed(plan, 22.6), 22.63) is None


def test_a_value_that_is_exact_needs_no_zeros(plan: Plan, policy: Policy) -> None:
    asked = rule(policy, least=3)
    assert said(plan, asked, typed(plan, "60"), 60.0) is None
    assert said(plan, asked, typed(plan, "60"), 60.2) is not None


def test_only_computed_values_have_figures(hydraulic: "Case") -> None:
    asked = rule(hydraulic.policy, least=3, most=3)
    for quantity in hydraulic.plan.answered:
        text = replace(typed(hydraulic.plan, "5"), quantity=quantity.id)
        found = figures_remark(quantity, text, asked)
        assert (found is not None) == (quantity.kind == "formula")
