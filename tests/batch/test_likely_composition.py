"""What a file is about is guessed by its name, so that one worker judges what is alike."""

from dataclasses import replace

import pytest

from gripcourse.batch.context import GradingContext, likely_composition


@pytest.mark.parametrize(
    "name",
    [
        "s03.xlsx",
        "s03/answers.xlsx",
        "Lab 1/s03_final (2).xlsx",
        "Шевченко Тарас_77_assignsubmission_file_/s03.xlsx",
    ],
)
def test_a_word_that_is_a_students_id_is_enough(context: GradingContext, name: str) -> None:
    expected = context.register["s03"].variant.composition
    assert likely_composition(name, context) == expected


def test_of_a_name_that_tells_nothing_nothing_is_guessed(context: GradingContext) -> None:
    assert likely_composition("answers (2).xlsx", context) is None


def test_a_persons_word_comes_first_and_a_joined_id_is_its_students(
    context: GradingContext,
) -> None:
    said = replace(context, whose={"s03.xlsx": "s05"}, joined={"old": "s06"})
    for name, student in (("s03.xlsx", "s05"), ("old.xlsx", "s06")):
        found = likely_composition(name, said)
        assert found == context.register[student].variant.composition
