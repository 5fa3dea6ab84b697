"""A course is written in the languages that it names, and a reader of another gets its own."""

import re
import shutil
from pathlib import Path

import pytest

from gripcourse.course.read import read_course
from gripcourse.machine.resources import skeleton_root


@pytest.fixture
def small(tmp_path: Path) -> Path:
    """Return a copy of the course to begin with, that has lost its Ukrainian."""
    root = tmp_path / "small"
    shutil.copytree(skeleton_root(), root)
    for path in (root / "variants").rglob("*.toml"):
        text = path.read_text(encoding="utf-8")
        text = re.sub(r', uk = "[^"]*"', "", text).replace("{language}", "en")
        path.write_text(text, encoding="utf-8")
    return root


def write_languages(root: Path, language: str, languages: str) -> None:
    path = root / "variants" / "course.toml"
    text = path.read_text(encoding="utf-8")
    text = text.replace('languages = ["en", "ru", "uk"]\n', "")
    said = f'language = "{language}"\nlanguages = {languages}'
    path.write_text(text.replace('language = "en"', said, 1), encoding="utf-8")


def test_a_course_need_not_be_written_in_a_language_that_it_does_not_name(small: Path) -> None:
    write_languages(small, "ru", '["en", "ru"]')
    course, problems = read_course(small)
    assert problems == []
    assert course is not None
    title = course.sections[0].title
    assert title.of("uk") == title.of("ru") == "Нагрузки и напряжения"
    assert course.languages == ("ru", "en")


def test_what_a_named_language_lacks_is_told(small: Path) -> None:
    write_languages(small, "en", '["en", "uk"]')
    _, problems = read_course(small)
    assert {str(one.key).rpartition(".")[2] for one in problems} == {"uk"}
    assert "says so with 'languages'" in str(problems[0].remedy)


def test_the_language_of_documents_is_one_that_the_course_is_written_in(small: Path) -> None:
    write_languages(small, "uk", '["ru", "de"]')
    _, problems = read_course(small)
    assert {str(one.key) for one in problems} == {"languages", "language"}
