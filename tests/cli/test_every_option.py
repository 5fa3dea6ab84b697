"""Whatever lies at a path that a command is given: a sentence and exit code 2, never a traceback.

The commands and their options are found in the command line itself: a new one is tested unasked.
"""

import logging
import shutil
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import pytest
from pypdf import PdfWriter

from gripcourse.cli.main import app
from gripcourse.machine.resources import course_root
from support.command_line import Run, call, put_together

# What a command wants besides the path that is tried; "{}" is a folder with nothing in it.
REQUIRED: dict[str, tuple[str, ...]] = {
    "issue": ("--roster", "roster.csv", "--out", "out", "--workers", "0"),
    "reissue": ("s1", "--why", "slip", "--out", "out", "--workers", "0"),
    "withdraw": ("s1", "--why", "left"),
    "grade": ("junk.xlsx", "--out", "out", "--workers", "0"),
    "check": ("junk.xlsx",),
    "draw": ("001",),
    "solve": ("001", "--xlsx"),
    "mark": ("--list",),
    "trace": ("12",),
    "evaluate": ("--in-memory", "--count", "1"),
    "simulate": ("--count", "1", "--workers", "0"),
    "variants draw": ("--count", "1", "--seed", "1"),
    "variants import": ("table.csv",),
    "tolerance audit": ("--count", "0"),
    "atlas": ("none",),
    "init": ("new",),
    "lti register": (
        *("moodle", "--client-id", "1", "--deployment", "1"),
        *("--moodle", "https://moodle.example"),
    ),
    "lti bind": ("user-1", "s1"),
    "lti roster": ("--out", "roster"),
}
# A student's file that cannot be used is no wrong use: it is refused in the student's report.
MAY_REFUSE_A_FILE = {"grade", "check", "regrade"}
# An option to write to: what lies there is replaced, and only a folder or no folder is wrong.
WRITTEN = {"--out", "--misses", "--ledger", "--print"}
# What is read from a folder: that one is empty is no fault.
FROM_FOLDERS = {"serve"}
HOSTILE = ("missing", "empty", "folder", "noise", "long")
# What takes long, and the option that says where its results go: the function that computes.
LONG = {
    ("evaluate", "--misses"): "gripcourse.usecases.measuring.virtual.make_classroom",
    ("tolerance audit", "--out"): "gripcourse.usecases.measuring.tolerance.read_table",
    ("variants audit", "--out"): "gripcourse.usecases.solving.audit.audit",
    ("variants draw", "--out"): "gripcourse.usecases.solving.variants.draw_variants",
}
WANTS_A_FOLDER = {"variants audit"}


def commands() -> Iterator[tuple[str, Any]]:
    """Yield every command by its words."""

    def below(words: str, one: Any) -> Iterator[tuple[str, Any]]:  # noqa: ANN401 (the library names no type)
        inner = getattr(one, "commands", None)
        if inner is None:
            yield words, one
        else:
            for name, command in inner.items():
                yield from below(f"{words} {name}".strip(), command)

    yield from below("", put_together(app))


def paths() -> Iterator[tuple[str, str, str]]:
    """Yield every path of every command: the command's words, the name, and how it is typed."""
    for words, command in commands():
        callback = getattr(command.callback, "__wrapped__", command.callback)
        hints = get_type_hints(callback, include_extras=True)
        for one in command.params:
            if _is_path(hints.get(one.name)):
                typed = next((two for two in one.opts if two.startswith("--")), "")
                yield words, one.name, typed


def _is_path(hint: Any) -> bool:  # noqa: ANN401 (any annotation)
    if get_origin(hint) is Annotated:
        hint = get_args(hint)[0]
    return hint is Path or any(_is_path(one) for one in get_args(hint))


def is_written(words: str, typed: str) -> bool:
    return typed in WRITTEN or (words == "init" and not typed)


