"""A general view that draws nothing is a fault of the course."""

import shutil
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.errors import CourseError
from gripcourse.machine.resources import skeleton_root


def test_a_view_without_parts_is_named(tmp_path: Path) -> None:
    root = Path(shutil.copytree(skeleton_root(), tmp_path / "course"))
    drawing = root / "variants" / "schemes" / "rod" / "drawing.toml"
    drawing.write_text('characteristics = ["load"]', encoding="utf-8")
    with pytest.raises(CourseError) as caught:
        load_course(root)
    (problem,) = caught.value.problems
    assert (problem.file, problem.key) == ("variants/schemes/rod/drawing.toml", "part")
