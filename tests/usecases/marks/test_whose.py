"""A person's word for who handed a file in."""

from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.batch.doubts import in_doubt
from gripcourse.batch.graded import Graded, with_reports
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.errors import UsageError
from gripcourse.gradebook.store import open_gradebook
from gripcourse.gradebook.words import words_of
from gripcourse.grading.flag_code import FlagCode
from gripcourse.grading.model import Report
from gripcourse.usecases.marks.answered import with_answers
from gripcourse.usecases.marks.batch_wish import BatchWish
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.opening import by_word
from gripcourse.usecases.marks.whose import read_whose
from support.classroom import forget_one_jaw
from support.unsigned import leave_unsigned

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


def batch(issued: "Classroom", place: str, files: dict[str, Path], *whose: str) -> list[str]:
    """Grade files as one batch, and return whose each of them is."""
    context = by_word(BatchWish(whose=whose), list(files.values()), issued.context)
    context = with_answers(context, place, files.values())
    graded = [Graded(grade_file(one, context), "") for one in files.values()]
    doubted = with_reports(graded, in_doubt([one.report for one in graded]))
    kept = keep(doubted, context, place, datetime(2026, 12, 2, 9, tzinfo=UTC))
    return [one.report.student for one in kept]


@pytest.fixture
def beside(issued: "Classroom", tmp_path: Path) -> dict[str, Path]:
    """The signed work of s01, and one beside it that bears nobody's name but that of the file."""
    (tmp_path / "first").mkdir()
    signed = issued.hand_in("s01", correct, tmp_path / "first" / "signed.xlsx")
    named = issued.hand_in("s01", forget_one_jaw, tmp_path / "first" / "s01.xlsx")
    leave_unsigned(named)
    return {"signed": signed, "named": named}


@pytest.mark.parametrize("student", ["s01", "s03"])
def test_who_was_asked_about_a_work_beside_the_signed_one_need_not_answer_again(
    issued: "Classroom", place: str, beside: dict[str, Path], student: str
) -> None:
    assert batch(issued, place, beside) == ["s01", ""]
    assert batch(issued, place, beside, f"s01.xlsx={student}") == ["s01", student]
    assert batch(issued, place, beside) == ["s01", student]


def test_what_was_graded_by_its_name_before_the_signed_one_came_is_asked_about(
    issued: "Classroom", place: str, beside: dict[str, Path]
) -> None:
    assert batch(issued, place, {"named": beside["named"]}) == ["s01"]
    assert batch(issued, place, beside) == ["s01", ""]
    assert batch(issued, place, beside, "s01.xlsx=s01") == ["s01", "s01"]
    assert batch(issued, place, beside) == ["s01", "s01"]


def test_the_last_word_counts_also_where_it_is_one_of_before(
    issued: "Classroom", place: str, beside: dict[str, Path]
) -> None:
    named = {"named": beside["named"]}
    for student in ("s01", "s03", "s01"):
        assert batch(issued, place, named, f"s01.xlsx={student}") == [student]
        assert batch(issued, place, named) == [student]


def test_what_was_said_is_kept_once_for_the_same_bytes(
    issued: "Classroom", place: str, beside: dict[str, Path]
) -> None:
    for _ in range(2):
        batch(issued, place, beside, "s01.xlsx=s01")
    (word,) = words_of(open_gradebook(place))
    assert (word.student, word.digest) == ("s01", sha256(beside["named"].read_bytes()).hexdigest())


def test_other_bytes_under_the_name_are_nobodys_word(
    issued: "Classroom", place: str, beside: dict[str, Path]
) -> None:
    batch(issued, place, beside, "s01.xlsx=s01")
    issued.hand_in("s01", correct, beside["named"])
    leave_unsigned(beside["named"])
    assert batch(issued, place, beside) == ["s01", ""]
