"""Who checks one file is told what `grade` would read in it, of another format too."""

from collections.abc import Mapping

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.machine.office import Conversion
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.submission.model import Rejected
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.with_office import read_with_office
from hostile.small_workbook import PARTS, archive, holding

OPEN_DOCUMENT = archive(
    {"mimetype": b"application/vnd.oasis.opendocument.spreadsheet", "content.xml": b"<x/>"}
)
BARE = holding('<c r="E5"><f>E13*2</f></c>')
COMPUTED = holding('<c r="E5"><f>E13*2</f><v>80</v></c>')


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Let LibreOffice compute without being there; the names of the files that it gets."""
    names = list[str]()

    def made(files: Mapping[str, bytes], office: str, language: str) -> Conversion:
        assert (office, language) == ("soffice", "ru")
        names.extend(files)
        return Conversion(dict.fromkeys(files, COMPUTED), frozenset())

    monkeypatch.setattr("gripcourse.submission.with_office.converted", made)
    return names


def read(data: bytes, office: str | None = "soffice") -> RawWorkbook | Rejected:
    return read_with_office(NamedBytes("mine.ods", data), office, "ru")


def test_a_file_of_another_format_is_converted(asked: list[str]) -> None:
    found = read(OPEN_DOCUMENT)
    assert isinstance(found, RawWorkbook)
    assert (found.file, found.answers["force"].value) == ("mine.ods", 80)
    assert "LibreOffice converted it" in str(found.remarks[-1])
    assert [name.rpartition(".")[2] for name in asked] == ["ods"]


def test_results_that_are_not_stored_are_computed(asked: list[str]) -> None:
    found = read(BARE)
    assert isinstance(found, RawWorkbook)
    assert found.answers["force"].value == 80
    assert len(asked) == 1


def test_without_libreoffice_it_is_said_how_to_save_it(asked: list[str]) -> None:
    found = read(OPEN_DOCUMENT, None)
    assert isinstance(found, Rejected)
    assert found.code == WhyRefused.OPEN_DOCUMENT
    assert "Save it as an .xlsx" in str(found.reason)
    assert not asked


def test_what_it_cannot_make_more_of_it_does_not_get(asked: list[str]) -> None:
    assert isinstance(read(archive(PARTS)), RawWorkbook)
    assert isinstance(read(b"%PDF-1.7"), Rejected)
    assert not asked
