"""What another program makes of a file adds to what the file stores, and never replaces it."""

from dataclasses import replace

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.submission.model import Rejected
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from gripcourse.submission.second import lacks_results, read_again, stores_zeros
from hostile.small_workbook import PARTS, SHEET, archive, holding, replaced, stored

BARE = holding('<c r="E5"><f>E13*2</f></c>')
COMPUTED = holding('<c r="E5"><f>E13*2</f><v>80</v></c>')


def read(data: bytes, made: bytes) -> RawWorkbook | Rejected:
    return read_again(NamedBytes("answers.xlsx", data), made)


def test_a_result_that_is_not_stored_is_taken_from_the_other_program() -> None:
    first = read_workbook(NamedBytes("answers.xlsx", BARE))
    again = read(BARE, COMPUTED)
    assert isinstance(first, RawWorkbook)
    assert isinstance(again, RawWorkbook)
    assert lacks_results(first)
    assert not lacks_results(again)
    assert again.answers["force"] == replace(first.answers["force"], value=80)
    assert again.digest == first.digest
    assert "LibreOffice computed" in str(again.remarks[-1])


def test_a_stored_result_is_preferred() -> None:
    other = replaced(SHEET, "<v>22.9415</v>", "<v>1</v>")
    again = read(BARE, other)
    assert isinstance(again, RawWorkbook)
    assert again.answers["ratio"].value == 22.9415


def test_where_all_results_are_zeros_nobody_computed_them() -> None:
    """As XlsxWriter stores them, until a spreadsheet program opens the file."""
    zeros = replaced(SHEET, "<v>22.9415</v>", "<v>0</v>")
    first = read_workbook(NamedBytes("answers.xlsx", zeros))
    assert isinstance(first, RawWorkbook)
    assert stores_zeros(first)
    again = read(zeros, archive(PARTS))
    assert isinstance(again, RawWorkbook)
    assert again.answers["ratio"].value == 22.9415
    assert again.other_results == ()
    assert "LibreOffice computed" in str(again.remarks[-1])
    assert read(zeros, zeros) == first
    sound = read_workbook(NamedBytes("answers.xlsx", archive(PARTS)))
    assert isinstance(sound, RawWorkbook)
    assert not stores_zeros(sound)


@pytest.mark.parametrize(
    ("computed", "others"),
    [("<v>22.94150001</v>", 0), ("<v>22.95</v>", 1), ("<v>1e999</v>", 1), ("<v></v>", 1)],
)
def test_a_result_that_is_not_what_the_formula_gives_is_shown(computed: str, others: int) -> None:
    sound = archive(PARTS)
    again = read(sound, replaced(SHEET, "<v>22.9415</v>", computed))
    assert isinstance(again, RawWorkbook)
    assert [one.stored.cell for one in again.other_results] == ["1. Расчёт!E7"] * others
    assert again.answers["ratio"].value == 22.9415


def test_an_error_or_a_text_in_place_of_a_number_is_another_result() -> None:
    old = '<c r="E7"><f>E5/1000</f><v>22.9415</v></c>'
    for kind, value in (("e", "#DIV/0!"), ("str", "22.9415"), ("b", "1")):
        made = replaced(SHEET, old, f'<c r="E7" t="{kind}"><v>{value}</v></c>')
        again = read(archive(PARTS), made)
        assert isinstance(again, RawWorkbook)
        assert len(again.other_results) == 1
    lost = read(replaced(SHEET, old, made_error(old)), archive(PARTS))
    assert isinstance(lost, RawWorkbook)
    assert lost.other_results == ()


def made_error(cell: str) -> str:
    return cell.replace("<v>22.9415</v>", "<v>#NAME?</v>").replace('r="E7"', 'r="E7" t="e"')


def test_a_file_that_stores_all_is_what_it_was() -> None:
    data = stored("5")
    assert read(data, COMPUTED) == read_workbook(NamedBytes("answers.xlsx", data))


def test_another_program_helps_no_file_that_is_refused_for_its_content() -> None:
    data = archive({"xl/workbook.xml": b"<!DOCTYPE x><workbook/>"})
    assert read(data, COMPUTED) == read_workbook(NamedBytes("answers.xlsx", data))


def test_what_another_program_could_not_read_is_refused_as_it_was() -> None:
    data = archive(
        {"mimetype": b"application/vnd.oasis.opendocument.spreadsheet", "content.xml": b"<x/>"}
    )
    refused = read(data, b"?")
    assert isinstance(refused, Rejected)
    assert refused.code == "ods"


def test_a_converted_file_is_read_under_its_own_name_and_digest() -> None:
    data = archive(
        {"mimetype": b"application/vnd.oasis.opendocument.spreadsheet", "content.xml": b"<x/>"}
    )
    again = read_again(NamedBytes("answers.ods", data), COMPUTED)
    assert isinstance(again, RawWorkbook)
    assert again.file == "answers.ods"
    assert again.answers["force"].value == 80
    assert "converted" in str(again.remarks[-1])


def test_a_text_that_libreoffice_would_cut_short_is_not_taken_from_it() -> None:
    """Seen: Gnumeric writes 34,5 with a bold 3 so, and LibreOffice 7.4 opens it as a blank cell."""
    kind = b"application/vnd.oasis.opendocument.spreadsheet"
    cell = '<p xmlns="urn:oasis:names:tc:opendocument:xmlns:text:1.0"><span>3{}</span></p>'
    for text, is_read in (("4,5", True), ("<span>4,5</span>", False)):
        content = cell.format(text).encode()
        data = archive({"mimetype": kind, "content.xml": content})
        again = read_again(NamedBytes("answers.ods", data), COMPUTED)
        assert isinstance(again, RawWorkbook) is is_read
