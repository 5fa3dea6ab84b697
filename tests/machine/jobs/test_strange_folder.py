"""No file of the folder that somebody works in is run, whatever it is called: it may be a work."""

import operator
import os
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

from gripcourse.machine.jobs.child import ask, end, start
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.work import Task

# What the interpreter, the pools and we import first.
NAMES = ("pickle", "struct", "platform", "multiprocessing", "numpy", "gripcourse", "sqlalchemy")
# As a command does that gives jobs to workers.
POOL = """
from gripcourse.machine.jobs.pools import PROCESSES
if __name__ == "__main__":
    with PROCESSES.open(1, int, ()) as workers:
        print(workers.submit(abs, -7).result())
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder in which each module that is imported from it leaves a trace, and somebody works."""
    for name in NAMES:
        (tmp_path / f"{name}.py").write_text(
            f"open({str(tmp_path / 'ran')!r}, 'a').write('{name} ')", encoding="utf-8"
        )
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_child_runs_none_of_it(folder: Path) -> None:
    child = start(Limits())
    try:
        packed = pickle.dumps((Task(operator.add, 4, 60.0, Limits()), 3))
        assert ask(child, packed, 60.0)[0] == 7
    finally:
        end(child)
    assert not (folder / "ran").exists()


def test_a_worker_of_a_pool_runs_none_of_it(folder: Path) -> None:
    script = folder.with_name(f"{folder.name}_command") / "command.py"
    script.parent.mkdir()
    script.write_text(POOL, encoding="utf-8")
    done = subprocess.run(  # noqa: S603 (ourselves)
        [sys.executable, str(script)],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
        env={one: value for one, value in os.environ.items() if one != "PYTHONSAFEPATH"},
    )
    assert (done.returncode, done.stdout.strip()) == (0, "7"), done.stderr
    assert not (folder / "ran").exists()
