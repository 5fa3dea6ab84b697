"""What a student's report says, and above all what it does not say."""

from collections.abc import Callable
from dataclasses import replace
from datetime import date
from functools import cache
from html import unescape

import pytest

from gripcourse.course.model import Course
from gripcourse.documents.pdf import Document, render_html
from gripcourse.documents.report.student import TEMPLATE, student_report, student_values
from gripcourse.grading.model import Against, Cause, Flag, FlagCode, Outcome, Report, Timing
from gripcourse.policy.model import Policy, Reveal
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words, message
from support.pages import not_laid_out

Change = Callable[..., Report]
Printer = Callable[..., bytes]

TELLTALE = 77.777
RUSSIAN = Words("ru")


@pytest.fixture(scope="module")
def printed(plan: Plan, policy: Policy, course: Course, graded_on: date) -> Printer:
    def make(report: Report, reveal: Reveal = Reveal.NOTHING, words: Words = RUSSIAN) -> bytes:
        shown = replace(policy, reveal=reveal)
        return student_report(report, plan, shown, course, words, graded_on)

    return make


@pytest.fixture(scope="module")
def perfect_in(perfect: Report, long_name: str, printed: Printer) -> Callable[[str], bytes]:
    """The perfect report of a long name in a language, laid out once."""
    named = replace(perfect, name=long_name)
    return cache(lambda language: printed(named, words=Words(language)))


@pytest.fixture
def text(
    plan: Plan, policy: Policy, course: Course, graded_on: date, read: Callable[[str], str]
) -> Callable[..., str]:
    """Read all that the template puts out: what is not there cannot be in the file either."""

    def make(report: Report, reveal: Reveal = Reveal.NOTHING, words: Words = RUSSIAN) -> str:
        shown = replace(policy, reveal=reveal)
        values = student_values(report, plan, shown, course, words) | {"graded_on": graded_on}
        return read(render_html(Document(TEMPLATE, (), values), course.root / "templates", words))

    return make


def test_the_result_comes_first(perfect: Report, text: Callable[..., str]) -> None:
    written = text(perfect, words=Words("en"))
    assert perfect.name in written
    assert f"{perfect.score:g} of {perfect.max_score:g} points, 100%" in written
    assert "21 May 2025" in written
    assert written.index("points, 100%") < written.index("Your answer")


def test_what_lateness_leaves_stands_large_with_the_points_before_it(
    perfect: Report, text: Callable[..., str]
) -> None:
    late = replace(perfect, timing=Timing(1, 1, True, None, None, 1, 0.25, ""))
    whole = perfect.max_score
    written = text(late, words=Words("en"))
    assert f"{0.75 * whole:g} of {whole:g} points, 75% before lateness: {whole:g}" in written
    waiting = text(replace(late, open_points=8.0), words=Words("en"))
    assert "and up to 6 points more that the instructor marks" in waiting
    waived = replace(late, timing=Timing(1, 1, True, None, None, 0, 0.0, "Hospital."))
    written = text(waived, words=Words("en"))
    assert f"{whole:g} of {whole:g} points, 100%" in written
    assert "before lateness" not in written


def test_every_section_and_quantity_is_listed(
    perfect: Report, plan: Plan, text: Callable[..., str]
) -> None:
    written = text(perfect)
    for finding in perfect.findings:
        assert plan.quantities[finding.quantity].title.of("ru") in written
    for section in plan.course.sections:
        assert section.title.of("ru") in written


def test_points_that_wait_for_a_person_are_announced(
    perfect: Report, text: Callable[..., str]
) -> None:
    assert perfect.open_points == 4.0
    assert "and up to 4 points more that the instructor marks" in text(perfect, words=Words("en"))


def test_what_cost_points_is_named(
    perfect: Report, wrong: Change, text: Callable[..., str]
) -> None:
    written = text(wrong(perfect, "drive_force", 500.0), words=Words("en"))
    losses = written[written.index("What cost most points") :]
    assert losses.startswith("What cost most points −2 P required force of the drive ✗ wrong")


