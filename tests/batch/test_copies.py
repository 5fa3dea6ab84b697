"""Evidence reaches the instructor as flags, and never the student."""

from dataclasses import replace

import pytest

from gripcourse.batch import copies as alike
from gripcourse.batch.context import GradingContext
from gripcourse.batch.copies import like_others, with_alike
from gripcourse.batch.graded import Graded
from gripcourse.documents.report.student import student_values
from gripcourse.exports.grades import grades_text
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Report
from gripcourse.grading.unjudged import unknown_student_report
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.text.words import LANGUAGES, Words

TELLING = {"other_variant", "same_answers", "same_creator"}


@pytest.fixture(scope="session")
def other(context: GradingContext, plan: Plan) -> GradingContext:
    """One student of the context has numbers of his own."""
    entry = context.register["s02"]
    low = {
        one.id: value * (1.07 if one.kind == "given" and value > 1 else 1.0)
        for one in plan.givens
        for value in (entry.variant.given[one.id],)
    }
    variant = replace(entry.variant, id="002", given=low)
    return replace(context, register={**context.register, "s02": replace(entry, variant=variant)})


def graded(
    context: GradingContext, plan: Plan, student: str, source: str, creator: str = ""
) -> Report:
    """The report of a student who hands in the answers of another's variant."""
    entry = context.register[student]
    values = solve_variant(plan, context.register[source].variant.given)
    answers = {
        one.id: Answer(
            one.id, Reading.READ, values[one.id], "", "E6", 0.0005, "", unit_fits=True, remarks=()
        )
        for one in plan.answered
    }
    variant = entry.variant
    identity = Identity(student, variant.id, variant.scheme, variant.options, entry.signature)
    submission = Submission(
        f"{student}.xlsx", "", identity, creator, dict(variant.given), answers, ()
    )
    return judge(submission, entry, plan, context.policy)


def codes(report: Report) -> set[str]:
    return {flag.code for flag in report.flags} & TELLING


def like(reports: list[Report], context: GradingContext) -> tuple[list[Report], str]:
    """All reports as they are after the comparison, and what failed."""
    batch = [Graded(one, "") for one in reports]
    compared = with_alike(batch, like_others(batch, context), reports)
    return [one.report for one in compared], "".join(one.incident for one in compared)


def test_a_copied_workbook_is_flagged_and_the_honest_ones_are_not(
    other: GradingContext, plan: Plan
) -> None:
    reports = [graded(other, plan, name, name) for name in ("s01", "s02", "s03")]
    copied = graded(other, plan, "s04", "s02")
    marked, trace = like([*reports, copied], other)
    assert trace == ""
    assert [codes(one) for one in marked[:3]] == [set(), set(), set()]
    assert codes(marked[3]) == {"other_variant", "same_answers"}
    assert "s02" in str(marked[3].flags[-1].message)
    assert marked[3].score == copied.score


def test_the_instructor_sees_the_flag_and_the_student_nothing(
    other: GradingContext, plan: Plan
) -> None:
    copied = graded(other, plan, "s04", "s02", "Petrov")
    copy = graded(other, plan, "s05", "s05", "Petrov")
    rest = graded(other, plan, "s01", "s01")
    marked, _ = like([copied, copy, rest], other)
    assert codes(marked[0]) >= {"other_variant", "same_creator"}
    assert "other_variant" in grades_text(marked)
    for language in LANGUAGES:
        words = Words(language)
        pages = [
            student_values(replace(one, flags=flags), plan, other.policy, other.course, words)
            for one in marked
            for flags in ((), one.flags)
        ]
        assert pages[0::2] == pages[1::2]
        assert "s02" not in str(pages[:2])


def test_files_that_were_not_judged_are_passed_over(other: GradingContext) -> None:
    report = unknown_student_report("x.xlsx", "nobody", "")
    assert like([report], other) == ([report], "")
    assert like([], other) == ([], "")


def test_grading_is_never_lost_for_a_failure_of_the_search(
    other: GradingContext, plan: Plan, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(alike, "find_evidence", fail)
    report = graded(other, plan, "s01", "s01")
    marked, trace = like([report], other)
    assert marked == [report]
    assert "ZeroDivisionError" in trace
