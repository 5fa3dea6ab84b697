"""What was found sound is not judged again, and nothing else is taken for it."""

import time
from pathlib import Path

import pytest

from gripcourse.errors import Problem
from gripcourse.text.words import message
from gripcourse.usecases.authoring.judged_before import FilesSeen, files_seen, unless_sound

FAULT = Problem("variants/a.toml", "", message("The file is missing."), message("Write it."))


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    folder = tmp_path / "course" / "variants"
    folder.mkdir(parents=True)
    (folder / "a.toml").write_text("a = 1", encoding="utf-8")
    return folder.parent


def seen(root: Path) -> FilesSeen:
    return files_seen(root, [root / "variants"])


def judged(root: Path, *problems: Problem, subject: str = "numbers") -> list[Problem]:
    """Judge a course that has some problems."""
    return unless_sound(subject, [seen(root)], lambda: list(problems))


def test_what_was_found_sound_is_not_judged_again(root: Path) -> None:
    assert judged(root) == []
    assert judged(root, FAULT) == []


def test_another_judgement_of_the_same_files_is_made(root: Path) -> None:
    assert judged(root) == []
    assert judged(root, FAULT, subject="templates") == [FAULT]


def test_what_was_found_wrong_is_judged_each_time(root: Path) -> None:
    assert judged(root, FAULT) == [FAULT]
    assert judged(root, FAULT) == [FAULT]
    assert judged(root) == []


@pytest.mark.parametrize("name", ["a.toml", "tables/main.csv", "b"])
def test_a_file_that_changed_or_is_new_is_judged(root: Path, name: str) -> None:
    assert judged(root) == []
    path = root / "variants" / name
    path.parent.mkdir(exist_ok=True)
    path.write_text("a = 2", encoding="utf-8")
    assert judged(root, FAULT) == [FAULT]


def test_what_changes_while_it_is_judged_is_judged_again(root: Path) -> None:
    def judge() -> list[Problem]:
        (root / "variants" / "a.toml").write_text("a = 2", encoding="utf-8")
        return []

    assert unless_sound("numbers", [seen(root)], judge) == []
    (root / "variants" / "a.toml").write_text("a = 1", encoding="utf-8")
    assert judged(root, FAULT) == [FAULT]


def test_what_changed_between_a_look_and_the_judgement_is_judged_again(root: Path) -> None:
    before = seen(root)
    (root / "variants" / "a.toml").write_text("a = 2", encoding="utf-8")
    assert unless_sound("numbers", [before], list) == []
    assert judged(root, FAULT) == [FAULT]
    (root / "variants" / "a.toml").write_text("a = 1", encoding="utf-8")
    assert judged(root, FAULT) == [FAULT]


def test_a_file_that_changed_while_it_was_judged_and_is_again_what_it_was(root: Path) -> None:
    def judge() -> list[Problem]:
        for text in ("a = 2", "a = 1"):
            (root / "variants" / "a.toml").write_text(text, encoding="utf-8")
        return []

    before = seen(root)
    time.sleep(0.02)  # more than the clock of a disk takes to go on
    assert unless_sound("numbers", [before], judge) == []
    assert judged(root, FAULT) == [FAULT]


def test_a_folder_that_is_a_link_is_judged_each_time(root: Path) -> None:
    (root / "variants" / "one").mkdir()
    (root / "variants" / "linked").symlink_to(root / "variants" / "one")
    assert judged(root) == []
    assert judged(root, FAULT) == [FAULT]
