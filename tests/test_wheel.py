"""The wheel as somebody else gets it: built, installed and used far away from the repository."""

import json
import os
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

import pytest

from gripcourse.machine.resources import COURSE_FOLDERS

REPOSITORY = Path(__file__).parents[1]
SCHEME = "rack_parallelogram"

# On one worker: otherwise each would build and install a wheel of its own.
pytestmark = pytest.mark.xdist_group("wheel")


def run(*command: str | Path, folder: Path) -> str:
    """Run a command in a folder; its standard output, or its whole output when it fails."""
    # Not the repository's sources: what this Python imports must come from the wheel.
    environment = {k: v for k, v in os.environ.items() if k not in {"PYTHONPATH", "PYTHONHOME"}}
    done = subprocess.run(  # noqa: S603 - commands of this test
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, f"{command}: {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def files_below(folder: Path) -> set[str]:
    paths = (path for path in folder.rglob("*") if path.is_file() and path.suffix != ".pyc")
    return {path.relative_to(REPOSITORY).as_posix() for path in paths}


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    build = (sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder)
    run(*build, REPOSITORY, folder=folder)
    [built] = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def program(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Install the wheel into an environment of its own; libraries are borrowed from this one."""
    environment = tmp_path_factory.mktemp("environment") / "venv"
    run(sys.executable, "-m", "venv", "--without-pip", environment, folder=wheel.parent)
    python = environment / "bin" / "python"
    pip = (sys.executable, "-m", "pip", "--python", python)
    run(*pip, "install", "--no-compile", "--no-deps", "--no-index", wheel, folder=wheel.parent)
    [site] = environment.glob("lib/python*/site-packages")
    # Later on the path than the wheel, and a path file inside of it is not followed.
    (site / "borrowed.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    where = run(python, "-c", "import gripcourse; print(gripcourse.__file__)", folder=environment)
    assert Path(where.strip()).is_relative_to(site)
    return environment / "bin" / "gripcourse"


def test_the_wheel_carries_the_whole_course(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    for folder in COURSE_FOLDERS:
        expected = {f"gripcourse/_course/{name}" for name in files_below(REPOSITORY / folder)}
        assert expected
        assert expected <= names


def test_the_wheel_carries_the_whole_package_and_nothing_else(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        names = {name for name in archive.namelist() if ".dist-info/" not in name}
    package = {name.removeprefix("src/") for name in files_below(REPOSITORY / "src")}
    assert {name for name in names if "/_course/" not in name} == package


def test_a_course_can_be_made_and_solved(program: Path, tmp_path: Path) -> None:
    """Who solves reads and checks the whole course, and would be told what is wrong with it."""
    run(program, "init", "mine", folder=tmp_path)
    solve = (program, "solve", "--scheme", SCHEME, "--json", "--course", "mine")
    solved = json.loads(run(*solve, folder=tmp_path))
    assert solved["values"]["grip_force"]["value"] > 0


def test_the_installed_reference_course_is_found_and_valid(program: Path, tmp_path: Path) -> None:
    """One scheme of it: all files are in the wheel, and the whole is judged where they are."""
    run(program, "validate", "--scheme", SCHEME, folder=tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_the_machine_is_healthy_for_the_installed_program(program: Path, tmp_path: Path) -> None:
    assert "Python" in run(program, "doctor", folder=tmp_path)
