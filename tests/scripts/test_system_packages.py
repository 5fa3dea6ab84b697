"""The script that installs Debian packages, run against a pretended machine."""

import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts" / "system-packages"
RUN = (
    "libpango-1.0-0",
    "libpangoft2-1.0-0",
    "libharfbuzz-subset0",
    "fonts-paratype",
    "fonts-liberation",
    "fonts-dejavu-core",
)
ROOT, SOMEBODY = 0, 1000


@dataclass(frozen=True, slots=True)
class Machine:
    """A folder that stands for everything on the search path."""

    folder: Path

    def command(self, name: str, script: str) -> None:
        path = self.folder / name
        path.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        path.chmod(0o755)

    def run(self, layer: str, python: str = sys.executable) -> subprocess.CompletedProcess[str]:
        environment = {"PATH": str(self.folder), "PYTHON": python}
        return subprocess.run(  # noqa: S603 - the project's own script
            [SCRIPT, layer], env=environment, capture_output=True, text=True, check=False
        )

    @property
    def apt_calls(self) -> list[str]:
        log = self.folder / "apt.log"
        return log.read_text(encoding="utf-8").splitlines() if log.exists() else []


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    for name in ("grep", "tr"):
        (tmp_path / name).symlink_to(shutil.which(name) or name)
    return Machine(tmp_path)


def debian(machine: Machine, installed: tuple[str, ...], user: int) -> Machine:
    cases = "".join(f"{name}) printf installed ;;\n" for name in installed)
    machine.command("dpkg-query", f'case "$3" in\n{cases}*) exit 1 ;;\nesac')
    machine.command("apt-get", f'echo "$*" >> "{machine.folder}/apt.log"')
    machine.command("id", f"echo {user}")
    return machine


def test_nothing_happens_when_everything_is_there(machine: Machine) -> None:
    result = debian(machine, RUN, SOMEBODY).run("run")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")


def test_root_gets_what_is_missing_and_nothing_else(machine: Machine) -> None:
    result = debian(machine, RUN[:3], ROOT).run("run")
    assert result.returncode == 0
    assert [call.split()[0] for call in machine.apt_calls] == ["update", "install"]
    assert set(machine.apt_calls[1].split()) & set(RUN) == set(RUN[3:])
    assert "--no-install-recommends" in machine.apt_calls[1]


def test_anybody_else_is_told_the_exact_line(machine: Machine) -> None:
    result = debian(machine, RUN[1:], SOMEBODY).run("run")
    assert result.returncode == 1
    line = "    sudo apt-get install --yes --no-install-recommends libpango-1.0-0\n"
    assert line in result.stderr
    assert machine.apt_calls == []


def test_tests_need_more_than_a_run(machine: Machine) -> None:
    result = debian(machine, RUN, SOMEBODY).run("test")
    assert result.returncode == 1
    needed = "libreoffice-calc-nogui libreoffice-draw-nogui librecad poppler-utils postgresql"
    assert needed in result.stderr


def test_the_libreoffice_of_a_desktop_is_not_replaced(machine: Machine) -> None:
    others = ("chromium", "chromium-driver", "librecad", "poppler-utils", "postgresql-15")
    installed = (*RUN, "libreoffice-calc", "libreoffice-draw", *others)
    assert debian(machine, installed, SOMEBODY).run("test").returncode == 0


def test_a_python_without_venv_gets_it(machine: Machine) -> None:
    machine.command("bare-python", "exit 1")
    result = debian(machine, RUN, ROOT).run("run", python=str(machine.folder / "bare-python"))
    assert result.returncode == 0
    assert machine.apt_calls[-1].endswith("python3-venv -qq")


def test_a_failed_installation_stops_make(machine: Machine) -> None:
    debian(machine, (), ROOT)
    machine.command("apt-get", "exit 100")
    assert machine.run("run").returncode == 100


def test_another_system_is_told_to_look_for_itself(machine: Machine) -> None:
    result = machine.run("run")
    assert result.returncode == 0
    assert "doctor" in result.stderr


def test_it_is_called_with_a_layer(machine: Machine) -> None:
    result = machine.run("everything")
    assert result.returncode == 2
    assert "run|test" in result.stderr
