"""What is refused is said in one line, with its exit code, and nothing is left behind."""

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import pytest

from gripcourse.cli import main as cli
from gripcourse.machine.database.home import gradebook_path
from support.cli_term import ROSTER, SCHEME, Command, refused


def table_with(course: Path, column: str, value: str) -> Path:
    """Change a cell of the first variant of the main table."""
    rows = (course / "variants" / "tables" / "main.csv").read_text(encoding="utf-8-sig")
    cells = [row.split(",") for row in rows.splitlines()]
    cells[1][cells[0].index(column)] = value
    table = course.parent / "changed.csv"
    table.write_text("\n".join(",".join(row) for row in cells) + "\n", encoding="utf-8")
    return table


def left_behind(folder: Path, but: Sequence[str] = ()) -> set[str]:
    return {path.name for path in folder.iterdir()} - set(but)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        pytest.param(["solve", "999"], ["no variant '999'"], id="unknown variant"),
        pytest.param(["solve"], ["--scheme"], id="neither variant nor scheme"),
        pytest.param(["solve", "001", "--set", "mass=5"], ["--scheme"], id="set of a variant"),
        pytest.param(["solve", "--scheme", "four_bar"], ["four_bar", SCHEME], id="scheme"),
        pytest.param(
            ["solve", "--scheme", SCHEME, "--set", "mass=-5"],
            ["mass", "0.001"],
            id="negative mass",
        ),
        pytest.param(
            ["solve", "--scheme", SCHEME, "--set", "friction=0"],
            ["friction", "0.01"],
            id="zero friction",
        ),
        pytest.param(
            ["solve", "--scheme", SCHEME, "--set", "mas=5"], ["mas", "'mass'"], id="misspelt"
        ),
        pytest.param(["solve", "--scheme", SCHEME, "--set", "mass"], ["name=value"], id="no value"),
        pytest.param(
            ["solve", "--scheme", SCHEME, "--option", "drive=steam"],
            ["steam", "hydraulic", "pneumatic"],
            id="unknown option",
        ),
        pytest.param(["solve", "001", "--language", "de"], ["de", "uk"], id="language"),
        pytest.param(["solve", "001", "--convention", "x"], ["corrected"], id="convention"),
        pytest.param(["solve", "001", "--table", "no.csv"], ["no.csv"], id="no table"),
        pytest.param(["validate", "--course", "nowhere"], ["nowhere"], id="no course"),
        pytest.param(
            ["variants", "draw", "--count", 2, "--seed", 1, "--scheme", "four_bar"],
            ["--scheme", "four_bar"],
            id="no space",
        ),
        pytest.param(["variants", "import", "own.csv"], ["own.csv"], id="no table to import"),
        pytest.param(["grade", "no.xlsx", "--out", "out"], ["no.xlsx"], id="nothing to grade"),
        pytest.param(["check", "no.xlsx"], ["no.xlsx"], id="nothing to check"),
        pytest.param(["mark"], ["--table", "--list"], id="nothing to mark"),
        pytest.param(["mark", "s01"], ["a student and an item"], id="no item"),
        pytest.param(
            ["mark", "--list", "--table", "marks.csv"], ["--list"], id="two marks at once"
        ),
        pytest.param(
            ["mark", "--list", "--gradebook", "no.sqlite"],
            ["no.sqlite", "gripcourse grade"],
            id="no gradebook",
        ),
        pytest.param(["issue", "--roster", "no.csv", "--out", "out"], ["no.csv"], id="no roster"),
    ],
)
def test_one_line_says_what_and_where_and_nothing_is_written(
    gripcourse: Command, tmp_path: Path, arguments: list[object], said: list[str]
) -> None:
    refused(gripcourse(*arguments), *said)
    assert left_behind(tmp_path) == set()


def test_every_path_that_is_not_there_has_its_line(gripcourse: Command) -> None:
    run = gripcourse("grade", "a.xlsx", "b.xlsx", "--out", "out")
    assert run.code == cli.WRONG_USE
    assert [line.split(":")[0] for line in run.problems] == ["a.xlsx", "b.xlsx"]


@pytest.mark.parametrize(
    "arguments",
    [
        ["nope"],
        ["grade", "a.xlsx"],
        ["grade", "a.xlsx", "--out", "out", "--date", "2026-13-01"],
        ["variants", "draw", "--count", "0", "--seed", "1"],
        ["mark", "s01", "general_view_drawing", "--points", "viel"],
    ],
)
def test_the_parsers_own_refusals_have_the_same_code(
    gripcourse: Command, tmp_path: Path, arguments: list[str]
) -> None:
    run = gripcourse(*arguments)
    assert run.code == cli.WRONG_USE
    assert "Traceback" not in run.err
    assert left_behind(tmp_path) == set()


def test_a_file_that_is_no_workbook_is_refused_with_its_reason(
    gripcourse: Command, tmp_path: Path
) -> None:
    file = tmp_path / "ответы.xlsx"
    file.write_bytes("усилие;3900".encode("cp1251"))
    refused(gripcourse("check", file), "ответы.xlsx", ".xlsx")


@pytest.mark.parametrize(
    ("column", "value"), [("mass [kg]", "-5"), ("friction", "0"), ("scheme", "four_bar")]
)
def test_a_bad_cell_of_a_table_is_named_by_file_row_and_column(
    gripcourse: Command, course: Path, column: str, value: str
) -> None:
    table = table_with(course, column, value)
    out = course.parent / "assignments"
    roster = course / "variants" / "roster.csv"
    run = gripcourse(
        *("issue", "--course", course, "--roster", roster),
        *("--table", table, "--out", out),
    )
    refused(run, "changed.csv", "row 2", column.split(maxsplit=1)[0])
    assert not out.exists()
    assert not gradebook_path(course).exists()


