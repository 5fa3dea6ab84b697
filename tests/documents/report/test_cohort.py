"""The report on a cohort: everybody is in it, and what a person must look at stands out."""

from collections.abc import Callable
from dataclasses import replace
from datetime import date
from functools import cache

import pytest

from gripcourse.course.model import Course
from gripcourse.documents.report import cohort
from gripcourse.documents.report.cohort import cohort_report, cohort_values
from gripcourse.documents.report.items import item_statistics
from gripcourse.documents.report.quantities import AskedQuantity, quantity_groups
from gripcourse.documents.report.totals import quantity_totals
from gripcourse.grading.model import Flag, FlagCode, Outcome, Report, Timing
from gripcourse.policy.model import Policy
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words, message
from support.pages import not_laid_out, text_of_page

Change = Callable[..., Report]


@pytest.fixture(scope="module")
def reports(
    perfect: Report, wrong: Change, blank: Change, rejected: Change, long_name: str
) -> list[Report]:
    odd = Flag(FlagCode.GIVENS_CHANGED, message("Given values were changed in the workbook."))
    unread = Flag(FlagCode.REJECTED, message("The file is protected by a password."))
    return [
        perfect,
        replace(wrong(perfect, "drive_force", 1.0), name=long_name, flags=(odd,)),
        replace(blank(perfect, "bore"), name='<b>&"Иван'),
        replace(rejected(perfect), name="Сидоров Сидор", flags=(unread,)),
    ]


@pytest.fixture(scope="module")
def printed(
    policy: Policy, course: Course, graded_on: date
) -> Callable[[list[Report], str], bytes]:
    def make(reports: list[Report], language: str) -> bytes:
        return cohort_report(reports, policy, course, Words(language), graded_on)

    return make


@pytest.fixture(scope="module")
def printed_in(reports: list[Report], printed: Callable[..., bytes]) -> Callable[[str], bytes]:
    """The summary of all the reports in a language, laid out once."""
    return cache(lambda language: printed(reports, language))


def test_the_summary_counts_files(reports: list[Report], policy: Policy, course: Course) -> None:
    summary = dict(cohort_values(reports, policy, course, Words("en"))["summary"])  # type: ignore[call-overload]
    assert (summary["Files"], summary["Judged"], summary["Not judged"]) == ("4", "3", "1")
    assert summary["To look at"] == "2"
    assert summary["Lowest and highest"].endswith("100%")


def test_of_a_students_attempts_the_one_that_counts_is_in_the_statistics(
    perfect: Report, wrong: Change, policy: Policy, course: Course
) -> None:
    timings = [Timing(number, 2, number == 1, None, None, 0, 0.0, "") for number in (1, 2)]
    others = replace(wrong(perfect, "drive_force", 1.0), timing=timings[1])
    reports = [others, replace(perfect, student="other"), replace(perfect, timing=timings[0])]
    values = cohort_values(reports, policy, course, Words("en"))
    summary = dict(values["summary"])  # type: ignore[call-overload]
    assert (summary["Files"], summary["Mean"]) == ("3", "100%")
    assert values["slips"] == []
    attempts = [row.attempt for row in values["students"]]  # type: ignore[attr-defined]
    assert attempts == ["", "Attempt 2 of 2: another one counts.", ""]


def test_lateness_is_named_where_the_score_is_less_than_its_sections(
    perfect: Report, printed: Callable[..., bytes]
) -> None:
    late = replace(perfect, timing=Timing(1, 1, True, None, None, 2, 0.2, ""))
    said = "taken off the score, not off the points of sections"
    with not_laid_out():
        assert said in text_of_page(printed([perfect, late], "en"))
        assert said not in text_of_page(printed([perfect], "en"))


