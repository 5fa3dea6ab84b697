"""Everything that people type into a cell, as spreadsheet programs store it: one list, one test.

What ru-RU and uk-UA sessions store was tried in LibreOffice 7.4; a text cell keeps what was typed.
"""

import socket
import threading
from dataclasses import dataclass
from datetime import date, datetime, time
from typing import TYPE_CHECKING

import pytest

from gripcourse.solver.plan import Plan
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Answer, Identity, Reading
from gripcourse.submission.raw import CellValue, RawCell, RawWorkbook
from gripcourse.text.words import LANGUAGES, Words

if TYPE_CHECKING:
    from .conftest import Returned

FORCE = "drive_force"  # in N
BORE = "bore_required"  # in mm
ANGLE = "arm_angle_open"  # in °
RATIO = "velocity_ratio"  # a plain number
PRESSURE = "bearing_stress"  # in MPa
WHERE = "2. Привод!E6"

AS_TEXT = "The cell holds text"
CONVERTED = "Read as"
UNFIT = "does not fit"
UNKNOWN = "no known unit"
A_DATE = "into the date"
TYPED_DATE = "looks like a date"
SEVERAL = "One number is needed"
NO_NUMBER = "does not begin with a number"
LETTER = "letter stands among"
ERROR = "gives the error"


@dataclass(frozen=True, slots=True)
class Row:
    """What a cell holds, and what must be made of it.

    Attributes:
        stored: by the spreadsheet program.
        meant: the value in the declared unit; None for an unreadable answer.
        said: a part of what the student is told; empty where nothing is to be said.
    """

    stored: CellValue
    meant: float | None
    said: str = ""
    quantity: str = BORE
    number_format: str = "General"
    error: bool = False
    formula: str = ""


def text(typed: str, meant: float | None, said: str = AS_TEXT, quantity: str = BORE) -> Row:
    return Row(typed, meant, said, quantity, "@")


A_DAY = datetime(2026, 5, 1)  # noqa: DTZ001 - cells have no zone

TYPED_IN_SESSIONS = (
    # 1,5: a number in both sessions, a text in an `@` cell, a number under 0,000
    Row(1.5, 1.5),
    text("1,5", 1.5),
    Row(1.5, 1.5, number_format="0.000"),
    # 1.5: a text in ru, a date in uk, a serial number under 0,000
    text("1.5", 1.5),
    Row(A_DAY, None, A_DATE, number_format="dd/mm/yy"),
    Row(46143, None, A_DATE, number_format="0.000"),
    # 12.5, 31.12, 10.10, 25.1: a text in ru, dates in uk, serials under 0,000
    *(text(typed, float(typed)) for typed in ("12.5", "31.12", "10.10", "25.1")),
    *(Row(datetime(2026, m, d), None, A_DATE) for d, m in ((12, 5), (31, 12), (10, 10), (25, 1))),  # noqa: DTZ001
    *(Row(serial, None, A_DATE, number_format="0.000") for serial in (46154, 46387, 46305, 46047)),
    # 1.05 is the same day as 1.5
    text("1.05", 1.05),
    Row(A_DAY, None, "1.5 or 1.05", number_format="dd/mm/yy"),
    # 1.25, 0.5, 32.1, 2.50: texts everywhere
    *(text(typed, float(typed)) for typed in ("1.25", "0.5", "32.1", "2.50")),
    # 1.5.26 and 1.май
    text("1.5.26", None, TYPED_DATE),
    text("1.май", None, TYPED_DATE),
    text("1 мая", None, TYPED_DATE),
    text("1 трав.", None, TYPED_DATE),
    text("5 May", None, TYPED_DATE),
    Row(date(1987, 5, 1), None, "5.1987"),
    # 5 % and 5,5 %: fractions with a percent format, a text in an `@` cell
    Row(0.05, 0.05, "", RATIO, "0.00%"),
    Row(0.055, 0.055, "", RATIO, "0.00%"),
    Row(0.05, 0.05, "percent format", BORE, "0.00%"),
    text("5%", 0.05, CONVERTED, RATIO),
    text("5,5 %", 0.055, CONVERTED, RATIO),
    Row(0.05, 0.05, "", RATIO),
    # 1 250,5 with a space, a no-break space, a narrow one
    Row(1250.5, 1250.5),
    *(text(f"1{space}250,5", 1250.5) for space in " \u00a0\u202f\u2009\u2007"),
    # minus signs, about, a unit, a power of ten
    *(text(f"{minus}12,5", -12.5) for minus in "-\u2212\u2013\u2014\u2011"),
    text("≈12,5", 12.5, "left out"),
    text("12,5 Н", 12.5, AS_TEXT, FORCE),
    text("1,5*10^3", 1500.0),
    text("1,5·10^3", 1500.0),
    text("1,5 · 10 ^ 3", 1500.0),
    text("1,5×10³", 1500.0),
    text("1,5·10⁻³", 0.0015),
    text("1,5*10**3", 1500.0),
    # 1e3 and 1,5e3: numbers; as text with a Cyrillic exponent too
    Row(1000, 1000.0, number_format="0.00E+00"),
    Row(1500, 1500.0, number_format="0.00E+00"),
    *(text(f"1,5{letter}3", 1500.0) for letter in "eEеЕ"),
    text("1,5Е3Н", 1500.0, AS_TEXT, FORCE),
    text("1,5Е3 Н", 1500.0, AS_TEXT, FORCE),
    # 1:30
    Row(time(1, 30), None, "into a time"),
    text("1:30", None, SEVERAL),
    # =1,5*2: a formula with its result, or a text in an `@` cell
    Row(3, 3.0, formula="=1.5*2"),
    text("=1,5*2", None, "formula was typed"),
    # '12,5: the apostrophe is a mark of text, or stays in an `@` cell
    text("12,5", 12.5),
    text("'12,5", 12.5),
    # of an en-US session
    text("1,250.5", 1250.5, "groups of three"),
    text("1.250,5", 1250.5, "groups of three"),
    text("1,250", 1.25, "decimal sign"),
    text("1.250.000", 1_250_000.0, "groups of three"),
)

