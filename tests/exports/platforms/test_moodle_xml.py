"""A variant as a question of many parts: Moodle takes points only, and absolute tolerances."""

import re
from base64 import b64decode
from xml.etree import ElementTree as ET

import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.documents.assignment_sheet import option_pairs
from gripcourse.exports.platforms.moodle_xml import moodle_xml
from gripcourse.grading.choices import sizes_at
from gripcourse.policy.model import Policy
from gripcourse.solver.numbers import evaluate_numbers
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import to_si
from gripcourse.text.units import factor
from gripcourse.text.words import Words
from gripcourse.variants.model import Variant
from support.reports import values, variant

__all__ = ["values", "variant"]
PART = re.compile(r"\{(\d+):(NM|MC):=([^~{}]*)(?:~([^{}]*))?\}")
OTHER = re.compile(r"%100%([^#~]*)(?:#([^~]*))?")
NUMBER = re.compile(r"(-?\d+(?:\.\d+)?):(\d+(?:\.\d+)?)")


@pytest.mark.parametrize("language", ["en", "ru", "uk"])
def test_every_answer_is_a_part_with_its_value_and_band(
    variant: Variant, plan: Plan, course: Course, policy: Policy, values: dict[str, float],
    language: str,
) -> None:  # fmt: skip
    root = ET.fromstring(moodle_xml([variant], course, policy, Words(language)))  # noqa: S314 (ours)
    category, question = root
    assert category.findtext("category/text", "").startswith("$course$/top/")
    parts = PART.findall(question.findtext("questiontext/text", ""))
    assert len(parts) == len(plan.answered)
    numbers = [NUMBER.fullmatch(right) for _, kind, right, _ in parts if kind == "NM"]
    assert all(numbers)
    found = [float(one[1]) for one in numbers if one]
    asked = [one for section in course.sections for one in plan.answered
             if one.section == section.id and one.kind != "verdict"]  # fmt: skip
    assert found == pytest.approx([values[one.id] for one in asked], rel=1e-8)
    assert all(float(one[2]) > 0 for one in numbers if one and float(one[1]))


def test_a_question_says_what_was_chosen_and_shows_the_diagram(
    variant: Variant, plan: Plan, course: Course, policy: Policy
) -> None:
    words = Words("ru")
    root = ET.fromstring(moodle_xml([variant], course, policy, words))  # noqa: S314 (ours)
    text = root.findtext("question/questiontext/text", "")
    assert all(f"<li>{title}: {choice}</li>" in text for title, choice in option_pairs(plan, words))
    file = root.find("question/questiontext/file")
    assert file is not None
    assert f"@@PLUGINFILE@@/{file.get('name')}" in text
    assert b64decode(file.text or "").startswith(b"<svg")


def test_every_size_that_the_rule_of_a_decision_admits_counts(
    variant: Variant, plan: Plan, course: Course, policy: Policy, values: dict[str, float]
) -> None:
    root = ET.fromstring(moodle_xml([variant], course, policy, Words("en")))  # noqa: S314 (ours)
    numbers = evaluate_numbers(plan, to_si(plan, variant.given))
    asked = [one for section in course.sections for one in plan.answered
             if one.section == section.id]  # fmt: skip
    parts = PART.findall(root.findtext("question/questiontext/text", ""))
    counted = {
        one.id: [right, *(number for number, _ in OTHER.findall(more))]
        for one, (_, kind, right, more) in zip(asked, parts, strict=True)
        if kind == "NM"
    }
    told = [said for *_, more in parts for _, said in OTHER.findall(more)]
    for one in asked:
        if one.kind is Kind.CHOICE and not (one.alternatives or one.as_printed):
            sizes = [size / factor(one.unit) for size in sizes_at(plan, one.id, numbers)]
            found = sorted(float(number.partition(":")[0]) for number in counted[one.id])
            assert found == pytest.approx(sorted({*sizes, values[one.id]}), rel=1e-8)
    assert any(len(one) > 1 for one in counted.values())
    assert any("what follows goes on with" in said for said in told)