def test_statistics_go_by_what_lateness_leaves_and_items_by_what_was_right(
    perfect: Report, policy: Policy, course: Course
) -> None:
    late = replace(perfect, timing=Timing(1, 1, True, None, None, 2, 0.2, ""))
    values = cohort_values([perfect, late], policy, course, Words("en"))
    summary = dict(values["summary"])  # type: ignore[call-overload]
    assert (summary["Mean"], summary["Median"]) == ("90%", "90%")
    assert summary["Lowest and highest"].startswith("80%")
    rows = values["students"]
    assert isinstance(rows, list)
    assert rows[0].before == ""
    assert float(rows[1].before) == float(rows[0].score)
    assert {row.mean for row in values["sections"]} == {"100%"}  # type: ignore[attr-defined]


def test_everybody_is_listed_with_what_was_noticed(
    printed_in: Callable[[str], bytes],
    text_of: Callable[[bytes], str],
    long_name: str,
) -> None:
    written = text_of(printed_in("en"))
    for name in ("Иванова Ольга", long_name, '<b>&"Иван', "Сидоров Сидор"):
        assert name.split()[-1] in written
    assert "Given values were changed in the workbook." in written
    assert "The file is protected by a password." in written


def test_a_rejected_file_has_a_dash_for_points(
    reports: list[Report], policy: Policy, course: Course
) -> None:
    rows = cohort_values(reports, policy, course, Words("en"))["students"]
    assert isinstance(rows, list)
    assert rows[-1].score == "—"
    assert set(rows[-1].sections) == {"—"}


def test_each_quantity_has_its_outcomes(
    reports: list[Report], policy: Policy, course: Course
) -> None:
    groups = cohort_values(reports, policy, course, Words("en"))["groups"]
    assert isinstance(groups, list)
    rows = [row for group in groups for row in group.rows]
    force = next(row for row in rows if row.title == "required force of the drive")
    outcomes = [one for one in Outcome if one.traits.counted]
    counted = dict(zip(outcomes, force.counts, strict=True))
    some = {outcome: count for outcome, count in counted.items() if count}
    assert some == {Outcome.CORRECT: "2", Outcome.WRONG: "1"}
    assert force.facility == ("66.7%", "66.7%")
    assert force.discrimination == ("—", "—")


def test_what_a_person_marks_is_no_row_of_outcomes(
    reports: list[Report], policy: Policy, course: Course
) -> None:
    groups = cohort_values(reports, policy, course, Words("en"))["groups"]
    assert isinstance(groups, list)
    named = sum(len(group.rows) + len(group.faultless) for group in groups)
    assert named == sum(one.points > 0 for one in reports[0].findings)


def test_a_row_has_only_what_somebody_got_wrong_or_left_out(
    reports: list[Report], plan: Plan, policy: Policy, course: Course
) -> None:
    groups = cohort_values(reports, policy, course, Words("en"))["groups"]
    assert isinstance(groups, list)
    titles = {row.title for group in groups for row in group.rows}
    changed = ("drive_force", "bore")
    assert titles == {plan.quantities[one].title.of("en") for one in changed}
    assert {one.answers for group in groups for one in group.faultless} == {3}


def test_an_empty_workbook_says_nothing_about_a_quantity(
    perfect: Report, blank: Change, policy: Policy, course: Course
) -> None:
    empty = perfect
    for one in perfect.findings:
        if one.outcome is not Outcome.MANUAL:
            empty = blank(empty, one.quantity)
    groups = cohort_values([perfect, empty], policy, course, Words("en"))["groups"]
    assert isinstance(groups, list)
    assert not any(group.rows for group in groups)


def test_what_one_scheme_alone_asks_for_comes_after_what_several_do(
    reports: list[Report], course: Course
) -> None:
    other = replace(
        reports[1],
        scheme="wedge_roller",
        options={},
        findings=tuple(one for one in reports[1].findings if one.quantity != "drive_force"),
    )
    both = [reports[0], other]
    asked = AskedQuantity(both, quantity_totals(both), item_statistics(both), {}, course)
    groups = quantity_groups(asked, Words("en"))
    assert groups[0].title.startswith("1. ")
    assert groups[-1].title == "Only rack with gear sectors and parallelogram"
    assert [one.title for one in groups[-1].faultless] == ["drive_force"]


