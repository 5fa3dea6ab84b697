"""An early hard step must not make the later ones look hard."""

from collections.abc import Callable

import pytest

from gripcourse.documents.report.items import FEWEST, item_statistics
from gripcourse.grading.model import Against, Outcome, Report

Change = Callable[..., Report]


@pytest.fixture
def consequence(perfect: Report, wrong: Change, with_finding: Change) -> Report:
    """Somebody whose grip force is wrong and whose drive force follows from it."""
    return with_finding(
        wrong(perfect, "grip_force", 1.0),
        "drive_force",
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        roots=("grip_force",),
    )


def test_facility_is_the_mean_share_of_the_points(perfect: Report, wrong: Change) -> None:
    found = item_statistics([perfect, perfect, wrong(perfect, "drive_force", 1.0)])["drive_force"]
    assert found.without.facility == pytest.approx(2 / 3)
    assert found.with_consequences.facility == pytest.approx(2 / 3)


def test_a_consequence_counts_against_an_item_only_where_it_should(
    perfect: Report, consequence: Report
) -> None:
    items = item_statistics([perfect, consequence])
    assert items["drive_force"].with_consequences.facility == 0.5
    assert items["drive_force"].without.facility == 1.0
    assert items["grip_force"].without.facility == 0.5


def test_a_consequence_counts_as_right_whatever_credit_it_earned(
    consequence: Report, with_finding: Change
) -> None:
    half = with_finding(consequence, "drive_force", points=1.0)
    assert item_statistics([half])["drive_force"].without.facility == 1.0


def test_what_follows_from_another_sound_decision_is_no_consequence_of_a_mistake(
    perfect: Report, with_finding: Change
) -> None:
    report = with_finding(perfect, "drive_force", outcome=Outcome.CARRIED, roots=())
    assert item_statistics([report])["drive_force"].with_consequences.facility == 1.0


def test_what_waits_for_a_person_says_nothing(
    perfect: Report, with_finding: Change, rejected: Change
) -> None:
    waiting = with_finding(perfect, "drive_force", outcome=Outcome.NOT_JUDGED, points=0.0)
    items = item_statistics([waiting, rejected(perfect)])
    assert "drive_force" not in items
    assert "general_view_drawing" not in items
    assert items["bore"].without.facility == 1.0


def test_an_item_that_the_weak_miss_tells_students_apart_and_one_that_the_strong_miss_does_not(
    perfect: Report, wrong: Change
) -> None:
    weak = perfect
    for name in ("bore_required", "bore", "grip_force", "drive_force"):
        weak = wrong(weak, name, 1.0)
    strong = wrong(perfect, "pin_force", 1.0)
    items = item_statistics([weak] * (FEWEST // 2) + [strong] * (FEWEST // 2))
    telling, misleading = items["bore"].without, items["pin_force"].without
    assert telling.discrimination == pytest.approx(1.0)
    assert misleading.discrimination == pytest.approx(-1.0)
    assert items["lifting_load"].without.discrimination is None, "everybody has it right"


def test_few_students_tell_nothing_about_discrimination(perfect: Report, wrong: Change) -> None:
    one = wrong(wrong(perfect, "bore", 1.0), "grip_force", 1.0)
    items = item_statistics([perfect] * (FEWEST - 2) + [one])
    assert items["bore"].without.discrimination is None


def test_consequences_make_later_items_look_as_if_they_told_students_apart(
    perfect: Report, consequence: Report
) -> None:
    items = item_statistics([perfect] * FEWEST + [consequence] * FEWEST)
    assert items["drive_force"].with_consequences.discrimination == pytest.approx(1.0)
    assert items["drive_force"].without.discrimination is None