@pytest.mark.parametrize("outcome", [Outcome.WRONG, Outcome.SLIP, Outcome.BLANK])
def test_a_reference_is_never_printed_unless_the_policy_reveals_it(
    perfect: Report, with_finding: Change, text: Callable[..., str], outcome: Outcome
) -> None:
    report = with_finding(
        perfect,
        "drive_force",
        outcome=outcome,
        against=Against.NOTHING,
        given=None if outcome is Outcome.BLANK else 12.0,
        reference=TELLTALE,
        expected=TELLTALE,
        band=TELLTALE / 100,
        points=0.0,
    )
    assert "77,777" not in text(report)
    assert "0,7778" not in text(report)
    assert "77,777" in text(report, Reveal.REFERENCE)


def test_a_correct_answer_does_not_bring_the_exact_reference(
    perfect: Report, with_finding: Change, text: Callable[..., str]
) -> None:
    report = with_finding(perfect, "drive_force", given=77.7, reference=TELLTALE, expected=TELLTALE)
    assert "77,777" not in text(report)


def test_a_number_that_is_not_the_students_own_is_not_substituted(
    perfect: Report, wrong: Change, blank: Change, text: Callable[..., str]
) -> None:
    # The judge computes a blank bore from what is upstream; that number is the next reference.
    report = wrong(
        blank(perfect, "bore_required"), "bore", 100.0, inputs={"bore_required": TELLTALE}
    )
    assert "77,777" not in text(report)
    assert "77,777" in text(report, Reveal.REFERENCE)


def test_a_number_that_was_not_carried_on_is_not_replaced_by_the_reference(
    perfect: Report, with_finding: Change, wrong: Change, text: Callable[..., str]
) -> None:
    unthinkable = with_finding(perfect, "bore_required", given=-5.0)
    report = wrong(unthinkable, "bore", 100.0, inputs={"bore_required": TELLTALE})
    assert "77,777" not in text(report)


def test_the_students_own_numbers_are_substituted(
    perfect: Report, with_finding: Change, wrong: Change, text: Callable[..., str]
) -> None:
    own = with_finding(perfect, "bore_required", given=TELLTALE)
    report = wrong(own, "bore_first", 50.0, inputs={"bore_required": TELLTALE})
    assert "D I ≥ D тр = 77,777 мм" in text(report)


def test_what_follows_from_own_numbers_is_shown_with_its_result(
    perfect: Report, with_finding: Change, text: Callable[..., str]
) -> None:
    report = with_finding(
        perfect,
        "grip_force",
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        given=4200.0,
        expected=4201.4,
        band=42.0,
    )
    assert "= 4201,4 Н" in text(report)


def test_what_follows_from_a_slip_in_a_blank_step_does_not_bring_the_right_value(
    perfect: Report, with_finding: Change, blank: Change, text: Callable[..., str]
) -> None:
    # The formula's value at the right value of the blank step is the reference.
    report = with_finding(
        blank(perfect, "bore_required"),
        "grip_force",
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        given=4200.0,
        expected=TELLTALE,
        low=TELLTALE,
        high=TELLTALE,
        band=TELLTALE / 100,
        slip=SlipId.parse("unit:cm"),
        roots=("bore_required",),
        message=message("Follows from a slip in a step that you left blank."),
    )
    written = text(report)
    assert "77,777" not in written
    assert "Follows from a slip in a step that you left blank." in written
    assert "77,777" in text(report, Reveal.REFERENCE)


def test_a_consequence_names_the_answer_that_it_follows_from(
    perfect: Report, with_finding: Change, wrong: Change, text: Callable[..., str]
) -> None:
    report = with_finding(
        wrong(perfect, "grip_force", 1.0),
        "drive_force",
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        roots=("grip_force",),
    )
    assert "↪ carried forward from F 2 / 2" in text(report, words=Words("en"))


def test_roots_and_next_steps_come_before_the_answers(
    perfect: Report, with_finding: Change, wrong: Change, text: Callable[..., str]
) -> None:
    carried = with_finding(
        wrong(perfect, "grip_force", 1.0),
        "drive_force",
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        roots=("grip_force",),
    )
    cause = Cause("grip_force", ("drive_force",), message("It explains a later answer."))
    written = text(replace(carried, causes=(cause,)), words=Words("en"))
    places = [
        written.index(said)
        for said in (
            "What cost most points",
            "Causes of lost points",
            "What to do next",
            "Review first: F",
            "How to read this report",
            "Your answer",
        )
    ]
    assert places == sorted(places)


