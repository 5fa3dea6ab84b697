"""Variants as questions that Moodle imports: one of many parts for each, for a self-test.

The answers are in the file: it is for the instructor. Moodle reads only a decimal point and only an
absolute tolerance.
"""

import re
from base64 import b64encode
from collections.abc import Iterable, Iterator
from typing import Final
from xml.etree import ElementTree as ET

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.documents.assignment_sheet import given_data, option_pairs
from gripcourse.drawing.diagram.kinematic_diagram import KinematicDiagram, kinematic_diagram
from gripcourse.drawing.diagram.nominal import nominal_values
from gripcourse.exports.platforms.moodle_parts import answer_part, as_text
from gripcourse.policy.model import Policy
from gripcourse.policy.points import points_of
from gripcourse.solver.asked import deciding
from gripcourse.solver.numbers import evaluate_numbers
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.solver.solve import to_si
from gripcourse.text.shown import shown
from gripcourse.text.units import unit_text
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Variant

_LOWERED: Final = re.compile(r"_([^\W_]+)")
_WEIGHT: Final = 1000  # weights are whole numbers: thousandths of all points
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
    parts = (course.title.of(words.language), _title(variant, words))
    path = "/".join(("$course$", "top", *map(_category, parts)))
    ET.SubElement(ET.SubElement(question, "category"), "text").text = path
    ET.SubElement(question, "idnumber").text = shown(f"{course.id}-{variant.id}")


def _category(title: str) -> str:
    """Return the name of a category as a path holds it: a stroke divides, a doubled one is one.

    Three would be read as one, so that none may stand at an end; Moodle drops the blank.
    """
    name = shown(title).replace("/", "//")
    return f"{' ' * name.startswith('/')}{name}{' ' * name.endswith('/')}"


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
    yield f"<p>{as_text(plan.scheme.task.of(language))}</p>"
    if diagram is not None:
        address, alt = f"@@PLUGINFILE@@/{_DIAGRAM}", as_text(diagram.title)
        yield f'<p><img src="{address}" alt="{alt}" style="max-width:100%"></p>'
    yield "<ul>"
    for title, choice in option_pairs(plan, words):
        yield f"<li>{as_text(title)}: {as_text(choice)}</li>"
    for datum in given_data(plan.givens, variant.given, words):
        value = f"{datum.value} {datum.unit}".strip()
        yield f"<li>{as_text(datum.title)}: {_symbol(datum.symbol)} = {as_text(value)}</li>"
    yield "</ul>"
    points = points_of(plan, policy)
    numbers = evaluate_numbers(plan, to_si(plan, variant.given))
    for section in course.sections:
        asked = [one for one in plan.answered if one.section == section.id]
        if asked:
            yield f"<h4>{as_text(section.title.of(language))}</h4>"
        for quantity in asked:
            weight = max(1, round(_WEIGHT * points[quantity.id] / policy.total))
            part = answer_part(quantity, plan, numbers, policy, words)
            yield _line(quantity, plan, f"{{{weight}:{part}}}", words)


def _line(quantity: Quantity, plan: Plan, answer: str, words: Words) -> str:
    """Return the line of an answer, and below it what decides it, as the sheet says."""
    unit = as_text(unit_text(quantity.unit, words.language))
    symbol = _symbol(quantity.symbol.of(words.language))
    named = quantity.kind is not Kind.VERDICT and symbol
    said = deciding(quantity, plan, words)
    return (
        f"<p>{as_text(quantity.title.of(words.language))}: "
        f"{f'{symbol} = ' if named else ''}{answer} {unit}"
        f"{f'<br><small>{as_text(said)}</small>' if said else ''}</p>"
    )


def _symbol(symbol: str) -> str:
    return _LOWERED.sub(r"<sub>\1</sub>", as_text(symbol))
