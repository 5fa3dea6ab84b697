"""The commands that measure the grader, from the command line."""

import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gripcourse.cli.main import app
from gripcourse.errors import UsageError

# Its works are judged in a third of the time that those of the reference course take.
COURSE = str(Path(__file__).parents[2] / "examples" / "belt_drive")
FEW = ("--count", "2", "--scheme", "v_belt", "--seed", "3", "--workers", "0")


def call(*arguments: str) -> tuple[int, str]:
    whole = [*arguments, "--course", COURSE, "--language", "en"]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", ["gripcourse", *whole])
        result = CliRunner().invoke(app, whole)
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.stdout


def test_a_cohort_is_simulated_and_evaluated(tmp_path: Path) -> None:
    out = tmp_path / "cohort"
    code, said = call("simulate", *FEW, "--out", str(out))
    assert code == 0
    assert "Workbooks of virtual students in" in said
    assert len(list((out / "submissions").iterdir())) == 2
    code, said = call("evaluate", str(out), "--workers", "0")
    assert code == 0
    assert "answers of honest students refused" in said
    assert (out / "misses.csv").is_file()


def test_a_cohort_is_evaluated_in_memory(tmp_path: Path) -> None:
    code, said = call("evaluate", "--in-memory", *FEW, "--misses", str(tmp_path / "misses.csv"))
    assert code == 0
    assert "Virtual students: 2" in said
    assert (tmp_path / "misses.csv").is_file()


@pytest.mark.parametrize("arguments", [("evaluate",), ("evaluate", "somewhere", "--in-memory")])
def test_either_a_folder_or_memory_is_named(arguments: tuple[str, ...]) -> None:
    with pytest.raises(UsageError, match="--in-memory"):
        call(*arguments)


def test_tolerances_are_audited(tmp_path: Path) -> None:
    """With some rows of the course's table, and variants drawn besides."""
    rows = (Path(COURSE) / "variants" / "tables" / "main.csv").read_bytes().splitlines(True)
    (tmp_path / "few.csv").write_bytes(b"".join(rows[: 1 + 2]))
    table = ("--table", str(tmp_path / "few.csv"))
    out = ("--out", str(tmp_path / "audit.csv"))
    code, said = call("tolerance", "audit", *table, "--count", "1", "--workers", "0", *out)
    assert code in {0, 1}  # 1 while the policy refuses honest answers
    assert "Near zero an absolute floor counts instead" in said
    assert (tmp_path / "audit.csv").is_file()
