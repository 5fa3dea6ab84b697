"""A small course on the command line: one that was issued and graded, and what refuses a call."""

import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from gripcourse.cli import main as cli
from support.command_line import Run

SCHEME = "rack_parallelogram"
ROSTER = """\
student,name,group,email,language,variant
s01,Иванова Анна,РТК-41,,ru,
s02,Шевченко Оксана,РТК-41,,uk,007
"""


Command = Callable[..., Run]


@dataclass(frozen=True, slots=True)
class Term:
    """A folder with a course, its handed out assignments and one graded work, and what was said."""

    folder: Path
    issued: Run
    graded: Run

    def again(self, folder: Path) -> "Term":
        """Copy the folder for a story of its own."""
        shutil.copytree(self.folder, folder, dirs_exist_ok=True)
        return Term(folder, self.issued, self.graded)

    @property
    def own(self) -> Path:
        """The workbook that was handed out to the first student."""
        return self.folder / "assignments" / "s01" / "s01.xlsx"

    @property
    def place(self) -> tuple[object, ...]:
        return ("--course", self.folder / "course", "--workers", 0, "--date", "2026-09-07")


def refused(run: Run, *said: str) -> None:
    """Check that a call was refused with one line that says all of this."""
    assert run.code == cli.WRONG_USE
    assert len(run.problems) == 1, run.err
    assert all(part in run.problems[0] for part in said), run.err
    assert "Traceback" not in run.out + run.err
    assert not run.problems[0].startswith(":")
