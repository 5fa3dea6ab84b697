"""A copy of the reference course, with one scheme, that a test may break."""

import pickle
import re
import shutil
import tomllib
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.errors import CourseError, Problem
from gripcourse.policy.load import load_policy

REPOSITORY = Path(__file__).parents[2]
SCHEME = "rack_parallelogram"
# Choices of options that have many.
CHOICES = {
    "object_position": {"one_element", "friction_pair", "wide_pair"},
    "jaw_shape": {"flat", "prism", "crossed", "concave"},
}


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

    def problems_of_policy(self, sound: Course) -> tuple[Problem, ...]:
        """Load the policy of a course whose own files are as they were: every problem of it."""
        try:
            load_policy(replace(sound, root=self.root))
        except CourseError as error:
            return error.problems
        return ()

    def problem_of_policy(self, sound: Course) -> Problem:
        """The only problem of the policy."""
        problems = self.problems_of_policy(sound)
        assert len(problems) == 1, [str(one.what) for one in problems]
        return problems[0]

    def load(self) -> Course:
        return load_course(self.root)


@pytest.fixture(scope="session")
def sound(one_scheme: Path) -> Course:
    """The course that drafts are made from."""
    return load_course(one_scheme)


@pytest.fixture(scope="session")
def one_scheme(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The reference course cut down to one scheme, so that each fault shows once.

    Of its options a few choices are left: a draft is checked with every two of them.
    """
    root = tmp_path_factory.mktemp("one_scheme") / "course"
    for folder in ("variants", "grader"):
        shutil.copytree(REPOSITORY / folder, root / folder)
    content = root / "variants"
    # Neither is read with a course; every draft would copy them.
    for folder in ("tables", "equilibrium"):
        shutil.rmtree(content / folder)
    for path in (*(content / "schemes").iterdir(), *(content / "spaces").iterdir()):
        if path.stem != SCHEME:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    for option, choices in CHOICES.items():
        leave_choices(content / "options" / f"{option}.toml", choices)
    for path in (content / "options").iterdir():
        if path.stem not in options_of(content):
            path.unlink()
    used = parts_of(content)
    for path in (content / "sections").iterdir():
        if path.stem not in used:
            path.unlink()
    forget_weights(root / "grader" / "policy.toml", declared_in(content))
    load_course(root)  # every fault is one of a course that was found sound before
    return root


def leave_choices(file: Path, wanted: set[str]) -> None:
    """Remove all but these choices of an option from its file."""
    head, *choices = file.read_text("utf-8").split("[[choice]]")
    kept = [one for one in choices if tomllib.loads(one)["id"] in wanted]
    assert len(kept) == len(wanted)
    file.write_text("[[choice]]".join([head, *kept]), "utf-8")


def options_of(content: Path) -> set[str]:
    """Read which shared options the scheme lists."""
    scheme = tomllib.loads((content / "schemes" / SCHEME / "scheme.toml").read_text("utf-8"))
    return set(scheme.get("options", []))


def parts_of(content: Path) -> set[str]:
    """Read which parts the scheme uses, with any of its options."""
    scheme = tomllib.loads((content / "schemes" / SCHEME / "scheme.toml").read_text("utf-8"))
    options = list(scheme.get("option", []))
    shared = (content / "options" / f"{name}.toml" for name in scheme.get("options", []))
    options += [tomllib.loads(path.read_text("utf-8")) for path in shared]
    chosen = [part for one in options for choice in one["choice"] for part in choice["parts"]]
    return {*scheme["parts"], *chosen}


def declared_in(content: Path) -> set[str]:
    """Read the ids of all declared quantities."""
    texts = (path.read_text("utf-8") for path in content.rglob("*.toml"))
    heading = re.compile(r"^\[quantity\.(\w+)\]", re.MULTILINE)
    return {name for text in texts for name in heading.findall(text)}


def forget_weights(policy: Path, declared: set[str]) -> None:
    """Remove the points and weights of quantities that are not declared any more."""
    text = policy.read_text("utf-8")
    for table in ("[points.quantity]", "[weight.quantity]"):
        before, heading, after = text.partition(table)
        lines, gap, rest = after.partition("\n\n")
        kept = [
            line
            for line in lines.splitlines()
            if "=" not in line or line.split("=")[0].strip() in declared
        ]
        text = before + heading + "\n".join(kept) + gap + rest
    policy.write_text(text, "utf-8")


@cache
def parsed(text: str, parse_float: Callable[[str], float]) -> bytes:
    """Parse a TOML text, to be unpickled by each who reads it: fifteen times as fast."""
    return pickle.dumps(tomllib.loads(text, parse_float=parse_float))


class ParsedOnce:
    """What the program uses of `tomli`: a draft differs from the one before in a file or two."""

    TOMLDecodeError = tomllib.TOMLDecodeError

    @staticmethod
    def loads(text: str, *, parse_float: Callable[[str], float]) -> object:
        return pickle.loads(parsed(text, parse_float))  # noqa: S301 (pickled here)


@pytest.fixture
def draft(tmp_path: Path, one_scheme: Path, monkeypatch: pytest.MonkeyPatch) -> Draft:
    """A course: what an instructor starts from."""
    monkeypatch.setattr("gripcourse.course.toml_faults.tomli", ParsedOnce)
    return Draft(Path(shutil.copytree(one_scheme, tmp_path / "course")))


@pytest.fixture
def said() -> Callable[[Problem], str]:
    """Put a problem into English as a person reads it, without the place."""

    def say(problem: Problem) -> str:
        return f"{problem.what} {problem.remedy}"

    return say