@pytest.mark.parametrize(
    ("content", "said"),
    [
        pytest.param(b"student,name\n\xff\0\n", ["not in UTF-8", "line 2"], id="no text"),
        pytest.param((ROSTER + "s01,Петров,,,,\n").encode(), ["row 4", "s01"], id="doubled id"),
        pytest.param(b"", ["roster.csv"], id="empty"),
        pytest.param(b"student,name\n", ["no students"], id="headings only"),
        pytest.param("шифр\ns01\n".encode(), ["name"], id="no names"),
    ],
)
def test_a_bad_roster_is_refused_and_nothing_is_issued(
    gripcourse: Command, course: Path, content: bytes, said: list[str]
) -> None:
    roster = course / "variants" / "roster.csv"
    roster.write_bytes(content)
    out = course.parent / "assignments"
    run = gripcourse("issue", "--course", course, "--roster", roster, "--out", out)
    refused(run, "roster.csv", *said)
    assert not out.exists()
    assert not gradebook_path(course).exists()


def test_a_damaged_gradebook_is_refused_before_anything_is_graded(
    gripcourse: Command, course: Path, tmp_path: Path
) -> None:
    file, book = tmp_path / "s01.xlsx", tmp_path / "book.sqlite"
    file.write_bytes(b"")
    book.write_text("student;points\n" * 100, encoding="utf-8")
    run = gripcourse(
        *("grade", file, "--course", course, "--gradebook", book, "--out", tmp_path / "out")
    )
    refused(run, "book.sqlite", "not a database", "backup")
    assert not (tmp_path / "out").exists()


def test_a_place_that_cannot_be_written_is_named(gripcourse: Command, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("…", encoding="utf-8")
    out = tmp_path / "file" / "drawn.csv"
    refused(gripcourse("variants", "draw", "--count", 1, "--seed", 1, "--out", out), "file")


def test_one_file_is_not_written_twice(gripcourse: Command, tmp_path: Path) -> None:
    run = gripcourse("solve", "001", "--pdf", "--xlsx", "--out", "solution.pdf")
    refused(run, "--out", "two documents")
    assert left_behind(tmp_path) == set()


def test_the_demo_never_removes_what_it_did_not_make(gripcourse: Command, tmp_path: Path) -> None:
    work = tmp_path / "submissions" / "s01.xlsx"
    work.parent.mkdir()
    work.write_bytes(b"somebody's work")
    refused(gripcourse("demo", "--out", tmp_path), str(tmp_path), "not empty")
    assert work.read_bytes() == b"somebody's work"
    assert left_behind(tmp_path) == {"submissions"}


def test_problems_are_said_in_the_language_of_the_system(gripcourse: Command) -> None:
    said = [
        gripcourse("solve", "999", system=system).err
        for system in ("C", "de_DE.UTF-8", "ru_RU.UTF-8", "uk_UA.UTF-8")
    ]
    assert said[0] == said[1]
    assert len(set(said)) == 3


@pytest.mark.parametrize(
    "fault",
    [
        MemoryError(),
        RuntimeError("can't start new thread"),
        ImportError("mtrand.so: failed to map segment from shared object"),
    ],
)
def test_too_little_memory_is_no_mistake_of_ours(
    gripcourse: Command, monkeypatch: pytest.MonkeyPatch, fault: Exception
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise fault

    monkeypatch.setattr("gripcourse.usecases.authoring.validate.validated", fail)
    run = gripcourse("validate")
    assert run.code == cli.WRONG_USE
    assert "too little memory" in run.err


def test_where_neither_results_nor_complaints_can_be_written_the_code_says_it() -> None:
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "gripcourse", "--version"],
            stdout=full,
            stderr=full,
            check=False,
        )
    assert done.returncode == cli.WRONG_USE


def test_an_unforeseen_failure_is_a_sentence_a_log_and_its_own_code(
    gripcourse: Command, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def fail(_root: Path, **_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr("gripcourse.usecases.authoring.validate.validated", fail)
    run = gripcourse("validate")
    assert run.code == cli.OUR_MISTAKE
    assert len(run.problems) == 1
    assert "Traceback" not in run.err
    (log,) = tmp_path.glob("gripcourse-incident-*.log")
    assert str(log) in run.err
    assert "ZeroDivisionError" in log.read_text(encoding="utf-8")


def test_what_is_no_number_cannot_be_traced(gripcourse: Command) -> None:
    run = gripcourse("trace", "12-13", "--quantity", "drive_forc=5")
    assert run.code == 2
    assert len(run.problems) == 2
    both = gripcourse("trace", "12", "--table", "a.csv", "--issued", ".")
    assert both.code == 2
    assert "exclude each other" in both.err


def test_an_unknown_variant_is_not_drawn(gripcourse: Command) -> None:
    run = gripcourse("draw", "999")
    assert run.code == 2
    assert "The table has no variant '999'." in run.err


def test_a_date_to_be_written_that_is_none_is_said_to_be_left_out_of_account(
    gripcourse: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "abc")
    run = gripcourse("solve", "--scheme", SCHEME)
    assert run.code == 0
    assert "SOURCE_DATE_EPOCH is 'abc'" in run.err
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    assert gripcourse("solve", "--scheme", SCHEME).err == ""
