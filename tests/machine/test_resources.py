from pathlib import Path

import pytest

from gripcourse.errors import UsageError
from gripcourse.machine.resources import COURSE_FOLDERS, course_root, engine_template, expect_apart

REPOSITORY = Path(__file__).parents[2]


def make_course(folder: Path) -> Path:
    for name in COURSE_FOLDERS:
        (folder / name).mkdir(parents=True)
    return folder


def test_an_editable_installation_uses_the_repository() -> None:
    assert course_root() == REPOSITORY


def test_an_installed_wheel_uses_the_course_inside_the_package(tmp_path: Path) -> None:
    package = tmp_path / "lib" / "python" / "gripcourse"
    course = make_course(package / "_course")
    assert course_root(package=package) == course


def test_a_named_folder_wins(tmp_path: Path) -> None:
    package = tmp_path / "package"
    make_course(package / "_course")
    own = make_course(tmp_path / "own")
    assert course_root(own, package=package) == own


def test_a_named_folder_that_does_not_exist_is_refused(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"nowhere: course: There is no such folder\."):
        course_root(tmp_path / "nowhere")


def test_a_named_folder_that_is_no_course_is_told_what_it_lacks(tmp_path: Path) -> None:
    (tmp_path / "templates").mkdir()
    with pytest.raises(UsageError, match="lacks variants, grader"):
        course_root(tmp_path)


def test_an_installation_without_its_course_says_so(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="reference course is not installed"):
        course_root(package=tmp_path / "lib" / "python" / "gripcourse")


def test_a_template_of_the_engine_is_found_beside_the_package_and_in_a_wheel(
    tmp_path: Path,
) -> None:
    wheel = tmp_path / "gripcourse"
    own = wheel / "_course" / "templates" / "style" / "page.css"
    own.parent.mkdir(parents=True)
    own.touch()
    assert engine_template("style/page.css", wheel) == own.resolve()
    assert engine_template("style/other.css", wheel) is None
    assert engine_template("student.html.j2") == course_root() / "templates" / "student.html.j2"


def test_results_do_not_get_among_the_files_of_a_course(tmp_path: Path) -> None:
    own = make_course(tmp_path / "own")
    expect_apart(own / "graded", own)
    expect_apart(tmp_path, own)
    (tmp_path / "link").symlink_to(own)
    (tmp_path / "round").symlink_to("round")
    expect_apart(tmp_path / "round", own)
    for folder in (own, own / "variants", own / "private" / "out", tmp_path / "link"):
        with pytest.raises(UsageError, match="own files are in this folder"):
            expect_apart(folder, own)