def test_what_a_likeness_rests_on_is_named_by_titles(
    perfect: Report, plan: Plan, policy: Policy, course: Course
) -> None:
    names = message("{names} and {count} more", names="grip_force, bore", count=50)
    odd = Flag(FlagCode.SAME_ANSWERS, message("It rests on: {names}.", names=names))
    flagged = cohort_values([replace(perfect, flags=(odd,))], policy, course, Words("en"))
    (said,) = flagged["flagged"][0].sentences  # type: ignore[index]
    assert f"{plan.quantities['bore'].title.of('en')} and 50 more" in said
    assert "grip_force" not in said


def test_the_plots_can_be_read_as_text(
    printed_in: Callable[[str], bytes], text_of: Callable[[bytes], str]
) -> None:
    written = text_of(printed_in("en"))
    assert "score, %" in written
    assert "mean share of the points, %" in written


def test_the_same_reports_give_the_same_document(
    reports: list[Report], printed: Callable[..., bytes]
) -> None:
    with not_laid_out():
        assert printed(reports, "uk") == printed(reports, "uk")


def test_its_fonts_are_in_the_file(
    printed_in: Callable[[str], bytes], embedded_fonts: Callable[[bytes], dict[str, bool]]
) -> None:
    """In English with Russian names; `test_accessible.py` looks at one in Ukrainian."""
    assert all(embedded_fonts(printed_in("en")).values())


def test_a_cohort_of_which_nothing_could_be_judged_is_reported_too(
    reports: list[Report], printed: Callable[..., bytes], pages_of: Callable[[bytes], list[str]]
) -> None:
    assert len(pages_of(printed(reports[-1:], "en"))) == 1


def test_a_table_too_long_for_paper_says_where_all_of_it_stands(
    reports: list[Report],
    printed: Callable[..., bytes],
    text_of: Callable[[bytes], str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(cohort, "_MOST_ROWS", 2)
    written = " ".join(text_of(printed(reports * 2, "en")).split())
    assert "Only the first 2 of 8 stand here; the table of grades has all." in written  # students
    assert "Only the first 2 of 4 stand here; the table of grades has all." in written  # to look at
    assert "Сидоров" not in written.split("Students", 1)[1]
    monkeypatch.setattr(cohort, "_MOST_ROWS", 8)
    assert "Only the first" not in text_of(printed(reports * 2, "en"))


def test_the_headings_of_a_long_table_are_repeated(
    reports: list[Report], printed: Callable[..., bytes], pages_of: Callable[[bytes], list[str]]
) -> None:
    pages = pages_of(printed(reports[2:3] * 50, "en"))
    with_students = [page for page in pages if "Иван" in page]
    assert len(with_students) >= 2
    assert all(
        "Student Variant 1 2 3 4 5 Score Mark ECTS Open Flags" in page for page in with_students
    )


def test_sections_slips_and_fairness_have_their_tables(
    reports: list[Report],
    with_finding: Change,
    printed: Callable[..., bytes],
) -> None:
    slip = with_finding(
        reports[0],
        "bore",
        outcome=Outcome.SLIP,
        slip=SlipId.parse("unit:mm>cm"),
        given=6.3,
        points=0.0,
    )
    with not_laid_out():
        written = text_of_page(printed([*reports, slip], "en"))
    for heading in (
        "Sections",
        "Were schemes and variants equally hard?",
        "Most common slips",
        "Kinds of mistakes",
        "another unit",
        "not explained",
    ):
        assert heading in written


def test_without_a_mistake_there_is_no_table_of_mistakes(
    perfect: Report, printed: Callable[..., bytes]
) -> None:
    with not_laid_out():
        written = text_of_page(printed([perfect], "en"))
    assert "Most common slips" not in written
    assert "Kinds of mistakes" not in written
