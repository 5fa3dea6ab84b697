"""A workbook that is read in a process of its own takes nothing else along."""

import os
import time
from typing import TYPE_CHECKING

import pytest

from gripcourse.machine.content import NamedBytes, Readable
from gripcourse.submission.apart import Read, read_apart
from gripcourse.submission.model import Rejected
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook

if TYPE_CHECKING:
    from pathlib import Path


def hang(_: Readable) -> Rejected:
    time.sleep(60)
    raise AssertionError


def die(_: Readable) -> Rejected:
    os._exit(9)


def grow(_: Readable) -> Rejected:
    raise AssertionError(len(bytearray(1 << 40)))


def test_a_workbook_reads_the_same(blank: bytes, tmp_path: "Path") -> None:
    path = tmp_path / "answers.xlsx"
    path.write_bytes(blank)
    found = read_apart(path)
    assert isinstance(found, RawWorkbook)
    assert found == read_workbook(path)


@pytest.mark.parametrize("read", [hang, die, grow])
def test_what_hangs_dies_or_grows_is_a_refusal(read: Read) -> None:
    found = read_apart(NamedBytes("answers.xlsx", b"?"), read=read, seconds=0.5)
    assert isinstance(found, Rejected)
    assert (found.file, found.code) == ("answers.xlsx", "too_costly")
