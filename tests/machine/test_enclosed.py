"""A course shows nothing of the machine, and no name leads out of a folder."""

import os
from pathlib import Path

import pytest

from gripcourse.machine.enclosed import file_below, is_file_name, strange_files


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
