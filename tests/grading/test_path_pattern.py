"""An order of folders of one's own says whose a file is, only where it says so wholly."""

from time import process_time

import pytest

from gripcourse.errors import UsageError
from gripcourse.grading.path_pattern import fits_none, path_pattern

IDS = ("s1", "s10", "ivanov-i", "ivanov")


@pytest.mark.parametrize(
    ("pattern", "file", "identifier", "name"),
    [
        ("{name}/{id}*.xlsx", "in/Иванов Иван/s1_final.xlsx", "s1", "Иванов Иван"),
        ("{id}*.xlsx", "in/s10.xlsx", "s10", ""),
        ("{id}*.xlsx", "in/ivanov-i (2).xlsx", "ivanov-i", ""),
        ("{name}/Version ?/*", "Submitted files/А Б/Version 2/x.xlsx", "", "А Б"),
        ("./{name} - *", "class/А Б - work.xlsx", "", "А Б"),
        ("*_{name}_*.xlsx", "1_А Б_2_3.xlsx", "", "2"),
        ("{name}{id}.xlsx", "А Бs10.xlsx", "s10", "А Б"),
        ("{id}_*.xlsx", "in/IVANOV-I_1.XLSX", "ivanov-i", ""),
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


@pytest.mark.parametrize("name", ["s_" * 120, "s1" * 120, "Ж" * 250])
def test_no_name_that_a_student_chooses_takes_long(name: str) -> None:
    pattern = path_pattern("*{name}*{id}*?*?*?*.xlsx", IDS)
    began = process_time()
    assert pattern.part_of(f"in/{name}.ods") is None
    assert process_time() - began < 1  # comparing one way after the other takes a minute


def test_a_pattern_that_fits_no_file_is_told() -> None:
    files = ("in/s1_a.xlsx", "in/s10_b.xlsx")
    assert fits_none(path_pattern("{id}_*.ods", IDS), files) == "{id}_*.ods"
    assert fits_none(path_pattern("{id}_a.xlsx", IDS), files) == ""
    assert fits_none(None, files) == ""
