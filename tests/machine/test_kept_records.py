"""Values that come one by one are found again, but for what was damaged."""

from hashlib import sha256
from pathlib import Path

import pytest

from gripcourse.machine.kept_records import kept_records, new_records

KEYS = [sha256(name.encode()).digest() for name in ("one", "two", "three")]


def found(folder: Path) -> list[object]:
    with kept_records(folder) as find:
        return [find(key) for key in KEYS]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    folder = tmp_path / "private" / "records"
    records = new_records(folder)
    for number, key in enumerate(KEYS[:2]):
        records.add(key, {"number": number})
    return folder


def test_what_was_kept_comes_back_and_nothing_else(folder: Path) -> None:
    assert found(folder) == [{"number": 0}, {"number": 1}, None]


def test_every_process_adds_to_a_file_of_its_own(folder: Path) -> None:
    new_records(folder).add(KEYS[2], "third")
    assert found(folder) == [{"number": 0}, {"number": 1}, "third"]
    assert len(list(folder.iterdir())) == 2


def test_nobody_else_may_read_it(folder: Path) -> None:
    [path] = folder.iterdir()
    assert path.stat().st_mode & 0o077 == folder.stat().st_mode & 0o077 == 0


def test_what_somebody_else_could_have_written_is_not_taken(folder: Path) -> None:
    [path] = folder.iterdir()
    path.chmod(0o620)
    assert found(folder) == [None, None, None]


@pytest.mark.parametrize("left", [0, 5, 72, 80])
def test_half_a_value_takes_none_before_it_along(folder: Path, left: int) -> None:
    [path] = folder.iterdir()
    whole = path.read_bytes()
    second = len(whole) // 2
    path.write_bytes(whole[: second + left])
    assert found(folder) == [{"number": 0}, None, None]


def test_a_changed_value_is_not_taken(folder: Path) -> None:
    [path] = folder.iterdir()
    whole = bytearray(path.read_bytes())
    whole[80] ^= 1
    path.write_bytes(whole)
    assert found(folder) == [None, {"number": 1}, None]


def test_a_full_disk_leaves_what_was_kept_before(folder: Path) -> None:
    records = new_records(folder)
    records.add(KEYS[2], "third")
    if not Path("/dev/full").exists():
        pytest.skip("no device that is always full")
    with Path("/dev/full").open("r+b", buffering=0) as stream:
        full = type(records)(records.path, stream)
        with pytest.raises(OSError, match=records.path.name):
            full.add(KEYS[0], "lost")
    assert found(folder) == [{"number": 0}, {"number": 1}, "third"]


def test_a_folder_that_is_not_there_has_nothing(tmp_path: Path) -> None:
    assert found(tmp_path / "nowhere") == [None, None, None]
