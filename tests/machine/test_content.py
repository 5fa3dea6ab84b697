"""A file is a path, or bytes under a name."""

import os
from pathlib import Path

import pytest

from gripcourse.machine.content import (
    NamedBytes,
    content_of,
    digest_of_content,
    is_there,
    pure_path,
    shown_name,
)


def test_bytes_under_a_name_are_a_file(tmp_path: Path) -> None:
    sent, path = NamedBytes("group/s01.xlsx", b"PK"), tmp_path / "s01.xlsx"
    path.write_bytes(b"PK")
    for source in (sent, path):
        assert is_there(source)
        assert content_of(source) == b"PK"
        assert pure_path(source).name == "s01.xlsx"
        assert shown_name(source).endswith("s01.xlsx")


def test_only_a_path_can_be_missing(tmp_path: Path) -> None:
    assert not is_there(tmp_path)
    with pytest.raises(FileNotFoundError):
        content_of(tmp_path / "nothing")


def test_who_claims_a_hundred_gigabytes_is_known_by_size_and_ends(tmp_path: Path) -> None:
    huge = [tmp_path / name for name in "abc"]
    for path, end in zip(huge, (b"1", b"1", b"2"), strict=True):
        with path.open("wb") as stream:
            stream.truncate(100 << 30)
            stream.seek(-1, os.SEEK_END)
            stream.write(end)
    one, same, other = map(digest_of_content, huge)
    assert one == same != other
