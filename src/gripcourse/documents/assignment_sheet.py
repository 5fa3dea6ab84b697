"""The assignment sheet of one student: who, what is given, what is asked, how it is judged."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from gripcourse.course.model import Course, Section
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.documents.appendix import appendix_of, cited_tables
from gripcourse.documents.assignment_rules import course_notes, hand_in, judging_rules
from gripcourse.documents.pdf import Chart, Document, picture, render_pdf
from gripcourse.drawing.diagram.kinematic_diagram import kinematic_diagram, line_titles
from gripcourse.drawing.diagram.layout import WIDEST
from gripcourse.drawing.diagram.nominal import nominal_values
from gripcourse.issuing.seal import seal_modules, seal_of, seal_svg
from gripcourse.policy.model import Policy
from gripcourse.solver.asked import deciding
from gripcourse.solver.band_text import band_text
from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import NO_BREAK_SPACE, counted_points, day_text
from gripcourse.text.units import stands_close, unit_text
from gripcourse.text.words import Message, Words, message
from gripcourse.variants.model import Issued
from gripcourse.workbook.cover import variant_text

TEMPLATE = "assignment.html.j2"
STYLES = ("page.css", "formula.css", "assignment.css")

# So many letters of a signature tell two sheets apart at a glance.
_CONTROL_LETTERS = 12
# Millimetres of a module of the square code: three dots of a scan at 150 an inch, and
# what the sheets with most to read have room for.
_MODULE, _SMALL_MODULE = 0.5, 0.38
_NARROW = 112.0  # mm of a diagram that leaves room for text beside it
_MANY = 85  # quantities, from which on a diagram has to leave room beside it
# Prints by how much there is to read, in letters. The appendix follows at once in all of them: no
# page stays half empty, and the shortest sheets are one leaf.
_SOME, _MUCH = 6_000, 10_000
_PRINTS = ("", "dense running", "dense long running")
# A diagram with text beside it is printed smaller where there is much to read, letters and all.
_MUCH_SCALE = 0.84
_LETTERS_OF_ROW = 8  # that a symbol and the gap beside it take
_GIVEN_FIGURES = 7  # given values are printed as the table has them, never rounded


@dataclass(frozen=True, slots=True)
class SheetDatum:
    """A row of the given data: texts in the reader's language, `symbol` as declared.

    Degrees belong to the number and stand in `value`; any other unit has a column of its own.
    """

    symbol: str
    title: str
    value: str
    unit: str


@dataclass(frozen=True, slots=True)
class SheetDiagram:
    """A diagram for a page.

    Attributes:
        address: of the picture, which is drawn when a page shows it.
        text: what it shows, for a reader who does not see it.
        width, height: mm.
        beside: whether it is narrow enough for text beside it.
        lines: what thick lines show and what thin ones do; None where one position is shown.
    """

    address: Chart
    text: str
    width: float
    height: float
    beside: bool
    lines: tuple[str, str] | None


@dataclass(frozen=True, slots=True)
class SheetItem:
    """A quantity that the student is asked for.

    Attributes:
        symbol: as declared.
        text: name, unit, and the band where it is not the usual one.
        wide: whether the symbol is a whole condition, or there is none.
    """

    symbol: str
    text: str
    wide: bool

    @property
    def line(self) -> str:
        """What takes the width of a column: a symbol that is no condition stands in its margin."""
        return f"{self.symbol}: {self.text}" if self.wide and self.symbol else self.text


@dataclass(frozen=True, slots=True)
class SheetTask:
    """A section of the assignment with its points and the quantities asked."""

    title: str
    task: str
    points: str
    items: tuple[SheetItem, ...]


def assignment_sheet(
    issued: Issued, plan: Plan, policy: Policy, course: Course, words: Words, link: str = ""
) -> bytes:
    """Make the assignment sheet of a student as a PDF file.

    The shortest assignments take two or three pages with the series and tables behind them, the
    others three, those of more than 150 quantities a part of a fourth.

    Args:
        issued: the student, the frozen values and the dates.
        plan: of the variant's scheme and options.
        policy: points, bands and credits that the sheet announces.
        course: titles, tasks and constants.
        words: the language of the sheet.
        link: the student's own page; empty for none on the sheet.
    """
    values = sheet_values(issued, plan, policy, course, words, link)
    return render_pdf(Document(TEMPLATE, STYLES, values), course.root / "templates", words)


def sheet_values(
    issued: Issued, plan: Plan, policy: Policy, course: Course, words: Words, link: str = ""
) -> dict[str, object]:
    """Return what the template of the sheet needs; see `assignment_sheet` for the arguments."""
    listed = sum(map(len, (plan.givens, plan.constants, plan.answered, plan.manual)))
    widest = _NARROW if listed > _MANY else WIDEST
    diagram = drawn_diagram(plan, nominal_values(plan), words, widest)
    data = given_data(plan.givens, issued.variant.given, words)
    constants = given_data(plan.constants, issued.variant.given, words)
    sections = list(_tasks(plan, policy, course, words))
    rules = [*course_notes(plan, words), *map(words.say, judging_rules(plan, policy, words))]
    density = _density(_letters((*data, *constants), sections, rules))
    seal, address = seal_of(issued, course.id), link or course.address
    module = _SMALL_MODULE if density == _PRINTS[-1] and not link else _MODULE
    return {
        "course": course.title.of(words.language),
        "student": issued.student.name,
        "variant": variant_text(issued, words),
        "control": issued.signature[:_CONTROL_LETTERS],
        "seal": picture(seal_svg(seal, address)),
        "seal_width": round(seal_modules(seal, address) * module, 1),
        "address": address,
        "link": link,
        "diagram": _fitted(diagram, density),
        "pairs": _pairs(issued, plan, words),
        "task": plan.scheme.task.of(words.language),
        "data": data,
        "constants": constants,
        "density": density,
        "sections": sections,
        "hand_in": [words.say(sentence) for sentence in hand_in(plan, words)],
        "appendix": appendix_of(plan, words),
        "rules": rules,
    }


def _letters(
    data: Iterable[SheetDatum], sections: Iterable[SheetTask], rules: Iterable[str]
) -> int:
    """Count what a sheet gives to read."""
    rows = [*(datum.title for datum in data)]
    rows += (item.text for section in sections for item in section.items)
    texts = [*rows, *rules, *(section.task for section in sections)]
    return sum(map(len, texts)) + _LETTERS_OF_ROW * len(rows)


def _density(letters: int) -> str:
    """Name the print for so much to read; laying out a sheet to find out takes as long again."""
    return _PRINTS[(letters > _SOME) + (letters > _MUCH)]


def _fitted(diagram: SheetDiagram | None, density: str) -> SheetDiagram | None:
    if diagram is None or not diagram.beside or density != _PRINTS[-1]:
        return diagram
    return smaller(diagram)


def smaller(diagram: SheetDiagram) -> SheetDiagram:
    """Return a diagram in the size that leaves room for much text on its page."""
    width, height = (round(_MUCH_SCALE * size, 2) for size in (diagram.width, diagram.height))
    return replace(diagram, width=width, height=height)


def _pairs(issued: Issued, plan: Plan, words: Words) -> list[tuple[str, str]]:
    """Return labels and values of the head of the sheet; what is unknown is left out."""
    language, deadline = words.language, issued.deadline
    pairs = [
        (words.say(message("Student")), issued.student.name),
        (words.say(message("Group")), issued.student.group),
        (words.say(message("Variant")), variant_text(issued, words)),
        (words.say(message("Scheme")), plan.scheme.title.of(language)),
        (words.say(message("Issued on")), day_text(issued.issued_on, words)),
        (words.say(message("Deadline")), day_text(deadline, words) if deadline else ""),
        *option_pairs(plan, words),
    ]
    return [(label, value) for label, value in pairs if value]


def option_pairs(plan: Plan, words: Words) -> Iterator[tuple[str, str]]:
    """Yield the titles of a plan's options, as labels, and of what was chosen."""
    for option in plan.scheme.options:
        label = option.title.of(words.language)
        for choice in option.choices:
            if choice.id == plan.options.get(option.id):
                yield label[:1].upper() + label[1:], choice.title.of(words.language)


