"""What commands print and leave behind where all is well, and their exit codes."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from gripcourse.api.results import SolutionResult
from gripcourse.cli import main as cli
from gripcourse.cli.options import NEEDS_PERSON
from support.cli_term import SCHEME, Command, refused

REPOSITORY = Path(__file__).parents[3]


def test_the_reference_course_is_valid(gripcourse: Command) -> None:
    run = gripcourse("validate")
    assert (run.code, run.out.strip()) == (0, "The course is valid.")


def test_a_variant_is_solved_as_json(gripcourse: Command) -> None:
    run = gripcourse("solve", "001", "--json")
    plain = json.loads(run.out)
    values = plain["values"]
    assert SolutionResult.from_dict(plain).variant == "001"
    assert run.code == 0
    assert values["lifting_load"]["unit"] == "N"
    assert values["lifting_load"]["value"] > 0


def test_the_guides_example_is_solved_with_values_set_by_hand(gripcourse: Command) -> None:
    """Guide §5: F = 1.3·900/(2·0.15) = 3900 N."""
    run = gripcourse("solve", "--scheme", SCHEME, "--set", "gravity=10", "--json")
    assert json.loads(run.out)["values"]["grip_force"]["value"] == pytest.approx(3900)


def test_the_reference_is_written_in_english_unless_told_otherwise(
    gripcourse: Command, tmp_path: Path
) -> None:
    # The course with the fewest schemes: one page of each takes half a second.
    course = ("--course", REPOSITORY / "examples" / "belt_drive")
    run = gripcourse("reference", *course, "--out", "pages", system="ru_RU.UTF-8")
    pages = {path.name: path for path in (tmp_path / "pages").iterdir()}
    assert run.code == 0
    assert {"index.html", "flat_belt.html", "v_belt.html"} <= pages.keys()
    assert '<html lang="en">' in pages["index.html"].read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("language", "title"),
    [
        ("en", "grip force (normal force at one jaw)"),
        ("ru", "усилие зажима (нормальная сила на одной губке)"),
        ("uk", "зусилля затискання (нормальна сила на одній губці)"),
    ],
)
def test_declared_titles_are_in_the_chosen_language(
    gripcourse: Command, language: str, title: str
) -> None:
    run = gripcourse("solve", "001", "--language", language)
    assert run.code == 0
    assert title.split(" (", maxsplit=1)[0] in run.out


def test_a_drawn_table_is_said_and_can_be_solved(gripcourse: Command, tmp_path: Path) -> None:
    table = tmp_path / "drawn.csv"
    run = gripcourse(
        *("variants", "draw", "--count", 2, "--seed", 1),
        *("--scheme", SCHEME, "--out", table),
    )
    assert run.code == 0
    assert str(table) in run.out
    assert "%" in run.out
    assert gripcourse("solve", "002", "--table", table).code == 0


@pytest.mark.usefixtures("few_slips_counted")
def test_a_course_for_another_term_says_how_its_variants_are_kept_apart(
    gripcourse: Command, course: Path, tmp_path: Path
) -> None:
    run = gripcourse("init", tmp_path / "next", "--from", course)
    last_year = course / "variants" / "tables" / "main.csv"
    assert run.code == 0
    assert f"--apart-from {last_year}" in run.out
    assert not (tmp_path / "next" / "variants" / "roster.csv").exists()


def test_an_audit_says_with_its_exit_code_whether_somebody_must_look(
    gripcourse: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    table, out = tmp_path / "drawn.csv", tmp_path / "audit"
    drawing = ("variants", "draw", "--count", 4, "--seed", 1, "--scheme", "wedge_slide")
    gripcourse(*drawing, "--out", table)
    certificate = "gripcourse.documents.report.certificate.certificate"
    monkeypatch.setattr(certificate, lambda *_: b"%PDF of it")  # nobody reads it here
    audit = ("variants", "audit", "--workers", 0, "--table", table, "--out", out)
    sound = gripcourse(*audit)
    assert (sound.code, sound.err) == (cli.DONE, "")
    assert "The table keeps all rules." in sound.out
    assert str(out / "certificate.pdf") in sound.out
    assert (out / "certificate.pdf").read_bytes() == b"%PDF of it"
    head, first, *rest = table.read_text(encoding="utf-8-sig").splitlines()
    twin = ",".join(["twin", *first.split(",")[1:]])
    table.write_text("\n".join([head, first, *rest, twin]) + "\n", encoding="utf-8")
    doubled = gripcourse(*audit)
    assert doubled.code == NEEDS_PERSON
    assert "Too near to another variant: 2." in doubled.out


def test_an_imported_table_is_counted(gripcourse: Command, tmp_path: Path) -> None:
    drawn, out = tmp_path / "drawn.csv", tmp_path / "own.csv"
    gripcourse("variants", "draw", "--count", 3, "--seed", 1, "--out", drawn)
    run = gripcourse("variants", "import", drawn, "--out", out)
    assert (run.code, run.out.strip()) == (0, f"3 variants were written to {out}.")


def test_a_folder_that_is_a_course_is_used_without_being_named(
    gripcourse: Command, course: Path
) -> None:
    text = (course / "variants" / "course.toml").read_text(encoding="utf-8")
    broken = text.replace('convention = "corrected"', 'convention = "corected"')
    (course / "variants" / "course.toml").write_text(broken, encoding="utf-8")
    run = gripcourse("validate", "--scheme", SCHEME, home=course)
    refused(run, "course.toml", "corected")


def test_the_program_runs_as_a_module_and_starts_without_heavy_libraries() -> None:
    libraries = (
        *("numpy", "pandas", "weasyprint", "matplotlib", "openpyxl", "scipy", "pint"),
        "sqlalchemy",
    )
    heavy = set(libraries)
    code = f"import gripcourse.cli.main, sys; print(sorted({heavy} & set(sys.modules)))"
    done = subprocess.run(  # noqa: S603 (our own interpreter)
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
    called = subprocess.run(
        [sys.executable, "-m", "gripcourse", "--help"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert "grade" in called.stdout


def test_what_was_graded_before_is_looked_at_without_the_course() -> None:
    course = {"numpy", "openpyxl", "gripcourse.course.model", "gripcourse.grading.model"}
    looks = "import gripcourse.cli.grade, gripcourse.usecases.grading.as_before, sys"
    done = subprocess.run(  # noqa: S603 (our own interpreter)
        [sys.executable, "-c", f"{looks}; print(sorted({course} & set(sys.modules)))"],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout.strip() == "[]"


def test_numbers_are_traced_to_a_variant_of_the_table(gripcourse: Command) -> None:
    solved = json.loads(gripcourse("solve", "006", "--json").out)["values"]
    computed = {name: one["value"] for name, one in solved.items() if one["kind"] == "formula"}
    numbers = [
        f"{value:.4g}".replace(".", ",") for value in list(computed.values())[:8] if value > 0
    ]
    run = gripcourse("trace", *numbers)
    assert run.code == 0
    assert "006" in run.out.splitlines()[3]
    assert set(list(computed)[:8]) & set(re.findall(r"\w+", run.out))


def test_a_variant_is_drawn(gripcourse: Command, tmp_path: Path) -> None:
    run = gripcourse("draw", "002", "--student-name", "Иванова А.", "--out", "views")
    assert run.code == 0
    paths = [tmp_path / line for line in run.out.split()]
    assert [path.suffix for path in paths] == [".dxf", ".svg"]
    assert "Иванова А." in paths[1].read_text(encoding="utf-8")
