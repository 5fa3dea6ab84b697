import stat
from pathlib import Path

import pytest

from gripcourse.errors import UsageError
from gripcourse.issuing.signature import key_path, read_key
from gripcourse.machine.resources import COURSE_FOLDERS, course_root
from gripcourse.text.words import Words
from gripcourse.usecases import init
from gripcourse.usecases.init import init_course

SECRET = bytes(range(32))
WORDS = Words("en")


def files_below(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def test_every_file_of_the_reference_course_is_copied_unchanged(tmp_path: Path) -> None:
    init_course(tmp_path / "mine", SECRET, WORDS)
    for name in COURSE_FOLDERS:
        original = files_below(course_root() / name)
        assert original
        assert files_below(tmp_path / "mine" / name) == original


def test_the_copy_is_a_course_itself(tmp_path: Path) -> None:
    init_course(tmp_path / "first", SECRET, WORDS)
    init_course(tmp_path / "second", SECRET, WORDS, source=course_root(tmp_path / "first"))
    assert files_below(tmp_path / "first") == files_below(tmp_path / "second")


def test_only_the_owner_reads_the_key(tmp_path: Path) -> None:
    init_course(tmp_path / "mine", SECRET, WORDS)
    key = key_path(tmp_path / "mine")
    assert read_key(key) == SECRET
    assert stat.S_IMODE(key.stat().st_mode) == 0o600


def test_version_control_leaves_the_private_folder_out(tmp_path: Path) -> None:
    init_course(tmp_path / "mine", SECRET, WORDS)
    ignored = (tmp_path / "mine" / ".gitignore").read_text(encoding="utf-8").splitlines()
    assert {"private/", "out/"} <= set(ignored)


def test_the_instructor_finds_a_guide(tmp_path: Path) -> None:
    init_course(tmp_path / "mine", SECRET, WORDS)
    guide = (tmp_path / "mine" / "README.md").read_text(encoding="utf-8")
    assert all(f"- `{name}/`: " in guide for name in COURSE_FOLDERS)


def test_missing_folders_above_are_made(tmp_path: Path) -> None:
    init_course(tmp_path / "2026" / "spring" / "mine", SECRET, WORDS)
    assert (tmp_path / "2026" / "spring" / "mine" / "grader").is_dir()


def test_an_empty_folder_is_filled_and_stays_the_same_folder(tmp_path: Path) -> None:
    target = tmp_path / "mine"
    target.mkdir()
    before = target.stat().st_ino
    init_course(target, SECRET, WORDS)
    assert target.stat().st_ino == before
    assert (target / "variants").is_dir()


def test_a_folder_in_use_is_refused_and_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("years of work", encoding="utf-8")
    with pytest.raises(UsageError, match="not empty"):
        init_course(tmp_path / "mine", SECRET, WORDS)
    assert files_below(tmp_path) == {"mine/thesis.txt": b"years of work"}


def test_a_file_of_that_name_is_refused_and_left_alone(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("years of work", encoding="utf-8")
    with pytest.raises(UsageError, match="a file, not a folder"):
        init_course(tmp_path / "mine", SECRET, WORDS)
    assert files_below(tmp_path) == {"mine": b"years of work"}


def test_a_folder_below_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(UsageError, match="cannot be written"):
        init_course(tmp_path / "file" / "mine", SECRET, WORDS)


@pytest.mark.parametrize("exists", [False, True])
def test_nothing_is_left_behind_when_it_fails_half_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, exists: bool
) -> None:
    if exists:
        (tmp_path / "mine").mkdir()

    def full_disk(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(init, "write_text", full_disk)
    with pytest.raises(UsageError, match="The disk is full"):
        init_course(tmp_path / "mine", SECRET, WORDS)
    assert list(tmp_path.rglob("*")) == ([tmp_path / "mine"] if exists else [])
