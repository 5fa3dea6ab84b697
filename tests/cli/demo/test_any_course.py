"""The demo runs on a course that knows nothing of the reference course's subject."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from gripcourse.cli.demo import classroom
from gripcourse.cli.demo.run import run_demo
from gripcourse.cli.demo.students import COPIED
from gripcourse.machine.resources import course_root, skeleton_root
from gripcourse.text.words import Words
from support.pages import no_pages

SMALL = Path(__file__).parents[2] / "variants" / "small_course"


def small_course(root: Path) -> Path:
    """The small test course with a policy: no errata, no manual items, no slips, no roster."""
    shutil.copytree(SMALL, root)
    (root / "grader").mkdir()
    policy = (skeleton_root() / "grader" / "policy.toml").read_text(encoding="utf-8")
    policy = policy.replace("loads = 40\nsizes = 60", "drive = 100").replace(
        ", gravity = [9.8, 10]", ""
    )
    (root / "grader" / "policy.toml").write_text(policy, encoding="utf-8")
    shutil.copyfile(course_root() / "grader" / "slips.toml", root / "grader" / "slips.toml")
    return root


@pytest.fixture(autouse=True)
def _no_pages() -> Iterator[None]:
    with no_pages():
        yield


def test_stories_without_an_occasion_are_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(classroom, "_STUDENTS", 12)
    source = small_course(tmp_path / "source")
    demo = run_demo(source, tmp_path / "out", Words("en"), 0, lambda _name, _total: lambda: None)
    assert list(demo.students.values()) == [
        *("correct", "three_figures", "early_slip", "blank", "text_and_units", "rounded_down"),
        COPIED,
    ]
    assert demo.marking is None
    scores = {demo.students[one.student]: one.score for one in demo.outcome.reports if one.student}
    assert (scores["correct"], scores["three_figures"]) == pytest.approx((100, 100))
    assert 0 == scores["blank"] < scores["early_slip"] < 100
    assert not (demo.graded / "incidents.log").exists()


def test_with_fewer_students_than_stories_nobody_copies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(classroom, "_STUDENTS", 1)
    source = small_course(tmp_path / "source")
    demo = run_demo(source, tmp_path / "out", Words("en"), 0, lambda _name, _total: lambda: None)
    assert list(demo.students.values()) == ["correct"]
