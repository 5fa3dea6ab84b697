"""Workbooks that somebody changed by hand to be taken for another's, or for better than they are.

Each is judged rightly, or a person is told: nothing is graded for who did not do it without a word.
"""

import io
import re
import zipfile
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Final, TypeAlias

import pytest

from gripcourse.batch.one_file import grade_file
from gripcourse.grading.model import FlagCode, Report
from gripcourse.grading.outcome import Outcome
from gripcourse.machine.content import NamedBytes
from gripcourse.text.words import Words
from hostile.small_workbook import archive
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

Change: TypeAlias = Callable[[str], str]

NAMES: Final = "xl/workbook.xml"
GIVENS: Final = "xl/worksheets/sheet1.xml"
DRIVE: Final = "xl/worksheets/sheet3.xml"
IDENTITY: Final = "xl/worksheets/sheet8.xml"
PROPERTIES: Final = "docProps/custom.xml"

ASKED: Final = "drive_force"
PLACE: Final = "'2. Привод'!$E$6<"
ANSWER: Final = re.compile(r'<c r="E6"[^>]*>.*?</c>')
SAID: Final = re.compile(r'<c r="B(\d)".*?</c>')


def members_of(data: bytes) -> dict[str, bytes]:
    with zipfile.ZipFile(io.BytesIO(data)) as opened:
        return {one: opened.read(one) for one in opened.namelist()}


def changed(data: bytes, changes: Mapping[str, Change]) -> bytes:
    """Rewrite members of a workbook; a change that changes nothing is a fault."""
    members = members_of(data)
    for name, change in changes.items():
        before = members[name].decode()
        members[name] = change(before).encode()
        assert members[name] != before.encode(), name
    return archive(members)


def replacing(before: str, after: str) -> Change:
    return lambda text: text.replace(before, after)


@pytest.fixture(scope="module")
def works(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, bytes]:
    """Workbooks of two students, filled in."""
    folder = tmp_path_factory.mktemp("works")
    return {
        one: issued.hand_in(one, forget_one_jaw, folder / f"{one}.xlsx").read_bytes()
        for one in ("s01", "s02")
    }


def graded(issued: "Classroom", data: bytes, name: str = "work.xlsx") -> Report:
    return grade_file(NamedBytes(name, data), issued.context)


def codes(report: Report) -> set[FlagCode]:
    return {one.code for one in report.flags} - {FlagCode.NOT_JUDGED}


def identity_of(other: bytes, fields: str) -> Change:
    """Put cells of another's hidden sheet into the place of one's own; `1` names the student."""
    theirs = {one[1]: one[0] for one in SAID.finditer(members_of(other)[IDENTITY].decode())}
    return lambda text: SAID.sub(lambda one: theirs[one[1]] if one[1] in fields else one[0], text)


@pytest.mark.parametrize("fields", ["1", "15", "12345"])
def test_who_puts_an_identity_into_anothers_workbook_has_to_explain_it(
    issued: "Classroom", works: Mapping[str, bytes], fields: str
) -> None:
    forged = changed(works["s01"], {IDENTITY: identity_of(works["s02"], fields)})
    report = graded(issued, forged)
    assert (report.student, report.judged) == ("", False)
    assert codes(report) == {FlagCode.WHO_HANDED_IN}


def test_who_puts_a_whole_identity_into_anothers_workbook_is_known_by_its_given_values(
    issued: "Classroom", works: Mapping[str, bytes]
) -> None:
    theirs = members_of(works["s02"])
    members = {**members_of(works["s01"]), **{one: theirs[one] for one in (IDENTITY, PROPERTIES)}}
    report = graded(issued, archive(members))
    assert report.student == "s02"
    assert FlagCode.GIVENS_CHANGED in codes(report)


def test_a_signature_does_not_prove_another_student(
    issued: "Classroom", works: Mapping[str, bytes]
) -> None:
    report = graded(issued, changed(works["s01"], {IDENTITY: identity_of(works["s02"], "5")}))
    assert (report.student, codes(report)) == ("", {FlagCode.WHO_HANDED_IN})


def test_another_variant_is_named_and_what_was_issued_counts(
    issued: "Classroom", works: Mapping[str, bytes]
) -> None:
    honest = graded(issued, works["s01"])
    report = graded(issued, changed(works["s01"], {IDENTITY: identity_of(works["s02"], "2")}))
    assert (report.student, report.variant, report.score) == ("s01", "001", honest.score)
    assert codes(report) == {FlagCode.IDENTITY_CHANGED}


@pytest.mark.parametrize("name", ["s02.xlsx", "s02/a.xlsx", "Шевченко_s02_assignsubmission_file/a"])
def test_anothers_signed_workbook_under_ones_own_name_goes_to_a_person(
    issued: "Classroom", works: Mapping[str, bytes], name: str
) -> None:
    report = graded(issued, works["s01"], name)
    assert (report.student, codes(report)) == ("", {FlagCode.WHO_HANDED_IN})


