"""The report on a cohort, for the instructor: what to look at, slips, fairness, every quantity."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from functools import partial
from pathlib import PurePath
from typing import Final

from gripcourse.course.compose import declared_in
from gripcourse.course.model import Course, Section
from gripcourse.documents.pdf import Chart, Document, render_pdf
from gripcourse.documents.report.charts import ChartBox, box_plot, facility_plot, score_plot
from gripcourse.documents.report.columns import aligned_rows
from gripcourse.documents.report.fairness import extent_text, fairness_rows
from gripcourse.documents.report.flagged import flagged_files
from gripcourse.documents.report.items import FEWEST, item_statistics
from gripcourse.documents.report.marked import decision_rows, marked_tables
from gripcourse.documents.report.mistakes import kind_rows, slip_rows
from gripcourse.documents.report.quantities import COUNTED, AskedQuantity, hardest, quantity_groups
from gripcourse.documents.report.soundness import (
    difficulty_sentences,
    reliability_rows,
    time_sentence,
)
from gripcourse.documents.report.standing import attempt_text, grades_of
from gripcourse.documents.report.totals import (
    counting,
    is_counting,
    quantity_totals,
    section_shares,
    section_totals,
    shares,
    spread,
)
from gripcourse.grading.model import Report
from gripcourse.policy.model import Policy
from gripcourse.text.amounts import percent_text, points_text
from gripcourse.text.words import Message, Words, message

TEMPLATE = "cohort.html.j2"
STYLES = ("page.css", "formula.css", "cohort.css")
# Nobody reads more of them on paper, and each takes time and memory to lay out.
_MOST_ROWS: Final = 2000


@dataclass(frozen=True, slots=True)
class StudentRow:
    """A student's line: texts in the order of the columns; `flags` counts what to look at.

    `attempt` says of a work that another one counts; else it is empty. `score` is what counts;
    `before` is what it was before lateness, empty where that took nothing off.
    """

    name: str
    attempt: str
    variant: str
    score: str
    before: str
    grades: tuple[str, ...]
    sections: tuple[str, ...]
    open_points: str
    flags: str


@dataclass(frozen=True, slots=True)
class SectionRow:
    """A section's line: its number, title and points, and how scores in it are spread."""

    number: int
    title: str
    points: float
    mean: str
    median: str
    deviation: str
    extent: str


def cohort_report(
    reports: Sequence[Report], policy: Policy, course: Course, words: Words, graded_on: date
) -> bytes:
    """Make the report on a cohort as a PDF file.

    Args:
        reports: one for each file, judged or rejected, in the order of the table.
        policy: points of the sections.
        course: titles, declarations and the folder with the templates.
        words: the language of the report.
        graded_on: the day that is printed.
    """
    values = cohort_values(reports, policy, course, words) | {"graded_on": graded_on}
    return render_pdf(Document(TEMPLATE, STYLES, values), course.root / "templates", words)


def cohort_values(
    reports: Sequence[Report], policy: Policy, course: Course, words: Words
) -> dict[str, object]:
    """Return what the template needs but the date; see `cohort_report` for the arguments."""
    declared = declared_in(course, (report.composition for report in reports))
    works = counting(reports)
    scores = shares(works)
    judged = [report for report in works if report.judged]
    totals, items = quantity_totals(judged), item_statistics(judged)
    asked = AskedQuantity(judged, totals, items, declared, course)
    bars = hardest(asked, words)
    sections = [section for section in course.sections if section.id in policy.section_points]
    earned = section_shares(works)
    rows = [_section(earned.get(section.id, ()), section, number, policy, words)
            for number, section in enumerate(sections, start=1)]  # fmt: skip
    columns = [section.id for section in sections]
    beside = _side_by_side(reports)
    students = [_student(one, columns, policy, words) for one in beside[:_MOST_ROWS]]
    flagged = [report for report in reports if report.flags]
    return {
        "course": course.title.of(words.language),
        "summary": list(_summary(reports, scores, words)),
        "sections": aligned_rows(rows, "mean", "median", "deviation", "extent"),
        "scales": [one.title.of(words.language) for one in policy.scales],
        "late": any(one.judged and one.is_cut for one in reports),
        "students": aligned_rows(students, "sections", "score", "before", "open_points"),
        "more_students": _more(len(beside), words),
        "score_plot": Chart(partial(score_plot, scores, words)) if scores else "",
        "section_plot": _section_plot(earned, sections, words),
        "facility_plot": Chart(partial(facility_plot, bars, words)) if bars else "",
        "slips": aligned_rows(slip_rows(works, declared, words), "share"),
        "kinds": aligned_rows(kind_rows(works, policy.slips, words), "share"),
        "fairness": aligned_rows(
            fairness_rows(works, course, words), "mean", "deviation", "extent", "difference"
        ),
        "reliability": aligned_rows(reliability_rows(works, course, words), "alphas"),
        "equal": list(difficulty_sentences(works, words)),
        "times": time_sentence(reports, words),
        "fewest": FEWEST,
        "outcomes": [(outcome.traits.sign, words.say(outcome.traits.word)) for outcome in COUNTED],
        "groups": quantity_groups(asked, words),
        "marked": marked_tables(reports, declared, policy, words),
        "decided": decision_rows(reports, declared, words),
        "flagged": flagged_files(flagged[:_MOST_ROWS], declared, words),
        "more_flagged": _more(len(flagged), words),
    }


