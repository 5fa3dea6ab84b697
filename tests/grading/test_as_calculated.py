"""Who writes few digits and goes on with all of them makes no mistake by that."""

import math
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind
from gripcourse.grading.model import Finding, Outcome

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from conftest import Case, Written
    from gripcourse.submission.model import Answer

    Whole = Callable[..., dict[str, Written]]

SOME = 5  # every so many-th of the drawn variants
FEW = 20
ONCE = 0.85  # by the cells alone it is little more than half: nobody rounds harder than so


def whole(value: float) -> tuple[float, float]:
    """A number in whole units, below ten with a decimal, and half a unit of its last digit."""
    decimals = 0 if abs(value) >= 10 else 1
    if abs(value) < 0.5 * 10.0**-decimals:
        decimals = 1 - math.floor(math.log10(abs(value)))
    return round(value, decimals), 0.5 * 10.0**-decimals


@pytest.fixture
def in_whole_units(read_answer: "Callable[..., Answer]") -> "Whole":
    """Write computed answers in whole units; sizes and verdicts stand as they are."""

    def write(case: "Case", answers: "Mapping[str, float]") -> "dict[str, Written]":
        kinds = {one.id: one.kind for one in case.plan.answered}
        found: dict[str, Written] = dict(answers)
        for name, value in answers.items():
            if kinds[name] is Kind.FORMULA and value and not case.plan.quantities[name].integer:
                typed, half_unit = whole(value)
                figures = len(f"{typed:g}".replace(".", "").lstrip("-0").rstrip("0")) or 1
                found[name] = replace(
                    read_answer(name, typed), half_unit=half_unit, figures=figures
                )
        return found

    return write


def mistakes(findings: "Mapping[str, Finding]") -> list[str]:
    return [name for name, one in findings.items() if one.outcome.traits.mistake]


def early(case: "Case") -> str:
    """A computed answer that many others need."""
    computed = [one.id for one in case.plan.answered if one.kind is Kind.FORMULA]
    return max(computed[: len(computed) // 2], key=lambda name: len(case.needing(name)))


def test_ten_for_gravity_and_whole_numbers_are_rough_and_never_wrong(
    drawn: "tuple[Case, ...]", in_whole_units: "Whole"
) -> None:
    for case in drawn[::SOME]:
        answers = in_whole_units(case, case.following(gravity=10.0))
        assert mistakes(case.findings(answers)) == [], case.label


def test_an_early_mistake_costs_once_though_later_numbers_were_computed_with_more_digits(
    drawn: "tuple[Case, ...]", in_whole_units: "Whole"
) -> None:
    works, once, told = 0, 0, []
    for case in drawn:
        name = early(case)
        answers = case.following(gravity=10.0, **{name: 1.6 * case.reference[name]})
        if all(map(math.isfinite, answers.values())):
            findings = case.findings(in_whole_units(case, answers))
            works += 1
            once += mistakes(findings) in ([], [name])
            told += [one for one in findings.values() if "calculator" in str(one.message)]
    assert works > FEW
    assert once >= ONCE * works
    assert told
    assert all(one.points == one.max_points for one in told)


@pytest.mark.parametrize("times", [0.8, 1.25])
def test_a_wrong_number_beside_whole_ones_stays_wrong(
    drawn: "tuple[Case, ...]", in_whole_units: "Whole", times: float
) -> None:
    """More than rounding explains: it differs by more than two units of the last digit."""
    looked_at = 0
    for case in drawn[::SOME]:
        right = case.following(gravity=10.0)
        for name in [one.id for one in case.plan.answered if one.kind is Kind.FORMULA][::11]:
            typed, half_unit = whole(times * right[name]) if right[name] else (0.0, 0.0)
            if abs(typed - right[name]) <= 4 * half_unit:
                continue
            answers = in_whole_units(case, {**right, name: times * right[name]})
            finding = case.findings(answers)[name]
            looked_at += 1
            assert finding.outcome not in {Outcome.CORRECT, Outcome.ROUGH}, (case.label, name)
    assert looked_at > FEW
