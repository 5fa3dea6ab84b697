"""What people take for the same word, and in which order they look for it."""

from itertools import pairwise

import pytest

from gripcourse.text.spelling import alphabetical, plain


@pytest.mark.parametrize(
    "names",
    [
        ["Антоненко", "Гончар", "Ґудзь", "Дяченко", "Єфремов", "Жук", "Зима", "Іваненко", "Їжак"],
        ["Ежов", "Ёлкин", "Ершов", "Жуков"],
        ["Adams", "Smith", "Абрамов", "Иванов", "Йовенко", "Яковлев"],
        ["Мар’яненко", "Мар'яненко Я.", "Мар’ясов"],
        ["РТК-9", "РТК-10", "РТК-10а", "РТК-41"],
    ],
)
def test_names_and_groups_are_sorted_as_people_sort_them(names: list[str]) -> None:
    assert all(alphabetical(one) < alphabetical(next_) for one, next_ in pairwise(names))


def test_a_name_is_the_same_word_with_any_apostrophe() -> None:
    assert plain("Мар'яненко") == plain("МАР’ЯНЕНКО")
