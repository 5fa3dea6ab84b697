"""A scheme is judged again when a file changed that it is judged from, and not for another's."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from gripcourse.course.read import read_course
from gripcourse.course.sound_schemes import NOT_READ, SchemeJudgement, judgement
from gripcourse.course.source_files import source_files

COURSE = Path(__file__).parents[2] / "examples" / "belt_drive"
BOTH = frozenset({"flat_belt", "v_belt"})
# Prints every file that is opened while a course is read and checked.
READER = """
import sys
from pathlib import Path
sys.addaudithook(lambda event, args: event == "open" and print(args[0]))
from gripcourse.course.check import check_course
from gripcourse.course.read import read_course
course, problems = read_course(Path(sys.argv[1]))
assert not problems and not check_course(course)
"""


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A course whose schemes were found sound."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    root = Path(shutil.copytree(COURSE, tmp_path / "course"))
    found = judged(root)
    assert found.alone.keys() == BOTH
    found.remember()
    return root


def judged(root: Path, subject: str = "declarations") -> SchemeJudgement:
    files, (course, problems) = source_files(root), read_course(root)
    assert files is not None
    assert course is not None
    assert problems == []
    return judgement(course, files, NOT_READ, subject)


def waiting(root: Path, subject: str = "declarations") -> frozenset[str]:
    return frozenset(judged(root, subject).alone)


def change(root: Path, file: str) -> None:
    path = root / file
    path.write_text(path.read_text(encoding="utf-8") + "\n# more\n", encoding="utf-8")


def test_what_was_found_sound_is_not_judged_again(root: Path) -> None:
    assert waiting(root) == frozenset()
    assert waiting(root, "numbers") == BOTH


@pytest.mark.parametrize("file", ["scheme.toml", "worked_example.toml", "drawing.toml"])
def test_a_change_of_one_scheme_concerns_that_one(root: Path, file: str) -> None:
    change(root, f"variants/schemes/v_belt/{file}")
    assert waiting(root) == {"v_belt"}


@pytest.mark.parametrize(
    "file",
    [
        "variants/course.toml",
        "variants/sections/open_belt.toml",
        "variants/options/tensioning.toml",
        "variants/drawing/drive.toml",
        "grader/rubric/drive_drawing.toml",
    ],
)
def test_a_change_of_what_schemes_share_concerns_all(root: Path, file: str) -> None:
    change(root, file)
    assert waiting(root) == BOTH


@pytest.mark.parametrize("file", ["catalogues/v_belt.csv", "catalogues/v_wrap.csv"])
def test_a_change_of_what_one_scheme_names_concerns_that_one(root: Path, file: str) -> None:
    change(root, f"variants/{file}")
    assert waiting(root) == {"v_belt"}


@pytest.mark.parametrize("file", ["variants/proofs.toml", "grader/policy.toml"])
def test_a_change_of_what_declares_nothing_concerns_none(root: Path, file: str) -> None:
    change(root, file)
    assert waiting(root) == frozenset()


def test_a_scheme_is_judged_with_what_it_names_and_nothing_else(root: Path) -> None:
    alone = judged(root, "numbers").alone["flat_belt"]
    assert alone.schemes.keys() == {"flat_belt"}
    assert "v_belt" not in alone.catalogues
    assert alone.catalogues


def test_a_new_file_concerns_whose_it_is(root: Path) -> None:
    (root / "variants" / "schemes" / "flat_belt" / "more.toml").write_text("", encoding="utf-8")
    assert waiting(root) == {"flat_belt"}
    (root / "variants" / "more.toml").write_text("", encoding="utf-8")
    assert waiting(root) == BOTH


def test_a_scheme_that_was_taken_away_and_put_back_is_as_sound_as_before(root: Path) -> None:
    away = root / "away"
    (root / "variants" / "schemes" / "v_belt").rename(away)
    assert waiting(root) == frozenset()
    away.rename(root / "variants" / "schemes" / "v_belt")
    assert waiting(root) == frozenset()


def test_what_changes_while_it_is_judged_is_not_remembered(root: Path) -> None:
    change(root, "variants/course.toml")
    before = judged(root)
    change(root, "variants/course.toml")
    before.remember()
    assert waiting(root) == BOTH


def test_files_in_folders_that_are_links_are_not_told(root: Path) -> None:
    (root / "variants" / "schemes" / "v_belt" / "more").symlink_to(root / "variants" / "sections")
    assert source_files(root) is None


def test_a_name_that_is_written_with_an_escape_may_be_any(root: Path) -> None:
    path = root / "variants" / "schemes" / "flat_belt" / "scheme.toml"
    path.write_text(path.read_text(encoding="utf-8") + '# "\\u0076_belt"', encoding="utf-8")
    assert "v_belt" in judged(root).alone["flat_belt"].catalogues


def test_what_no_scheme_is_judged_from_is_never_opened(root: Path) -> None:
    done = subprocess.run(  # noqa: S603 (our own text)
        [sys.executable, "-c", READER, str(root)],
        capture_output=True,
        text=True,
        check=True,
        timeout=120,
    )
    home = root / "variants"
    opened = {Path(line) for line in done.stdout.splitlines() if line.startswith(str(root))}
    assert home / "schemes" / "v_belt" / "scheme.toml" in opened
    names = [one.relative_to(root).as_posix() for one in opened]
    assert [one for one in names if one.startswith(NOT_READ)] == []
