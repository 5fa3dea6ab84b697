"""A size that steps up: judged by the condition, at the reference's numbers and the student's own.

The flat belt needs 50.52 mm for its useful stress, and pulls 444.07 N. It slips at 6.7396 N for
each millimetre of width: one of 63 mm at 424.6 N, of 71 mm at 478.5 N, of 80 mm at 539.2 N. The row
goes on with 90, 100, 112, 125, 140 and 160 mm; one place above the first sound width is not
wasteful.
"""

from typing import TYPE_CHECKING

import pytest

from gripcourse.documents.report.mistakes import kind_rows, slip_rows
from gripcourse.exports.analysis_tables import analysis_tables
from gripcourse.exports.make_report_result import grades_result
from gripcourse.exports.results_tables import csv_tables
from gripcourse.grading.model import Against, Finding, Outcome
from gripcourse.slips.model import SlipId
from gripcourse.text.words import Words

if TYPE_CHECKING:
    from conftest import Case

NOT_STEPPED_UP = (
    "The size is not below the required value, but it does not satisfy F_t,max ≥ F_t: step up to "
    "the next size that does."
)
WASTEFUL = "Wastefully large: more than 1 step above the smallest size that fits."
PER_WIDTH = 6.7396  # newtons for each millimetre, by hand


def finding(case: "Case", **written: float) -> Finding:
    """Judge the width of a student who goes on faultlessly from what is written."""
    return case.findings(case.following(**written))["belt_width"]


@pytest.mark.parametrize("width", [71.0, 80.0])
def test_the_first_width_that_holds_is_sound_and_the_next_one_too(
    flat_belt: "Case", width: float
) -> None:
    found = finding(flat_belt, belt_width=width)
    assert (found.outcome, found.points) == (Outcome.CORRECT, found.max_points)


@pytest.mark.parametrize(
    ("width", "said"),
    [
        (50.0, "The size is below the required value."),
        (63.0, NOT_STEPPED_UP),
        (90.0, WASTEFUL),
        (65.0, "This size is not in the series."),
    ],
)
def test_what_is_wrong_is_said(flat_belt: "Case", width: float, said: str) -> None:
    found = finding(flat_belt, belt_width=width)
    assert (found.points, str(found.message)) == (0, said)
    assert found.outcome.traits.mistake


def test_a_width_that_slips_has_a_name_and_no_other_wrong_one_has(flat_belt: "Case") -> None:
    named = finding(flat_belt, belt_width=63.0)
    assert (named.outcome, named.slip) == (Outcome.SLIP, SlipId.not_stepped_up("belt_width"))
    assert SlipId.parse(str(named.slip)) == named.slip
    for width in (50.0, 65.0, 90.0):
        other = finding(flat_belt, belt_width=width)
        assert (other.outcome, other.slip) == (Outcome.WRONG, None)


def test_everything_that_counts_slips_counts_it(flat_belt: "Case") -> None:
    reports = [flat_belt.judge(flat_belt.following(belt_width=63.0))] * 2
    grades, words = grades_result(reports, Words("en")), Words("en")
    tables = csv_tables(analysis_tables(grades))
    assert "belt_width,not_stepped_up:belt_width,2" in tables["slips.csv"].decode()
    [kind] = kind_rows(reports, flat_belt.policy.slips, words)
    assert (kind.title, kind.students) == ("a size that was not stepped up", "2")
    [row] = slip_rows(reports, flat_belt.plan.quantities, words)
    assert (row.count, row.hint) == ("2", NOT_STEPPED_UP)


def test_the_width_that_was_not_stepped_up_costs_once(flat_belt: "Case") -> None:
    """The belt that slips is followed: its tension, its pull, and that the answer is no."""
    assert flat_belt.lost(flat_belt.following(belt_width=63.0)) == {"belt_width"}


@pytest.mark.parametrize("width", [71.0, 80.0])
def test_the_way_there_need_not_be_written_down(flat_belt: "Case", width: float) -> None:
    written = {**flat_belt.following(belt_width=width), "total_tension": None, "pull_limit": None}
    assert flat_belt.findings(written)["belt_width"].outcome is Outcome.CORRECT


class TestOwnNumbers:
    """Who pulls with 700 N needs 700/6.7396 = 103.9 mm; for the stress 79.6 mm would do."""

    @pytest.mark.parametrize("width", [112.0, 125.0])
    def test_a_width_stepped_up_to_from_them_is_no_second_mistake(
        self, flat_belt: "Case", width: float
    ) -> None:
        found = finding(flat_belt, peripheral_force=700.0, belt_width=width)
        assert (found.outcome, found.against) == (Outcome.CARRIED, Against.OWN_INPUTS)

    @pytest.mark.parametrize(("width", "said"), [(90.0, NOT_STEPPED_UP), (140.0, WASTEFUL)])
    def test_any_other_one_is(self, flat_belt: "Case", width: float, said: str) -> None:
        found = finding(flat_belt, peripheral_force=700.0, belt_width=width)
        assert (found.outcome.traits.mistake, str(found.message)) == (True, said)

    def test_where_no_width_holds_the_first_one_will_do(self, flat_belt: "Case") -> None:
        """Wrapped by 10° only, a belt of 500 mm would slip at 220 N."""
        written = flat_belt.following(belt_width=63.0) | {"wrap_angle": 10.0}
        found = flat_belt.findings(written)["belt_width"]
        assert found.outcome is Outcome.CARRIED


class TestWrongWayToTheCondition:
    """Who counts one strand finds half of each limit: 140 mm hold 471.8 N, 125 mm 421.2 N."""

    def written(self, case: "Case", width: float, times: float) -> dict[str, float]:
        right = case.following(belt_width=width)["pull_limit"]
        assert right == pytest.approx(PER_WIDTH * width, rel=1e-4)
        return case.following(belt_width=width, pull_limit=times * right)

    def test_a_width_that_holds_by_it_is_right(self, flat_belt: "Case") -> None:
        findings = flat_belt.findings(self.written(flat_belt, 140.0, 0.5))
        assert findings["belt_width"].outcome is Outcome.CARRIED
        assert str(findings["pull_limit"].slip) == "one_strand"

    @pytest.mark.parametrize("width", [100.0, 125.0])
    def test_one_that_slips_by_it_is_not(self, flat_belt: "Case", width: float) -> None:
        findings = flat_belt.findings(self.written(flat_belt, width, 0.5))
        assert findings["belt_width"].outcome is Outcome.WRONG

    def test_who_finds_too_much_does_not_step_up(self, flat_belt: "Case") -> None:
        """Twice the limit: 63 mm would hold 849 N."""
        findings = flat_belt.findings(self.written(flat_belt, 63.0, 2.0))
        assert findings["belt_width"].outcome is Outcome.CARRIED
        assert findings["pull_limit"].outcome.traits.mistake


def test_another_sound_width_may_not_be_written_down(flat_belt: "Case") -> None:
    """What follows from 80 mm is right, what follows from the 63 mm that slip is not."""
    for width, right in ((80.0, True), (63.0, False)):
        written = {**flat_belt.following(belt_width=width), "belt_width": None}
        found = flat_belt.findings(written)["total_tension"]
        assert found.outcome.traits.right is right
