"""What the pages tell a reader to do is possible, word for word."""

from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.simulation.write import fill
from gripcourse.variants.space import load_spaces
from support.steps import (
    ChangedLine,
    Shown,
    Typed,
    WrittenFile,
    change,
    missing_from,
    steps_of,
    type_line,
    write,
)

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


def test_the_grown_up_course_does_what_its_page_shows(here: Path) -> None:
    (here / "examples").symlink_to(DOCS.parent / "examples")
    part = Path("variants/sections/base_tensioning.toml")
    printed = ""
    for step in steps_of(DOCS / "tutorial-belts.md"):
        match step:
            case ChangedLine():
                change(step, Path())
            case Typed(line):
                printed = type_line(line)
            case Shown():
                assert missing_from(printed, step) == [], printed
            case WrittenFile():
                write(step, Path())
    assert part.read_bytes() == (here / "examples" / "belt_drive" / part).read_bytes()


@pytest.mark.usefixtures("here")
def test_a_given_number_is_added_in_one_file_for_all_schemes() -> None:
    printed = ""
    before: dict[Path, bytes] = {}
    for step in steps_of(DOCS / "howto" / "add-a-given.md"):
        match step:
            case WrittenFile():
                before = before or contents()
                write(step, Path())
            case ChangedLine():
                change(step, Path())
            case Typed(line):
                printed = type_line(line)
            case Shown():
                assert missing_from(printed, step) == [], printed
    part = Path("variants/sections/pin.toml")
    assert {path for path, text in contents().items() if before.get(path) != text} == {part}
    course = load_course(Path())
    with_pins = {scheme.id for scheme in course.schemes.values() if "pin" in scheme.parts}
    drawn = {
        space.scheme for space in load_spaces(course) if "pin_overload" in space.cases[0].given
    }
    assert with_pins
    assert with_pins <= drawn


def contents() -> dict[Path, bytes]:
    """Every file of the course."""
    return {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}


def alone(line: str) -> str:
    """Do here what workers would do: each of them imports for seconds."""
    return " --workers 0" if line.startswith(("gripcourse issue", "gripcourse grade")) else ""


def answer_by_hand() -> None:
    """Do what the page tells to do in an office program."""
    Path("submissions").mkdir()
    workbook = Path("handouts/shevchenko-ok/shevchenko-ok.xlsx")
    fill(workbook, FORGETS_PI, Path("submissions") / workbook.name)
