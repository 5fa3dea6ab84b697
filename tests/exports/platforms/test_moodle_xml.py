"""A variant as a question of many parts: Moodle takes points only, and absolute tolerances."""

import re
from base64 import b64decode
from xml.etree import ElementTree as ET

import pytest

from gripcourse.course.model import Course
from gripcourse.documents.assignment_sheet import option_pairs
from gripcourse.exports.platforms.moodle_xml import moodle_xml
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words
from gripcourse.variants.model import Variant
from support.reports import values, variant

__all__ = ["values", "variant"]
PART = re.compile(r"\{(\d+):(NM|MC):=([^~{}]*)(?:~([^{}]*))?\}")
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