def test_a_sound_decision_is_shown_as_the_student_took_it(
    perfect: Report, with_finding: Change, text: Callable[..., str]
) -> None:
    report = with_finding(
        perfect,
        "bore",
        outcome=Outcome.CARRIED,
        against=Against.OWN_INPUTS,
        given=80.0,
        expected=63.0,
        reference=63.0,
        inputs={},
    )
    assert "→ 80 мм" in text(report)
    assert "→ 63 мм" not in text(report)


def test_flags_are_for_the_instructor(perfect: Report, text: Callable[..., str]) -> None:
    flag = Flag(FlagCode.OTHER_VARIANT, message("The answers fit another variant better."))
    assert "another variant" not in text(replace(perfect, flags=(flag,)))


def test_unreadable_cells_are_listed_with_their_places_and_blank_ones_by_symbol(
    perfect: Report, blank: Change, with_finding: Change, text: Callable[..., str]
) -> None:
    report = with_finding(
        blank(perfect, "bore_required"),
        "drive_force",
        outcome=Outcome.UNREADABLE,
        against=Against.NOTHING,
        given=None,
        typed="около 23 кН",
        cell="Ответы!D42",
        points=0.0,
        remarks=(message("There is no number in the cell."),),
    )
    written = text(report, words=Words("en"))
    unreadable = written[written.index("Cells that could not be read") :]
    assert "(Ответы!D42)" in unreadable
    assert "около 23 кН" in unreadable
    assert "There is no number in the cell." in unreadable
    assert written.count("There is no number in the cell.") == 1
    empty = written[written.index("Cells without an answer") : written.index("Your answer")]
    assert "D req" in empty


def test_an_empty_work_is_told_no_formula_and_each_section_once(
    perfect: Report, blank: Change, text: Callable[..., str]
) -> None:
    report = perfect
    for one in perfect.findings:
        if not one.outcome.traits.by_rubric:
            report = blank(report, one.quantity)
    written = text(report, words=Words("en"))
    assert written.count("Nothing was handed in for:") == 1
    assert "You handed in nothing" not in written
    assert "Cells without an answer" not in written
    assert "=" not in written[written.index("What to do next") :]


def test_whoever_hands_in_the_workbook_of_another_is_told_so_without_a_name(
    perfect: Report, text: Callable[..., str]
) -> None:
    flag = Flag(
        FlagCode.ISSUED_TO_OTHER, message("The workbook was issued to {other}.", other="s002")
    )
    written = text(replace(perfect, flags=(flag,)), words=Words("en"))
    assert "it was issued to another student. Hand in your own." in written
    assert "s002" not in written


def test_the_formula_of_a_blank_answer_waits_for_publication(
    perfect: Report, blank: Change, text: Callable[..., str]
) -> None:
    report = blank(perfect, "jaw_travel")
    assert "S =" not in text(report, words=Words("en"))


def test_an_accepted_erratum_comes_with_its_remark(
    perfect: Report, with_finding: Change, text: Callable[..., str]
) -> None:
    report = with_finding(
        perfect,
        "drive_force",
        against=Against.PRINTED,
        message=message("Accepted as the source prints it."),
        remarks=(message("The force ratio is largest at another position."),),
    )
    written = text(report, words=Words("en"))
    assert "as printed" in written
    assert "Accepted as the source prints it." in written
    assert "The force ratio is largest at another position." in written


def test_a_file_that_could_not_be_judged_is_no_zero(
    perfect: Report, rejected: Change, text: Callable[..., str]
) -> None:
    written = text(rejected(perfect), words=Words("en"))
    assert "This file could not be judged." in written
    assert "this is not a zero" in written
    assert "points," not in written
    assert "Your answer" not in written


