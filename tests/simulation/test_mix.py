"""The mix: every fault of its file is named with its key."""

import math
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.simulation.mix import load_mix, mix_path, read_mix
from gripcourse.simulation.model import Conduct, Mix


@pytest.fixture
def changed(course: Course, tmp_path: Path) -> Callable[..., Course]:
    """Copy the reference course's mix with some text replaced."""

    def make(*edits: tuple[str, str]) -> Course:
        target = mix_path(tmp_path)
        target.parent.mkdir(exist_ok=True)
        shutil.copyfile(mix_path(course.root), target)
        text = target.read_text(encoding="utf-8")
        for old, new in edits:
            assert old in text
            text = text.replace(old, new, 1)
        target.write_text(text, encoding="utf-8")
        return replace(course, root=tmp_path)

    return make


def test_the_reference_mix_knows_every_conduct(mix: Mix) -> None:
    assert set(mix.conduct) == set(Conduct)
    assert mix.required.slip_named == 0.95


def test_a_course_need_not_say_how_constants_are_shortened(
    course: Course, changed: Callable[..., Course]
) -> None:
    text = mix_path(course.root).read_text(encoding="utf-8")
    pi = text[text.index("[pi]") : text.index("[constant.gravity]")]
    gravity = text[text.index("[constant.gravity]") : text.index("[language]")]
    found, problems = read_mix(changed((pi, ""), (gravity, "")))
    assert problems == []
    assert found is not None
    assert found.pi == {math.pi: 1.0}
    assert found.constants == {}


def test_a_course_that_declares_nobody_has_the_usual_students_in_its_own_languages(
    course: Course, tmp_path: Path
) -> None:
    usual = load_mix(replace(course, root=tmp_path, languages=("ru", "uk")))
    assert set(usual.conduct) == set(Conduct)
    assert usual.language == {"ru": 1.0, "uk": 1.0}
    assert usual.constants == {}, "they take its constants as they are declared"


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ("two_slips =", "three_slips =", "conduct.three_slips"),
        ("honest = 45.0", "honest = -1.0", "conduct.honest"),
        ('"3.14" =', '"three" =', "pi.three"),
        ("[constant.gravity]", "[constant.gravitation]", "constant.gravitation"),
        ("tries = 60", "tries = 0.5", "slip.tries"),
        ("5 = 2.0", "50 = 2.0", "figures"),
        ("bands = [0.001, 0.002", "bands = [0.002, 0.001", "tolerance.bands"),
        ("copied = 0.9", "copied = 1.9", "share.copied"),
        ("copying = [", "copies = [", "flags.copies"),
    ],
)
def test_a_fault_is_named_with_its_key(
    changed: Callable[..., Course], old: str, new: str, key: str
) -> None:
    _, problems = read_mix(changed((old, new)))
    assert key in {one.key for one in problems}
    assert {one.file for one in problems} == {"grader/virtual.toml"}
