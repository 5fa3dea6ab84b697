"""A person's word for who handed a file in."""

from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.errors import UsageError
from gripcourse.grading.flag_code import FlagCode
from gripcourse.grading.model import Report
from gripcourse.usecases.marks.answered import with_answers
from gripcourse.usecases.marks.batch_wish import BatchWish
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.opening import by_word
from gripcourse.usecases.marks.whose import read_whose
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

FILES = [Path("work/s002.xlsx"), Path("work/late/s002.xlsx"), Path("work/a=b.xlsx")]


@pytest.mark.parametrize(
    ("written", "file"),
    [
        ("work/s002.xlsx=s003", "work/s002.xlsx"),
        ("late/s002.xlsx = s003", "work/late/s002.xlsx"),
        ("a=b.xlsx=s003", "work/a=b.xlsx"),
    ],
)
def test_a_file_is_named_by_the_end_of_its_path(written: str, file: str) -> None:
    assert read_whose([written], FILES, {"s003"}) == {file: "s003"}


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("s002.xlsx=s003", "2 files"),
        ("gone.xlsx=s003", "0 files"),
        ("work/s002.xlsx=s9", "no student"),
        ("work/s002.xlsx", "no file with its student"),
        ("=s003", "no file with its student"),
    ],
)
def test_what_names_no_file_or_no_student_is_refused(written: str, said: str) -> None:
    with pytest.raises(UsageError, match=said):
        read_whose([written], FILES, {"s003"})


def test_the_library_speaks_of_its_own_parameter() -> None:
    with pytest.raises(UsageError) as refused:
        read_whose(["s009.xlsx=s002"], FILES, {"s002"})
    (problem,) = refused.value.problems
    assert (problem.parameter, problem.key) == ("whose", "")


def graded_again(issued: "Classroom", place: str, file: Path, *whose: str) -> Report:
    """Grade one file as a run of its own does, and keep it."""
    context = by_word(BatchWish(whose=whose), [file], issued.context)
    report = grade_file(file, with_answers(context, place, [file]))
    keep([Graded(report, "")], issued.context, place, datetime(2026, 12, 2, 9, tzinfo=UTC))
    return report


def test_who_was_asked_once_need_not_answer_again(issued: "Classroom", tmp_path: Path) -> None:
    place, file = str(tmp_path / "gradebook.sqlite"), tmp_path / "s02.xlsx"
    issued.hand_in("s01", correct, file)
    asked = graded_again(issued, place, file)
    assert [flag.code for flag in asked.flags] == [FlagCode.WHO_HANDED_IN]
    said = graded_again(issued, place, file, "s02.xlsx=s01")
    assert (said.student, said.score) == ("s01", graded_again(issued, place, file).score)
    assert graded_again(issued, place, file, "s02.xlsx=s02").student == "s02"
    assert graded_again(issued, place, file).student == "s02"


def test_another_work_under_the_same_name_is_asked_about(
    issued: "Classroom", tmp_path: Path
) -> None:
    place, file = str(tmp_path / "gradebook.sqlite"), tmp_path / "s02.xlsx"
    issued.hand_in("s01", correct, file)
    graded_again(issued, place, file, "s02.xlsx=s01")
    issued.hand_in("s01", forget_one_jaw, file)
    assert [flag.code for flag in graded_again(issued, place, file).flags] == [
        FlagCode.WHO_HANDED_IN
    ]
    elsewhere = tmp_path / "s02" / "work.xlsx"
    issued.hand_in("s01", correct, elsewhere)
    assert graded_again(issued, place, elsewhere).student == ""


def test_a_work_that_lies_under_its_name_again_is_still_known(
    issued: "Classroom", tmp_path: Path
) -> None:
    """A platform calls what two students sent by the same name, one download after the other."""
    place, file = str(tmp_path / "gradebook.sqlite"), tmp_path / "s02.xlsx"
    first = issued.hand_in("s01", correct, tmp_path / "first.xlsx").read_bytes()
    second = issued.hand_in("s03", correct, tmp_path / "second.xlsx").read_bytes()
    for content, student in ((first, "s01"), (second, "s03")):
        file.write_bytes(content)
        graded_again(issued, place, file, f"s02.xlsx={student}")
    for content, student in ((first, "s01"), (second, "s03"), (first, "s01")):
        file.write_bytes(content)
        assert graded_again(issued, place, file).student == student
