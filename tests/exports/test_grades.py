"""The table of grades is read by programs: one row for each file, and nothing that runs."""

import csv
import io
from collections.abc import Callable
from dataclasses import replace

import pytest

from gripcourse.exports.grades import Called, grades_text
from gripcourse.grading.model import Flag, FlagCode, Outcome, Report
from gripcourse.policy.model import Policy
from gripcourse.slips.model import SlipId
from gripcourse.text.words import Words, message
from gripcourse.variants.model import Student

Change = Callable[..., Report]


def rows(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


def test_a_row_has_the_points_with_decimal_points(perfect: Report, wrong: Change) -> None:
    report = wrong(perfect, "drive_force", 1.0)
    (row,) = rows(grades_text([report]))
    assert row["student"] == "s017"
    assert row["name"] == "Иванова Ольга"
    assert float(row["score"]) == report.score
    assert float(row["max_score"]) == report.max_score
    assert row["open_points"] == "4"
    assert float(row["percent"]) == pytest.approx(100 * report.score / report.max_score, abs=1e-4)


def test_each_scale_has_a_column_that_is_empty_while_points_that_wait_decide(
    perfect: Report, policy: Policy
) -> None:
    called = Called(policy.scales, Words("ru"))
    (row,) = rows(grades_text([perfect], {}, called))
    assert (row["mark"], row["ects"]) == ("5", "A")
    half = replace(perfect, score=83.0, max_score=96.0)
    (row,) = rows(grades_text([half], {}, called))
    assert (row["mark"], row["ects"]) == ("", "B")
    (row,) = rows(grades_text([replace(perfect, judged=False)], {}, called))
    assert (row["mark"], row["ects"]) == ("", "")


def test_the_columns_of_the_sections_add_up_to_the_score(perfect: Report, wrong: Change) -> None:
    report = wrong(perfect, "drive_force", 1.0)
    (row,) = rows(grades_text([report]))
    names = ("scheme", "drive", "grip", "elements", "general_view")
    assert sum(float(row[name]) for name in names) == pytest.approx(float(row["score"]))


def test_a_rejected_file_has_a_row_and_no_zero(perfect: Report, rejected: Change) -> None:
    flagged = replace(
        rejected(perfect), flags=(Flag(FlagCode.REJECTED, message("Protected by a password.")),)
    )
    _, row = rows(grades_text([perfect, flagged]))
    assert row["file"] == "inbox/s017.xlsx"
    assert row["flags"] == "rejected"
    points = ("score", "max_score", "percent", "open_points", "scheme", "drive", "grip")
    assert {row[name] for name in points} == {""}


def test_without_any_judged_file_there_is_still_a_table(perfect: Report, rejected: Change) -> None:
    (row,) = rows(grades_text([rejected(perfect)]))
    assert row["score"] == ""


def test_flags_are_listed_once_each(perfect: Report) -> None:
    flags = (Flag("a", message("x")), Flag("b", message("y")), Flag("a", message("z")))
    (row,) = rows(grades_text([replace(perfect, flags=flags)]))
    assert row["flags"] == "a; b"


def on_roster(*ids: str) -> dict[str, Student]:
    return {id_: Student(id_, f"Имя {id_}", "РТ-41", f"{id_}@uni", "", "") for id_ in ids}


def test_group_and_address_are_taken_from_the_roster(perfect: Report) -> None:
    row = rows(grades_text([perfect], on_roster("s017")))[0]
    assert (row["group"], row["email"]) == ("РТ-41", "s017@uni")
    row = rows(grades_text([perfect]))[0]
    assert (row["group"], row["email"]) == ("", "")


def test_who_handed_nothing_in_has_a_row_without_points(perfect: Report) -> None:
    _, missing = rows(grades_text([perfect], on_roster("s016", "s017")))
    said = {name: cell for name, cell in missing.items() if cell}
    assert said == {
        "student": "s016",
        "name": "Имя s016",
        "group": "РТ-41",
        "email": "s016@uni",
        "flags": "not_handed_in",
    }


def test_a_carriage_return_is_shown_and_begins_no_cell(perfect: Report) -> None:
    """Some programs take what follows one for a formula."""
    report = replace(perfect, name="\r=1+1")
    assert rows(grades_text([report]))[0]["name"] == "\ufffd=1+1"


@pytest.mark.parametrize("start", ["=", "+", "-", "@", "\t"])
def test_a_text_cannot_become_a_formula(perfect: Report, start: str) -> None:
    hostile = f"{start}cmd|' /C calc'!A0"
    report = replace(perfect, name=hostile, file=hostile, student=hostile, variant=hostile)
    row = next(csv.reader(io.StringIO(grades_text([report]).partition("\r\n")[2], newline="")))
    assert row.count(f"'{hostile}") == 4
    assert not any(cell.startswith(start) for cell in row)


def test_commas_quotes_and_lines_in_names_stay_in_their_cell(perfect: Report) -> None:
    name = 'Иванов, "Ваня"\nмл.'
    assert rows(grades_text([replace(perfect, name=name)]))[0]["name"] == name


def test_recognised_slips_are_listed_where_they_were_made(
    perfect: Report, with_finding: Change
) -> None:
    slipped = with_finding(
        perfect, "bore_required", outcome=Outcome.SLIP, slip=SlipId.parse("unit:cm")
    )
    earlier = with_finding(
        slipped,
        "drive_force",
        outcome=Outcome.CARRIED,
        slip=SlipId.parse("swapped:a"),
        roots=("grip_force",),
    )
    (row,) = rows(grades_text([earlier]))
    assert set(row["slips"].split("; ")) == {"bore_required=unit:cm", "grip_force=swapped:a"}
    assert rows(grades_text([perfect]))[0]["slips"] == ""
