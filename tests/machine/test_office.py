"""LibreOffice computes and converts what it is given, and one bad file takes no other along."""

import io
from pathlib import Path

import pytest
from openpyxl import Workbook, load_workbook

from gripcourse.machine.office import Conversion, converted, office_command, office_identity


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
    made = converted({"0.xlsx": workbook(), "1.xls": b"\xd0\xcf\x11\xe0"}, office, "ru").made
    sheet = load_workbook(io.BytesIO(made["0.xlsx"]), data_only=True).active
    assert sheet is not None
    assert (sheet["A2"].value, sheet["A3"].value) == (42, 3)
    assert not isinstance(sheet["A4"].value, int | float)


def test_what_a_program_gives_up_by_itself_is_told_from_what_it_was_stopped_in(
    tmp_path: Path,
) -> None:
    stopped = tmp_path / "stopped"
    stopped.write_text("#!/bin/sh\nkill -9 $$\n", encoding="utf-8")
    stopped.chmod(0o755)
    files = {"0.xlsx": b"?", "1.xls": b"!"}
    assert converted(files, "true", "ru") == Conversion({}, frozenset(files))
    assert converted(files, str(stopped), "ru") == Conversion({}, frozenset())


def test_another_version_is_another_program(tmp_path: Path) -> None:
    program, version = tmp_path / "soffice", tmp_path / "versionrc"
    program.write_bytes(b"starts it")
    without = office_identity(str(program))
    version.write_bytes(b"24.2")
    old = office_identity(str(program))
    version.write_bytes(b"24.8")
    assert len({without, old, office_identity(str(program)), office_identity(None)}) == 4