def kinds(words: str, name: str, typed: str) -> tuple[str, ...]:
    if is_written(words, typed):
        return ("below_a_file",)
    # One reader looks at the courses of all commands.
    if name == "course":
        return ("missing", "noise")
    return tuple(kind for kind in HOSTILE if not (words in FROM_FOLDERS and kind == "folder"))


def cases() -> list[tuple[str, str, str, str]]:
    return [
        (words, name, typed, kind)
        for words, name, typed in paths()
        for kind in kinds(words, name, typed)
    ]


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with something of every wrong kind in it."""
    folder = tmp_path_factory.mktemp("hostile")
    shutil.copytree(course_root() / "examples" / "belt_drive", folder / "course")
    (folder / "empty").write_bytes(b"")
    (folder / "folder").mkdir()
    (folder / "noise").write_bytes(bytes(range(256)) * 64 + b"PK\x03\x04" * 64 + b"\x1b[31m\n\r\0")
    (folder / "junk.xlsx").write_bytes(b"PK\x03\x04 no workbook")
    (folder / "roster.csv").write_text("student,name\ns1,Anna\n", encoding="utf-8")
    (folder / "table.csv").write_text("variant\n1\n", encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def page() -> bytes:
    """A page with nothing on it."""
    writer, stream = PdfWriter(), BytesIO()
    writer.add_blank_page(595, 842)
    writer.write(stream)
    return stream.getvalue()


@pytest.fixture(autouse=True)
def sheets_cost_nothing(page: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where a path is refused last, students are issued to before: nobody reads their sheets."""
    monkeypatch.setattr("gripcourse.usecases.issuing.handout.assignment_sheet", lambda *_: page)


def place(kind: str) -> str:
    return {
        "missing": "nowhere/at-all",
        "long": "x" * 300,
        "below_a_file": "roster.csv/inside.xlsx",
    }.get(kind, kind)


def run(home: Path, words: str, name: str, typed: str, kind: str) -> Run:
    required = list(REQUIRED.get(words, ()))
    if typed in required:
        at = required.index(typed)
        del required[at : at + 2]
    elif not typed and required and not required[0].startswith("-"):
        del required[0]
    tried = (typed, place(kind)) if typed else (place(kind),)
    course = () if name == "course" else ("--course", "course")
    if not any(one.name == "course" for one in dict(commands())[words].params):
        course = ()
    return call(home, *words.split(), *tried, *required, *course, "--quiet")


@pytest.mark.parametrize(("words", "name", "typed", "kind"), cases())
def test_what_cannot_be_used_is_refused_in_a_sentence(
    words: str, name: str, typed: str, kind: str, home: Path, caplog: pytest.LogCaptureFixture
) -> None:
    with caplog.at_level(logging.ERROR):
        done = run(home, words, name, typed, kind)
    said = done.out + done.err
    assert "Traceback" not in said + caplog.text
    assert "\x1b" not in said
    if words in MAY_REFUSE_A_FILE and done.code != 2:
        return
    assert done.code == 2, said
    # Where it is, what is wrong, and how it is mended.
    assert done.err.count(". ") >= 1, said
    assert not list(home.rglob(".*.????????*")), "something was left half-written"


@pytest.mark.parametrize("kind", ["below_a_file", "other", "long", "not_writable"])
@pytest.mark.parametrize(("words", "typed"), LONG)
def test_where_nothing_can_be_written_nothing_is_computed(
    words: str, typed: str, kind: str, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def compute(*_arguments: object, **_options: object) -> None:
        pytest.fail("It was computed first.")

    monkeypatch.setattr(LONG[words, typed], compute)
    if kind == "not_writable":  # root may write everywhere
        monkeypatch.setattr("gripcourse.machine.files.os.access", lambda *_: False)
    if kind == "other":
        kind = "noise" if words in WANTS_A_FOLDER else "folder"
    done = run(home, words, typed.strip("-"), typed, kind)
    assert done.code == 2, done.out + done.err
    assert done.err.count(". ") >= 1
