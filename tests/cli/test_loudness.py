"""How much is said, which version says it, and what a shell completes."""

import io
import json
import logging
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from gripcourse import __version__
from gripcourse.cli import main as cli
from gripcourse.cli.loudness import is_quiet, is_verbose
from gripcourse.cli.options import NEEDS_PERSON
from gripcourse.errors import Problem
from gripcourse.text.words import message
from gripcourse.usecases.authoring.validate import Validation
from gripcourse.usecases.issuing.handout import Handout
from gripcourse.usecases.issuing.issue import Issuing

Say = Callable[..., tuple[int, str, str]]


@pytest.fixture
def say(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Say:
    """Call the command line: its exit code, and what it says on both streams."""

    def said(*arguments: str, system: str = "C", **environment: str) -> tuple[int, str, str]:
        monkeypatch.setenv("LC_ALL", system)
        for name, value in environment.items():
            monkeypatch.setenv(name, value)
        monkeypatch.setattr(sys, "argv", ["gripcourse", *arguments])
        capsys.readouterr()
        with pytest.raises(SystemExit) as left:
            cli.main()
        return (int(left.value.code or 0), *capsys.readouterr())

    return said


@pytest.fixture
def library_log() -> Iterator[logging.Logger]:
    """The log of the program, as it was before."""
    logger = logging.getLogger("gripcourse")
    before = logger.level, list(logger.handlers)
    yield logger
    logger.setLevel(before[0])
    logger.handlers[:] = before[1]


def test_the_version_is_told(say: Say) -> None:
    assert say("--version") == (0, f"gripcourse {__version__}\n", "")


def test_nothing_is_done_for_a_closed_output(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("LC_ALL", "C")
    monkeypatch.setattr(sys, "argv", ["gripcourse", "--version"])
    monkeypatch.setattr(sys, "stdout", None)
    with pytest.raises(SystemExit) as left:
        cli.main()
    assert (left.value.code, "closed" in capsys.readouterr().err) == (2, True)


@pytest.mark.parametrize(
    ("arguments", "quiet", "verbose"),
    [
        (["grade", "-q"], True, False),
        (["--quiet", "grade"], True, False),
        (["grade", "--verbose"], False, True),
        (["grade", "-qv"], True, True),
        (["grade", "q", "-", "--query"], False, False),
    ],
)
def test_the_words_themselves_tell_how_loud(
    monkeypatch: pytest.MonkeyPatch, arguments: list[str], *, quiet: bool, verbose: bool
) -> None:
    monkeypatch.setattr(sys, "argv", ["gripcourse", *arguments])
    assert (is_quiet(), is_verbose()) == (quiet, verbose)


@pytest.mark.parametrize("arguments", [["-q", "validate"], ["validate", "--quiet"]])
def test_quiet_leaves_out_what_was_done(
    say: Say, monkeypatch: pytest.MonkeyPatch, arguments: list[str]
) -> None:
    sound = Validation([], computed=True)
    monkeypatch.setattr("gripcourse.usecases.authoring.validate.validated", lambda _, **__: sound)
    assert say("validate") == (0, "The course is valid.\n", "")
    assert say(*arguments) == (0, "", "")


def test_quiet_keeps_problems_and_results(say: Say, monkeypatch: pytest.MonkeyPatch) -> None:
    problem = Problem("a.toml", "", message("Wrong."), message("Mend it."))
    found = Validation([problem], computed=True)
    monkeypatch.setattr("gripcourse.usecases.authoring.validate.validated", lambda _, **__: found)
    assert say("-q", "validate") == (cli.WRONG_USE, "", "a.toml: Wrong. Mend it.\n")
    assert say("-q", "--version")[1]


def test_quiet_keeps_whose_documents_could_not_be_made(
    say: Say, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    lost = Handout("s01", (), (message("The disk is full."),))
    monkeypatch.setattr(
        "gripcourse.usecases.issuing.issue.issue_order", lambda *_, **__: Issuing((lost,), ())
    )
    asked = ("-q", "issue", "--roster", str(tmp_path / "r.csv"), "--out", str(tmp_path / "out"))
    assert say(*asked) == (NEEDS_PERSON, "s01: The disk is full.\n", "")


def test_verbose_tells_how_it_ended(
    say: Say, monkeypatch: pytest.MonkeyPatch, library_log: logging.Logger
) -> None:
    sound = Validation([], computed=True)
    monkeypatch.setattr("gripcourse.usecases.authoring.validate.validated", lambda _, **__: sound)
    library_log.handlers.clear()
    code, said, error = say("-v", "validate")
    assert (code, said) == (0, "The course is valid.\n")
    assert "exit code 0" in error


def test_verbose_shows_the_trace_of_our_own_mistake(
    say: Say,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path_factory: pytest.TempPathFactory,
    library_log: logging.Logger,
) -> None:
    def fail(_root: object, **_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr("tempfile.tempdir", str(tmp_path_factory.mktemp("incidents")))
    monkeypatch.setattr("gripcourse.usecases.authoring.validate.validated", fail)
    code, _, error = say("validate", "--verbose")
    assert code == cli.OUR_MISTAKE
    assert "ZeroDivisionError" in error
    assert library_log.level == logging.DEBUG


@pytest.mark.parametrize(
    ("words", "place", "completed"),
    [
        ("gripcourse va", "1", {"validate", "variants"}),
        ("gripcourse variants i", "2", {"import"}),
        ("gripcourse grade --ou", "2", {"--out"}),
        ("gripcourse -", "1", {"--language", "--quiet", "-q", "--version", "--help"}),
        ("gripcourse nothing --o", "2", set()),
    ],
)
def test_a_shell_completes_commands_and_options(
    say: Say, words: str, place: str, completed: set[str]
) -> None:
    code, said, error = say(
        COMP_WORDS=words, COMP_CWORD=place, _GRIPCOURSE_COMPLETE="complete_bash"
    )
    assert (code, error) == (0, "")
    assert set(said.split()) >= completed
    assert completed or not said.strip()


def test_what_is_completed_is_explained_in_the_readers_language(say: Say) -> None:
    _, said, _ = say(
        system="uk_UA.UTF-8",
        _TYPER_COMPLETE_ARGS="gripcourse vali",
        _GRIPCOURSE_COMPLETE="complete_zsh",
    )
    assert "курс" in said


@pytest.mark.parametrize("encoding", ["cp1251", "cp866", "cp1252", "latin-1", "ascii"])
def test_a_terminal_without_the_letters_is_no_mistake_of_ours(
    monkeypatch: pytest.MonkeyPatch, encoding: str
) -> None:
    raw = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(raw, encoding=encoding))
    monkeypatch.setenv("LC_ALL", "uk_UA.UTF-8")
    monkeypatch.setattr(sys, "argv", ["gripcourse", "--help"])
    with pytest.raises(SystemExit) as left:
        cli.main()
    sys.stdout.flush()
    assert left.value.code == cli.WRONG_USE or not left.value.code
    assert b"--language" in raw.getvalue()


def test_json_loses_no_letter_on_such_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    plain = {"symbol": "θ_откр", "value": None}
    for encoding in ("cp1251", "latin-1", "utf-8"):
        stream = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
        monkeypatch.setattr(sys, "stdout", stream)
        text = cli.cli_text.json_text(plain)
        assert json.loads(text.encode(encoding).decode(encoding)) == plain
