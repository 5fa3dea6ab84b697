"""Variants as questions that Moodle imports: one of many parts for each, for a self-test.

The answers are in the file: it is for the instructor. Moodle reads only a decimal point and only an
absolute tolerance, and it knows nothing of consequences: a part counts by its own number alone. Of
a decision all sizes count that are sound; what follows goes on with the reference.
"""

import re
from base64 import b64encode
from collections.abc import Iterable, Iterator
from decimal import Decimal
from html import escape
from typing import Final
from xml.etree import ElementTree as ET

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.documents.assignment_sheet import given_data, option_pairs
from gripcourse.drawing.diagram.kinematic_diagram import KinematicDiagram, kinematic_diagram
from gripcourse.drawing.diagram.nominal import nominal_values
from gripcourse.grading.choices import same_size, sizes_at
from gripcourse.policy.bands import band
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of
from gripcourse.solver.numbers import PlainNumbers, evaluate_numbers
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import from_si, to_si
from gripcourse.text.shown import shown
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Variant

_LOWERED: Final = re.compile(r"_([^\W_]+)")
_DIGITS: Final = 10  # significant
_LEAST: Final = 1e-9  # a tolerance of zero would refuse what floating point rounds
_WEIGHT: Final = 10  # weights are whole numbers: tenths of points
_DIAGRAM: Final = "diagram.svg"
_PENALTY: Final = "0.3333333"


def moodle_xml(variants: Iterable[Variant], course: Course, policy: Policy, words: Words) -> bytes:
    """Return the questions as Moodle XML.

    Args:
        variants: each becomes a question in a category of its own.
        course: whose variants they are.
        policy: points and tolerances.
        words: the language of the questions.
    """
    quiz = ET.Element("quiz")
    for variant in variants:
        _add_category(quiz, variant, course, words)
        _add_question(quiz, variant, course, policy, words)
    ET.indent(quiz)
    return bytes(ET.tostring(quiz, encoding="utf-8", xml_declaration=True))


def _add_category(quiz: ET.Element, variant: Variant, course: Course, words: Words) -> None:
    question = ET.SubElement(quiz, "question", type="category")
    # A stroke divides categories; a doubled one is a stroke.
    parts = (course.title.of(words.language), _title(variant, words))
    path = "/".join(("$course$", "top", *(shown(one).replace("/", "//") for one in parts)))
    ET.SubElement(ET.SubElement(question, "category"), "text").text = path
    ET.SubElement(question, "idnumber").text = shown(f"{course.id}-{variant.id}")


def _add_question(
    quiz: ET.Element, variant: Variant, course: Course, policy: Policy, words: Words
) -> None:
    question = ET.SubElement(quiz, "question", type="cloze")
    ET.SubElement(ET.SubElement(question, "name"), "text").text = shown(_title(variant, words))
    text = ET.SubElement(question, "questiontext", format="html")
    plan = plan_of(course, variant.composition)
    diagram = kinematic_diagram(plan, nominal_values(plan), words.language)
    html = _html(variant, plan, diagram, policy, words)
    ET.SubElement(text, "text").text = shown("".join(html))
    if diagram is not None:
        file = ET.SubElement(text, "file", name=_DIAGRAM, path="/", encoding="base64")
        file.text = b64encode(diagram.svg().encode()).decode()
    ET.SubElement(ET.SubElement(question, "generalfeedback", format="html"), "text").text = ""
    ET.SubElement(question, "penalty").text = _PENALTY
    ET.SubElement(question, "hidden").text = "0"
    ET.SubElement(question, "idnumber").text = shown(f"{course.id}-{variant.id}")


def _title(variant: Variant, words: Words) -> str:
    return words.say(message("Variant {id}", id=variant.id))


def _html(
    variant: Variant, plan: Plan, diagram: KinematicDiagram | None, policy: Policy, words: Words
) -> Iterator[str]:
    """Yield the text of a question: the diagram, what is given, then a line for each answer."""
    course, language = plan.course, words.language
    yield f"<p>{escape(plan.scheme.task.of(language))}</p>"
    if diagram is not None:
        address, alt = f"@@PLUGINFILE@@/{_DIAGRAM}", escape(diagram.title)
        yield f'<p><img src="{address}" alt="{alt}" style="max-width:100%"></p>'
    yield "<ul>"
    for title, choice in option_pairs(plan, words):
        yield f"<li>{escape(title)}: {escape(choice)}</li>"
    for datum in given_data(plan.givens, variant.given, words):
        value = f"{datum.value} {datum.unit}".strip()
        yield f"<li>{escape(datum.title)}: {_symbol(datum.symbol)} = {escape(value)}</li>"
    yield "</ul>"
    points = points_of(plan, policy)
    numbers = evaluate_numbers(plan, to_si(plan, variant.given))
    values = from_si(plan, numbers.values)
    for section in course.sections:
        asked = [one for one in plan.answered if one.section == section.id]
        if asked:
            yield f"<h4>{escape(section.title.of(language))}</h4>"
        for quantity in asked:
            right = _right(quantity, values[quantity.id], policy, words)
            right += "".join(_other_sizes(quantity, plan, numbers, policy, words))
            weight = max(1, round(_WEIGHT * points[quantity.id]))
            yield _line(quantity, f"{{{weight}:{right}}}", language)


def _line(quantity: Quantity, answer: str, language: str) -> str:
    unit = escape(unit_text(quantity.unit, language))
    symbol = _symbol(quantity.symbol.of(language))
    named = quantity.kind is not Kind.VERDICT and symbol
    return (
        f"<p>{escape(quantity.title.of(language))}: "
        f"{f'{symbol} = ' if named else ''}{answer} {unit}</p>"
    )


def _right(quantity: Quantity, value: float, policy: Policy, words: Words) -> str:
    """Return an answer as Moodle's text holds it: kind, what is right and how nearly."""
    if quantity.kind is Kind.VERDICT:
        yes, no = words.say(message("yes")), words.say(message("no"))
        right, wrong = (yes, no) if value else (no, yes)
        return f"MC:={right}~{wrong}"
    return f"NM:={_number(quantity, value, policy)}"


def _other_sizes(
    quantity: Quantity, plan: Plan, numbers: PlainNumbers, policy: Policy, words: Words
) -> Iterator[str]:
    """Yield the other sizes that a decision may take, as alternatives of full worth."""
    unit = factor(quantity.unit)
    reference = numbers.values[quantity.id]
    goes_on = any(quantity.id in plan.inputs[one.id] for one in plan.answered)
    told = message(
        "Sound as well; what follows goes on with {value}.",
        value=f"{_plain(reference / unit)} {unit_text(quantity.unit, words.language)}".strip(),
    )
    comment = f"#{words.say(told)}" if goes_on else ""
    for size in sizes_at(plan, quantity.id, numbers):
        if not same_size(size, reference):
            yield f"~%100%{_number(quantity, size / unit, policy)}{comment}"


def _number(quantity: Quantity, value: float, policy: Policy) -> str:
    """Return a number and how far from it an answer may be."""
    tolerance = max(band(quantity, value, policy), _LEAST * abs(value))
    return f"{_plain(value)}:{_plain(tolerance)}"


def _plain(value: float) -> str:
    """Write a number with a point and without an exponent."""
    return f"{Decimal(f'{value:.{_DIGITS}g}'):f}"


def _symbol(symbol: str) -> str:
    return _LOWERED.sub(r"<sub>\1</sub>", escape(symbol))
