"""What stands above the line in a cell means what it shows: 10 with a raised 6 is a million."""

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Answer, Reading
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from hostile.small_workbook import SHEET, holding, quantities, replaced

RAISED = '<vertAlign val="superscript"/>'
LOWERED = '<vertAlign val="subscript"/>'
CROSSED = "<strike/>"


def pieces(*written: tuple[str, str]) -> str:
    """Write a text of several looks."""
    return "".join(
        f'<r><rPr>{look}<sz val="11"/></rPr><t xml:space="preserve">{text}</t></r>'
        for look, text in written
    )


def answer(data: bytes, name: str) -> Answer:
    raw = read_workbook(NamedBytes("answers.xlsx", data))
    assert isinstance(raw, RawWorkbook)
    return interpret(raw, quantities()).answers[name]


def angle(*written: tuple[str, str]) -> Answer:
    cell = f'<c r="E9" t="inlineStr"><is>{pieces(*written)}</is></c>'
    return answer(replaced(SHEET, '<c r="E9" s="2"><v>45000</v></c>', cell), "angle")


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ([("", "10"), (RAISED, "6")], 1e6),
        ([("", "2,3·10"), (RAISED, "3")], 2300.0),
        ([("", "2·10"), (RAISED, "-3")], 0.002),
        ([("", "2·10"), (RAISED, "−3")], 0.002),
        ([("", "1,5·10"), (RAISED, "3"), ("", " Н")], 1500.0),
        ([("", "12"), (RAISED, ""), ("", "3")], 123.0),
        ([("", "D"), (LOWERED, "1"), ("", " = 63")], 63.0),
    ],
)
def test_a_raised_number_is_a_power(written: list[tuple[str, str]], meant: float) -> None:
    found = answer(holding(f'<c r="E5" t="inlineStr"><is>{pieces(*written)}</is></c>'), "force")
    assert found.value == pytest.approx(meant)


def test_so_it_is_in_the_table_of_texts() -> None:
    shared = replaced(
        "xl/sharedStrings.xml",
        "<r><t>63</t></r><r><t> мм</t></r>",
        pieces(("", "10"), (RAISED, "2")),
    )
    assert answer(shared, "bore").value == 100.0


@pytest.mark.parametrize("sign", ["o", "о", "O", "О"])
def test_a_raised_letter_o_is_a_degree(sign: str) -> None:
    cell = f'<c r="E9" t="inlineStr"><is>{pieces(("", "30"), (RAISED, sign))}</is></c>'
    found = answer(
        replaced("xl/worksheets/sheet1.xml", '<c r="E9" s="2"><v>45000</v></c>', cell), "angle"
    )
    assert found.value == 30.0


def test_a_raised_zero_may_be_a_degree_or_a_power_and_is_no_number() -> None:
    cell = f'<c r="E9" t="inlineStr"><is>{pieces(("", "30"), (RAISED, "0"))}</is></c>'
    found = answer(
        replaced("xl/worksheets/sheet1.xml", '<c r="E9" s="2"><v>45000</v></c>', cell), "angle"
    )
    assert found.reading is Reading.UNREADABLE


def force(*written: tuple[str, str]) -> Answer:
    return answer(holding(f'<c r="E5" t="inlineStr"><is>{pieces(*written)}</is></c>'), "force")


def test_a_lowered_digit_is_no_digit_of_the_number() -> None:
    assert force(("", "63"), (LOWERED, "1")).reading is Reading.UNREADABLE


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ([(CROSSED, "12"), ("", "5")], 5.0),
        ([(CROSSED, "12,5"), ("", " 13,1")], 13.1),
        ([("", "13,1"), (CROSSED, "5")], 13.1),
        ([('<strike val="0"/>', "12"), ("", "5")], 125.0),
        ([(CROSSED, "12")], 12.0),
    ],
)
def test_a_part_that_is_crossed_out_does_not_count(
    written: list[tuple[str, str]], meant: float
) -> None:
    found = force(*written)
    assert found.value == meant
    told = {str(one) for one in found.remarks}
    is_told = "What is crossed out in the cell was left out." in told
    assert is_told is (len(written) > 1 and written[0][0] != '<strike val="0"/>')


def test_a_cell_in_which_only_a_blank_is_not_crossed_out_is_unreadable() -> None:
    assert force((CROSSED, "12"), ("", " ")).reading is Reading.UNREADABLE


def test_a_verdict_that_was_crossed_out_is_not_given() -> None:
    cell = f'<c r="E8" t="inlineStr"><is>{pieces((CROSSED, "да"), ("", " нет"))}</is></c>'
    found = answer(replaced(SHEET, '<c r="E8" t="s"><v>2</v></c>', cell), "holds")
    assert found.value == 0.0
