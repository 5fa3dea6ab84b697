"""A number written wrongly and calculated with rightly costs only the answer where it stands."""

from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.model import Outcome

if TYPE_CHECKING:
    from conftest import Case

_EARLY_SLIP = 1.37  # nothing that a wrong method makes


def _from_an_early_slip(case: "Case", **written: float) -> dict[str, float]:
    """Answers that follow from a wrong load, a number of them written in another unit."""
    answers = case.following(lifting_load=_EARLY_SLIP * case.reference["lifting_load"])
    return {**answers, **{name: answers[name] * factor for name, factor in written.items()}}


class TestAnotherUnit:
    @pytest.mark.parametrize("factor", [1e-3, 10])
    def test_what_is_computed_on_from_the_right_number_follows(
        self, hydraulic: "Case", factor: float
    ) -> None:
        """Not even where it is not the reference, because of an earlier mistake."""
        answers = _from_an_early_slip(hydraulic, grip_force=factor)
        findings = hydraulic.findings(answers)
        assert findings["grip_force"].outcome is Outcome.SLIP
        assert findings["drive_force"].outcome is Outcome.CARRIED
        assert findings["drive_force"].points == findings["drive_force"].max_points

    def test_the_worked_line_shows_the_number_that_was_meant(self, hydraulic: "Case") -> None:
        answers = _from_an_early_slip(hydraulic, grip_force=1e-3)
        shown = hydraulic.findings(answers)["drive_force"].inputs["grip_force"]
        assert shown == pytest.approx(1000 * answers["grip_force"])

    def test_what_is_computed_on_from_the_number_as_written_follows_too(
        self, hydraulic: "Case"
    ) -> None:
        wrong = 1e-3 * hydraulic.reference["grip_force"]
        findings = hydraulic.findings(hydraulic.following(grip_force=wrong))
        assert findings["grip_force"].outcome is Outcome.SLIP
        assert findings["drive_force"].outcome is Outcome.CARRIED

    def test_who_writes_all_forces_in_it_pays_once(self, hydraulic: "Case") -> None:
        answers = _from_an_early_slip(hydraulic, grip_force=1e-3, drive_force=1e-3)
        findings = hydraulic.findings(answers)
        assert findings["grip_force"].outcome is Outcome.SLIP
        assert findings["drive_force"].outcome is Outcome.CARRIED
        assert findings["bore_required"].outcome is Outcome.CARRIED


class TestOtherSlips:
    def test_a_wrong_method_is_not_forgiven_in_what_follows(self, hydraulic: "Case") -> None:
        """Only writing can go wrong beside a right calculation; half a load is half a load."""
        answers = _from_an_early_slip(hydraulic, grip_force=0.5)
        findings = hydraulic.findings(answers)
        assert any(
            findings[name].points < findings[name].max_points
            for name in hydraulic.needing("grip_force") & answers.keys()
        )


class TestRightVerdictBesideAWrongNumber:
    """The first pin's bearing stress answers one question: is it below what is allowed?

    It is 40 MPa where 26 are allowed, say: no. Who writes 19, and no, has compared the 40.
    """

    def across(self, case: "Case", share: float) -> dict[str, float]:
        """Right answers, but a stress on the other side of what is allowed."""
        allowed = case.given["bearing_stress_allowed"]
        right = case.reference["bearing_stress"]
        wrong = allowed * (1 - share if right > allowed else 1 + share)
        return {**case.answers, "bearing_stress": wrong}

    def test_a_number_that_nothing_explains_costs_and_the_verdict_does_not(
        self, hydraulic: "Case"
    ) -> None:
        answers = self.across(hydraulic, 0.2731)
        findings = hydraulic.findings(answers)
        assert findings["bearing_stress"].outcome is Outcome.WRONG
        assert hydraulic.lost(answers) == {"bearing_stress"}

    def test_a_verdict_on_the_number_as_written_follows_from_it(self, hydraulic: "Case") -> None:
        answers = self.across(hydraulic, 0.2731)
        answers["bearing_ok"] = 1.0 - answers["bearing_ok"]
        assert hydraulic.findings(answers)["bearing_ok"].outcome is Outcome.CARRIED

    def test_who_used_a_wrong_method_says_the_opposite_of_it(
        self, table: "tuple[Case, ...]"
    ) -> None:
        """Half of the stress is that of twice the diameter: it was computed, and compared."""
        case, answers = next(
            (case, answers)
            for case in table
            if "bearing_stress" in case.answers
            and 1.2 < case.reference["bearing_stress"] / case.given["bearing_stress_allowed"] < 1.8
            for answers in [
                {**case.answers, "bearing_stress": case.reference["bearing_stress"] / 2}
            ]
            if case.findings(answers)["bearing_stress"].outcome is Outcome.SLIP
        )
        assert case.lost(answers) == {"bearing_stress", "bearing_ok"}
