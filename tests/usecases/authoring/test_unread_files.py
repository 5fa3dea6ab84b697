"""A file that stands where none is read is named, and so is a course without its main file."""

import shutil
from pathlib import Path

import pytest

from gripcourse.machine.resources import course_root, is_course, skeleton_root
from gripcourse.usecases.authoring.unread_files import unread_problems


@pytest.fixture
def small_course(tmp_path: Path) -> Path:
    return Path(shutil.copytree(skeleton_root(), tmp_path / "course"))


@pytest.mark.parametrize(
    ("stands", "moved", "remedy"),
    [
        ("grader/policy.toml", "grader/Policy.toml", "Rename it to grader/policy.toml."),
        (
            "variants/schemes/rod/worked_example.toml",
            "variants/schemes/rod/workedexample.toml",
            "Rename it to variants/schemes/rod/worked_example.toml.",
        ),
        (
            "variants/spaces/rod.toml",
            "variants/space/rod.toml",
            "Rename it to variants/spaces/rod.toml.",
        ),
        (
            "variants/sections/tension.toml",
            "variants/sections/tension.TOML",
            "Rename it to variants/sections/tension.toml.",
        ),
        (
            "variants/catalogues/rod.csv",
            "variants/catalogues/rod.CSV",
            "Rename it to variants/catalogues/rod.csv.",
        ),
        (
            "variants/spaces/rod.toml",
            "variants/elsewhere.toml",
            "Put it where it is read, as `gripcourse schema` lists it, or give it another ending.",
        ),
    ],
)
def test_a_file_that_nobody_reads_is_named_with_its_right_name(
    small_course: Path, stands: str, moved: str, remedy: str
) -> None:
    place = small_course / moved
    place.parent.mkdir(exist_ok=True)
    (small_course / stands).rename(place)
    found = list(unread_problems(small_course))
    assert [(one.file, str(one.remedy)) for one in found] == [(moved, remedy)]


def test_notes_and_lists_may_lie_anywhere(small_course: Path) -> None:
    for name in ("variants/notes.txt", "variants/group.csv", "grader/.hidden.toml"):
        (small_course / name).write_text("of my own", encoding="utf-8")
    assert list(unread_problems(small_course)) == []


@pytest.mark.parametrize("root", [course_root(None), skeleton_root()])
def test_every_file_of_the_courses_that_we_ship_is_read(root: Path) -> None:
    assert list(unread_problems(root)) == []


def test_a_course_without_its_main_file_is_still_the_one_that_is_meant(small_course: Path) -> None:
    (small_course / "variants" / "course.toml").unlink()
    assert is_course(small_course)


def test_a_course_without_its_policy_folder_is_still_the_one_that_is_meant(
    small_course: Path, tmp_path: Path
) -> None:
    shutil.rmtree(small_course / "grader")
    assert is_course(small_course)
    assert not is_course(tmp_path)