def drawn_diagram(
    plan: Plan, values: Mapping[str, float], words: Words, widest: float = WIDEST
) -> SheetDiagram | None:
    """Return the diagram of a scheme for a page; None where there is none.

    Args:
        plan: of the variant's scheme and options.
        values: in declared units; the givens at least.
        words: the language of the symbols.
        widest: mm that it may take of the page's width.
    """
    diagram = kinematic_diagram(plan, values, words.language, widest)
    if diagram is None:
        return None
    return SheetDiagram(
        address=Chart(diagram.svg),
        text=diagram.title,
        width=round(diagram.width, 2),
        height=round(diagram.height, 2),
        beside=diagram.width <= _NARROW,
        lines=line_titles(plan, words),
    )


def given_data(
    quantities: Iterable[Quantity], values: Mapping[str, float], words: Words
) -> list[SheetDatum]:
    """Return rows of given data; a constant that `values` does not have counts as declared."""
    return [
        _datum(quantity, values.get(quantity.id, quantity.value), words) for quantity in quantities
    ]


def _datum(quantity: Quantity, value: float | None, words: Words) -> SheetDatum:
    language = words.language
    unit = unit_text(quantity.unit, language)
    written = "—" if value is None else words.number(value, _GIVEN_FIGURES)
    degrees = bool(unit) and stands_close(unit)
    return SheetDatum(
        symbol=quantity.symbol.of(language),
        title=quantity.title.of(language),
        value=f"{written}{unit}" if degrees else written,
        unit="" if degrees else unit,
    )


