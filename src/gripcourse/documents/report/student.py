"""The report that a student gets: the result, what is behind it, and every answer with its verdict.

What the policy keeps back never reaches the template: where it reveals nothing, neither a reference
value, nor a result that would be one, nor a number that is not the student's own is put into words.
Flags are for the instructor. One is for the student too: that the workbook is another's.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import date

from gripcourse.course.model import Course
from gripcourse.course.note import NotedDocument, notes_of
from gripcourse.documents.pdf import Document, render_pdf
from gripcourse.documents.report.answers import AnswerRow, answer_row, own_numbers
from gripcourse.documents.report.columns import aligned_rows
from gripcourse.documents.report.next_steps import next_steps
from gripcourse.documents.report.root_causes import cause_rows
from gripcourse.documents.report.standing import grades_of, standing_of, timing_texts, waiting_text
from gripcourse.documents.report.totals import (
    SectionTotal,
    empty_sections,
    is_blank,
    peers_text,
    section_totals,
)
from gripcourse.documents.report.worked import notation_notes
from gripcourse.grading.model import Finding, FlagCode, Outcome, Report
from gripcourse.policy.model import Policy, Reveal
from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import NO_BREAK_SPACE, percent_text, points_text, points_up_to
from gripcourse.text.words import Message, Words, message

TEMPLATE = "student.html.j2"
STYLES = ("page.css", "formula.css", "student.css")

_AT_EASE = 30  # answers with something below them, before they stand closer
_COSTLY = 6  # so many of the costliest answers stand on the first page


@dataclass(frozen=True, slots=True)
class SectionBlock:
    """One section: its bar on the first page and its table.

    Attributes:
        title: in the reader's language.
        points: `12 / 15`.
        percent: share of the points earned, 0…100, as the width of the bar.
        waiting: what still waits for a person, empty for nothing.
        rows: one for each answer that there is anything to say of; none where nothing was handed
            in, which the first page says.
    """

    title: str
    points: str
    percent: float
    waiting: str
    rows: tuple[AnswerRow, ...]


@dataclass(frozen=True, slots=True)
class Loss:
    """An answer that cost points: how many, which, and the verdict with its sign."""

    points: str
    symbol: str
    title: str
    sign: str
    verdict: str


def student_report(  # noqa: PLR0913 (the last is what a class of one leaves as it is)
    report: Report,
    plan: Plan,
    policy: Policy,
    course: Course,
    words: Words,
    graded_on: date,
    *,
    peers: Sequence[float] = (),
) -> bytes:
    """Make the report of one submission as a PDF file.

    Args:
        report: the judgement, of a judged or of a rejected file.
        plan: of the scheme and options that the report names.
        policy: what may be revealed.
        course: titles and the folder with the templates.
        words: the language of the report.
        graded_on: the day that is printed.
        peers: shares of the points that all judged works of the class earned; printed as quartiles
            once the policy publishes the solution.
    """
    values = student_values(report, plan, policy, course, words, peers) | {"graded_on": graded_on}
    return render_pdf(Document(TEMPLATE, STYLES, values), course.root / "templates", words)


def student_values(
    report: Report,
    plan: Plan,
    policy: Policy,
    course: Course,
    words: Words,
    peers: Sequence[float] = (),
) -> dict[str, object]:
    """Return what the template needs but the date; see `student_report` for the arguments."""
    reveal = policy.reveal is Reveal.REFERENCE
    share = report.earned / report.max_score if report.max_score else None
    sections = list(_sections(report, plan, policy, course, words))
    return {
        "course": course.title.of(words.language),
        "student": report.name or report.student or "—",
        "variant": report.variant or "—",
        "scheme": plan.scheme.title.of(words.language),
        "judged": report.judged,
        "score": report.score,
        "earned": report.earned,
        "before": _before(report, words),
        "max_score": report.max_score,
        "share": "" if share is None else percent_text(share, words),
        "open_points": report.open_points,
        "to_come": standing_of(report).waiting,
        "grades": grades_of(report, policy.scales, words),
        "timing": timing_texts(report, words),
        "waits": waiting_text(report, plan.quantities, words),
        "reveal": reveal,
        "peers": peers_text(report, policy, words, peers),
        "remarks": [words.say(remark) for remark in (*_misplaced(report), *report.remarks)],
        "sections": aligned_rows(sections, "points"),
        "dense": sum(row.detailed for one in sections for row in one.rows) > _AT_EASE,
        "losses": aligned_rows([_loss(one, plan, words) for one in _costly(report)], "points"),
        "causes": list(cause_rows(report, plan, words)),
        "steps": next_steps(report, plan, words),
        "notes": [
            *notation_notes(plan, words),
            *(
                text.of(words.language)
                for text in notes_of(
                    course.notes, NotedDocument.REPORT, plan.scheme.id, plan.quantities
                )
            ),
        ],
        "legend": [
            (outcome.traits.sign, words.say(outcome.traits.word), words.say(outcome.traits.meaning))
            for outcome in Outcome
            if any(finding.outcome is outcome for finding in report.findings)
        ],
    }


def _before(report: Report, words: Words) -> str:
    """Return the points before lateness in words; nothing where it takes nothing off."""
    if not report.is_cut:
        return ""
    said = message("before lateness: {points}", points=points_text(report.score, words))
    # The number stands in a narrow column, and never on a line of its own.
    return words.say(said).replace(": ", f":{NO_BREAK_SPACE}")


def _misplaced(report: Report) -> Iterator[Message]:
    if any(flag.code is FlagCode.ISSUED_TO_OTHER for flag in report.flags):
        yield message(
            "This is not the workbook that was issued to you: it was issued to another student. "
            "Hand in your own."
        )


def _sections(
    report: Report, plan: Plan, policy: Policy, course: Course, words: Words
) -> Iterator[SectionBlock]:
    totals, own = section_totals(report), own_numbers(report, plan)
    empty = empty_sections(report)
    for section in course.sections:
        if section.id not in totals:
            continue
        total = totals[section.id]
        # Of a section without any answer there is nothing to say but that, once.
        told_once = section.id in empty and policy.reveal is Reveal.NOTHING
        rows = aligned_rows(
            [
                answer_row(finding, plan, own, policy, words)
                for finding in report.findings
                if finding.section == section.id and not (told_once and is_blank(finding))
            ],
            "points",
        )
        yield SectionBlock(
            title=section.title.of(words.language),
            points=_earned(total, words),
            percent=100 * total.points / total.max_points if total.max_points else 0.0,
            waiting=_waiting(total, words),
            rows=tuple(rows),
        )


def _earned(total: SectionTotal, words: Words) -> str:
    if not total.max_points:
        return "—"
    return f"{points_text(total.points, words)} / {points_text(total.max_points, words)}"


def _waiting(total: SectionTotal, words: Words) -> str:
    if not total.open_points:
        return ""
    points = points_up_to(total.open_points, words)
    return words.say(message("and {points} by hand", points=points))


def _costly(report: Report) -> list[Finding]:
    lost = [one for one in report.findings if not one.is_open and one.points < one.max_points]
    return sorted(lost, key=lambda one: one.points - one.max_points)[:_COSTLY]


def _loss(finding: Finding, plan: Plan, words: Words) -> Loss:
    quantity = plan.quantities[finding.quantity]
    return Loss(
        points=f"−{points_text(finding.max_points - finding.points, words)}",
        symbol=quantity.symbol.of(words.language),
        title=quantity.title.of(words.language),
        sign=finding.outcome.traits.sign,
        verdict=words.say(finding.outcome.traits.word),
    )
