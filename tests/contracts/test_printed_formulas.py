"""The printed substitution reads back to the number that is printed behind it."""

import re
from typing import TYPE_CHECKING

import numpy as np
import pytest

from gripcourse.course.quantity import Kind
from gripcourse.proofs.printed_lines import printable, printed_line, prove_printed_lines
from gripcourse.proofs.read_back import read_back
from gripcourse.proofs.samples import Trial
from support.each import each

if TYPE_CHECKING:
    from conftest import Composition


def test_a_printed_line_reads_back_to_its_value(trials: dict[str, tuple[Trial, ...]]) -> None:
    results = tuple(prove_printed_lines([one for own in trials.values() for one in own]))
    assert [one.problems for one in results if one.problems] == []
    assert sum(one.compared for one in results) > 400


@each("compositions", "composition")
def test_every_formula_that_reads_no_table_is_printed_without_one(
    composition: "Composition",
) -> None:
    read = {one.id for one, _ in printable(composition.plan)}
    left = {
        one.id
        for one in composition.plan.answered
        if one.kind is Kind.FORMULA and one.formula is not None and '"' not in one.formula.text
    } - read  # but what reads a table inside its formula
    assert left == set()


@pytest.mark.parametrize(
    ("line", "language", "value"),
    [
        ("1.3 · 900 N/(2 · 0.15)", "en", 3900),
        ("1,3 · 900 Н/(2 · 0,15)", "ru", 3900),
        ("√((4 · 22\u202f941,2 Н)/(π · 10 МПа · 0,8091))", "ru", 0.0600844),
        ("arcsin((90 мм)/(150 мм))", "ru", 0.6435011),
        ("51 mm · (36.8699° − 0°)", "en", 0.0328186),
        ("51 мм · (0,643501 рад − 0 рад)", "ru", 0.0328186),
        ("3,5 Вт/(11 Вт/(м²·К) · 48,5 см²)", "ru", 65.60450),
        ("60 кг · (10 м/с² + 5 м/с²)", "ru", 900),
        ("0,418² · 2·10⁻⁵ м", "ru", 3.494480e-6),
        ("max(5,2; 5,9)", "ru", 5.9),
        ("20,3 МПа ≤ 80 МПа", "ru", 1),
        ("2 ≤ max(1; 3); 7 ≤ 5", "ru", 0),
        ("585 N·m", "en", 585),
    ],
)
def test_the_reader_understands_what_is_printed(line: str, language: str, value: float) -> None:
    assert read_back(line, language) == pytest.approx(value, rel=1e-5)


@each("compositions", "composition")
def test_an_angle_that_counts_as_a_number_is_put_in_in_radians(composition: "Composition") -> None:
    """Else a pocket calculator gives another number for the printed line than stands behind it."""
    plan, faults = composition.plan, []
    for one, formula in printable(plan):
        line = printed_line(one, formula, plan, composition.example.values, "en")
        degrees = re.sub(
            r"(sin|cos|tan)[²³]? ?\((?:[^()]|\([^()]*\))*\)|(sin|cos|tan)[²³]? [\d.]+°",
            "",
            line,
        )
        if "°" in degrees and one.unit not in {"deg", "rad"} and one.kind is not Kind.VERDICT:
            faults.append(f"{one.id}: {line}")
    assert faults == []


@pytest.mark.parametrize(
    ("line", "language"), [("200 1/s · 0.3 ohm·s", "en"), ("200 1/с · 0,3 Ом·с", "uk")]
)
def test_a_unit_that_begins_with_a_one_is_no_further_factor(line: str, language: str) -> None:
    assert read_back(line, language) == pytest.approx(60)


def test_a_printed_line_that_lost_its_brackets_would_be_noticed() -> None:
    right = read_back("1.3 · 900 N/(2 · 0.15)", "en")
    wrong = read_back("1.3 · 900 N/2 · 0.15", "en")
    assert not np.isclose(right, wrong, rtol=1e-6)
