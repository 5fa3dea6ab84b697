"""The small course, and the reference course where it matters that it is real."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course

SMALL = Path(__file__).parent / "small_course"
REFERENCE = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def small_course() -> Course:
    return load_course(SMALL)


@pytest.fixture(scope="session")
def reference_course() -> Course:
    return load_course(REFERENCE)


@pytest.fixture
def small_with(tmp_path: Path) -> Callable[[str, str], Course]:
    """Load the small course with its space changed: `old` replaced by `new`."""

    def change(old: str, new: str) -> Course:
        root = tmp_path / "course"
        shutil.copytree(SMALL, root, dirs_exist_ok=True)
        space = root / "variants" / "spaces" / "press.toml"
        text = space.read_text(encoding="utf-8")
        assert old in text
        space.write_text(text.replace(old, new), encoding="utf-8")
        return load_course(root)

    return change
