"""A sentence that lost a value in translation is never shown, and always named."""

from pathlib import Path

import pytest

from gripcourse.text.translations import Kind, catalogue_file, places, read_translations

HEAD = r"""msgid ""
msgstr ""
"Content-Type: text/plain; charset=utf-8\n"
"Plural-Forms: nplurals={count}; plural={rule};\n"

msgid "One {{thing}}."
msgstr "Одна {{thing}}."

"""
RULE = "(n%10==1 && n%100!=11 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2)"
SENTENCE = "{count} cells of {file}."


def catalogue(folder: Path, translated: str = "", count: str = "3", rule: str = RULE) -> Path:
    text = HEAD.format(count=count, rule=rule)
    text += f'msgid "{SENTENCE}"\nmsgstr "{translated}"\n'
    path = folder / "ru.po"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("language", ["ru", "uk"])
def test_the_catalogues_of_the_program_are_whole(language: str) -> None:
    assert read_translations(catalogue_file(language), language).faults == ()


@pytest.mark.parametrize(
    ("translated", "kinds", "detail"),
    [
        ("Ячеек: {count}.", ["lost"], "file"),
        ("{count} из {file} и {other}.", ["invented"], "other"),
        ("{count} из {fiel}.", ["lost", "invented"], "file"),
        ("{count} из {file.", ["braces"], "{count} из {file."),
        ("{} из {file}.", ["lost", "invented"], "count"),
    ],
)
def test_a_sentence_that_cannot_be_used_is_named_and_stays_english(
    tmp_path: Path, translated: str, kinds: list[Kind], detail: str
) -> None:
    read = read_translations(catalogue(tmp_path, translated), "ru")
    assert [fault.kind for fault in read.faults] == kinds
    assert read.faults[0].detail == detail
    assert {fault.line for fault in read.faults} == {9}
    assert read.catalogue.gettext(SENTENCE) == SENTENCE
    assert read.catalogue.gettext("One {thing}.") == "Одна {thing}."


@pytest.mark.parametrize("translated", ["Из {file}: {count} ячеек.", "{count!s} из {file}", ""])
def test_a_sentence_with_the_same_values_is_right_in_any_order(
    tmp_path: Path, translated: str
) -> None:
    read = read_translations(catalogue(tmp_path, translated), "ru")
    assert read.faults == ()
    assert read.catalogue.gettext(SENTENCE) == (translated or SENTENCE)


@pytest.mark.parametrize(
    ("count", "rule", "kind"),
    [
        ("2", "(n != 1)", "plural"),
        ("3", "n===3", "unreadable"),
        ("3", "__import__('os')", "unreadable"),
        ("many", RULE, "unreadable"),
    ],
)
def test_plural_forms_that_are_not_those_of_the_language_are_named(
    tmp_path: Path, count: str, rule: str, kind: Kind
) -> None:
    read = read_translations(catalogue(tmp_path, count=count, rule=rule), "ru")
    assert [fault.kind for fault in read.faults] == [kind]


@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (b"", "empty"),
        (b"\xff\xfe\x00", "unreadable"),
        (b"<<<<<<< one side\n", "unreadable"),
        (b'msgid ""\nmsgstr "Content-Type: text/plain; charset=koi\\n"\n', "unreadable"),
    ],
)
def test_a_catalogue_that_is_none_leaves_everything_english(
    tmp_path: Path, content: bytes, kind: Kind
) -> None:
    path = tmp_path / "ru.po"
    path.write_bytes(content)
    read = read_translations(path, "ru")
    assert [fault.kind for fault in read.faults] == [kind]
    assert read.catalogue.gettext(SENTENCE) == SENTENCE


def test_a_catalogue_that_is_missing_is_named(tmp_path: Path) -> None:
    (fault,) = read_translations(tmp_path / "ru.po", "ru").faults
    assert fault.kind == "unreadable"


def test_places_are_named_whatever_their_form() -> None:
    assert places("{a} {b!r} {c:.2f} {{d}}") == {"a", "b", "c"}
    assert places("{a") is None
