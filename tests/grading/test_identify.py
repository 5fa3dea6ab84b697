"""Whose file it is: by the signed workbook first, by its path second, else a person asks."""

import unicodedata
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.identify import identify
from gripcourse.grading.known_by import KnownBy
from gripcourse.grading.path_pattern import path_pattern
from gripcourse.submission.model import Identity

if TYPE_CHECKING:
    from conftest import Case
    from gripcourse.variants.model import Issued

NAMES = {
    "s01": "Иванов Иван Иванович",
    "s02": "Шевченко Оксана",
    "s03": "О'Коннор Анна-Мария",
    "ivanov_i": "Иванов Игорь",
    "Ёлкин.Й": "Ёлкин Йосиф",
    **{str(number): f"Студент{'абвгде'[number - 1]} Пётр" for number in range(1, 7)},
}
PLATFORM_OF = "Студентв Петр_3_assignsubmission_file/answers.xlsx"
FOREIGN_PATHS = (
    "Lab 1/answers.xlsx",
    "otchet (2).xlsx",
    "3 курс/группа 4/answers.xlsx",
    "1/answers.xlsx",
    "work 1_2.xlsx",
    "otchet_1_2_final.xlsx",
    "Студентд Пётр_3_assignsubmission_file/answers.xlsx",
    "Участник_3_assignsubmission_file/answers.xlsx",
    "Группа по умолчанию_assignsubmission_file/answers.xlsx",
)


@pytest.fixture(scope="module")
def register(hydraulic: "Case") -> "dict[str, Issued]":
    issued = hydraulic.issued
    return {
        identifier: replace(
            issued,
            student=replace(issued.student, id=identifier, name=name),
            signature=f"{number:064x}",
        )
        for number, (identifier, name) in enumerate(NAMES.items())
    }


def signed(register: "dict[str, Issued]", student: str) -> Identity:
    """What the untouched workbook of a student says."""
    variant = register[student].variant
    return Identity(
        student, variant.id, variant.scheme, variant.options, register[student].signature
    )


@pytest.mark.parametrize("file", FOREIGN_PATHS)
def test_numbers_in_a_path_are_no_students(register: "dict[str, Issued]", file: str) -> None:
    assert identify(file, None, register).issued is None
    found = identify(file, signed(register, "5"), register)
    assert found.issued is register["5"]
    assert found.known_by is KnownBy.SIGNATURE


@pytest.mark.parametrize(
    "file",
    [
        "Курсовая s01 (исправлено).xlsx",
        "s01 (1).xlsx",
        "s01_late.xlsx",
        "группа s01/answers.xlsx",
        "inbox/s012.xlsx",
        "s01/вложение/answers.xlsx",
    ],
)
def test_words_of_a_path_tell_nothing(register: "dict[str, Issued]", file: str) -> None:
    assert identify(file, None, register).issued is None
    assert identify(file, signed(register, "s02"), register).issued is register["s02"]


@pytest.mark.parametrize(
    ("file", "student"),
    [
        ("Иван Иванов_s01_assignsubmission_file/answers.xlsx", "s01"),
        ("Иван Иванов_s01_assignsubmission_file_/вложение/s02.xlsx", "s01"),
        ("выгрузка/Игорь Иванов_ivanov_i_assignsubmission_file/a.xlsx", "ivanov_i"),
        ("Оксана Шевченко_s02_assignsubmission_file_answers.xlsx", "s02"),
        (PLATFORM_OF, "3"),
        ("студентвпетр_LATE_3_456_answers.xlsx", "3"),
        ("петрстудентв_3_456_answers.xlsx", "3"),
    ],
)
def test_a_platform_s_own_pattern_tells_whose_it_is(
    register: "dict[str, Issued]", file: str, student: str
) -> None:
    found = identify(file, None, register)
    assert (found.issued, found.known_by) == (register[student], KnownBy.PLATFORM)


@pytest.mark.parametrize(
    ("file", "student"),
    [
        ("inbox/s01.xlsx", "s01"),
        ("inbox/4.xlsx", "4"),
        ("handouts/s02/answers.xlsx", "s02"),
        (unicodedata.normalize("NFD", "inbox/Ёлкин.Й.xlsx"), "Ёлкин.Й"),
    ],
)
def test_a_name_that_is_an_id_and_nothing_else_tells_whose_it_is(
    register: "dict[str, Issued]", file: str, student: str
) -> None:
    found = identify(file, None, register)
    assert (found.issued, found.known_by) == (register[student], KnownBy.FILE_NAME)


@pytest.mark.parametrize(
    "file",
    [
        "s02.xlsx",
        "s02/answers.xlsx",
        PLATFORM_OF,
        "Оксана Шевченко_17_assignsubmission_file/answers.xlsx",
        "шевченкооксана_17_456_answers.xlsx",
    ],
)
def test_another_s_signed_workbook_goes_to_a_person(
    register: "dict[str, Issued]", file: str
) -> None:
    found = identify(file, signed(register, "s01"), register)
    assert found.issued is None
    assert "s01" in str(found.doubt)
    assert "Who handed this in?" in str(found.doubt)


def test_a_path_that_names_the_same_student_confirms_the_workbook(
    register: "dict[str, Issued]",
) -> None:
    for file in ("s01.xlsx", "Иван Иванов_s01_assignsubmission_file/s02.xlsx"):
        assert identify(file, signed(register, "s01"), register).issued is register["s01"]


