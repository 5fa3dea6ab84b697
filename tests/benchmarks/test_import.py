"""Benchmarks and scripts run seldom: that they still find what they use is tried by loading them.

What they call behind the import, and with what, mypy holds: both folders are among its files.
"""

import importlib.util
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).parents[2]
FOLDERS = ("benchmarks", "scripts")
FILES = [path for folder in FOLDERS for path in sorted((REPOSITORY / folder).glob("*.py"))]


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_it_loads_and_can_be_run(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(path.parent)  # as where it is run: a benchmark uses another
    spec = importlib.util.spec_from_file_location(f"tried_{path.stem}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert callable(module.main)
    assert module.__doc__


def test_there_are_some_of_both() -> None:
    assert {path.parent.name for path in FILES} == set(FOLDERS)
