"""A course whose published cases and proofs a test writes itself."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course

Written = Callable[[str, str], Course]


@pytest.fixture
def with_file(course: Course, tmp_path: Path) -> Written:
    """Return the reference course with one file of `variants` beside nothing else."""

    def write(name: str, text: str) -> Course:
        (tmp_path / "variants").mkdir(exist_ok=True)
        (tmp_path / "variants" / name).write_text(text, encoding="utf-8")
        return replace(course, root=tmp_path)

    return write
