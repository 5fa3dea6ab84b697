"""What the command line says of itself, in every language."""

import re
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Annotated

import pytest
import typer
from typer.core import TyperGroup

from gripcourse.cli import main as cli
from gripcourse.cli.grading_text import FLAGS
from gripcourse.cli.help import SpokenCommand, SpokenGroup, command_group
from gripcourse.errors import UsageError
from gripcourse.grading.flag_code import FlagCode
from gripcourse.likeness.model import NumberKind
from gripcourse.text.words import LANGUAGES
from support.command_line import put_together

SOURCES = Path(__file__).parents[2] / "src" / "gripcourse"

# Names of formats, ids and values that are typed as they stand, whatever the language.
TYPED = frozenset(
    (
        *("dask", "tcp", "tls", "host", "port"),
        *("ods", "xls"),
        *("csv", "xlsx", "zip", "json", "dxf", "svg", "url", "en", "ru", "uk", "corrected", "as"),
        *(
            "printed",
            "material",
            "steel",
            "mass",
            "atlas",
            "toml",
            "private",
            "gradebook",
            "sqlite",
            "raised",
            "lowered",
            "unchanged",
            "sourcedid",
            "email",
            "id",
        ),
    )
)

Help = Callable[..., str]


def commands_of(group: TyperGroup, path: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Paths of a group and of all commands below it."""
    yield path
    for name, command in group.commands.items():
        if isinstance(command, TyperGroup):
            yield from commands_of(command, (*path, name))
        else:
            yield (*path, name)


def root() -> TyperGroup:
    made = put_together(cli.app)
    assert isinstance(made, TyperGroup)
    return made


def find(path: tuple[str, ...]) -> SpokenCommand | SpokenGroup:
    command: object = root()
    for name in path:
        assert isinstance(command, TyperGroup)
        command = command.commands[name]
    assert isinstance(command, SpokenCommand | SpokenGroup)
    return command


COMMANDS = tuple(commands_of(root()))


@pytest.fixture
def speak(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Help:
    """Call the command line; everything that it says, on both streams."""

    def said(*arguments: str, system: str = "C") -> str:
        monkeypatch.setenv("LC_ALL", system)
        monkeypatch.setattr(sys, "argv", ["gripcourse", *arguments])
        monkeypatch.setattr("typer.main.get_command", put_together)
        capsys.readouterr()
        with pytest.raises(SystemExit):
            cli.main()
        return "".join(capsys.readouterr())

    return said


def latin_left(text: str, command: typer.core.TyperCommand | TyperGroup) -> set[str]:
    """Latin words of a help page that are no names of options, commands, formats or values."""
    names = {name for path in COMMANDS for name in path} | {"gripcourse"}
    values = {str(parameter.default) for parameter in command.params}
    without = re.sub(r"--[a-z][a-z-]*", " ", text)
    words = {word.lower() for word in re.findall(r"[A-Za-z]{2,}", without)}
    known = {part.lower() for one in names | values for part in re.findall(r"[A-Za-z]+", one)}
    return words - known - TYPED


@pytest.mark.parametrize("language", LANGUAGES[1:])
@pytest.mark.parametrize("path", COMMANDS, ids=" ".join)
def test_no_english_is_left_in_the_help_of_a_command(
    speak: Help, path: tuple[str, ...], language: str
) -> None:
    page = speak(*path, "--help", "--language", language)
    assert latin_left(page, find(path)) == set()
    assert re.search("[а-яіїє]", page)


@pytest.mark.parametrize("path", COMMANDS, ids=" ".join)
def test_a_command_tells_everything_that_it_takes(speak: Help, path: tuple[str, ...]) -> None:
    page = speak(*path, "--help")
    command = find(path)
    assert command.help
    for parameter in command.params:
        assert getattr(parameter, "help", ""), parameter.name
        shown = parameter.opts if parameter.param_type_name == "option" else [parameter.metavar]
        assert all(one and one in page for one in shown), parameter.name


def test_a_new_option_that_nobody_translated_is_noticed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    app = command_group("Some group.")

    @app.command(cls=SpokenCommand)
    def newly(speed: Annotated[int, typer.Option(help="How quickly.")] = 1) -> None:
        """Do something new."""

    monkeypatch.setattr(sys, "argv", ["x", "--language", "ru"])
    app(["newly", "--help"], standalone_mode=False)
    command = typer.main.get_command(app)
    assert isinstance(command, TyperGroup)
    (made,) = command.commands.values()
    assert isinstance(made, SpokenCommand)
    left = latin_left(capsys.readouterr().out, made)
    assert {"how", "quickly", "do", "something", "new"} <= left


@pytest.mark.parametrize(
    ("arguments", "system", "language"),
    [
        (["--help"], "C", "en"),
        (["--help"], "de_DE.UTF-8", "en"),
        (["--help"], "uk_UA.UTF-8", "uk"),
        (["--language", "ru", "--help"], "uk_UA.UTF-8", "ru"),
        (["--help", "--language=ru"], "C", "ru"),
        (["--language", "ru", "validate", "--help"], "C", "ru"),
        (["validate", "--language", "uk", "--help"], "ru_RU.UTF-8", "uk"),
        (["--language", "ru", "validate", "--language", "en", "--help"], "uk_UA.UTF-8", "en"),
        (["validate", "--language", "de", "--help"], "uk_UA.UTF-8", "uk"),
    ],
)
def test_the_language_named_last_counts_then_that_of_the_system(
    speak: Help, arguments: list[str], system: str, language: str
) -> None:
    usage = {"en": "Usage:", "ru": "Использование:", "uk": "Використання:"}[language]
    assert speak(*arguments, system=system).startswith(usage)


def test_a_language_named_before_the_command_counts_for_the_command(speak: Help) -> None:
    after = speak("solve", "999", "--language", "uk")
    assert speak("--language", "uk", "solve", "999") == after
    assert speak("variants", "audit", "--table", "no", "--language", "ru") == speak(
        *("--language", "uk", "variants", "--language", "ru", "audit", "--table", "no")
    )
    assert "'de'" in speak("--language", "de", "validate")


def test_a_group_alone_shows_its_help_and_is_wrong_use(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for group in ([], ["variants"], ["tolerance"]):
        monkeypatch.setattr(sys, "argv", ["gripcourse", *group, "--language", "ru"])
        with pytest.raises(SystemExit) as left:
            cli.main()
        assert left.value.code == cli.WRONG_USE
        assert "Команды:" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        (["marc", "a"], ["'marc'", "'mark'"]),
        (["validate", "a", "b"], ["'a b'"]),
        (["validate", "--corse", "x"], ["--corse", "'--course'"]),
        (["validate", "--course"], ["--course"]),
        (["solve", "001", "--json=1"], ["--json"]),
        (["grade", "a.xlsx"], ["--out", "gripcourse grade --help"]),
        (["check"], ["file"]),
        (["variants", "draw", "--seed", "1", "--count", "0"], ["--count", "'0'", "from 1 to"]),
        (["variants", "draw", "--seed", "-1", "--count", "1"], ["--seed", "'-1'", "at least 0"]),
        (["evaluate", "--in-memory", "--count", "x"], ["--count", "'x'", "whole number"]),
        (["issue", "--roster", "r", "--out", "o", "--date", "1.9."], ["--date", "'1.9.'", "2026"]),
        (["mark", "s01", "drawing", "--points", "viel"], ["--points", "'viel'"]),
    ],
)
def test_what_the_parser_refuses_is_one_sentence_in_every_language(
    speak: Help, arguments: list[str], named: list[str]
) -> None:
    said = speak(*arguments)
    assert said.count("\n") == 1
    assert all(one in said for one in named), said
    for language in LANGUAGES[1:]:
        spoken = speak(*arguments, system=language)
        words = re.sub(r"gripcourse[a-z ]+|\S*[-/.]\S*", " ", spoken)
        assert set(re.findall(r"[A-Za-z]{2,}", words)) <= {"marc", "mark", "viel"}, spoken


def test_a_refusal_is_an_error_like_any_other() -> None:
    with pytest.raises(UsageError) as caught:
        cli.app(["validate", "--corse", "x"], standalone_mode=False)
    (problem,) = caught.value.problems
    assert problem.key == "--corse"


def test_every_flag_has_its_words() -> None:
    assert set(FLAGS) == set(FlagCode)


def test_every_kind_of_likeness_has_its_flag() -> None:
    assert {kind.value for kind in NumberKind} <= set(FlagCode)
