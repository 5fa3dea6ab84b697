"""A file is a path, or bytes under a name."""

from pathlib import Path

import pytest

from gripcourse.machine.content import NamedBytes, content_of, is_there, pure_path, shown_name


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
