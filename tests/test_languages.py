"""Every sentence in every language, with the same values in it."""

import ast
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from string import Formatter

import pytest

import messages
from gripcourse.text.words import LANGUAGES, Words

REPOSITORY = Path(__file__).parents[1]


@cache
def sentences() -> frozenset[messages.Sentence]:
    """Every sentence of the program; not while tests are collected, which every worker does."""
    return frozenset(messages.extracted(REPOSITORY))


def places(text: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(text) if name is not None}


def forms(text: str | tuple[str, ...]) -> tuple[str, ...]:
    return (text,) if isinstance(text, str) else text


def takes_a_sentence(function: ast.expr) -> bool:
    """Whether it is `message` or `words.translate`, and not the `translate` of a string."""
    if isinstance(function, ast.Attribute):
        return function.attr == "translate" and ast.unparse(function.value).endswith("words")
    return isinstance(function, ast.Name) and function.id == "message"


def calls_with_sentences(tree: ast.Module) -> list[ast.Call]:
    return [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and takes_a_sentence(node.func)
    ]


@cache
def calls_of_the_program() -> Mapping[str, list[ast.Call]]:
    """Find by their file all calls that take a sentence."""
    return {
        str(path.relative_to(REPOSITORY)): calls_with_sentences(
            ast.parse(path.read_text(encoding="utf-8"))
        )
        for path in (REPOSITORY / "src").rglob("*.py")
    }


def without_a_sentence(calls: Iterable[ast.Call]) -> list[int]:
    """Lines of calls whose sentence the extractor cannot see: it is put together or passed on."""
    return [
        node.lineno
        for node in calls
        if not (
            node.args
            and isinstance(node.args[0], ast.Constant)
            and isinstance(node.args[0].value, str)
        )
    ]


def test_the_catalogues_are_those_of_the_program() -> None:
    assert ("en", *messages.LANGUAGES) == LANGUAGES
    found = {path.name for path in (REPOSITORY / messages.LOCALE).iterdir()}
    assert found == {f"{language}.po" for language in messages.LANGUAGES}


def test_every_sentence_is_written_out_where_it_is_made() -> None:
    hidden = [
        f"{file}:{line}"
        for file, calls in calls_of_the_program().items()
        for line in without_a_sentence(calls)
    ]
    assert hidden == []


def test_the_extractor_sees_every_sentence() -> None:
    written = {
        node.args[0].value
        for calls in calls_of_the_program().values()
        for node in calls
        if node.args and isinstance(node.args[0], ast.Constant)
    }
    assert written
    assert written <= sentences()


@pytest.mark.parametrize(
    "source",
    ['message(f"{x} mm")', 'message("a" + b)', "message(text)", "words.translate(said.text)"],
)
def test_a_sentence_that_cannot_be_extracted_is_noticed(source: str) -> None:
    assert without_a_sentence(calls_with_sentences(ast.parse(source))) == [1]


@pytest.mark.parametrize("language", messages.LANGUAGES)
def test_every_sentence_is_translated(language: str) -> None:
    catalogue = messages.read_catalogue(REPOSITORY, language)
    assert messages.untranslated(catalogue, sentences()) == []


@pytest.mark.parametrize("language", messages.LANGUAGES)
def test_a_translation_has_the_same_places(language: str) -> None:
    catalogue = messages.read_catalogue(REPOSITORY, language)
    differing = {
        entry.id: form
        for entry in catalogue
        if entry.id and entry.string
        for form in forms(entry.string)
        if places(form) != places(forms(entry.id)[0])
    }
    assert differing == {}


@pytest.mark.parametrize("language", messages.LANGUAGES)
def test_no_translation_is_of_a_sentence_that_is_gone(language: str) -> None:
    catalogue = messages.read_catalogue(REPOSITORY, language)
    assert {entry.id for entry in catalogue if entry.id} <= sentences()
    assert not catalogue.obsolete


@pytest.mark.parametrize("language", messages.LANGUAGES)
def test_catalogues_are_as_the_tool_writes_them(language: str) -> None:
    catalogue = messages.read_catalogue(REPOSITORY, language)
    written = (REPOSITORY / messages.LOCALE / f"{language}.po").read_bytes()
    assert messages.written(messages.merged(catalogue, sentences())) == written


@pytest.mark.parametrize("language", messages.LANGUAGES)
def test_the_program_speaks_the_language(language: str) -> None:
    catalogue = messages.read_catalogue(REPOSITORY, language)
    written = {entry.id: entry.string for entry in catalogue if entry.id}
    words = Words(language)
    one = {sentence for sentence in sentences() if isinstance(sentence, str)}
    assert {sentence: words.translate(sentence) for sentence in one} == {
        sentence: string for sentence, string in written.items() if sentence in one
    }
    for counted in sentences() - one:
        said = {words.counted(*counted, count) for count in (1, 2, 5)}
        assert said == set(written[counted])
