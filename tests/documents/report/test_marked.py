"""What a person decided, as a student and an instructor read it."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from datetime import UTC, date, datetime

import pytest

from gripcourse.course.model import Course
from gripcourse.documents.report.cohort import cohort_report
from gripcourse.documents.report.marked import decision_rows, marked_item, marked_tables
from gripcourse.documents.report.student import student_report, student_values
from gripcourse.exports.grades import grades_text
from gripcourse.grading.model import Against, Decision, Outcome, Report
from gripcourse.policy.model import Policy
from gripcourse.policy.rubric import Level
from gripcourse.solver.plan import Plan
from gripcourse.text.words import LANGUAGES, Texts, Words
from support.pages import not_laid_out, text_of_page

Change = Callable[..., Report]

DRAWING = "general_view_drawing"
LINES = {"sizes": 1.0, "assembly": 0.5, "standards": 0.0}
ENGLISH = Words("en")


def decide(
    report: Report,
    change: Change,
    quantity: str = DRAWING,
    credit: float = 0.55,
    **changes: object,
) -> Report:
    """Let a person decide about one item that is worth 2 points."""
    decision = Decision(
        automatic=Outcome.MANUAL,
        credit=credit,
        lines=LINES,
        marker="Петров П. П.",
        decided_at=datetime(2025, 5, 20, 9, tzinfo=UTC),
        comment="Нет масштаба.",
        outdated=False,
    )
    changed = change(
        report,
        quantity,
        outcome=Outcome.MANUAL,
        against=Against.NOTHING,
        points=2 * credit,
        decision=replace(decision, **changes),  # type: ignore[arg-type]
    )
    closed = [one for one in changed.findings if not one.is_open]
    return replace(
        changed,
        score=sum(one.points for one in closed),
        max_score=sum(one.max_points for one in closed),
        open_points=sum(one.max_points for one in changed.findings if one.is_open),
    )


@pytest.fixture
def marked(perfect: Report, with_finding: Change) -> Report:
    """Everything is right; the drawing has 1.1 of 2 points, another item is open."""
    return decide(perfect, with_finding)


@pytest.fixture
def overruled(perfect: Report, wrong: Change, with_finding: Change) -> Report:
    """A wrong answer for which a person gave a half."""
    return decide(
        wrong(perfect, "drive_force", 1.0),
        with_finding,
        "drive_force",
        0.5,
        automatic=Outcome.WRONG,
        lines={},
        comment="Описка в условии.",
    )


@pytest.fixture(autouse=True)
def _not_laid_out() -> Iterator[None]:
    with not_laid_out():
        yield


@pytest.fixture
def printed(
    plan: Plan, policy: Policy, course: Course, graded_on: date
) -> Callable[[Report, str], str]:
    """Return the text of a student's report."""

    def make(report: Report, language: str) -> str:
        words = Words(language)
        return text_of_page(student_report(report, plan, policy, course, words, graded_on))

    return make