def test_names_and_cells_are_text_and_never_markup(
    perfect: Report, with_finding: Change, text: Callable[..., str]
) -> None:
    report = with_finding(
        replace(perfect, name='<b>&"Иван'),
        "drive_force",
        outcome=Outcome.UNREADABLE,
        against=Against.NOTHING,
        given=None,
        typed="<script>{{ 7*7 }}</script>",
        points=0.0,
    )
    written = text(report)
    assert '<b>&"Иван' in written
    assert "<script>{{ 7*7 }}</script>" in written


def test_no_line_ends_between_the_sign_of_a_verdict_and_what_it_means(
    perfect: Report, blank: Change, printed: Printer
) -> None:
    with not_laid_out():
        page = printed(blank(perfect, "bore")).decode()
    for outcome in (Outcome.CORRECT, Outcome.BLANK):
        word = RUSSIAN.say(outcome.traits.word)
        assert f"<b>{outcome.traits.sign}\u00a0{word}:</b>" in unescape(page)


def test_no_line_of_the_head_begins_with_a_separator(perfect: Report, printed: Printer) -> None:
    with not_laid_out():
        page = printed(perfect).decode()
    head = page.partition('<p class="under">')[2].partition("</p>")[0]
    assert "&nbsp;· " in head
    assert " · " not in head


def test_a_long_name_stands_on_the_first_page_and_the_last_tells_how_many_there_are(
    long_name: str, perfect_in: Callable[[str], bytes], pages_of: Callable[[bytes], list[str]]
) -> None:
    pages = pages_of(perfect_in("ru"))
    assert long_name in pages[0]
    assert pages[-1].endswith(f"{len(pages)} / {len(pages)}")


def test_the_file_says_what_the_template_says_and_keeps_back_what_it_keeps_back(
    perfect: Report, wrong: Change, printed: Printer, text_of: Callable[[bytes], str]
) -> None:
    report = wrong(perfect, "drive_force", 12.0, reference=TELLTALE, expected=TELLTALE)
    pdf = printed(report)
    assert "Иванова Ольга" in text_of(pdf)
    assert "77,777" not in text_of(pdf)


@pytest.mark.parametrize("reveal", [Reveal.NOTHING, Reveal.REFERENCE])
def test_points_of_many_figures_stay_on_a_line(
    reveal: Reveal, perfect: Report, printed: Printer, pages_of: Callable[[bytes], list[str]]
) -> None:
    first, second, *others = perfect.findings
    many = (replace(first, points=100.0, max_points=100.0),
            replace(second, points=8.75, max_points=17.25))  # fmt: skip
    pages = pages_of(printed(replace(perfect, findings=(*many, *others)), reveal))
    printed_points = " ".join(" ".join(pages).replace("\u00a0", " ").split())
    assert "100,00 / 100,00" in printed_points
    assert "8,75 / 17,25" in printed_points


def test_a_report_is_the_same_each_time(perfect: Report, printed: Printer) -> None:
    with not_laid_out():
        assert printed(perfect) == printed(perfect)


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_perfect_report_is_short_and_brings_its_fonts(
    perfect_in: Callable[[str], bytes],
    pages_of: Callable[[bytes], list[str]],
    embedded_fonts: Callable[[bytes], dict[str, bool]],
    language: str,
) -> None:
    first = perfect_in(language)
    assert len(pages_of(first)) <= 3
    assert all(embedded_fonts(first).values())


def test_headers_are_repeated_on_every_page(
    long_name: str, perfect_in: Callable[[str], bytes], pages_of: Callable[[bytes], list[str]]
) -> None:
    pages = pages_of(perfect_in("en"))
    assert len(pages) >= 2
    assert all("Your answer" in page for page in pages)
    assert all(long_name in page for page in pages)


def test_the_worst_reports_of_all_are_short(
    perfect: Report,
    blank: Change,
    wrong: Change,
    printed: Printer,
    pages_of: Callable[[bytes], list[str]],
) -> None:
    empty = all_wrong = perfect
    for finding in perfect.findings:
        if finding.outcome is not Outcome.MANUAL:
            empty = blank(empty, finding.quantity)
            all_wrong = wrong(all_wrong, finding.quantity, 1234.5)
    assert empty.score == 0
    assert len(pages_of(printed(empty))) <= 2
    assert 2 <= len(pages_of(printed(all_wrong))) <= 5