@pytest.mark.parametrize("written", ["ѕ01", " s01", "s01\u200f", "S01", "ｓ01", "s1"])
def test_an_id_that_looks_alike_is_nobodys(
    issued: "Classroom", works: Mapping[str, bytes], written: str
) -> None:
    forged = changed(works["s01"], {IDENTITY: replacing("<t>s01</t>", f"<t>{written}</t>")})
    report = graded(issued, forged)
    assert (report.student, codes(report)) == ("", {FlagCode.UNKNOWN_STUDENT})


def test_a_person_who_decides_learns_whose_the_workbook_was(
    issued: "Classroom", works: Mapping[str, bytes]
) -> None:
    forged = changed(works["s01"], {IDENTITY: identity_of(works["s02"], "12345")})
    context = issued.context
    decided = type(context)(
        context.course, context.policy, context.register, whose={"a.xlsx": "s02"}
    )
    report = grade_file(NamedBytes("a.xlsx", forged), decided)
    (said,) = (one for one in report.flags if one.code is FlagCode.IDENTITY_CHANGED)
    assert (report.student, said.others) == ("s02", ("s01",))


@pytest.mark.parametrize(
    "reference", ["22650.588<", "[1]Sheet1!$E$6<", "OFFSET('2. Привод'!$E$7,-1,0)<", "#REF!<"]
)
def test_of_a_name_that_is_no_cell_of_the_workbook_nothing_is_read_but_what_its_row_holds(
    issued: "Classroom", works: Mapping[str, bytes], reference: str
) -> None:
    """Cutting a cell and pasting it over another one leaves such a name to an honest student."""
    honest = graded(issued, works["s01"])
    report = graded(issued, changed(works["s01"], {NAMES: replacing(PLACE, reference)}))
    (found,) = (one for one in report.findings if one.quantity == ASKED)
    (there,) = (one for one in honest.findings if one.quantity == ASKED)
    assert (found.typed, report.score) == (there.typed, honest.score)


@pytest.mark.parametrize("reference", ["'2. Привод'!$E$7<", "'Задание'!$E$42<"])
def test_an_answer_is_found_by_its_title_where_its_name_was_moved(
    issued: "Classroom", works: Mapping[str, bytes], reference: str
) -> None:
    """The first answer of a section too, above which no other one stands."""
    honest = graded(issued, works["s01"])
    report = graded(issued, changed(works["s01"], {NAMES: replacing(PLACE, reference)}))
    assert (report.score, codes(report)) == (honest.score, {FlagCode.CELLS_MOVED})


def test_what_programs_would_read_differently_is_refused(
    issued: "Classroom", works: Mapping[str, bytes]
) -> None:
    """A cell, a row or a sheet that is there twice."""
    for member, change in {
        DRIVE: lambda text: ANSWER.sub(lambda one: one[0] * 2, text, count=1),
        NAMES: replacing('name="3. Усилие зажима"', 'name="2. Привод"'),
    }.items():
        report = graded(issued, changed(works["s01"], {member: change}))
        assert (report.judged, codes(report)) == (False, {FlagCode.REJECTED})


@pytest.mark.parametrize(
    ("formula", "is_outside"),
    [
        ("[1]Sheet1!$A$1", True),
        ("2*'[12]Мои расчёты'!B7+1", True),
        ("[3]!force", True),
        ("Table1[1]", False),
        ("SUM(Table1[[#This Row],[1]])", False),
        ("'2. Привод'!E7", False),
    ],
)
def test_answers_from_another_workbook_are_named(
    issued: "Classroom",
    works: Mapping[str, bytes],
    formula: str,
    is_outside: bool,  # noqa: FBT001 (a parameter of the test)
) -> None:
    cell = f'<c r="E6"><f>{formula}</f><v>22650.6</v></c>'
    report = graded(issued, changed(works["s01"], {DRIVE: lambda t: ANSWER.sub(cell, t, count=1)}))
    said = " ".join(Words("en").say(one) for one in report.remarks)
    assert ("another workbook, which was not handed in: 2. Привод!E6" in said) is is_outside
    assert report.unverified


TYPED: Final = {
    "−12,5 кН": -12500.0,
    "１２，５": 12.5,
    "\u200f12,5\u200e": 12.5,
    "\u202e12,5": None,
    "1e400": None,
    "-1E400": None,
    "1e-400": None,
    "-0.0e9": 0.0,
    "٢٢": 22.0,
    "२२": None,
    "∞": None,
    "12,5 … 13": None,
    "9" * 400: None,
    "12,5" + " " * 40_000: 12.5,
}


@pytest.mark.parametrize("typed", TYPED)
@pytest.mark.parametrize("kind", ["inlineStr", "n", "str"])
def test_a_text_is_read_for_what_it_says_or_not_at_all(
    issued: "Classroom", works: Mapping[str, bytes], typed: str, kind: str
) -> None:
    held = f"<is><t>{typed}</t></is>" if kind == "inlineStr" else f"<v>{typed}</v>"
    cell = f'<c r="E6" t="{kind}">{held}</c>'
    report = graded(issued, changed(works["s01"], {DRIVE: lambda t: ANSWER.sub(cell, t, count=1)}))
    (found,) = (one for one in report.findings if one.quantity == ASKED)
    assert found.given == TYPED[typed]
    assert (found.outcome is Outcome.UNREADABLE) is (found.given is None)
