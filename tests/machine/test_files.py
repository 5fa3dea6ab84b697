"""A reader never sees half of a file."""

import errno
import stat
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from gripcourse.machine.files import (
    discard_all_unfinished,
    discard_unfinished,
    making,
    replacing,
    write_bytes,
    write_text,
    write_together,
)


def _write_half(target: Path) -> None:
    with replacing(target) as temporary:
        temporary.write_text("half", encoding="utf-8")
        raise RuntimeError("half way")


def test_text_is_written_as_utf8_with_its_own_line_ends(tmp_path: Path) -> None:
    target = tmp_path / "sheet.csv"
    write_text(target, "масса\r\n60\n")
    assert target.read_bytes() == "масса\r\n60\n".encode()


def test_missing_folders_are_made(tmp_path: Path) -> None:
    target = tmp_path / "out" / "student" / "file.bin"
    write_bytes(target, b"\x00\x01")
    assert target.read_bytes() == b"\x00\x01"


def test_an_old_file_is_replaced_and_nothing_is_left_beside_it(tmp_path: Path) -> None:
    target = tmp_path / "register.json"
    write_text(target, "old")
    write_text(target, "new")
    assert target.read_text(encoding="utf-8") == "new"
    assert [path.name for path in tmp_path.iterdir()] == ["register.json"]


def test_a_failed_write_leaves_the_old_file_and_no_rest(tmp_path: Path) -> None:
    target = tmp_path / "register.json"
    write_text(target, "old")
    with pytest.raises(RuntimeError, match="half way"):
        _write_half(target)
    assert target.read_text(encoding="utf-8") == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["register.json"]


def test_a_block_that_wrote_nothing_is_an_error_and_keeps_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "register.json"
    write_text(target, "old")
    with pytest.raises(FileNotFoundError), replacing(target):
        pass
    assert target.read_text(encoding="utf-8") == "old"


def test_what_fails_is_said_of_the_file_that_was_asked_for(tmp_path: Path) -> None:
    target = tmp_path / "missing" / "term.zip"
    with pytest.raises(FileNotFoundError) as failed, making(target) as temporary:
        temporary.write_bytes(b"")
    assert failed.value.filename == str(target)


def test_the_temporary_name_keeps_the_suffix(tmp_path: Path) -> None:
    with replacing(tmp_path / "answers.xlsx") as temporary:
        assert temporary.suffix == ".xlsx"
        assert temporary.parent == tmp_path
        temporary.write_bytes(b"")


@pytest.mark.skipif(sys.platform == "win32", reason="the mode bits are of POSIX systems")
def test_a_private_file_is_readable_by_its_owner_only(tmp_path: Path) -> None:
    target = tmp_path / "private" / "key"
    write_text(target, "secret", private=True)
    assert stat.S_IMODE(target.stat().st_mode) == 0o600


def test_what_a_killed_process_left_is_removed_and_nothing_else(tmp_path: Path) -> None:
    target = tmp_path / "s01.xlsx"
    kept = {"s01.xlsx", ".s01.xlsx", ".s01.notatoken.xlsx", ".s02.00ff00ff.xlsx", "s01.pdf"}
    for name in {*kept, ".s01.00ff00ff.xlsx"}:
        (tmp_path / name).touch()
    discard_unfinished(target)
    assert {path.name for path in tmp_path.iterdir()} == kept


def test_nothing_is_removed_from_a_folder_that_is_not_there(tmp_path: Path) -> None:
    discard_unfinished(tmp_path / "gone" / "s01.xlsx")
    assert not (tmp_path / "gone").exists()


def test_a_folder_of_ours_is_rid_of_all_that_was_left_unfinished(tmp_path: Path) -> None:
    for name in (".s01.0a1b2c3d.pdf", ".s02.0a1b2c3d", "s01.pdf", ".hidden.pdf", ".s.0a1b.pdf"):
        (tmp_path / name).write_bytes(b"")
    discard_all_unfinished(tmp_path)
    left = {path.name for path in tmp_path.iterdir()}
    assert left == {"s01.pdf", ".hidden.pdf", ".s.0a1b.pdf"}
    discard_all_unfinished(tmp_path / "gone")


def test_files_that_belong_together_take_their_places_together(tmp_path: Path) -> None:
    first, second = tmp_path / "a.csv", tmp_path / "b.json"
    write_together({first: ["1", "\r\n"], second: ["ж"]})
    assert (first.read_bytes(), second.read_bytes()) == (b"1\r\n", "ж".encode())

    def without_room() -> Iterator[str]:
        yield "half"
        raise OSError(errno.ENOSPC, "full")

    with pytest.raises(OSError, match="full"):
        write_together({first: ["2"], second: without_room()})
    assert (first.read_bytes(), second.read_bytes()) == (b"1\r\n", "ж".encode())
    assert sorted(one.name for one in tmp_path.iterdir()) == ["a.csv", "b.json"]
