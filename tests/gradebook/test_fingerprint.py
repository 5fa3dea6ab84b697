"""A fingerprint tells whether the same course and policy graded."""

import shutil
from pathlib import Path

import pytest

from gripcourse.gradebook.fingerprint import fingerprints

REPOSITORY = Path(__file__).parents[2]


@pytest.fixture
def root(tmp_path: Path) -> Path:
    for folder in ("variants", "grader"):
        shutil.copytree(REPOSITORY / folder, tmp_path / folder)
    return tmp_path


def touch(path: Path) -> None:
    path.write_bytes(path.read_bytes() + b"\n")


def test_a_copy_has_the_same(root: Path) -> None:
    assert fingerprints(root) == fingerprints(REPOSITORY)


@pytest.mark.parametrize(
    "file",
    [
        "variants/course.toml",
        "variants/sections/drawings.toml",
        "variants/schemes/rack_parallelogram/scheme.toml",
    ],
)
def test_a_declaration_changes_that_of_the_course_alone(root: Path, file: str) -> None:
    before = fingerprints(root)
    touch(root / file)
    after = fingerprints(root)
    assert after.course != before.course
    assert after.policy == before.policy


def test_a_catalogue_changes_that_of_the_course(root: Path) -> None:
    before = fingerprints(root)
    touch(next((root / "variants" / "catalogues").glob("*.csv")))
    assert fingerprints(root).course != before.course


@pytest.mark.parametrize("file", ["grader/policy.toml", "grader/rubric/general_view.toml"])
def test_points_and_rubrics_change_that_of_the_policy_alone(root: Path, file: str) -> None:
    before = fingerprints(root)
    touch(root / file)
    after = fingerprints(root)
    assert after.policy != before.policy
    assert after.course == before.course


def test_tables_ranges_and_rosters_change_nothing(root: Path) -> None:
    """What was issued is in the register, whatever becomes of them."""
    before = fingerprints(root)
    for folder in ("tables", "spaces"):
        for path in (root / "variants" / folder).iterdir():
            touch(path)
    (root / "variants" / "roster.csv").write_text("student,name\n", encoding="utf-8")
    assert fingerprints(root) == before


def test_the_content_counts_with_its_file(root: Path) -> None:
    before = fingerprints(root)
    (root / "grader" / "policy.toml").rename(root / "grader" / "rules.toml")
    assert fingerprints(root).policy != before.policy
