from pathlib import Path

import pytest
from jinja2 import TemplateSyntaxError

import messages


@pytest.fixture
def root(tmp_path: Path) -> Path:
    for folder in ("src", "templates", messages.LOCALE):
        (tmp_path / folder).mkdir(parents=True, exist_ok=True)
    return tmp_path


def sentences_of(root: Path, python: str = "", template: str = "") -> list[str]:
    (root / "src" / "some.py").write_text(python, encoding="utf-8")
    (root / "templates" / "some.html.j2").write_text(template, encoding="utf-8")
    return list(messages.extracted(root))


def catalogue_text(root: Path, language: str) -> str:
    return (root / messages.LOCALE / f"{language}.po").read_text(encoding="utf-8")


def test_strings_written_side_by_side_are_one_sentence(root: Path) -> None:
    source = 'message(\n    "A force of {force} "\n    "is too large.",\n    force=1.0,\n)'
    assert sentences_of(root, source) == ["A force of {force} is too large."]


def test_a_sentence_inside_a_sentence_is_found(root: Path) -> None:
    source = 'message("outer {a} {b}", a=message("inner"), b=[message("each") for _ in range(2)])'
    assert sorted(sentences_of(root, source)) == ["each", "inner", "outer {a} {b}"]


def test_values_are_no_sentences(root: Path) -> None:
    assert sentences_of(root, 'message("unit {unit}", unit="mm")') == ["unit {unit}"]


def test_escapes_and_letters_beyond_ascii_are_kept(root: Path) -> None:
    assert sentences_of(root, 'words.translate("a line\\nand “another”")') == [
        "a line\nand “another”"
    ]


def test_only_the_two_functions_count(root: Path) -> None:
    assert sentences_of(root, 'print("a"); other("b"); def_message("c")') == []


def test_the_help_of_commands_is_read_where_it_is_declared(root: Path) -> None:
    source = (
        'app = command_group("Some group.")\n'
        'Speed = Annotated[int, typer.Option("--speed", metavar="number", help="How quickly.")]\n'
        'Workers = typer.Option(help="How many.", show_default="processors", hidden=False)\n'
        '@app.command("run", cls=Spoken)\n'
        'def run(speed: Speed) -> None:\n    """Do it."""\n'
        'def other() -> None:\n    """Nothing that is shown."""\n'
    )
    path = root / "src" / "gripcourse" / "cli" / "some.py"
    path.parent.mkdir(parents=True)
    path.write_text(source, encoding="utf-8")
    assert sorted(messages.extracted(root)) == sorted(
        ["Some group.", "number", "How quickly.", "How many.", "processors", "Do it."]
    )


def test_templates_are_read(root: Path) -> None:
    template = """{% if x %}<p title="{{ _('Marks') }}">{{ _("Total: ") }}{{ say(x) }}{% endif %}"""
    assert sentences_of(root, template=template) == ["Marks", "Total: "]


def test_a_template_that_does_not_parse_is_an_error(root: Path) -> None:
    with pytest.raises(TemplateSyntaxError):
        sentences_of(root, template='{% if %}{{ _("lost") }}')


def test_a_new_sentence_appears_without_a_translation(root: Path) -> None:
    sentences_of(root, 'message("New.")')
    assert messages.main(["update", "--root", str(root)]) == 1
    assert 'msgid "New."\nmsgstr ""\n' in catalogue_text(root, "ru")


def test_translations_survive_an_update_and_obsolete_ones_do_not(root: Path) -> None:
    sentences_of(root, 'message("Kept {n}.")')
    for language in messages.LANGUAGES:
        catalogue = messages.Catalog(locale=language)
        catalogue.add("Kept {n}.", "Осталось {n}.")
        catalogue.add("Gone.", "Ушло.")
        path = root / messages.LOCALE / f"{language}.po"
        path.write_bytes(messages.written(catalogue))
    assert messages.main(["update", "--root", str(root)]) == 0
    text = catalogue_text(root, "uk")
    assert 'msgstr "Осталось {n}."' in text
    assert "Gone" not in text


def test_a_changed_sentence_is_never_given_a_similar_translation() -> None:
    catalogue = messages.Catalog(locale="ru")
    catalogue.add("The force is too large.", "Сила слишком велика.")
    result = messages.merged(catalogue, ["The force is too small."])
    assert messages.untranslated(result, ["The force is too small."]) == ["The force is too small."]


def test_an_update_of_what_is_up_to_date_changes_nothing(root: Path) -> None:
    sentences_of(root, 'message("B"); message("A"); message("50 % of {b}"); message("A")')
    messages.update(root)
    before = catalogue_text(root, "ru")
    messages.update(root)
    assert catalogue_text(root, "ru") == before
    assert before.index('msgid "A"') < before.index('msgid "B"')


def test_catalogues_carry_no_dates_places_or_names(root: Path) -> None:
    sentences_of(root, 'message("A")')
    messages.update(root)
    text = catalogue_text(root, "ru")
    assert not {"Date", "some.py", "Generated", "Translator"} & set(text.replace("-", " ").split())
    assert "Plural-Forms: nplurals=3;" in text


def test_what_is_missing_is_listed(root: Path, capsys: pytest.CaptureFixture[str]) -> None:
    sentences_of(root, 'message("A")')
    assert messages.main(["missing", "--root", str(root)]) == 1
    assert capsys.readouterr().out == "ru: 'A'\nuk: 'A'\n"
