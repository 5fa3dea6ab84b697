"""Numbers of a scheme are judged from what its digest covers, and from nothing else."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from gripcourse.course.read import read_course
from gripcourse.course.sound_schemes import SchemeJudgement
from gripcourse.course.source_files import SourceFiles, source_files
from gripcourse.usecases.authoring.scheme_numbers import NOT_COMPUTED, numbers_of_schemes

COURSE = Path(__file__).parents[3] / "examples" / "belt_drive"
# Prints every file that is opened while the numbers of a scheme are judged.
READER = """
import sys
from pathlib import Path
from gripcourse.course.read import read_course
from gripcourse.course.source_files import source_files
from gripcourse.proofs.published_cases import read_published_cases
from gripcourse.usecases.authoring.scheme_numbers import is_sound_alone, numbers_of_schemes
root = Path(sys.argv[1])
files, (course, _) = source_files(root), read_course(root)
judged, (cases, _) = numbers_of_schemes(course, files), read_published_cases(course)
sys.addaudithook(lambda event, args: event == "open" and print(args[0]))
assert is_sound_alone(judged, sys.argv[2], cases)
"""


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return Path(shutil.copytree(COURSE, tmp_path / "course"))


def files_of(root: Path) -> SourceFiles:
    files = source_files(root)
    assert files is not None
    return files


def judged(root: Path) -> SchemeJudgement | None:
    course, problems = read_course(root)
    assert course is not None
    assert problems == []
    return numbers_of_schemes(course, files_of(root))


def waiting(root: Path) -> set[str]:
    found = judged(root)
    assert found is not None
    return set(found.alone)


def test_a_changed_space_concerns_its_scheme(root: Path) -> None:
    found = judged(root)
    assert found is not None
    found.remember()
    assert waiting(root) == set()
    path = root / "variants" / "spaces" / "v_belt.toml"
    path.write_text(path.read_text(encoding="utf-8") + "\n# more\n", encoding="utf-8")
    assert waiting(root) == {"v_belt"}


def test_a_changed_printed_case_concerns_all(root: Path) -> None:
    found = judged(root)
    assert found is not None
    found.remember()
    path = root / "variants" / "published_cases.toml"
    path.write_text(path.read_text(encoding="utf-8") + "\n# more\n", encoding="utf-8")
    assert waiting(root) == {"flat_belt", "v_belt"}


def test_a_space_of_no_scheme_keeps_anything_from_being_passed_over(root: Path) -> None:
    (root / "variants" / "spaces" / "more.toml").write_text('scheme = "x"', encoding="utf-8")
    assert judged(root) is None


def test_what_the_digest_does_not_cover_is_never_opened(root: Path) -> None:
    done = subprocess.run(  # noqa: S603 (our own text)
        [sys.executable, "-c", READER, str(root), "v_belt"],
        capture_output=True,
        text=True,
        check=True,
        timeout=240,
    )
    course, _ = read_course(root)
    assert course is not None
    files = files_of(root)
    covered = files.of_scheme(course.schemes["v_belt"], files.shared(NOT_COMPUTED))
    opened = [Path(one) for one in done.stdout.splitlines() if one.startswith(str(root))]
    names = {one.relative_to(root).as_posix() for one in opened}
    assert "variants/spaces/v_belt.toml" in names
    assert names <= set(covered)