def _tasks(plan: Plan, policy: Policy, course: Course, words: Words) -> Iterator[SheetTask]:
    for section in course.sections:
        asked = [q for q in plan.asked if q.section == section.id]
        if asked:
            yield _task(section, asked, plan, policy, words)


def _task(
    section: Section, asked: list[Quantity], plan: Plan, policy: Policy, words: Words
) -> SheetTask:
    points = policy.section_points.get(section.id)
    return SheetTask(
        title=section.title.of(words.language),
        task=section.task_of(plan.quantities, words.language),
        points="" if points is None else counted_points(points, words),
        items=asked_items(asked, plan, policy, words),
    )


def asked_items(
    quantities: Iterable[Quantity], plan: Plan, policy: Policy, words: Words
) -> tuple[SheetItem, ...]:
    """Return what is asked, as the sheet prints it: name, unit, and what decides the answer."""
    cited = cited_tables(plan)
    return tuple(_asked(one, cited.get(one.id), plan, policy, words) for one in quantities)


def _asked(
    quantity: Quantity, cited: Message | None, plan: Plan, policy: Policy, words: Words
) -> SheetItem:
    text = quantity.title.of(words.language)
    if quantity.kind is Kind.VERDICT:
        text += f" ({words.say(message('yes or no'))})"
    elif quantity.kind is Kind.MANUAL:
        text += f" ({words.say(message('marked by the instructor'))})"
    elif quantity.unit:
        text += f",{NO_BREAK_SPACE}{unit_text(quantity.unit, words.language)}"
    band = policy.tolerances.get(quantity.id) or quantity.tolerance
    unusual = band is not None and band.relative != policy.tolerance.relative
    if band is not None and unusual and not quantity.exact:
        text += f", {band_text(band, quantity.unit, words)}"
    said = deciding(quantity, plan, words)
    text += f"; {said}" if said else ""
    if cited is not None:
        text += f" [{words.say(cited)}]".replace(", ", f",{NO_BREAK_SPACE}")
    symbol = quantity.symbol.of(words.language)
    wide = quantity.kind is Kind.VERDICT or not symbol
    return SheetItem(symbol, text, wide)
