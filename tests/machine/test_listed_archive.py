"""A zip of thousands of works is listed once, and no file of it stays open."""

import os
import sys
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from gripcourse.machine.archive import UnreadableMemberError, read_member
from gripcourse.machine.listed_archive import ask_archive

COUNT = 60


def packed(path: Path, work: str) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for number in range(COUNT):
            archive.writestr(f"{number}.xlsx", f"{work} {number} " * 1000)
    return path


def content(work: str, number: int) -> bytes:
    return (f"{work} {number} " * 1000).encode()


def test_the_list_of_a_zip_is_read_once_for_all_its_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = packed(tmp_path / "a.zip", "work")
    listed: list[object] = []
    opened = zipfile.ZipFile

    def noted(file: str) -> zipfile.ZipFile:
        listed.append(file)
        return opened(file)

    monkeypatch.setattr("gripcourse.machine.listed_archive.zipfile.ZipFile", noted)
    read = [read_member(path, number) for number in range(COUNT)]
    assert read == [content("work", number) for number in range(COUNT)]
    assert len(listed) == 1


def test_a_zip_that_was_downloaded_again_is_another_one(tmp_path: Path) -> None:
    path = packed(tmp_path / "a.zip", "first")
    assert read_member(path, 5) == content("first", 5)
    packed(tmp_path / "b.zip", "other").replace(path)
    assert read_member(path, 5) == content("other", 5)


def test_a_zip_that_is_cut_short_is_damaged_and_read_again_when_it_is_whole(tmp_path: Path) -> None:
    path = packed(tmp_path / "a.zip", "work")
    whole = path.read_bytes()
    path.write_bytes(whole[:-30])
    for _ in range(2):
        with pytest.raises(UnreadableMemberError):
            read_member(path, 0)
    path.write_bytes(whole)
    assert read_member(path, 0) == content("work", 0)


def test_several_who_ask_one_zip_at_once_get_what_they_asked_for(tmp_path: Path) -> None:
    path = packed(tmp_path / "a.zip", "work")
    with ThreadPoolExecutor(8) as pool:
        read = list(pool.map(lambda number: read_member(path, number), range(COUNT)))
    assert read == [content("work", number) for number in range(COUNT)]


def test_a_question_that_fails_leaves_the_zip_to_the_next_one(tmp_path: Path) -> None:
    path = packed(tmp_path / "a.zip", "work")
    with pytest.raises(KeyError):
        ask_archive(path, lambda opened: opened.read("none"))
    assert read_member(path, 1) == content("work", 1)


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not list open files so")
def test_no_zip_stays_open(tmp_path: Path) -> None:
    path = packed(tmp_path / "a.zip", "work")
    read_member(path, 0)
    open_files = {os.path.realpath(one) for one in Path("/proc/self/fd").iterdir()}
    assert str(path) not in open_files
