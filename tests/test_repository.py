"""What holds for every file of the repository."""

import re
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import pytest

REPOSITORY = Path(__file__).parents[1]
FOLDERS = (
    ".ci",
    ".github",
    "benchmarks",
    "docs",
    "examples",
    "grader",
    "scripts",
    "src",
    "templates",
    "tests",
    "variants",
)
LONGEST_MODULE = 350

# Put together from pieces, or this file would be its own first finding.
UNFINISHED = re.compile(r"\b(TO" + r"DO|FIX" + r"ME|X" + r"XX)\b")
MACHINE_PATH = re.compile("/(wo" + "rk|ro" + "ot|ho" + "me|Us" + "ers)/")
PACKAGE_INDEX = re.compile(
    "py" + r"pi\.|python" + r"hosted\.|--(extra-)?index" + "-url", re.IGNORECASE
)
TICKET = re.compile(r"\b(issue|ticket|bug|pull request)s? #?\d", re.IGNORECASE)


def text_files() -> Iterator[Path]:
    """Every file that people write, without what tools leave behind."""
    # In a second working tree `.git` is a file.
    yield from (path for path in REPOSITORY.iterdir() if path.is_file() and path.name != ".git")
    for folder in FOLDERS:
        for path in (REPOSITORY / folder).rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts:
                yield path


@cache
def texts() -> Mapping[str, str]:
    """Each text file by its place; pictures and workbooks are passed over."""
    found = {}
    for path in text_files():
        with suppress(UnicodeDecodeError):
            found[str(path.relative_to(REPOSITORY))] = path.read_text(encoding="utf-8")
    return found


@pytest.mark.parametrize("pattern", [UNFINISHED, MACHINE_PATH, PACKAGE_INDEX, TICKET])
def test_no_file_says_what_belongs_elsewhere(pattern: re.Pattern[str]) -> None:
    found = [
        f"{place}:{number}: {line.strip()}"
        for place, text in texts().items()
        if pattern.search(text)  # none of them reaches over the end of a line
        for number, line in enumerate(text.splitlines(), start=1)
        if pattern.search(line)
    ]
    assert not found, "\n".join(found)


def test_no_module_has_grown_too_long() -> None:
    lengths = {
        str(path.relative_to(REPOSITORY)): len(path.read_text(encoding="utf-8").splitlines())
        for path in (REPOSITORY / "src").rglob("*.py")
    }
    assert lengths
    assert {path: length for path, length in lengths.items() if length > LONGEST_MODULE} == {}


def plain_name(requirement: str) -> str:
    """Name the distribution of a requirement in the one spelling that compares."""
    return re.sub(r"[-_.]+", "-", re.split(r"[\s=<>~!;\[]", requirement, maxsplit=1)[0]).lower()


def wished_for(project: Mapping[str, Any]) -> list[str]:
    """Every requirement that the project itself names: to run, to develop, to document."""
    extras = project["project"]["optional-dependencies"].values()
    groups = [*project["dependency-groups"].values(), *extras]
    return [*project["project"]["dependencies"], *(each for group in groups for each in group)]


def test_every_dependency_has_one_exact_version() -> None:
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))
    wanted = [*project["build-system"]["requires"], *wished_for(project)]
    constraints = (REPOSITORY / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pins = [line for line in constraints if line and not line.startswith("#")]
    assert [pin for pin in pins if not re.fullmatch(r"[a-z0-9-]+==[\w.]+", pin)] == []
    names = [plain_name(pin) for pin in pins]
    assert names == sorted(set(names))
    assert {plain_name(each) for each in wanted} <= set(names)


def test_every_dependency_has_its_reason() -> None:
    project = tomllib.loads((REPOSITORY / "pyproject.toml").read_text(encoding="utf-8"))
    wanted = wished_for(project)
    record = REPOSITORY / "docs" / "decisions" / "0002-dependencies.md"
    explained = re.findall(
        r"^- \*\*([\w.-]+)\*\*:", record.read_text(encoding="utf-8"), re.MULTILINE
    )
    assert {plain_name(each) for each in wanted} == {plain_name(name) for name in explained}


@pytest.mark.parametrize("command", [".ci/run", "scripts/system-packages"])
def test_commands_can_be_run(command: str) -> None:
    assert (REPOSITORY / command).stat().st_mode & 0o111 == 0o111


def test_decisions_are_numbered_without_gaps() -> None:
    records = sorted(path.name for path in (REPOSITORY / "docs" / "decisions").glob("[0-9]*"))
    assert [name[:5] for name in records] == [f"{n:04d}-" for n in range(1, len(records) + 1)]
