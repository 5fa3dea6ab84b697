"""Whose file it is: by its path first, by what the workbook says second."""

import unicodedata
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.identify import submitter

if TYPE_CHECKING:
    from conftest import Case
    from gripcourse.variants.model import Issued

IDS = ("s01", "s02", "ivanova-ap", "ivanov_i", "i", "Ёлкин.Й", "7")


@pytest.fixture(scope="module")
def register(hydraulic: "Case") -> "dict[str, Issued]":
    issued = hydraulic.issued
    return {
        name: replace(
            issued, student=replace(issued.student, id=unicodedata.normalize("NFC", name))
        )
        for name in IDS
    }


@pytest.mark.parametrize(
    ("file", "student"),
    [
        pytest.param("inbox/s01.xlsx", "s01", id="file name"),
        pytest.param("inbox/ivanova-ap.xlsx", "ivanova-ap", id="file name with a hyphen"),
        pytest.param("inbox/s01 (1).xlsx", "s01", id="downloaded twice"),
        pytest.param("inbox/Курсовая s01 (исправлено).xlsx", "s01", id="words round it"),
        pytest.param("s01/ответы.xlsx", "s01", id="folder"),
        pytest.param(
            "Иванов Иван_s01_assignsubmission_file/ответы.xlsx", "s01", id="learning platform"
        ),
        pytest.param(
            "Иванов Иван_s01_assignsubmission_file_/вложение/a.xlsx", "s01", id="folder inside it"
        ),
        pytest.param(
            "Иванов Иван_ivanov_i_assignsubmission_file/ответы.xlsx",
            "ivanov_i",
            id="an id with an underscore, and another student called like its end",
        ),
        pytest.param("s02/s01.xlsx", "s01", id="the nearest part counts first"),
        pytest.param("s02/s01_i.xlsx", "s02", id="a name that fits two says nothing"),
        pytest.param(
            unicodedata.normalize("NFD", "inbox/Ёлкин.Й.xlsx"), "Ёлкин.Й", id="letters in two parts"
        ),
    ],
)
def test_the_path_tells_whose_it_is(register: "dict[str, Issued]", file: str, student: str) -> None:
    found = submitter(file, "s99", register)
    assert found is not None
    assert found.student.id == student


@pytest.mark.parametrize(
    "file", ["inbox/ответы.xlsx", "s01_s02.xlsx", "inbox/s012.xlsx", "inbox/17.xlsx"]
)
def test_where_the_path_says_nothing_the_workbook_does(
    register: "dict[str, Issued]", file: str
) -> None:
    found = submitter(file, "s02", register)
    assert found is register["s02"]


def test_the_path_goes_before_the_workbook(register: "dict[str, Issued]") -> None:
    assert submitter("s01.xlsx", "s02", register) is register["s01"]


@pytest.mark.parametrize("workbook_student", ["", "s99"])
def test_nobody_is_guessed(register: "dict[str, Issued]", workbook_student: str) -> None:
    assert submitter("inbox/ответы.xlsx", workbook_student, register) is None
