"""A student's self-check: how the workbook is read, and nothing of the answers."""

import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from openpyxl import Workbook, load_workbook

from gripcourse.cli.text import check_text
from gripcourse.course.quantity import Kind
from gripcourse.errors import UsageError
from gripcourse.gradebook.checks import CheckLedger
from gripcourse.grading.self_check import SectionState, State
from gripcourse.policy.model import CheckRule, Tells
from gripcourse.simulation.write import fill
from gripcourse.solver.solve import solve_variant
from gripcourse.text.number_text import format_number
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.usecases.grading.check import CheckedWorkbook, check_file
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom


@pytest.fixture
def slipped(issued: "Classroom", tmp_path: Path) -> Path:
    """Everything computed on from a doubled grip force."""
    return issued.hand_in("s01", forget_one_jaw, tmp_path / "мой ответ.xlsx")


def refusal(issued: "Classroom", file: Path) -> str:
    with pytest.raises(UsageError) as caught:
        check_file(file, issued.course, issued.policy)
    (problem,) = caught.value.problems
    assert problem.file == str(file)
    return problem.say(Words("en"))


def test_a_workbook_is_checked_without_register_and_key(issued: "Classroom", slipped: Path) -> None:
    checked = check_file(slipped, issued.course, issued.policy)
    states = {one.quantity: one.state for one in checked.checks}
    assert {states["lifting_load"], states["grip_force"]} == {State.READ}
    assert (checked.sections, checked.left) == ((), None)


@pytest.mark.parametrize("name", ["ответ.zip", "ответ.xls", "ответ"])
def test_a_workbook_is_checked_whatever_it_is_called_and_that_is_said(
    issued: "Classroom", slipped: Path, name: str
) -> None:
    renamed = slipped.rename(slipped.with_name(name))
    (said,) = check_file(renamed, issued.course, issued.policy).remarks
    assert f"The file {name} is a workbook" in Words("en").say(said)


def test_whether_numbers_fit_is_told_as_often_as_the_policy_says(
    issued: "Classroom", slipped: Path, tmp_path: Path
) -> None:
    """Each student has their own questions; afterwards only the reading is told."""

    def asked(who: str) -> CheckedWorkbook:
        ledger = CheckLedger(tmp_path / "checks.sqlite", who)
        return check_file(slipped, issued.course, issued.policy, ledger=ledger)

    times = issued.policy.check.times
    told = [asked("s01") for _ in range(times + 2)]
    assert [bool(one.sections) for one in told] == [True] * times + [False] * 2
    assert [one.left for one in told] == [*range(times - 1, -1, -1), 0, 0]
    assert asked("s02").sections


def test_a_check_that_compares_nothing_takes_none_of_them(
    issued: "Classroom", slipped: Path, tmp_path: Path
) -> None:
    ledger = CheckLedger(tmp_path / "checks.sqlite", "s01")
    blank = issued.workbook("s01")
    times = issued.policy.check.times

    def asked(file: Path) -> CheckedWorkbook:
        return check_file(file, issued.course, issued.policy, ledger=ledger)

    assert [asked(blank).left for _ in range(times + 1)] == [times] * (times + 1)
    assert {one.state for one in asked(blank).sections} == {SectionState.OPEN}
    assert (asked(slipped).left, asked(blank).left) == (times - 1, times - 1)


def test_answers_are_told_only_where_the_policy_wants_an_oracle(
    issued: "Classroom", slipped: Path, tmp_path: Path
) -> None:
    policy = replace(issued.policy, check=CheckRule(Tells.ANSWERS, 1))
    ledger = CheckLedger(tmp_path / "checks.sqlite", "s01")
    checked = check_file(slipped, issued.course, policy, ledger=ledger)
    states = {one.quantity: one.state for one in checked.checks}
    assert states["grip_force"] is State.INCONSISTENT
    assert states["drive_force"] is State.CONSISTENT


def test_what_is_told_of_sections_is_printed(
    issued: "Classroom", slipped: Path, tmp_path: Path
) -> None:
    ledger = CheckLedger(tmp_path / "checks.sqlite", "s01")
    checked = check_file(slipped, issued.course, issued.policy, ledger=ledger)
    shown = check_text(checked, Words("en"))
    assert "At least one number does not follow" in shown
    assert "left: 2." in shown


