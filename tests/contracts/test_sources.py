"""Where numbers come from is said in every language; works are cited in their own."""

import re

import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Source
from gripcourse.text.words import LANGUAGES

# An English word, and no function, unit, standard or name of a file.
WORD = re.compile(r"(?<![\w.])[a-z]{4,}(?![\w(.]|\.toml)")
# Names that stay: ids of columns and functions, a work cited in its own language.
KEPT = frozenset({"sqrt", "arcsin", "arctg", "suction"})


def sources(course: Course) -> list[Source]:
    declared = [*course.constants.values()]
    for part in (*course.parts.values(), *course.schemes.values()):
        declared += part.quantities.values()
    found = [one.source for one in declared]
    return found + [one.example.source for one in course.schemes.values() if one.example]


@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_a_note_on_a_source_has_no_english_words_in_another_language(
    course: Course, language: str
) -> None:
    notes = {one.told(language) for one in sources(course)}
    assert notes
    assert {note for note in notes if set(WORD.findall(note)) - KEPT} == set()


@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_a_catalogue_says_in_every_language_where_it_comes_from(
    course: Course, language: str
) -> None:
    said = {one.id: one.source.of(language) for one in course.catalogues.values()}
    assert all(re.search("[а-яіїє]{4}", text) for text in said.values())
    ids = {name for one in course.catalogues.values() for name in one.columns}
    left = {id_: set(WORD.findall(text)) - KEPT - ids for id_, text in said.items()}
    assert {id_: words for id_, words in left.items() if words} == {}


def test_a_published_work_is_cited_as_it_is_called(course: Course) -> None:
    """Readers of English get its title in Latin letters, and what it means in brackets."""
    own = {"derived", "course_rule"}
    for work in course.works.values():
        english, russian, ukrainian = (work.title.of(one) for one in ("en", "ru", "uk"))
        if work.id in own:
            assert len({english, russian, ukrainian}) == len(own) + 1
            continue
        assert russian == ukrainian
        assert english.isascii() or english.replace("§", "").isascii(), english
        assert (english == russian) is russian.isascii()
        assert english == russian or re.search(r"\[[^]]+\]", english)
