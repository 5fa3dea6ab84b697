"""Calling the command line inside of this process."""

import sys
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from functools import cache
from io import StringIO
from pathlib import Path

import pytest
import typer

from gripcourse.cli import main as cli


@dataclass(frozen=True, slots=True)
class Run:
    """What a call of the command line came to."""

    code: int
    out: str
    err: str

    @property
    def problems(self) -> list[str]:
        """The lines on the error stream, but for the progress bar."""
        return [line for line in self.err.splitlines() if line.strip() and "━" not in line]


# All commands with their options: to put them together takes longer than most calls.
put_together = cache(typer.main.get_command)


def _no_server(*_arguments: object, **_options: object) -> None:
    pytest.fail("A server was started.")


def call(home: Path, *arguments: object, system: str = "C") -> Run:
    """Call the command line in a folder."""
    out, err = StringIO(), StringIO()
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(out), redirect_stderr(err):
        patch.chdir(home)
        patch.setenv("LC_ALL", system)
        patch.setattr("uvicorn.run", _no_server)  # a server would not come back
        patch.setattr("typer.main.get_command", put_together)
        patch.setattr(sys, "argv", ["gripcourse", *map(str, arguments)])
        with pytest.raises(SystemExit) as left:
            cli.main()
    return Run(int(left.value.code or 0), out.getvalue(), err.getvalue())
