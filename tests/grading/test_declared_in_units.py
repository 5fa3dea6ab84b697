"""A wrong method by which a number measures something else: an area written for a length."""

from typing import TYPE_CHECKING

from gripcourse.grading.model import Outcome

if TYPE_CHECKING:
    from conftest import Case


def test_a_length_without_its_width_is_an_area_and_named(table: "tuple[Case, ...]") -> None:
    """1200 N on 10 N/mm² are 120 mm², whatever the width of the slot."""
    case = next(one for one in table if one.plan.scheme.id == "wedge_slide")
    area = case.reference["wedge_force"] / case.given["slot_pressure_allowed"]
    answers = case.following(slot_contact_required=area)
    finding = case.findings(answers)["slot_contact_required"]
    assert finding.outcome is Outcome.SLIP
    assert "width_left_out" in str(finding.slip)
