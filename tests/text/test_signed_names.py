"""Surname and initials, where it is certain which is which."""

import pytest

from gripcourse.text.signed_names import signed_name


@pytest.mark.parametrize(
    ("name", "signed"),
    [
        ("Шевченко Оксана Костянтинівна", "Шевченко О. К."),
        ("Кузнецов Дмитрий Сергеевич", "Кузнецов Д. С."),
        ("Морозов Пётр Ильич", "Морозов П. И."),
        ("Нечуй-Левицький Іван Семенович", "Нечуй-Левицький І. С."),
        ("Мар’яненко  Дар’я Юріївна", "Мар’яненко Д. Ю."),
        ("Соколова Мария Ильинична", "Соколова М. И."),
    ],
)
def test_a_name_with_a_patronymic_is_signed_by_surname_and_initials(name: str, signed: str) -> None:
    assert signed_name(name) == signed


@pytest.mark.parametrize(
    "name",
    ["", "Julia L. Carter", "Анна Петровна Иванова", "Шевченко Оксана", "Ким Ен Сун", "%%c a b"],
)
def test_any_other_name_stays_whole(name: str) -> None:
    assert signed_name(name) == name