STORED_ERRORS = ("#DIV/0!", "#VALUE!", "#REF!", "#NAME?", "#NUM!", "#N/A", "#NULL!")
PASTED_ERRORS = ("#ДЕЛ/0!", "#ЗНАЧ!", "#ССЫЛКА!", "#ИМЯ?", "#ЧИСЛО!", "#Н/Д", "#ПУСТО!")
OTHER_ERRORS = ("#ІМ'Я?", "#SPILL!", "#CALC!", "#GETTING_DATA", "Err:502", "Ошибка:502")

ERRORS = (
    *(Row(sign, None, f"{ERROR} {sign}", error=True) for sign in STORED_ERRORS),
    *(text(sign, None, f"{ERROR} {sign}") for sign in (*STORED_ERRORS, *PASTED_ERRORS)),
    *(text(sign, None, f"{ERROR} {sign}") for sign in OTHER_ERRORS),
)

FORMULAS = (
    Row(None, None, "empty or not stored", formula="=2*3"),
    Row(0, 0.0, formula="=2*3"),  # some writers store a zero for every formula
    Row(46143, None, A_DATE, formula="=DATE(2026,5,1)"),
    Row(0.333333333333333, 0.333333333333333, formula="=1/3"),
)

UNITS = (
    *(text(f"12,5 {unit}", 12.5, AS_TEXT, FORCE) for unit in ("Н", "н", "N", "H", "ньютонів")),
    *(text(f"12,5 {unit}", 12500.0, CONVERTED, FORCE) for unit in ("кН", "kN", "кH", "kH", "КН")),
    *(text(f"2 {unit}", 19.6133, CONVERTED, FORCE) for unit in ("кгс", "kgf", "КГС", "кГ")),
    *(text(f"0,012 {unit}", 12000.0, CONVERTED, FORCE) for unit in ("МН", "MN", "MH")),
    *(text(f"60 {unit}", 60.0) for unit in ("мм", "mm", "ММ", "мм.", "[мм]", "міліметрів")),
    *(text(f"6 {unit}", 60.0, CONVERTED) for unit in ("см", "cm", "сантиметров")),
    *(text(f"0,06 {unit}", 60.0, CONVERTED) for unit in ("м", "m", "M", "метра")),
    *(text(f"6,3 {unit}", 6.3, AS_TEXT, PRESSURE) for unit in ("МПа", "MPa", "мпа")),
    text("6,3 Н/мм2", 6.3, CONVERTED, PRESSURE),
    *(text(f"63 {unit}", 6.3, CONVERTED, PRESSURE) for unit in ("бар", "bar")),
    text("64,2 кгс/см²", 6.2958693, CONVERTED, PRESSURE),
    *(text(f"0,5 {unit}", 28.6478897565, CONVERTED, ANGLE) for unit in ("рад", "rad", "радіан")),
    *(text(f"36,9{unit}", 36.9, AS_TEXT, ANGLE) for unit in ("°", "º", " град.", " градусів")),
    *(text(f"2,2 {unit}", 2.2, UNFIT) for unit in ("кВт", "kW", "Вт", "W", "ватт")),
    text("60 Н", 60.0, UNFIT),
    text("30 %", 30.0, UNFIT, ANGLE),
    text("12,5 попугаев", 12.5, UNKNOWN),
)

NOT_ONE_NUMBER = (
    *(text(typed, None, SEVERAL) for typed in ("12-13", "12…13", "12 – 13", "12±1", "12 13")),
    *(text(typed, None, SEVERAL) for typed in ("12; 13", "12 или 13", "60 мм, 5 мм", "7/2")),
    *(text(typed, None, SEVERAL) for typed in ("12x13", "2√2", "1,5π", "12 (13)", "5·103")),
    *(text(typed, None, NO_NUMBER) for typed in ("от 12 до 13", "NaN", "inf", "√2", "много")),
    *(text(typed, None, "too large") for typed in ("10^400", "1e400", "1" + "0" * 180 + "e200")),
    *(text(typed, None, "too small") for typed in ("1e-999", "10^-400", "-2·10⁻⁴⁰⁰", "4e-323 мкм")),
    Row(10**400, None, "too large"),
    Row(float("inf"), None, "too large"),
    Row(float("nan"), None, "too large"),
    text("7" * 1_000_000, None, "too long"),
    text("(" * 1_000_000, None, "too long"),
    text("1 " * 500_000, None, "too long"),
    Row(True, None, "logical"),
)

