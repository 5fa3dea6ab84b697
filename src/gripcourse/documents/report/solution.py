"""One variant fully worked, for the instructor: every quantity as symbols = numbers = result."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.documents.assignment_sheet import (
    drawn_diagram,
    given_data,
    option_pairs,
    smaller,
)
from gripcourse.documents.pdf import Document, picture, render_pdf
from gripcourse.documents.report.worked import entering_units, notation_notes, worked_line
from gripcourse.drawing.paper.title_block import variant_block
from gripcourse.drawing.view.general_view import general_view, sheet_svg
from gripcourse.formula.boxes import Box
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Variant

TEMPLATE = "solution.html.j2"
STYLES = ("page.css", "formula.css", "solution.css")

_MANY = 36  # given numbers, from which on the diagram leaves them its page


@dataclass(frozen=True, slots=True)
class SolutionStep:
    """One worked quantity: its name, its line, the units of bare numbers, its source."""

    title: str
    line: Box
    units: tuple[tuple[str, str], ...]
    source: str


@dataclass(frozen=True, slots=True)
class SolutionChapter:
    """The steps of one section."""

    title: str
    steps: tuple[SolutionStep, ...]


def solution_pdf(
    plan: Plan, variant: Variant, values: Mapping[str, float], course: Course, words: Words
) -> bytes:
    """Make the worked solution of a variant as a PDF file.

    Args:
        plan: of the variant's scheme and options.
        variant: what is solved.
        values: value of every quantity by id, in declared units; NaN where there is none.
        course: titles, sections and cited works.
        words: the language of the solution.
    """
    content = solution_values(plan, variant, values, course, words)
    return render_pdf(Document(TEMPLATE, STYLES, content), course.root / "templates", words)


def solution_values(
    plan: Plan, variant: Variant, values: Mapping[str, float], course: Course, words: Words
) -> dict[str, object]:
    """Return what the template needs; see `solution_pdf` for the arguments."""
    known = {name: value for name, value in values.items() if not math.isnan(value)}
    diagram = drawn_diagram(plan, known, words)
    data = given_data(plan.givens, known, words)
    constants = given_data(plan.constants, known, words)
    return {
        "course": course.title.of(words.language),
        "variant": variant.id,
        "pairs": list(_pairs(plan, variant, words)),
        "diagram": smaller(diagram)
        if diagram is not None and len(data + constants) > _MANY
        else diagram,
        "data": data,
        "constants": constants,
        "chapters": list(_chapters(plan, known, course, words)),
        "notes": notation_notes(plan, words),
        "works": [course.works[one].title.of(words.language) for one in _cited(plan, course)],
        "view": _general_view(plan, variant, known, words),
    }


def _general_view(
    plan: Plan, variant: Variant, values: Mapping[str, float], words: Words
) -> tuple[str, str, bool] | None:
    """Return the general view: address, alternative text, whether its sheet stands upright."""
    if plan.scheme.view is None:
        return None
    block = variant_block(plan, variant.id, "", words)
    drawn = general_view(plan, plan.scheme.view, values, block, words)
    sheet = drawn.arranged.sheet
    svg, title = sheet_svg(drawn, block)
    return picture(svg), title, sheet.height > sheet.width


def _pairs(plan: Plan, variant: Variant, words: Words) -> Iterator[tuple[str, str]]:
    yield words.say(message("Variant")), variant.id
    yield words.say(message("Scheme")), plan.scheme.title.of(words.language)
    yield from option_pairs(plan, words)


def _chapters(
    plan: Plan, values: Mapping[str, float], course: Course, words: Words
) -> Iterator[SolutionChapter]:
    cited = _cited(plan, course)
    for section in course.sections:
        inside = (quantity for quantity in plan.answered if quantity.section == section.id)
        steps = tuple(step for one in inside for step in _steps(one, plan, values, cited, words))
        if steps:
            yield SolutionChapter(section.title.of(words.language), steps)


def _steps(
    quantity: Quantity,
    plan: Plan,
    values: Mapping[str, float],
    cited: Sequence[str],
    words: Words,
) -> Iterator[SolutionStep]:
    """Yield the step of a quantity; none where nothing is computed."""
    inputs = {name: values[name] for name in plan.inputs[quantity.id] if name in values}
    line = worked_line(quantity, inputs, values.get(quantity.id), plan, words)
    if line is not None:
        yield SolutionStep(
            title=quantity.title.of(words.language),
            line=line,
            units=entering_units(quantity, plan, words),
            source=_source(quantity, cited, words),
        )


def _source(quantity: Quantity, cited: Sequence[str], words: Words) -> str:
    """Cite briefly: the number of the work in the list below, and the equation."""
    equation = quantity.source.equation
    numbered = f"({equation})" if equation[:1].isdigit() else equation
    work = quantity.source.work
    brief = f"[{cited.index(work) + 1}] {numbered}".strip() if work in cited else numbered
    errata = ", ".join(printed.erratum for printed in quantity.as_printed)
    if errata:
        brief += words.say(message("; corrected: {errata}", errata=errata))
    return brief


def _cited(plan: Plan, course: Course) -> tuple[str, ...]:
    """Return the ids of the works that the steps cite, in the order of the course's list."""
    cited = {quantity.source.work for quantity in plan.answered}
    return tuple(id_ for id_ in course.works if id_ in cited)
