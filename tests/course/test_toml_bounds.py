"""A file of a course may say anything, but not at any length."""

from pathlib import Path

import pytest

from gripcourse.course.toml_faults import toml_values
from gripcourse.errors import Problem


def read(folder: Path, text: str) -> tuple[dict[str, object] | None, list[Problem]]:
    (folder / "course.toml").write_text(text, encoding="utf-8")
    problems: list[Problem] = []
    return toml_values(folder / "course.toml", "course.toml", problems), problems


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ('title = "{long}"', "title"),
        ('[section]\ntitle = {{ en = "a", ru = "{long}" }}', "section.title.ru"),
        ('[[note]]\ntexts = ["a", "{long}"]', "note.0.texts.1"),
    ],
)
def test_a_text_that_no_page_has_room_for_is_named_and_cut(
    tmp_path: Path, text: str, place: str
) -> None:
    values, [problem] = read(tmp_path, text.format(long="Ж" * 10_000))
    assert problem.key == place
    assert "10000 signs; 2000 at most" in str(problem.what)
    assert len(str(values)) < 200
    assert read(tmp_path, text.format(long="Ж" * 2000))[1] == []


def test_a_key_of_any_length_is_named(tmp_path: Path) -> None:
    values, [problem] = read(tmp_path, f"{'k' * 5000} = 1")
    assert problem.key == f"{'k' * 40}…"
    assert list(values or ()) == [f"{'k' * 40}…"]


@pytest.mark.parametrize("value", ["9" * 5000, "[" * 20_000])
def test_digits_and_brackets_without_end_are_no_exception(tmp_path: Path, value: str) -> None:
    values, problems = read(tmp_path, f"one = {value}")
    assert values is None
    assert len(problems) == 1
