"""LibreOffice computes and converts what it is given, and one bad file takes no other along."""

import io

import pytest
from openpyxl import Workbook, load_workbook

from gripcourse.machine.office import converted, office_command


def workbook() -> bytes:
    book = Workbook()
    sheet = book.active
    assert sheet is not None
    sheet["A1"] = 2
    sheet["A2"] = "=A1*21"
    sheet["A3"] = '=VALUE("1,5")*2'
    sheet["A4"] = '=WEBSERVICE("http://127.0.0.1:9/")'
    stream = io.BytesIO()
    book.save(stream)
    return stream.getvalue()


@pytest.mark.office
def test_formulas_without_results_are_computed_as_the_course_writes_numbers() -> None:
    office = office_command()
    assert office is not None
    made = converted({"0.xlsx": workbook(), "1.xls": b"\xd0\xcf\x11\xe0"}, office, "ru")
    sheet = load_workbook(io.BytesIO(made["0.xlsx"]), data_only=True).active
    assert sheet is not None
    assert (sheet["A2"].value, sheet["A3"].value) == (42, 3)
    assert not isinstance(sheet["A4"].value, int | float)


def test_where_nothing_can_be_started_nothing_is_converted() -> None:
    assert converted({"0.xlsx": b"?"}, "true", "ru") == {}
