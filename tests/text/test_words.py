from copy import copy

import pytest

from gripcourse.text.number_text import format_number
from gripcourse.text.words import LANGUAGES, Message, Texts, Words, counted, message

EVERY_LANGUAGE = pytest.mark.parametrize("language", LANGUAGES)


def test_values_stand_in_their_places() -> None:
    said = message("row {row}, column {column}", row=7, column="mass")
    assert Words("en").say(said) == "row 7, column mass"


def test_a_message_reads_as_english() -> None:
    assert str(message("at most {limit}", limit="ten")) == "at most ten"


def test_a_message_inside_a_message_is_put_into_words_too() -> None:
    inner = message("a force of {force}", force="5 N")
    assert str(message("found {what}", what=inner)) == "found a force of 5 N"


@EVERY_LANGUAGE
def test_numbers_are_written_as_the_language_writes_them(language: str) -> None:
    said = Words(language).say(Message("{value}", {"value": 1234.5}))
    assert said == format_number(1234.5, language)


@EVERY_LANGUAGE
def test_the_figures_of_a_number_can_be_chosen(language: str) -> None:
    assert Words(language).number(2.0 / 3.0, 2) == format_number(2.0 / 3.0, language, 2)


@EVERY_LANGUAGE
def test_texts_of_the_course_are_taken_in_the_readers_language(language: str) -> None:
    title = Texts({"en": "bore", "ru": "диаметр", "uk": "діаметр"})
    said = Words(language).say(Message("{title}", {"title": title}))
    assert said == title.of(language)


@EVERY_LANGUAGE
def test_no_text_stays_no_text(language: str) -> None:
    # In a catalogue the empty key is the header.
    assert Words(language).translate("") == ""


@EVERY_LANGUAGE
def test_a_sentence_that_no_catalogue_knows_stays_as_it_is(language: str) -> None:
    assert Words(language).translate("No catalogue has this.") == "No catalogue has this."


def test_a_value_that_is_missing_is_an_error() -> None:
    with pytest.raises(KeyError, match="force"):
        str(message("a force of {force}"))


def test_equal_messages_are_equal() -> None:
    assert message("{a}", a=1) == message("{a}", a=1)
    assert message("{a}", a=1) != message("{a}", a=2)


@pytest.mark.parametrize(
    ("language", "forms"),
    [
        ("en", {1: "1 assignment is", 2: "2 assignments are", 21: "21 assignments are"}),
        (
            "ru",
            {1: "1 задание", 2: "2 задания", 5: "5 заданий", 11: "11 заданий", 21: "21 задание"},
        ),
        (
            "uk",
            {1: "1 завдання", 2: "2 завдання", 5: "5 завдань", 11: "11 завдань", 21: "21 завдання"},
        ),
    ],
)
def test_a_counted_message_goes_with_its_number(language: str, forms: dict[int, str]) -> None:
    for number, form in forms.items():
        said = counted(
            "{count} assignment is in {folder}.",
            "{count} assignments are in {folder}.",
            number,
            folder="out",
        )
        assert Words(language).say(said).startswith(f"{form} "), number
        assert Words(language).say(copy(said)).startswith(f"{form} "), "as one that travelled"
