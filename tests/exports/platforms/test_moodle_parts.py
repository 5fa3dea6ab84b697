"""What counts in a part of a Moodle question, read as Moodle reads it, in a course of its own."""

import math
import re
from collections.abc import Callable
from html import unescape
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from gripcourse.course.load import load_course
from gripcourse.exports.platforms.moodle_xml import moodle_xml
from gripcourse.policy.load import load_policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import empty_course
from gripcourse.variants.model import Variant

# A part as Moodle's manual states it: a weight, a kind, then alternatives up to a brace.
PART = re.compile(r"\{(\d+):(NM|MC):(.*?)(?<!\\)\}", re.DOTALL)
ALTERNATIVE = re.compile(r"(?:(=)|%([\d.]+)%)?([^~#]+)(?:#([^~]*))?")
SIZES = (8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 32, 36, 40, 45, 50, 56, 63, 71, 80)
MASS, YIELD, SAFETY = 2000.0, 240.0, 1.5
LOAD = MASS * 9.81
REQUIRED = math.sqrt(4 * LOAD / (math.pi * YIELD / SAFETY))

ANOTHER = """
[[quantity.load.alternative]]
id = "half"
formula = "mass*gravity/2"
remark = { en = "half < all: {~#}", ru = "half", uk = "half" }
[[quantity.load.as_printed]]
erratum = "twice"
formula = "mass*gravity*2"
note = { en = "twice", ru = "twice", uk = "twice" }
"""
ERRATA = """
[erratum.twice]
work = "textbook"
equation = "1"
printed = { en = "twice", ru = "twice", uk = "twice" }
right = { en = "once", ru = "once", uk = "once" }
"""
OF_CHOICE = """
[[quantity.diameter.alternative]]
id = "with_reserve"
formula = "diameter_required*1.5"
remark = { en = "with a reserve", ru = "with a reserve", uk = "with a reserve" }
"""
Marked = Callable[[str, float], tuple[float, str]]


def changed(file: Path, old: str, new: str) -> None:
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new), encoding="utf-8")


@pytest.fixture
def root(tmp_path: Path) -> Path:
    root = tmp_path / "course"
    empty_course(root, bytes(32), Words("en"))
    with (root / "variants/schemes/rod/scheme.toml").open("a", encoding="utf-8") as scheme:
        scheme.write(ANOTHER)
    with (root / "variants/sections/tension.toml").open("a", encoding="utf-8") as part:
        part.write(OF_CHOICE)
    (root / "variants/errata.toml").write_text(ERRATA, encoding="utf-8")
    changed(root / "grader/policy.toml", "printed = 1.0", "printed = 0.5")
    return root


def question(root: Path) -> ET.Element:
    course = load_course(root)
    given = {"mass": MASS, "yield_strength": YIELD, "safety": SAFETY}
    variants = [Variant("001", "rod", {}, given)]
    written = moodle_xml(variants, course, load_policy(course), Words("en"))
    return ET.fromstring(written)  # noqa: S314 (ours)


def parts(root: Path) -> dict[str, str]:
    """Return what counts in each part, by the words before it."""
    text = question(root).findtext("question/questiontext/text", "")
    lines = [one for one in text.split("<p>") if PART.search(one)]
    assert all(len(PART.findall(one)) == 1 for one in lines)
    return {unescape(one.partition(":")[0]): PART.findall(one)[0][2] for one in lines}


@pytest.fixture
def marked(root: Path) -> Marked:
    """Mark an answer as Moodle does: the first alternative counts in whose reach it lies."""
    known = parts(root)

    def mark(part: str, answer: float) -> tuple[float, str]:
        for right, percent, number, comment in ALTERNATIVE.findall(known[part]):
            value, _, reach = number.partition(":")
            if abs(answer - float(value)) <= float(reach):
                share = 1.0 if right else float(percent or 0) / 100
                return share, unescape(unescape(comment))
        return 0.0, ""

    return mark


def test_a_number_counts_within_its_band(marked: Marked) -> None:
    assert marked("required diameter", REQUIRED * 1.009)[0] == 1
    assert marked("required diameter", REQUIRED * 1.011)[0] == 0
    assert marked("required diameter", REQUIRED / 2)[0] == 0


def test_another_honest_reading_counts_as_much_and_says_how_it_was_read(marked: Marked) -> None:
    share, comment = marked("load on the rod", LOAD / 2)
    assert share == 1
    assert "half < all: {~#}" in comment
    assert f"goes on with {LOAD:g} N" in comment


def test_what_a_source_prints_wrongly_counts_as_the_policy_says(marked: Marked) -> None:
    share, comment = marked("load on the rod", 2 * LOAD)
    assert share == pytest.approx(0.5)
    assert "erratum twice" in comment


def test_a_size_counts_by_the_rule_and_by_another_reading_of_it(marked: Marked) -> None:
    first = next(number for number, size in enumerate(SIZES) if size >= REQUIRED)
    other = next(number for number, size in enumerate(SIZES) if size >= 1.5 * REQUIRED)
    counted = {*SIZES[first : first + 3], *SIZES[other : other + 3]}
    assert {size for size in SIZES if marked("accepted diameter", size)[0] == 1} == counted


def test_braces_in_a_text_are_no_part(root: Path) -> None:
    scheme = root / "variants/schemes/rod/scheme.toml"
    changed(scheme, '"load on the rod"', '"load {1:NM:=5:0} on the rod"')
    assert [one for one in parts(root) if "load" in one] == ["load {1"]
    text = question(root).findtext("question/questiontext/text", "")
    assert "load {1:NM:=5:0} on the rod" in unescape(text)
    assert len(PART.findall(text)) == 6


def test_beside_an_answer_stands_what_decides_it(root: Path) -> None:
    decides = 'decides = { en = "at rest", ru = "at rest", uk = "at rest" }'
    scheme = root / "variants/schemes/rod/scheme.toml"
    changed(scheme, 'kind = "formula"', f'kind = "formula"\n{decides}')
    text = question(root).findtext("question/questiontext/text", "")
    assert "at rest" in next(one for one in text.split("<p>") if one.startswith("load on the rod"))


def test_a_stroke_in_a_title_divides_no_category(root: Path) -> None:
    changed(root / "variants/course.toml", 'en = "Design of a rod"', 'en = "Rods / bars/"')
    path = question(root).findtext("question/category/text", "")
    assert [one.replace("//", "/").strip() for one in re.split("(?<!/)/(?!/)", path)] == [
        "$course$", "top", "Rods / bars/", "Variant 001",
    ]  # fmt: skip


def test_the_weights_are_shares_of_all_points(root: Path) -> None:
    def weights() -> list[str]:
        text = question(root).findtext("question/questiontext/text", "")
        return [weight for weight, *_ in PART.findall(text)]

    hundred = weights()
    policy = root / "grader/policy.toml"
    changed(policy, "total = 100", "total = 1")
    changed(policy, "loads = 40\nsizes = 60", "loads = 0.4\nsizes = 0.6")
    assert weights() == hundred
