"""A copy of the reference course that a test may break."""

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.policy_load import load_policy
from gripcourse.errors import CourseError, Problem

REPOSITORY = Path(__file__).parents[2]


@dataclass(frozen=True, slots=True)
class Draft:
    """A course under change."""

    root: Path

    def edit(self, file: str, old: str, new: str) -> "Draft":
        """Replace the first occurrence of `old` in a file."""
        path = self.root / file
        text = path.read_text(encoding="utf-8")
        assert old in text, f"{file} does not hold {old!r}"
        path.write_text(text.replace(old, new, 1), encoding="utf-8")
        return self

    def append(self, file: str, text: str) -> "Draft":
        """Write text at the end of a file."""
        path = self.root / file
        path.write_text(f"{path.read_text(encoding='utf-8')}\n{text}\n", encoding="utf-8")
        return self

    def put(self, file: str, content: bytes) -> "Draft":
        """Write a whole file."""
        (self.root / file).write_bytes(content)
        return self

    def remove(self, file: str) -> "Draft":
        """Take a file away."""
        (self.root / file).unlink()
        return self

    def problems(self) -> tuple[Problem, ...]:
        """Load course and policy; every problem of both."""
        try:
            load_policy(load_course(self.root))
        except CourseError as error:
            return error.problems
        return ()

    def problem(self) -> Problem:
        """The only problem of the course."""
        problems = self.problems()
        assert len(problems) == 1, [str(one.what) for one in problems]
        return problems[0]

    def load(self) -> Course:
        return load_course(self.root)


@pytest.fixture
def draft(tmp_path: Path) -> Draft:
    """The reference course, copied: what an instructor starts from."""
    root = tmp_path / "course"
    for folder in ("variants", "grader"):
        shutil.copytree(REPOSITORY / folder, root / folder)
    return Draft(root)


@pytest.fixture
def said() -> Callable[[Problem], str]:
    """Put a problem into English as a person reads it, without the place."""

    def say(problem: Problem) -> str:
        return f"{problem.what} {problem.remedy}"

    return say
