"""Jobs that other processes find."""

import importlib
from pathlib import Path
from types import ModuleType

import pytest


@pytest.fixture
def errands(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module of jobs for tests; a new process gets this path too."""
    monkeypatch.syspath_prepend(str(Path(__file__).parent))
    return importlib.import_module("errands")
