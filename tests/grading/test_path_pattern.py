"""An order of folders of one's own says whose a file is, only where it says so wholly."""

import pytest

from gripcourse.errors import UsageError
from gripcourse.grading.path_pattern import path_pattern

IDS = ("s1", "s10", "ivanov-i", "ivanov")


@pytest.mark.parametrize(
    ("pattern", "file", "identifier", "name"),
    [
        ("{name}/{id}*.xlsx", "in/Иванов Иван/s1_final.xlsx", "s1", "Иванов Иван"),
        ("{id}*.xlsx", "in/s10.xlsx", "s10", ""),
        ("{id}*.xlsx", "in/ivanov-i (2).xlsx", "ivanov-i", ""),
        ("{name}/Version ?/*", "Submitted files/А Б/Version 2/x.xlsx", "", "А Б"),
    ],
)
def test_a_path_of_the_form_says_who(pattern: str, file: str, identifier: str, name: str) -> None:
    part = path_pattern(pattern, IDS).part_of(file)
    assert part is not None
    assert (part.identifier, part.name) == (identifier, name)


@pytest.mark.parametrize("file", ["s11.xlsx", "s1.ods", "xs1.xlsx"])
def test_another_path_says_nothing(file: str) -> None:
    assert path_pattern("{id}*.xlsx", IDS).part_of(file) is None


@pytest.mark.parametrize("pattern", ["*.xlsx", "{id}/{id}.xlsx", "{group}/{id}.xlsx", ""])
def test_a_pattern_that_says_nothing_of_a_student_is_refused(pattern: str) -> None:
    with pytest.raises(UsageError):
        path_pattern(pattern, IDS)
