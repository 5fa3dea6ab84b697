"""A course shows nothing of the machine, and no name leads out of a folder."""

import os
import sys
from pathlib import Path

import pytest

from gripcourse.course.digest import course_digest
from gripcourse.course.source_files import source_files
from gripcourse.errors import CourseError
from gripcourse.machine.enclosed import (
    file_below,
    is_file_name,
    read_within_bounds,
    strange_files,
)
from gripcourse.usecases.grading.versions import versions_of


@pytest.fixture
def course(tmp_path: Path) -> Path:
    root = tmp_path / "course"
    (root / "variants" / "tables").mkdir(parents=True)
    (root / "variants" / "course.toml").write_text("", encoding="utf-8")
    (tmp_path / "secret").write_text("secret", encoding="utf-8")
    return root


def test_a_link_out_of_the_course_is_refused_wherever_it_is(course: Path, tmp_path: Path) -> None:
    (course / "variants" / "own").symlink_to(course / "variants" / "course.toml")
    assert strange_files(course, ("variants", "templates")) == []
    (course / "variants" / "tables" / "main.csv").symlink_to(tmp_path / "secret")
    (course / "variants" / "parts").symlink_to(tmp_path)
    (course / "templates").symlink_to(tmp_path)
    found = strange_files(course, ("variants", "templates"))
    assert sorted(one.file for one in found) == [
        *("templates", "variants/parts", "variants/tables/main.csv")
    ]


def test_a_course_may_be_reached_by_a_link_itself(course: Path, tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(course)
    (course / "variants" / "own").symlink_to(course / "variants" / "course.toml")
    assert strange_files(tmp_path / "link", ("variants",)) == []


def test_a_pipe_and_a_huge_file_are_refused(course: Path) -> None:
    os.mkfifo(course / "variants" / "pipe")
    with (course / "variants" / "huge.csv").open("wb") as stream:
        stream.truncate(10**9)
    found = strange_files(course, ("variants",))
    assert sorted(one.file for one in found) == ["variants/huge.csv", "variants/pipe"]


@pytest.mark.parametrize("name", ["001", "ivanova-an", "Вариант 5", "a.b", "x" * 64])
def test_usual_ids_name_files(name: str, tmp_path: Path) -> None:
    assert is_file_name(name)
    assert file_below(tmp_path, name).parent == tmp_path


@pytest.mark.parametrize(
    "name", ["", "..", "../x", "a/b", "a\\b", "/etc", "C:x", "nul.txt", ".hidden", "a\n", "x."]
)
def test_what_leads_elsewhere_names_no_file(name: str, tmp_path: Path) -> None:
    assert not is_file_name(name)
    with pytest.raises(ValueError, match="no name of a file"):
        file_below(tmp_path, name)


@pytest.mark.skipif(os.name == "nt" or sys.platform == "darwin", reason="names are text there")
def test_a_name_in_the_letters_of_another_system_is_refused(course: Path) -> None:
    Path(os.fsdecode(os.fsencode(course) + b"/variants/\xef\xee\xe4.csv")).touch()
    (found,) = strange_files(course, ("variants",))
    assert "letters of another system" in str(found.what)


def test_nobody_reads_a_file_that_is_larger_than_any_of_a_course(course: Path) -> None:
    huge = course / "variants" / "huge.toml"
    with huge.open("wb") as stream:
        stream.truncate(100 << 30)
    with pytest.raises(OSError, match="huge"):
        read_within_bounds(huge)
    assert course_digest(course) is None
    assert source_files(course) is None
    with pytest.raises(CourseError, match="107374 MB"):
        versions_of(course)
