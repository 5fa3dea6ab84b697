"""Pages that tell what to do, read as steps and done in a folder."""

import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from io import StringIO
from pathlib import Path

from gripcourse.cli import main as cli

FENCE = re.compile(r"^```(.*)\n((?:.*\n)*?)```$", re.MULTILINE)
AT_THE_END = "at the end of "


@dataclass(frozen=True, slots=True)
class WrittenFile:
    """A file that the reader writes, or text that is put at its end."""

    path: str
    text: str
    added: bool


@dataclass(frozen=True, slots=True)
class ChangedLine:
    """A line of a file that becomes another."""

    path: str
    old: str
    new: str


@dataclass(frozen=True, slots=True)
class Typed:
    """A line that the reader types."""

    line: str


@dataclass(frozen=True, slots=True)
class Shown:
    """What the reader sees then, among other lines."""

    lines: tuple[str, ...]


Step = WrittenFile | ChangedLine | Typed | Shown


def steps_of(page: Path) -> Iterator[Step]:
    """Read the steps of a page: files, changed lines, `console` lines, `text` that follows."""
    for kind, body in FENCE.findall(page.read_text(encoding="utf-8")):
        if kind.startswith("{code-block}"):
            first, _, text = body.partition("\n")
            caption = first.removeprefix(":caption: ")
            if kind == "{code-block} diff":
                old, new = text.splitlines()
                yield ChangedLine(caption, old.removeprefix("-"), new.removeprefix("+"))
                continue
            yield WrittenFile(caption.removeprefix(AT_THE_END), text, AT_THE_END in caption)
        elif kind == "console":
            yield from (Typed(line.removeprefix("$ ")) for line in body.splitlines())
        elif kind == "text":
            yield Shown(tuple(body.splitlines()))


def write(step: WrittenFile, folder: Path) -> None:
    """Write a file as the page says."""
    path = folder / step.path
    path.parent.mkdir(parents=True, exist_ok=True)
    before = path.read_text(encoding="utf-8") + "\n" if step.added else ""
    path.write_text(before + step.text, encoding="utf-8")


def change(step: ChangedLine, folder: Path) -> None:
    """Change the one line that the page shows."""
    path = folder / step.path
    text = path.read_text(encoding="utf-8")
    assert text.splitlines().count(step.old) == 1
    path.write_text(text.replace(step.old, step.new), encoding="utf-8")


def type_line(line: str) -> str:
    """Do in the current folder what a line says, and return what it prints.

    `cd` moves this process too: whoever calls has to put it back.
    """
    command, *arguments = shlex.split(line)
    if command == "cd":
        os.chdir(*arguments)
        return ""
    if command == "gripcourse":
        return gripcourse(*arguments)
    subprocess.run(["/bin/sh", "-c", line], check=True)  # noqa: S603 (a line of our own page)
    return ""


def gripcourse(*arguments: str) -> str:
    """Call the command line in this process: a new one would import for seconds."""
    printed, before = StringIO(), sys.argv
    sys.argv = ["gripcourse", *arguments]
    try:
        with redirect_stdout(printed), redirect_stderr(printed):
            cli.main()
    except SystemExit as left:
        if left.code not in {0, 1, 2}:
            raise
    finally:
        sys.argv = before
    return printed.getvalue()


def missing_from(printed: str, shown: Shown) -> list[str]:
    """Return the lines that a page shows and that were not printed; spaces do not count."""
    seen = {" ".join(line.split()) for line in printed.splitlines()}
    return [line for line in shown.lines if " ".join(line.split()) not in seen]
