"""A workbook that spreadsheet programs open is read, whatever is damaged that no answer needs."""

import re
from collections.abc import Mapping
from typing import Final

import pytest

from gripcourse.machine.content import NamedBytes
from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.table import visible_sheets
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Reading, Rejected, Submission
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from hostile import foreign, harmless
from hostile.small_workbook import (
    HIDDEN,
    PARTS,
    RELATIONS,
    SHEET,
    archive,
    patched,
    quantities,
    stored,
)
from hostile.test_kinds import kinds_in

KINDS: Final = dict([*kinds_in(harmless), *kinds_in(foreign)])
LOOKS_LOST: Final = "styles of the workbook are damaged"
PART_DAMAGED: Final = "Parts of the workbook are damaged"
# What a percentage and a date show hangs on their format.
SHOWN: Final = {"loss", "angle"}


def read(data: bytes) -> Submission:
    raw = read_workbook(NamedBytes("answers.xlsx", data))
    assert isinstance(raw, RawWorkbook), raw
    return interpret(raw, quantities())


def values(work: Submission, but: set[str]) -> Mapping[str, tuple[Reading, float | None]]:
    return {name: (one.reading, one.value) for name, one in work.answers.items() if name not in but}


@pytest.mark.parametrize("name", KINDS)
def test_the_answers_are_those_of_the_sound_workbook(name: str) -> None:
    sound, work = read(archive(PARTS)), read(KINDS[name]())
    lost = any(LOOKS_LOST in str(one) for one in work.remarks)
    but = SHOWN if lost else set[str]()
    assert values(work, but) == values(sound, but)
    assert work.identity.student == sound.identity.student == "s001"


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("all styles past the last", LOOKS_LOST),
        ("styles that are gone", LOOKS_LOST),
        ("styles that nobody names", LOOKS_LOST),
        ("styles cut in the middle", LOOKS_LOST),
        ("styles of no bytes", LOOKS_LOST),
        ("styles without formats of cells", LOOKS_LOST),
        ("a format twice as long as any", LOOKS_LOST),
        ("a theme cut in the middle", PART_DAMAGED),
        ("properties cut in the middle", PART_DAMAGED),
        ("own properties cut in the middle", PART_DAMAGED),
        ("a pivot table cut in the middle", PART_DAMAGED),
        ("an encoding of a drawing that there is not", PART_DAMAGED),
        ("relations of a sheet cut in the middle", PART_DAMAGED),
    ],
)
def test_what_is_damaged_is_said(name: str, said: str) -> None:
    assert [said in str(one) for one in read(KINDS[name]()).remarks] == [True]


def test_of_a_sound_workbook_nothing_is_said() -> None:
    assert read(archive(PARTS)).remarks == ()


def test_numbers_that_have_no_style_lose_none() -> None:
    bare = patched(SHEET, lambda data: re.sub(rb' s="\d"', b"", data))
    without = {"xl/styles.xml": b"<styleSheet/>"}
    assert (
        read(bare).remarks
        == read(
            archive(
                {
                    **PARTS,
                    **without,
                    SHEET: PARTS[SHEET]
                    .replace(b' s="1"', b"")
                    .replace(b' s="2"', b"")
                    .replace(b' s="3"', b""),
                }
            )
        ).remarks
        == ()
    )


def test_many_damaged_parts_are_named_in_short() -> None:
    many = {f"xl/drawings/{'d' * 300}\x1b{number}.xml": b"<x" for number in range(50)}
    (said,) = read(archive({**PARTS, **many})).remarks
    assert len(str(said)) < 700
    assert "\x1b" not in str(said)


@pytest.mark.parametrize("part", [SHEET, HIDDEN, RELATIONS, "xl/workbook.xml", "_rels/.rels"])
def test_what_answers_or_identity_stand_in_must_be_sound(part: str) -> None:
    found = read_workbook(NamedBytes("answers.xlsx", patched(part, lambda data: data[:-9])))
    assert isinstance(found, Rejected)
    assert found.code == WhyRefused.INVALID_XML


def test_a_sheet_of_answers_that_is_gone_refuses_the_workbook_and_costs_no_points() -> None:
    gone = archive({name: data for name, data in PARTS.items() if name != SHEET})
    nowhere = patched(RELATIONS, lambda data: data.replace(b"worksheets/sheet1", b"sheets/1"))
    for data in (gone, nowhere):
        found = read_workbook(NamedBytes("answers.xlsx", data))
        assert isinstance(found, Rejected)
        assert found.code == WhyRefused.PART_MISSING


def test_an_answer_whose_text_is_not_in_the_file_is_not_taken_for_blank() -> None:
    answer = read(stored("4", "s")).answers["force"]
    assert answer.reading is Reading.UNREADABLE
    assert "not in the file" in str(answer.remarks[0])


def test_a_table_whose_numbers_may_have_been_percentages_is_refused() -> None:
    """A student's work is seen by a person; a table of marks is taken as it is."""
    lost = KINDS["styles that are gone"]()
    assert visible_sheets(lost) == WhyRefused.UNREADABLE_CONTENT
    assert not isinstance(visible_sheets(KINDS["a theme cut in the middle"]()), WhyRefused)
