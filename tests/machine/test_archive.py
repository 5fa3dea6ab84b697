"""What lies in a zip is named as its owner named it, and nothing in it leads anywhere."""

import stat
import struct
import unicodedata
import warnings
import zipfile
from pathlib import Path

import pytest

from gripcourse.errors import UsageError
from gripcourse.machine import archive as module
from gripcourse.machine.archive import (
    UnreadableMemberError,
    Unusable,
    is_bundle,
    members_of,
    read_member,
)


def packed(path: Path, *names: str, data: bytes = b"work") -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in names:
            archive.writestr(name, data)
    return path


def recoded(path: Path, placeholder: bytes, name: bytes) -> Path:
    """Write a name of the same length over a placeholder, without the flag of UTF-8."""
    assert len(placeholder) == len(name)
    path.write_bytes(path.read_bytes().replace(placeholder, name))
    return path


NAME = "Иванов Иван_12_assignsubmission_file/Ответ.xlsx"


@pytest.mark.parametrize("encoding", ["cp866", "utf-8"])
def test_a_name_without_the_flag_is_read_in_the_packers_own_encoding(
    tmp_path: Path, encoding: str
) -> None:
    name = NAME.encode(encoding)
    path = packed(tmp_path / "a.zip", "x" * len(name))
    (one,) = members_of(recoded(path, b"x" * len(name), name))
    assert one.name == NAME


def test_a_name_in_pieces_is_put_together(tmp_path: Path) -> None:
    (one,) = members_of(packed(tmp_path / "a.zip", unicodedata.normalize("NFD", "Йод.xlsx")))
    assert one.name == "Йод.xlsx"


@pytest.mark.parametrize(
    "name", ["../a.xlsx", "b/../../a.xlsx", "/etc/a.xlsx", "..\\a.xlsx", "C:\\a.xlsx"]
)
def test_a_name_that_leads_out_is_refused(tmp_path: Path, name: str) -> None:
    (one,) = members_of(packed(tmp_path / "a.zip", name))
    assert one.unusable is Unusable.UNSAFE_PATH
    assert [path.name for path in tmp_path.iterdir()] == ["a.zip"]


def test_a_link_is_refused(tmp_path: Path) -> None:
    info = zipfile.ZipInfo("a.xlsx")
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as archive:
        archive.writestr(info, "/etc/passwd")
    (one,) = members_of(tmp_path / "a.zip")
    assert one.unusable is Unusable.NO_FILE


def sized(path: Path, size: int) -> Path:
    """Let an archive of one member declare another size of it, in both of its places."""
    data = path.read_bytes()
    for mark, place in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
        at = data.index(mark) + place
        data = data[:at] + struct.pack("<I", size) + data[at + 4 :]
    path.write_bytes(data)
    return path


def test_a_member_that_declares_gigabytes_is_refused(tmp_path: Path) -> None:
    path = sized(packed(tmp_path / "a.zip", "a.xlsx"), 4_000_000_000)
    (one,) = members_of(path)
    assert one.unusable is Unusable.TOO_LARGE


def test_a_member_larger_than_it_declares_is_refused_while_it_is_read(tmp_path: Path) -> None:
    path = sized(packed(tmp_path / "a.zip", "a.xlsx", data=bytes(3_000_000)), 10)
    (one,) = members_of(path)
    assert one.unusable is None
    with pytest.raises(UnreadableMemberError):
        read_member(path, one.place)


def test_no_more_is_read_than_may_be(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = packed(tmp_path / "a.zip", "a.xlsx", data=bytes(1000))
    monkeypatch.setattr(module, "LARGEST_MEMBER", 999)
    with pytest.raises(UnreadableMemberError):
        read_member(path, 0)


def test_two_members_of_one_name_are_both_there(tmp_path: Path) -> None:
    with pytest.warns(UserWarning, match="Duplicate"):
        path = packed(tmp_path / "a.zip", "a.xlsx", "a.xlsx")
    assert [one.name for one in members_of(path)] == ["a (2).xlsx", "a.xlsx"]


def test_names_that_look_numbered_already_are_numbered_on(tmp_path: Path) -> None:
    names = ["x" + " (2)" * count for count in range(1200)]
    with pytest.warns(UserWarning, match="Duplicate"):
        path = packed(tmp_path / "a.zip", *names, "x")
    assert len({one.name for one in members_of(path)}) == len(names) + 1


@pytest.mark.parametrize("name", [".", "", "./", "/", "a/.."])
def test_members_without_a_name_are_not_read(tmp_path: Path, name: str) -> None:
    path = tmp_path / "a.zip"
    with zipfile.ZipFile(path, "w") as archive, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for _ in range(2):
            archive.writestr(zipfile.ZipInfo(name), b"1")
    assert {one.unusable for one in members_of(path)} <= {Unusable.UNSAFE_PATH}


@pytest.mark.parametrize("method", [zipfile.ZIP_LZMA, zipfile.ZIP_BZIP2])
def test_what_is_packed_in_a_rare_way_is_not_unpacked(tmp_path: Path, method: int) -> None:
    """A hundred bytes of bzip2 are a hundred megabytes, and its library unpacks them whole."""
    path = tmp_path / "a.zip"
    with zipfile.ZipFile(path, "w", method) as archive:
        archive.writestr("a.xlsx", bytes(range(256)) * 40)
    (one,) = members_of(path)
    assert one.unusable is Unusable.METHOD
    with pytest.raises(UnreadableMemberError):
        read_member(path, one.place)


def test_a_damaged_member_is_said_to_be_unreadable(tmp_path: Path) -> None:
    path = packed(tmp_path / "a.zip", "a.xlsx", data=bytes(range(256)) * 40)
    data = bytearray(path.read_bytes())
    for place in range(60, 100):
        data[place] ^= 0x5A
    path.write_bytes(data)
    with pytest.raises(UnreadableMemberError):
        read_member(path, 0)


def test_what_is_no_zip_is_refused_in_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "a.zip").write_bytes(b"PK\x03\x04 and no more")
    with pytest.raises(UsageError) as refused:
        members_of(tmp_path / "a.zip")
    assert "damaged" in str(refused.value)


def test_a_zip_that_broke_off_behind_a_zip_inside_is_damaged(tmp_path: Path) -> None:
    """Its last list of members is the one of that zip: one work is not all that were handed in."""
    inside = packed(tmp_path / "inside.xlsx", "[Content_Types].xml").read_bytes()
    whole = tmp_path / "whole.zip"
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_STORED) as archive:
        archive.writestr("first.xlsx", inside)
        archive.writestr("second.xlsx", inside)
    content = whole.read_bytes()
    broken = tmp_path / "broken.zip"
    broken.write_bytes(content[: content.index(b"second.xlsx")])
    assert zipfile.is_zipfile(broken)
    for ask in (is_bundle, members_of):
        with pytest.raises(UsageError, match="damaged"):
            ask(broken)
