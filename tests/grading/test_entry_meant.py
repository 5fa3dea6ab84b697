"""Entries of tables that were written in other units: who converts them has to round.

An inch is 25.4 mm by definition, a minute 60 s: 63 mm are 2.4803 in, 185 l/min 3.0833 l/s and
440 l/min 7.3333 l/s.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Finding, Outcome
from gripcourse.grading.self_check import State, self_check
from gripcourse.policy.model import Tells
from gripcourse.submission.measure import Understood, from_text
from gripcourse.submission.model import Answer, Reading

if TYPE_CHECKING:
    from conftest import Case, Written


def typed(case: "Case", quantity: str, text: str) -> Answer:
    read = from_text(case.plan.quantities[quantity], text)
    assert isinstance(read, Understood)
    return Answer(
        quantity=quantity,
        reading=Reading.READ,
        value=read.value,
        typed=text,
        cell="",
        half_unit=read.half_unit,
        unit=read.unit,
        unit_fits=read.unit_fits,
        remarks=read.remarks,
    )


def answers(case: "Case", texts: Mapping[str, str]) -> dict[str, "Written"]:
    return {**case.answers, **{name: typed(case, name, text) for name, text in texts.items()}}


def found(case: "Case", quantity: str, text: str) -> Finding:
    return case.findings(answers(case, {quantity: text}))[quantity]


@pytest.fixture(scope="module")
def ejector(table: tuple["Case", ...]) -> "Case":
    """A vacuum gripper that takes the ejector of 265 l/min, which consumes 440 l/min."""
    cups = (one for one in table if one.plan.scheme.id == "vacuum_cups")
    return next(one for one in cups if one.reference["ejector_suction"] == pytest.approx(265))


class TestSizes:
    @pytest.mark.parametrize("text", ["2.4803 in", "2.480 in", "2.48 in"])
    def test_a_size_in_inches_is_the_one_that_rounds_to_it(
        self, hydraulic: "Case", text: str
    ) -> None:
        assert found(hydraulic, "bore", text).outcome is Outcome.CORRECT

    @pytest.mark.parametrize("text", ["4.41667 l/s", "4.417 l/s", "4.42 l/s", "15.9 m**3/h"])
    def test_a_flow_in_litres_a_second_is_the_one_that_rounds_to_it(
        self, ejector: "Case", text: str
    ) -> None:
        assert found(ejector, "ejector_suction", text).outcome is Outcome.CORRECT

    def test_a_size_of_the_series_that_is_too_small_is_told_so(self, ejector: "Case") -> None:
        """It is of the series: what is wrong with it is another thing."""
        assert found(ejector, "ejector_suction", "3.08333 l/s").message.text.startswith(
            "The size is below"
        )

    def test_what_rounds_to_no_size_is_none(self, ejector: "Case") -> None:
        assert found(ejector, "ejector_suction", "4.40 l/s").outcome is not Outcome.CORRECT

    def test_what_several_sizes_round_to_is_none_of_them(self, hydraulic: "Case") -> None:
        """2 in stand for anything from 38 to 64 mm: 40, 50 and 63 mm."""
        assert found(hydraulic, "bore", "2 in").outcome is not Outcome.CORRECT

    def test_a_decimal_unit_has_the_same_digits(self, hydraulic: "Case") -> None:
        """63 mm are 6.3 cm; 6 cm are 60 mm, which the series does not have."""
        assert found(hydraulic, "bore", "6.3 cm").outcome is Outcome.CORRECT
        assert found(hydraulic, "bore", "6 cm").outcome is not Outcome.CORRECT

    def test_the_student_reads_what_it_was_taken_for(self, ejector: "Case") -> None:
        remarks = found(ejector, "ejector_suction", "4.417 l/s").remarks
        said = [one for one in remarks if one.text.startswith("It was taken for")]
        assert [one.values["value"] for one in said] == [265.0]


def test_a_number_of_a_table_is_the_one_that_rounds_to_it(ejector: "Case") -> None:
    assert found(ejector, "air_consumption", "7.33 l/s").outcome is Outcome.CORRECT
    assert found(ejector, "air_consumption", "7.33").outcome is not Outcome.CORRECT


def test_a_self_check_takes_it_for_the_same_entry(ejector: "Case") -> None:
    texts = {"ejector_suction": "4.417 l/s", "air_consumption": "7.33 l/s"}
    submission = ejector.submission(answers(ejector, texts))
    told = self_check(submission, ejector.plan, ejector.policy, Tells.ANSWERS).answers
    states = {one.quantity: one.state for one in told}
    assert {states[name] for name in texts} == {State.CONSISTENT}
