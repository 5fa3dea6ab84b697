"""Mistakes that the grader did not think of itself: one costs once, and gets no false name."""

import math
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind
from gripcourse.grading.model import Finding, Outcome
from gripcourse.grading.rounding import figure_half_unit

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from conftest import Case, Written
    from gripcourse.submission.model import Answer

    Typed = Callable[[str, float, int], Answer]
    Rounded = Callable[..., dict[str, Written]]

SMALL = 9  # variants of as many schemes; benchmarks measure with all
ONCE = 0.97
NINE = 9.0


@pytest.fixture
def rounded(typed: "Typed") -> "Rounded":
    """Write computed answers with so many figures; sizes and verdicts stand as they are."""

    def write(case: "Case", answers: "Mapping[str, float]", figures: int) -> "dict[str, Written]":
        quantities = case.plan.quantities
        return {
            name: typed(name, value, figures)
            if quantities[name].kind is Kind.FORMULA and value and not quantities[name].integer
            else value
            for name, value in answers.items()
        }

    return write


def lost(case: "Case", findings: "Mapping[str, Finding]") -> list[str]:
    return [
        name
        for name, one in findings.items()
        if case.plan.quantities[name].kind.answered and one.points < one.max_points - 1e-9
    ]


def swapped(value: float) -> float | None:
    """Swap the first two digits of a number that differ, none of them zero."""
    text = f"{value:.10g}"
    digits = [place for place, sign in enumerate(text) if sign in "123456789"]
    for one, other in pairwise(digits):
        if other == one + 1 and text[one] != text[other]:
            return float(text[:one] + text[other] + text[one] + text[other + 1 :])
    return None


@pytest.fixture(scope="module")
def some(drawn: "tuple[Case, ...]") -> "tuple[Case, ...]":
    return tuple(case.without_errata for case in drawn[:: max(1, len(drawn) // SMALL)])


def test_ten_for_gravity_is_coarse_and_costs_once(
    drawn: "tuple[Case, ...]", rounded: "Rounded"
) -> None:
    """Errata are accepted: the guide itself computes with 10."""
    said = []
    for case in drawn[::3]:
        findings = case.findings(rounded(case, case.following(gravity=10.0), 4))
        assert not [one.quantity for one in findings.values() if one.slip], case.label
        assert len(lost(case, findings)) <= 1, case.label
        assert not [one for one in findings.values() if one.outcome.traits.mistake], case.label
        said += [one for one in findings.values() if one.outcome is Outcome.ROUGH]
    assert said
    assert all("10" in str(one.message) for one in said)
    assert all(0 < one.points < one.max_points for one in said)


@pytest.mark.parametrize("figures", [1, 2])
def test_a_number_rounded_too_far_never_gets_a_slip(
    some: "tuple[Case, ...]", read_answer: "Callable[..., Answer]", figures: int
) -> None:
    for case in some[::4]:
        for name in [one.id for one in case.plan.answered if one.kind is Kind.FORMULA][::9]:
            coarse = float(f"{case.reference[name]:.{figures - 1}e}")
            typed = replace(
                read_answer(name, coarse),
                half_unit=min(0.5, figure_half_unit(coarse, figures)),
                figures=figures,
            )
            finding = case.findings({**case.answers, name: typed})[name]
            assert finding.slip is None, (case.label, name)


def test_a_misread_given_costs_once(some: "tuple[Case, ...]", rounded: "Rounded") -> None:
    works = []
    for case in some:
        for given in case.plan.givens:
            misread = swapped(case.given[given.id])
            users = [one for one in case.plan.answered if given.id in case.plan.inputs[one.id]]
            if misread is None or sum(one.kind is Kind.FORMULA for one in users) < 2:
                continue
            answers = case.following(**{given.id: misread})
            if all(math.isfinite(value) for value in answers.values()):
                works.append(len(lost(case, case.findings(rounded(case, answers, 4)))) <= 1)
                break
    assert len(works) >= SMALL // 2
    assert sum(works) >= ONCE * len(works) - 1  # one in few is no share


def test_a_number_read_for_an_issued_zero_costs_once(
    table: "tuple[Case, ...]", rounded: "Rounded"
) -> None:
    """An arm that lies along the axis by its sheet is taken as tilted by nine degrees."""
    works = [
        (case, given.id)
        for case in table
        for given in case.plan.givens
        if given.unit == "deg" and not case.given[given.id] and given.bounds[1] >= NINE
    ]
    looked_at = 0
    for case, given in works[:SMALL]:
        users = [one for one in case.plan.answered if given in case.plan.inputs[one.id]]
        answers = case.following(**{given: NINE})
        if len(users) > 1 and all(math.isfinite(value) for value in answers.values()):
            findings = case.findings(rounded(case, answers, 5))
            assert len(lost(case, findings)) <= 1, (case.label, given)
            looked_at += 1
    assert looked_at


def test_a_square_forgotten_in_millimetres_is_named_though_unlike_things_are_added(
    drawn: "tuple[Case, ...]", typed: "Typed"
) -> None:
    """π/4·(D² − d) with D = 50 and d = 20 is written down as 1948 mm²."""
    case = next(one for one in drawn if "rod" in one.plan.inputs.get("piston_area", ()))
    bore, rod = case.reference["bore"], case.reference["rod"]
    area = math.pi / 4 * (bore**2 - rod)
    assert case.reference["piston_area"] < 0.97 * area
    answers = {**case.following(piston_area=area), "piston_area": typed("piston_area", area, 5)}
    finding = case.without_errata.findings(answers)["piston_area"]
    assert finding.slip is not None
    assert finding.slip.kind == "power"


def test_a_number_read_wrongly_is_seen_where_gravity_was_shortened_too(
    table: "tuple[Case, ...]", rounded: "Rounded"
) -> None:
    """The answers that the mass spoils, of which one uses gravity, have one number in common."""
    case = next(
        one
        for one in table
        if {"load_lift", "load_extend"} <= one.plan.inputs.keys() and "mass" in one.given
    )
    misread = swapped(10 + case.given["mass"]) or 3 * case.given["mass"]
    answers = rounded(case, case.following(mass=misread, gravity=9.8), 4)
    findings = case.findings(answers)
    assert len(lost(case, findings)) <= 1
    assert {str(one.slip) for one in findings.values() if one.slip} <= {"used:mass"}
