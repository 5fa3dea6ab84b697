"""The library says what is wrong; the command line adds what is typed to mend it."""

import ast
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.cli import grade as cli_grade
from gripcourse.cli import main as cli
from gripcourse.cli.problems import TYPED, said_of, spoken
from gripcourse.cli.text import progress
from gripcourse.errors import NextStep, Problem
from gripcourse.text.words import LANGUAGES, Words, message

SOURCES = Path(__file__).parents[2] / "src" / "gripcourse"
ALONE = (*cli.app.registered_commands, *cli_grade.app.registered_commands)
COMMANDS = "|".join(one.name or one.callback.__name__ for one in ALONE)
TYPED_WORD = re.compile(rf"(?<![\w-])--[a-z]|gripcourse ({COMMANDS})\b")


def sentences(source: str) -> Iterator[str]:
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "message" and node.args:
            yield ast.literal_eval(node.args[0])


def test_the_library_never_speaks_of_options_and_commands() -> None:
    found = [
        f"{path.relative_to(SOURCES)}: {text}"
        for path in sorted(SOURCES.rglob("*.py"))
        if path.parent.name != "cli"
        for text in sentences(path.read_text(encoding="utf-8"))
        if TYPED_WORD.search(text)
    ]
    assert found == []


def test_an_option_in_a_sentence_is_noticed() -> None:
    (text,) = sentences('message("Set it with --set, or " "leave it.", name=1)')
    assert TYPED_WORD.search(text)
    assert TYPED_WORD.search("Grade it first: gripcourse grade.")
    assert not TYPED_WORD.search("Install gripcourse again -- or not.")


@pytest.mark.parametrize("step", NextStep)
@pytest.mark.parametrize("language", LANGUAGES)
def test_every_step_has_what_is_typed(step: NextStep, language: str) -> None:
    problem = Problem("book", "", message("Wrong."), message("Mend it."), step=step)
    assert TYPED[step] in spoken(problem, Words(language))
    assert TYPED[step] not in problem.say(Words(language))


def test_a_parameter_is_called_what_its_option_is_called() -> None:
    problem = Problem("", "mass", message("Wrong."), message("Mend it."), parameter="given")
    assert problem.say(Words("en")) == "given: mass: Wrong. Mend it."
    assert spoken(problem, Words("en")) == "--set: mass: Wrong. Mend it."


@pytest.mark.parametrize("language", LANGUAGES)
def test_of_thousands_of_problems_those_are_said_that_somebody_reads(language: str) -> None:
    words = Words(language)
    many = [
        Problem("a.csv", f"{row}", message("Row {row} is bad.", row=row), message("Mend it."))
        for row in range(5_000)
    ]
    *lines, last = said_of(many, words)
    assert lines == [spoken(one, words) for one in many[:100]]
    assert "4900" in last
    assert list(said_of(many[:100], words)) == lines


def test_what_is_wrong_in_many_places_of_a_file_is_said_once() -> None:
    wrong, mend = message("There is no section 'duty'."), message("Write it.")
    many = [Problem("a.toml", f"quantity.{name}.section", wrong, mend) for name in "pqrstu"]
    shown = replace(many[0], key="quantity.v.formula", excerpt="  1 + v\n      ^")
    elsewhere = Problem("b.toml", "quantity.w.section", wrong, mend)
    first, second = (f"quantity.{a}.section; quantity.{b}.section" for a, b in ("pq", "rs"))
    assert list(said_of([*many, shown, elsewhere], Words("en"))) == [
        f"a.toml: {first}; {second} and 2 more: There is no section 'duty'. Write it.",
        "a.toml: quantity.v.formula: There is no section 'duty'. Write it.\n  1 + v\n      ^",
        "b.toml: quantity.w.section: There is no section 'duty'. Write it.",
    ]


def test_a_name_that_is_missed_in_three_places_and_more_is_told_once_with_all_of_them() -> None:
    missed, near = message("No '{name}'.", name="g"), message("Did you mean 'gravity'?")
    listed = message("Known here: a.")
    places = [("a.toml", "p"), ("a.toml", "q"), ("b.toml", "r")]
    found = [
        Problem(file, key, missed, near if file == "a.toml" else listed, f"  {key} + g")
        for file, key in places
    ]
    (told,) = said_of(found, Words("en"))
    assert told == (
        "a.toml: p: No 'g'. And in 2 more places: q; b.toml: r. Did you mean 'gravity'?\n  p + g"
    )
    assert len(list(said_of(found[:2], Words("en")))) == 2
    other = replace(found[2], what=message("No '{name}'.", name="h"))
    assert len(list(said_of([*found[:2], other], Words("en")))) == 3


@pytest.mark.parametrize(
    ("language", "student", "item", "folder"),
    [
        ("en", "<student>", "<item>", "<folder>"),
        ("ru", "<студент>", "<пункт>", "<папка>"),
        ("uk", "<студент>", "<пункт>", "<папка>"),
    ],
)
def test_what_has_no_option_is_called_as_the_help_calls_it(
    language: str, student: str, item: str, folder: str
) -> None:
    words = Words(language)
    for parameter, called in (("student", student), ("quantity", item), ("graded", folder)):
        problem = Problem("", "", message("Name one."), message(""), parameter=parameter)
        assert spoken(problem, words).startswith(f"{called}: ")


@pytest.mark.parametrize(("language", "unit"), [("en", "/min"), ("ru", "/мин"), ("uk", "/хв")])
def test_how_fast_it_goes_is_said_in_the_readers_language(
    language: str,
    unit: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("sys.argv", ["gripcourse", "grade"])
    with progress(Words(language)) as step:
        step("…", 1)()
    assert re.search(rf"1/1 \d+{unit} ", capsys.readouterr().err)