@pytest.mark.parametrize("language", LANGUAGES)
def test_nothing_of_the_reference_is_printed(
    issued: "Classroom", slipped: Path, language: str
) -> None:
    """What depends on the doubled force has another reference; none of those is on the screen."""
    entry = issued.register["s01"]
    reference = solve_variant(issued.plan("s01"), entry.variant.given)
    typed = forget_one_jaw(issued.plan("s01"), entry)
    words = Words(language)
    shown = check_text(check_file(slipped, issued.course, issued.policy), words)
    answered = {one.id for one in issued.plan("s01").answered if one.kind is Kind.FORMULA}
    differing = [
        reference[name]
        for name, value in typed.items()
        if name in answered
        and value != pytest.approx(reference[name], rel=0.05)
        and reference[name] != float(f"{reference[name]:.3g}")  # 30 mm may be something else too
    ]
    assert len(differing) >= 8
    numbers = set(re.findall(r"\d[\d.,\u202f]*", shown))
    for value in differing:
        written = {format_number(value, language, figures) for figures in (4, 5, 6)}
        assert numbers.isdisjoint(written | {f"{value:.{figures}g}" for figures in (4, 5, 15)})


def test_it_shows_what_was_typed_and_the_declared_titles(
    issued: "Classroom", slipped: Path
) -> None:
    fill(slipped, {"lifting_load": "около 900"}, slipped)
    shown = check_text(check_file(slipped, issued.course, issued.policy), Words("uk"))
    quantity = issued.plan("s01").quantities["lifting_load"]
    assert "около 900" in shown
    assert quantity.title.of("uk").split()[0] in shown


def test_an_untouched_workbook_has_no_answers_yet(issued: "Classroom") -> None:
    checked = check_file(issued.workbook("s02"), issued.course, issued.policy)
    assert {one.state for one in checked.checks} == {State.BLANK}


def test_a_file_that_is_not_there_is_named(issued: "Classroom", tmp_path: Path) -> None:
    assert "There is no such file." in refusal(issued, tmp_path / "нет.xlsx")


def test_a_folder_is_no_workbook(issued: "Classroom", tmp_path: Path) -> None:
    assert "There is no such file." in refusal(issued, tmp_path)


def test_a_file_that_is_no_workbook_is_named_with_the_reason(
    issued: "Classroom", tmp_path: Path
) -> None:
    file = tmp_path / "ответ.xlsx"
    file.write_bytes("усилие;3900".encode("cp1251"))
    assert "Hand in the answer workbook that you were given." in refusal(issued, file)


def test_somebody_elses_kind_of_workbook_is_refused(issued: "Classroom", tmp_path: Path) -> None:
    file = tmp_path / "смета.xlsx"
    book = Workbook()
    book.active["A1"] = 3900
    book.save(file)
    assert "not the workbook that was issued" in refusal(issued, file)


def test_a_workbook_that_lost_its_identity_says_so(issued: "Classroom", tmp_path: Path) -> None:
    file = tmp_path / "ответ.xlsx"
    book = load_workbook(issued.workbook("s01"))
    for name in [one for one in book.defined_names if one.startswith("meta.")]:
        del book.defined_names[name]
    for stored in list(book.custom_doc_props.names):
        del book.custom_doc_props[stored]
    book.save(file)
    assert "does not say which variant" in refusal(issued, file)


def test_a_workbook_of_a_scheme_that_the_course_has_not_is_refused(
    issued: "Classroom", tmp_path: Path
) -> None:
    file = tmp_path / "ответ.xlsx"
    book = load_workbook(issued.workbook("s01"))
    for sheet, address in book.defined_names["meta.scheme"].destinations:
        book[sheet][address] = "four_bar"
    book.save(file)
    assert "four_bar" in refusal(issued, file)


def test_an_answer_that_cannot_be_read_is_named_with_its_cell(
    issued: "Classroom", slipped: Path
) -> None:
    book = load_workbook(slipped)
    [(sheet, address)] = book.defined_names["answer.drive_force"].destinations
    book[sheet][address.replace("$", "")] = "12-13 Н"
    book.save(slipped)
    shown = check_text(check_file(slipped, issued.course, issued.policy), Words("en"))
    told = " ".join(line[-60:] for line in shown.splitlines())
    assert address.replace("$", "") in told
