"""What the second generator did is set against what the grader says."""

from collections.abc import Sequence
from dataclasses import replace

import pytest

from gripcourse.course.model import Course
from gripcourse.grading.model import Against, Flag, FlagCode, Outcome
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.foreign.costs import Uncharged, why_uncharged
from gripcourse.simulation.foreign.judge import judge_foreign
from gripcourse.simulation.foreign.kinds import Doing
from gripcourse.simulation.foreign.measures import evaluate_foreign
from gripcourse.simulation.foreign.model import JudgedForeign
from gripcourse.simulation.mix import load_mix
from gripcourse.simulation.model import Mix
from gripcourse.text.words import message

COUNT, SEED, SCHEME = 10, 8, "rack_parallelogram"


@pytest.fixture(scope="module")
def mix(course: Course) -> Mix:
    return load_mix(course)


@pytest.fixture(scope="module")
def judged(course: Course, policy: Policy, mix: Mix) -> Sequence[JudgedForeign]:
    room = make_classroom(course, policy, mix, COUNT, SEED, SCHEME)
    return judge_foreign(room.context, SEED, 0)


def test_fine_honest_students_lose_nothing(judged: Sequence[JudgedForeign], mix: Mix) -> None:
    found = evaluate_foreign(judged, mix)
    assert found.students == COUNT
    assert found.rates["honest_refused"].hits == 0
    assert found.rates["honest_refused"].total > 50
    assert found.incidents == ()


def test_a_mistake_shows_in_what_it_reaches(judged: Sequence[JudgedForeign]) -> None:
    mistaken = [one for one in judged if one.work.done is not None]
    assert mistaken
    for one in mistaken:
        assert one.work.reaches
        assert one.report.score < one.report.max_score


def test_nobody_who_copies_is_the_source_of_another(judged: Sequence[JudgedForeign]) -> None:
    sources = {source for one in judged for source in one.work.sources}
    assert sources.isdisjoint(one.work.student for one in judged if one.work.sources)


def test_a_flag_on_own_work_is_counted(judged: Sequence[JudgedForeign], mix: Mix) -> None:
    flag = Flag(FlagCode.SAME_ANSWERS, message("Empty."))
    flagged = [replace(one, report=replace(one.report, flags=(flag,))) for one in judged]
    found = evaluate_foreign(flagged, mix)
    assert found.rates["own_flagged"].share == 1.0
    assert "own_flagged" in found.missed


def test_two_cohorts_are_counted_together(judged: Sequence[JudgedForeign], mix: Mix) -> None:
    half = len(judged) // 2
    parts = [evaluate_foreign(part, mix) for part in (judged[:half], judged[half:])]
    both = parts[0] + parts[1]
    whole = evaluate_foreign(judged, mix)
    for name in ("honest_refused", "charged_once", "named", "incidents"):
        assert both.rates[name] == whole.rates[name]
    assert both.by_kind == whole.by_kind
    doings = {one.work.doing for one in judged}
    assert {Doing.HONEST, Doing.MISTAKE} <= doings


def test_a_wrong_number_that_is_paid_for_is_no_miss_that_may_be(
    judged: Sequence[JudgedForeign], mix: Mix
) -> None:
    paid = [_settled(one, Outcome.CORRECT) for one in judged]
    wrong = [one for one in paid if why_uncharged(one) is Uncharged.PAID]
    assert wrong
    assert all(one.work.done is not None for one in wrong)
    found = evaluate_foreign(paid, mix)
    assert "uncharged_paid" in found.missed
    assert {one.work.student for what, one in found.misses if what == "paid"} <= {
        one.work.student for one in wrong
    }


def test_a_mistake_costs_nothing_more_for_one_of_four_reasons(
    judged: Sequence[JudgedForeign],
) -> None:
    one = next(
        one for one in judged if why_uncharged(_settled(one, Outcome.CORRECT)) is Uncharged.PAID
    )
    assert why_uncharged(one) is None, "it did cost"
    rough = _settled(one, Outcome.ROUGH)
    assert why_uncharged(rough) is Uncharged.ROUGH
    right = _settled(one, Outcome.CORRECT)
    sizes = replace(right, work=replace(right.work, decisions=right.work.reaches))
    assert why_uncharged(sizes) is Uncharged.SOUND
    printed = _settled(one, Outcome.CORRECT, Against.PRINTED)
    assert why_uncharged(printed) is Uncharged.SOUND
    blank = replace(right, work=replace(right.work, cells={}))
    assert why_uncharged(blank) is Uncharged.BLANK


def _settled(
    one: JudgedForeign, outcome: Outcome, against: Against = Against.REFERENCE
) -> JudgedForeign:
    """Return a work all of whose answers earn all points by one outcome."""
    findings = tuple(
        replace(found, outcome=outcome, against=against, points=found.max_points)
        for found in one.report.findings
    )
    return replace(one, report=replace(one.report, findings=findings))
