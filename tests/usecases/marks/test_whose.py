"""A person's word for who handed a file in."""

from pathlib import Path

import pytest

from gripcourse.errors import UsageError
from gripcourse.usecases.marks.whose import read_whose

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
