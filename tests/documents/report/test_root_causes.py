"""A report tells the few roots from the many answers that follow from them, and what to do."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from gripcourse.documents.report.next_steps import next_steps
from gripcourse.documents.report.root_causes import cause_rows
from gripcourse.grading.model import Against, Cause, Outcome, Report
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words, message

Change = Callable[..., Report]
ENGLISH = Words("en")
LATER = ("drive_force", "bore_required", "pin_force")


@pytest.fixture
def slipped(perfect: Report, wrong: Change, with_finding: Change) -> Report:
    """Somebody whose grip force is wrong and who computed on faultlessly."""
    report = wrong(perfect, "grip_force", 1.0)
    for name in LATER:
        report = with_finding(
            report,
            name,
            outcome=Outcome.CARRIED,
            against=Against.OWN_INPUTS,
            roots=("grip_force",),
        )
    cause = Cause("grip_force", LATER, message("Your {title} explains it.", title="grip force"))
    return replace(report, causes=(cause,))


@pytest.fixture
def mistaken(perfect: Report, plan: Plan, with_finding: Change) -> tuple[Report, str]:
    """Somebody who read a given value wrongly, and the id of that value."""
    given = plan.givens[0].id
    report = with_finding(
        perfect, "grip_force", outcome=Outcome.SLIP, slip=SlipId.used(given), points=0.0
    )
    report = with_finding(report, "drive_force", outcome=Outcome.CARRIED, roots=("grip_force",))
    said = message("These answers fit together if 12 kg was used.")
    return replace(report, causes=(Cause(given, ("grip_force", "drive_force"), said),)), given


def test_a_root_says_what_follows_from_it_and_what_that_kept(slipped: Report, plan: Plan) -> None:
    (row,) = cause_rows(slipped, plan, ENGLISH)
    assert row.symbol == plan.quantities["grip_force"].symbol.of("en")
    assert (row.sign, row.verdict, row.said) == ("✗", "wrong", "")
    assert row.later == tuple(plan.quantities[name].symbol.of("en") for name in LATER)
    assert row.count == "3"
    assert row.kept.split() == ["6", "/", "6"]


def test_a_number_used_wrongly_is_a_root_of_its_own_and_says_so(
    mistaken: tuple[Report, str], plan: Plan
) -> None:
    report, given = mistaken
    (row,) = cause_rows(report, plan, ENGLISH)
    assert row.title == plan.quantities[given].title.of("en")
    assert row.said == "These answers fit together if 12 kg was used."
    assert row.verdict == ""
    assert row.count == "1", "the answer that it spoiled first follows from nothing"


def test_a_cause_without_a_later_answer_has_no_row(slipped: Report, plan: Plan) -> None:
    cause = Cause("grip_force", ("bore",), message("Nothing follows."))
    assert list(cause_rows(replace(slipped, causes=(cause,)), plan, ENGLISH)) == []


def test_the_root_comes_before_the_other_mistakes(
    slipped: Report, wrong: Change, plan: Plan
) -> None:
    steps = next_steps(wrong(slipped, "bore", 1.0), plan, ENGLISH)
    assert [one.title for one in steps.first] == [plan.quantities["grip_force"].title.of("en")]
    assert [one.title for one in steps.other] == [plan.quantities["bore"].title.of("en")]
    assert steps.compare == ()


def test_a_given_value_that_was_mistaken_is_compared_with_the_sheet(
    mistaken: tuple[Report, str], plan: Plan
) -> None:
    report, given = mistaken
    steps = next_steps(report, plan, ENGLISH)
    assert [one.title for one in steps.compare] == [plan.quantities[given].title.of("en")]
    assert steps.first == steps.other == ()


def test_an_answer_that_another_number_was_used_for_is_gone_over_first(
    mistaken: tuple[Report, str], plan: Plan, with_finding: Change
) -> None:
    report, _ = mistaken
    report = with_finding(report, "grip_force", slip=SlipId.used("lifting_load"))
    cause = replace(report.causes[0], quantity="lifting_load")
    steps = next_steps(replace(report, causes=(cause,)), plan, ENGLISH)
    assert [one.title for one in steps.first] == [plan.quantities["lifting_load"].title.of("en")]
    assert steps.compare == ()


def test_what_waits_for_a_person_is_said_with_its_points(perfect: Report, plan: Plan) -> None:
    steps = next_steps(perfect, plan, ENGLISH)
    assert len(steps.waiting) == 2
    assert steps.waiting_points == "up\u00a0to\u00a04\u00a0points"
    assert steps.any


def test_where_all_is_done_there_is_no_next_step(perfect: Report, plan: Plan) -> None:
    closed = tuple(one for one in perfect.findings if not one.is_open)
    assert not next_steps(replace(perfect, findings=closed), plan, ENGLISH).any
