"""What the pages tell a reader to do is possible, word for word."""

from pathlib import Path

import pytest

from gripcourse.simulation.write import fill
from support.steps import Shown, Typed, WrittenFile, missing_from, steps_of, type_line, write

DOCS = Path(__file__).parents[2] / "docs"
FORGETS_PI = {
    "small_diameter_required": 174.8,
    "small_diameter": 180,
    "belt_speed": 2.91,
    "peripheral_force": 1031,
}


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder in which English is spoken."""
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.usefixtures("here")
def test_the_tutorial_leads_from_an_empty_folder_to_a_graded_answer() -> None:
    printed = ""
    for step in steps_of(DOCS / "tutorial.md"):
        match step:
            case WrittenFile():
                write(step, Path())
            case Typed(line):
                if line.startswith("gripcourse grade"):
                    answer_by_hand()
                printed = type_line(f"{line}{alone(line)}")
            case Shown():
                assert missing_from(printed, step) == [], printed
    assert "belt_speed=without_pi" in Path("graded/grades.csv").read_text(encoding="utf-8")


def alone(line: str) -> str:
    """Let one worker do what two would do: each of them imports for seconds."""
    return " --workers 1" if line.startswith(("gripcourse issue", "gripcourse grade")) else ""


def answer_by_hand() -> None:
    """Do what the page tells to do in an office program."""
    Path("submissions").mkdir()
    workbook = Path("handouts/shevchenko-ok/shevchenko-ok.xlsx")
    fill(workbook, FORGETS_PI, Path("submissions") / workbook.name)