def _more(rows: int, words: Words) -> str:
    """Say where the rows stand that a report has no room for; empty where all are there."""
    if rows <= _MOST_ROWS:
        return ""
    said = message(
        "Only the first {shown} of {count} stand here; the table of grades has all.",
        shown=_MOST_ROWS,
        count=rows,
    )
    return words.say(said)


def _summary(
    reports: Sequence[Report], scores: Sequence[float], words: Words
) -> Iterator[tuple[str, str]]:
    judged = sum(report.judged for report in reports)
    found = spread(scores)
    numbers: tuple[tuple[Message, str], ...] = (
        (message("Files"), str(len(reports))),
        (message("Judged"), str(judged)),
        (message("Not judged"), str(len(reports) - judged)),
        (message("To look at"), str(sum(bool(report.flags) for report in reports))),
        (message("Mean"), _share(found.mean, words)),
        (message("Median"), _share(found.median, words)),
        (message("Standard deviation"), _share(found.deviation, words)),
        (message("Lowest and highest"), extent_text(found.lowest, found.highest, words)),
    )
    for label, value in numbers:
        yield words.say(label), value


def _share(share: float | None, words: Words) -> str:
    return "—" if share is None else percent_text(share, words)


def _section(
    earned: Sequence[float], section: Section, number: int, policy: Policy, words: Words
) -> SectionRow:
    found = spread(earned)
    return SectionRow(
        number=number,
        title=section.title.of(words.language),
        points=policy.section_points[section.id],
        mean=_share(found.mean, words),
        median=_share(found.median, words),
        deviation=_share(found.deviation, words),
        extent=extent_text(found.lowest, found.highest, words),
    )


def _section_plot(
    earned: Mapping[str, Sequence[float]], sections: Sequence[Section], words: Words
) -> Chart | str:
    boxes = [
        ChartBox(section.title.of(words.language), earned[section.id])
        for section in sections
        if section.id in earned
    ]
    return Chart(partial(box_plot, boxes, words)) if boxes else ""


def _side_by_side(reports: Sequence[Report]) -> list[Report]:
    """Return the reports in their order, but with the attempts of a student one below the other."""
    first: dict[str, int] = {}
    for place, report in enumerate(reports):
        first.setdefault(report.student or report.file, place)
    return sorted(
        reports,
        key=lambda one: (
            first[one.student or one.file],
            0 if one.timing is None else one.timing.number,
        ),
    )


def _student(report: Report, sections: Sequence[str], policy: Policy, words: Words) -> StudentRow:
    grades = [grade for _, grade in grades_of(report, policy.scales, words)]
    totals = section_totals(report) if report.judged else {}
    return StudentRow(
        name=report.name or report.student or PurePath(report.file).name,
        attempt=attempt_text(report, words) if not is_counting(report) else "",
        variant=report.variant or "—",
        score=points_text(report.earned, words) if report.judged else "—",
        before=points_text(report.score, words) if report.judged and report.is_cut else "",
        grades=tuple(grades or ["—"] * len(policy.scales)),
        sections=tuple(
            points_text(totals[section].points, words) if section in totals else "—"
            for section in sections
        ),
        open_points=points_text(report.open_points, words) if report.open_points else "",
        flags=str(len(report.flags)) if report.flags else "",
    )