@pytest.mark.parametrize("signature", ["", "00", "ключ", "f" * 64])
def test_a_workbook_without_its_signature_says_nothing_alone(
    register: "dict[str, Issued]", signature: str
) -> None:
    forged = replace(signed(register, "s01"), signature=signature)
    alone = identify("answers.xlsx", forged, register)
    assert alone.issued is None
    assert "without the signature" in str(alone.doubt)
    beside = identify("s01.xlsx", forged, register)
    assert (beside.issued, beside.known_by) == (register["s01"], KnownBy.FILE_NAME)
    assert identify("s02.xlsx", forged, register).doubt is not None


def test_a_signature_is_that_of_one_student_only(register: "dict[str, Issued]") -> None:
    taken = replace(signed(register, "s01"), student="s02")
    assert identify("answers.xlsx", taken, register).issued is None


def test_a_workbook_of_another_course_under_a_student_s_name_is_in_doubt(
    register: "dict[str, Issued]",
) -> None:
    stranger = replace(signed(register, "s01"), student="s99")
    assert identify("s02.xlsx", stranger, register).doubt is not None


@pytest.mark.parametrize("student", ["", "s99"])
def test_nobody_is_guessed(register: "dict[str, Issued]", student: str) -> None:
    found = identify("answers.xlsx", Identity(student, "", "", {}, ""), register)
    assert found.issued is None
    assert found.doubt is None


NOTHING_INSIDE = Identity("", "", "", {}, "")


def test_a_file_and_its_folder_that_name_two_students_are_nobodys(
    register: "dict[str, Issued]",
) -> None:
    found = identify("s01/ivanov_i.xlsx", NOTHING_INSIDE, register)
    assert found.issued is None
    assert "say ivanov_i and s01" in str(found.doubt)
    alone = identify("ivanov_i/ivanov_i.xlsx", NOTHING_INSIDE, register)
    assert alone.issued == register["ivanov_i"]


def test_an_order_of_folders_that_names_two_students_asks_a_person(
    register: "dict[str, Issued]",
) -> None:
    pattern = path_pattern("{name}/{id}/*.xlsx", register)
    own = identify("Шевченко Оксана/s02/w.xlsx", NOTHING_INSIDE, register, pattern)
    assert own.issued == register["s02"]
    short = identify("Оксана/s02/w.xlsx", NOTHING_INSIDE, register, pattern)
    assert short.issued == register["s02"]
    mixed = identify("Иванов Игорь/s02/w.xlsx", NOTHING_INSIDE, register, pattern)
    assert mixed.issued is None
    assert "say s02 and ivanov_i" in str(mixed.doubt)
    signed_all_the_same = identify(
        "Иванов Игорь/s02/w.xlsx", signed(register, "s02"), register, pattern
    )
    assert signed_all_the_same.known_by is KnownBy.SIGNATURE


def test_a_name_that_two_have_asks_which_of_them(register: "dict[str, Issued]") -> None:
    pattern = path_pattern("{name} - *", register)
    found = identify("Иванов - w.xlsx", NOTHING_INSIDE, register, pattern)
    assert found.issued is None
    assert "Иванов, is that of s01, ivanov_i" in str(found.doubt)
    either = identify("Иванов - w.xlsx", signed(register, "ivanov_i"), register, pattern)
    assert either.issued == register["ivanov_i"]
    third = identify("Иванов - w.xlsx", signed(register, "s02"), register, pattern)
    assert third.issued is None
    assert "The workbook is that of s02" in str(third.doubt)


def test_a_joined_person_is_found_by_the_earlier_id_and_name(
    register: "dict[str, Issued]",
) -> None:
    entry = register["s02"]
    former = replace(entry.student, id="old-7", name="Коваль Оксана")
    known = {**register, "s02": replace(entry, joined=(former,))}
    joined = {"old-7": "s02"}
    by_id = path_pattern("{id}_*", {*known, *joined})
    found = identify("old-7_w.xlsx", NOTHING_INSIDE, known, by_id, joined=joined)
    assert found.issued == known["s02"]
    by_name = path_pattern("{name} - *", known)
    found = identify("Коваль Оксана - w.xlsx", NOTHING_INSIDE, known, by_name, joined=joined)
    assert found.issued == known["s02"]


def test_a_platform_may_write_a_person_as_the_register_did_before(
    register: "dict[str, Issued]",
) -> None:
    entry = register["s02"]
    known = {**register, "s02": replace(entry, student=replace(entry.student, name="Шевчук Ганна"))}
    known["s07"] = replace(entry, student=replace(entry.student, id="s07", name="Шевчук Анна"))
    file, said = "Шевчук Анна_201_assignsubmission_file/w.xlsx", signed(register, "s02")
    assert identify(file, said, known).issued is None
    former = {"s02": ("Шевчук Анна",)}
    found = identify(file, said, known, former=former)
    assert (found.issued, found.known_by) == (known["s02"], KnownBy.SIGNATURE)
    other = {"s02": ("Шевчук А.",)}
    assert identify(file, said, known, former={"s03": ("Шевчук Анна",)}).issued is None
    assert identify("Иванов Игорь_9_assignsubmission_file/w.xlsx", said, known,
                    former=other).issued is None  # fmt: skip