# A letter may be a unit, a tolerance or a power of a unit, or it stands for nobody knows what.
LETTERS_AND_DIGITS = (
    *(
        text(typed, 12.0, "tolerance")
        for typed in ("12H7", "12Н13", "12 мм H7", "12ммH7/m6", "12d11")
    ),
    text("12 Н (ок)", 12.0, UNKNOWN, FORCE),
    text("12мм2", 12.0, UNFIT, FORCE),
    *(text(typed, None, LETTER, FORCE) for typed in ("0b1", "1h30", "12Н13", "12 Н13", "4k7")),
    *(text(typed, None, LETTER) for typed in ("0b1", "1h30", "1d5", "1ч30мин")),
)

ROWS = (*LETTERS_AND_DIGITS, *TYPED_IN_SESSIONS, *ERRORS, *FORMULAS, *UNITS, *NOT_ONE_NUMBER)


def answer_of(row: Row, plan: Plan) -> Answer:
    cell = RawCell(row.stored, row.number_format, row.error, row.formula, WHERE)
    raw = RawWorkbook("a.xlsx", "", Identity("", "", "", {}, ""), "", {}, {row.quantity: cell}, ())
    return interpret(raw, plan.quantities.values()).answers[row.quantity]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row.stored!s:.24} in {row.quantity}")
def test_what_people_type_is_read_or_named_and_never_guessed(row: Row, plan: Plan) -> None:
    answer = answer_of(row, plan)
    said = " ".join(map(str, answer.remarks))
    assert answer.reading is (Reading.UNREADABLE if row.meant is None else Reading.READ), said
    assert answer.value == (None if row.meant is None else pytest.approx(row.meant, rel=1e-9))
    assert row.said in said
    assert bool(row.said) == bool(said)
    assert answer.cell == WHERE
    assert len(answer.typed) <= 80
    assert all(Words(language).say(one) for language in LANGUAGES for one in answer.remarks)


def test_a_megabyte_of_text_in_a_workbook_is_an_unreadable_answer(returned: "Returned") -> None:
    # A spreadsheet program cuts it at 32 767 characters; a file can hold more.
    quantity, path = returned.holding(f"<is><t>{'x' * 1_000_000}</t></is>", "inlineStr")
    answers = returned.read(path).answers
    assert answers[quantity].reading is Reading.UNREADABLE
    assert "too long" in str(answers[quantity].remarks[0])
    assert len(answers[quantity].typed) <= 80
    assert {one.reading for one in answers.values()} == {Reading.BLANK, Reading.UNREADABLE}


@pytest.mark.parametrize(
    ("number", "said"),
    [
        ("NaN", NO_NUMBER),
        ("INF", NO_NUMBER),
        ("1.#QNAN", SEVERAL),
        ("--5", NO_NUMBER),
        ("0x10", SEVERAL),
        ("9" * 10_000, "too long"),
        ("1" + "0" * 400, "too large"),
        ("1E400", "too large"),
    ],
)
def test_a_stored_number_that_is_none_spoils_only_its_own_cell(
    returned: "Returned", number: str, said: str
) -> None:
    quantity, path = returned.stored(number)
    answers = returned.read(path).answers
    assert answers[quantity].reading is Reading.UNREADABLE
    assert said in str(answers[quantity].remarks[0])
    assert answers[quantity].cell
    others = {one.reading for name, one in answers.items() if name != quantity}
    assert others == {Reading.BLANK}


def test_a_stored_number_with_a_decimal_comma_is_read_as_text(returned: "Returned") -> None:
    quantity, path = returned.stored("1,5")
    answer = returned.read(path).answers[quantity]
    assert answer.value == 1.5
    assert AS_TEXT in str(answer.remarks[0])


@pytest.mark.parametrize("stored", ["", "<v>12.5</v>"])
def test_a_formula_that_calls_the_network_calls_nobody(returned: "Returned", stored: str) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(0.2)
        called = threading.Event()

        def listen() -> None:
            try:
                server.accept()
                called.set()
            except TimeoutError:
                pass

        listening = threading.Thread(target=listen)
        listening.start()
        url = f"http://127.0.0.1:{server.getsockname()[1]}/"
        formula = f"<f>_xlfn.WEBSERVICE(&quot;{url}&quot;)</f>"
        quantity, path = returned.holding(formula + stored)
        answer = returned.read(path).answers[quantity]
        listening.join()
    assert not called.is_set()
    if stored:
        assert (answer.value, answer.figures) == (12.5, None)
    else:
        assert answer.reading is Reading.UNREADABLE
        assert "not stored" in str(answer.remarks[0])
        assert "WEBSERVICE" in answer.typed
