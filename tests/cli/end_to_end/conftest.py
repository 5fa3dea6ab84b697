"""The command line in an empty folder, a course of one's own, and a term that has begun."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from support.cli_term import ROSTER, Command, Term
from support.command_line import Run, call
from support.pages import no_pages


@pytest.fixture(scope="module", autouse=True)
def _no_pages() -> Iterator[None]:
    with no_pages():
        yield


@pytest.fixture
def gripcourse(tmp_path: Path) -> Command:
    """Call the command line in an empty folder, speaking English."""

    def run(*arguments: object, home: Path = tmp_path, system: str = "C") -> Run:
        return call(home, *arguments, system=system)

    return run


@pytest.fixture
def course(gripcourse: Command, tmp_path: Path) -> Path:
    """A course of one's own with a small roster."""
    root = tmp_path / "course"
    assert gripcourse("init", root).code == 0
    (root / "variants" / "roster.csv").write_text(ROSTER, encoding="utf-8")
    return root


@pytest.fixture(scope="module")
def term(tmp_path_factory: pytest.TempPathFactory) -> Term:
    """Issue to two students and grade a workbook in which nothing is written, once."""
    folder = tmp_path_factory.mktemp("term")
    assert call(folder, "init", folder / "course").code == 0
    roster = folder / "course" / "variants" / "roster.csv"
    roster.write_text(ROSTER, encoding="utf-8")
    nothing = Run(0, "", "")
    begun = Term(folder, nothing, nothing)
    out = folder / "assignments"
    issued = call(folder, "issue", *begun.place, "--roster", roster, "--out", out)
    graded = call(folder, "grade", *begun.place, begun.own, "--out", folder / "graded", "--json")
    return Term(folder, issued, graded)