class TestTheStudentsReport:
    def test_the_lines_stand_below_the_drawing_with_their_points(
        self, marked: Report, plan: Plan, policy: Policy
    ) -> None:
        finding = next(one for one in marked.findings if one.quantity == DRAWING)
        item = marked_item(finding, plan.quantities[DRAWING], policy, ENGLISH)
        assert item is not None
        rubric = policy.rubrics["general_view"]
        assert [one.text for one in item.lines] == [line.text.of("en") for line in rubric.lines]
        points = [one.points.replace("\u00a0", "") for one in item.lines]
        assert points == ["0.8/0.8", "0.3/0.6", "0/0.6"]
        assert item.said == "Marked by Петров П. П., 20\u00a0May\u00a02025."
        assert item.notes == ("Нет масштаба.",)

    @pytest.mark.parametrize("language", LANGUAGES)
    def test_it_is_printed_in_every_language(
        self, marked: Report, policy: Policy, printed: Callable[[Report, str], str], language: str
    ) -> None:
        text = printed(marked, language)
        for line in policy.rubrics["general_view"].lines:
            assert line.text.of(language)[:30] in text
        assert "Нет масштаба." in text
        assert "Петров П. П." in text

    def test_the_score_includes_it_and_less_is_open(
        self, marked: Report, perfect: Report, plan: Plan, policy: Policy, course: Course
    ) -> None:
        before = student_values(perfect, plan, policy, course, ENGLISH)
        after = student_values(marked, plan, policy, course, ENGLISH)
        assert after["score"] == pytest.approx(before["score"] + 1.1)
        assert after["max_score"] == before["max_score"] + 2
        assert after["open_points"] == before["open_points"] - 2
        assert after["share"] != before["share"]

    def test_what_a_drawing_cost_is_among_the_losses(
        self, marked: Report, plan: Plan, policy: Policy, course: Course
    ) -> None:
        losses = student_values(marked, plan, policy, course, ENGLISH)["losses"]
        assert [(one.points, one.verdict) for one in losses] == [("−0.9", "by the instructor")]

    def test_an_overruled_verdict_is_a_persons_decision(
        self, overruled: Report, plan: Plan, policy: Policy
    ) -> None:
        finding = next(one for one in overruled.findings if one.decision is not None)
        item = marked_item(finding, plan.quantities["drive_force"], policy, ENGLISH)
        assert item is not None
        assert item.said.startswith("Decided by Петров П. П., 20\u00a0May\u00a02025.")
        assert item.said.endswith("The automatic verdict was: wrong.")
        assert item.lines == ()

    def test_points_that_are_not_the_sum_of_the_lines_are_explained(
        self, perfect: Report, with_finding: Change, plan: Plan, policy: Policy
    ) -> None:
        report = decide(perfect, with_finding, credit=0.25)
        finding = next(one for one in report.findings if one.quantity == DRAWING)
        item = marked_item(finding, plan.quantities[DRAWING], policy, ENGLISH)
        assert item is not None
        assert item.notes[0] == "The lines add up to 1.1; 0.5 points were given."

    def test_the_level_that_was_reached_is_named(
        self, marked: Report, plan: Plan, policy: Policy
    ) -> None:
        rubric = policy.rubrics["general_view"]
        half = Level(0.5, Texts(dict.fromkeys(LANGUAGES, "moves, but collides")))
        line = replace(rubric.lines[1], levels=(half,))
        levels = replace(rubric, lines=(rubric.lines[0], line, rubric.lines[2]))
        finding = next(one for one in marked.findings if one.quantity == DRAWING)
        stepped = replace(policy, rubrics={"general_view": levels})
        item = marked_item(finding, plan.quantities[DRAWING], stepped, ENGLISH)
        assert item is not None
        assert [one.level for one in item.lines] == ["", "moves, but collides", ""]

    def test_a_line_that_the_rubric_lost_keeps_its_name(
        self, marked: Report, plan: Plan, policy: Policy
    ) -> None:
        rubric = policy.rubrics["general_view"]
        shorter = replace(policy, rubrics={"general_view": replace(rubric, lines=rubric.lines[1:])})
        finding = next(one for one in marked.findings if one.quantity == DRAWING)
        item = marked_item(finding, plan.quantities[DRAWING], shorter, ENGLISH)
        assert item is not None
        assert (item.lines[-1].text, item.lines[-1].points) == ("sizes", "100%")

    def test_a_comment_is_text_and_no_markup(
        self, perfect: Report, with_finding: Change, printed: Callable[[Report, str], str]
    ) -> None:
        report = decide(perfect, with_finding, comment="<b>A & B</b>")
        assert "<b>A & B</b>" in printed(report, "en")


class TestTheCohort:
    def test_a_table_for_each_rubric_with_the_means_of_its_lines(
        self, marked: Report, perfect: Report, with_finding: Change, policy: Policy, plan: Plan
    ) -> None:
        full = decide(perfect, with_finding, credit=1.0, lines=dict.fromkeys(LINES, 1.0))
        declared = plan.quantities
        (table,) = marked_tables([marked, perfect, full], declared, policy, ENGLISH)
        assert table.title == "General view drawing"
        assert [row.lines for row in table.rows] == [
            ("100%", "50%", "0%"),
            ("100%", "100%", "100%"),
        ]
        assert table.means == ("100%", "75%", "50%", "77.5%")
        assert table.lines[0].endswith("(40%)")

    def test_a_mark_to_look_at_again_says_so(
        self, perfect: Report, with_finding: Change, policy: Policy, plan: Plan
    ) -> None:
        report = decide(perfect, with_finding, outdated=True)
        (table,) = marked_tables([report], plan.quantities, policy, ENGLISH)
        assert "look again" in table.rows[0].marker

    def test_decisions_without_a_rubric_have_their_own_table(
        self, overruled: Report, marked: Report, plan: Plan, policy: Policy
    ) -> None:
        (row,) = decision_rows([overruled, marked], plan.quantities, ENGLISH)
        assert row.note == "wrong: Описка в условии."
        assert len(marked_tables([overruled, marked], plan.quantities, policy, ENGLISH)) == 1

    def test_both_are_printed(
        self,
        overruled: Report,
        marked: Report,
        policy: Policy,
        course: Course,
        graded_on: date,
    ) -> None:
        text = text_of_page(cohort_report([overruled, marked], policy, course, ENGLISH, graded_on))
        assert "Marked by the instructor: General view drawing" in text
        assert "Decided by the instructor" in text
        assert "Описка в условии." in text

    def test_without_marks_nothing_is_said_of_them(
        self,
        perfect: Report,
        policy: Policy,
        course: Course,
        graded_on: date,
    ) -> None:
        text = text_of_page(cohort_report([perfect], policy, course, ENGLISH, graded_on))
        assert "Marked by the instructor" not in text
        assert "Decided by the instructor" not in text

    def test_the_grades_have_the_points(self, marked: Report, perfect: Report) -> None:
        def row(report: Report) -> Mapping[str, str]:
            header, cells = grades_text([report]).splitlines()
            return dict(zip(header.split(","), cells.split(","), strict=True))

        before, after = row(perfect), row(marked)
        assert float(after["score"]) == pytest.approx(float(before["score"]) + 1.1)
        assert float(after["open_points"]) == float(before["open_points"]) - 2
