"""What no spreadsheet program shows is no answer, and where programs disagree nobody guesses."""

import pytest

from gripcourse.submission.model import Reading, Rejected
from hostile.reading import as_student
from hostile.small_workbook import SHEET, TEXTS, holding, patched, quantities

ROW = b'<row r="12"><c r="E12"><v>9</v></c></row>'
FOR_SOME = b'<mc:AlternateContent xmlns:mc="m"><mc:Choice Requires="x">%s</mc:Choice>'
FOR_OTHERS = b"<mc:Fallback>%s</mc:Fallback></mc:AlternateContent>"


def for_some_programs(content: bytes) -> bytes:
    return FOR_SOME % content + FOR_OTHERS % content


def without_stroke(part: bytes) -> bytes:
    return part.replace(b'<c r="E12"/>', b"")


def rows_behind_the_cells() -> bytes:
    return patched(
        SHEET, lambda part: without_stroke(part).replace(b"</sheetData>", b"</sheetData>" + ROW)
    )


def rows_of_an_extension() -> bytes:
    extension = b"<extLst><ext>%s</ext></extLst></worksheet>" % ROW
    return patched(SHEET, lambda part: without_stroke(part).replace(b"</worksheet>", extension))


@pytest.mark.parametrize("data", [rows_behind_the_cells(), rows_of_an_extension()])
def test_a_row_that_is_none_of_the_sheet_holds_no_answer(data: bytes) -> None:
    read = as_student(data, quantities())
    assert read.submission is not None
    assert read.submission.answers["stroke"].reading is Reading.BLANK
    assert read.submission.answers["force"].value == 22941.5


def test_a_range_that_is_none_of_the_sheet_merges_nothing() -> None:
    merged = b'<extLst><ext><mergeCell ref="D5:E5"/></ext></extLst></worksheet>'
    data = patched(SHEET, lambda part: part.replace(b"</worksheet>", merged))
    read = as_student(data, quantities())
    assert read.submission is not None
    assert read.submission.answers["force"].value == 22941.5


def test_texts_of_another_kind_do_not_count() -> None:
    data = patched(
        TEXTS, lambda part: part.replace(b"<si>", b'<x:si xmlns:x="x"><t>7</t></x:si><si>', 1)
    )
    read = as_student(data, quantities())
    assert read.submission is not None
    assert read.submission.answers["bore"].value == 63.0


@pytest.mark.parametrize(
    "data",
    [
        holding(b'<c r="E5">%s</c>' % for_some_programs(b"<v>7</v>")),
        holding(for_some_programs(b'<c r="E5"><v>7</v></c>')),
        patched(SHEET, lambda part: part.replace(ROW[:12], for_some_programs(b"") + ROW[:12], 1)),
        patched(TEXTS, lambda part: part.replace(b"<si>", for_some_programs(b"") + b"<si>", 1)),
        holding(b'<c r="E5"><v>1</v><v>2</v></c>'),
        holding(b'<c r="E5"><v>1<b/>2</v></c>'),
        holding(b'<c r="E5" t="inlineStr"><is><t>1</t></is><is><t>2</t></is></c>'),
    ],
)
def test_a_workbook_about_which_programs_disagree_is_refused(data: bytes) -> None:
    assert isinstance(as_student(data, quantities()).raw, Rejected)
