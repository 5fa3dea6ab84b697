"""What an author waits for: seconds of the processor, and by the clock, of whole commands.

    python benchmarks/author.py [--times 5] [--rows "validate, nothing kept" ...]

Each row is a command in a process of its own, with all that it starts: the least of so many runs,
and its share of the first row. "Nothing kept": what earlier runs kept of courses is thrown away;
"again": after the same command; "a … changed": one bound in a file, after the course was kept.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Final, TypeAlias

from again import hand_in

EXAMPLE: Final = Path(__file__).parents[1] / "examples" / "belt_drive"
_BOUNDS: Final = re.compile(r"bounds = \[(\S+), (\S+)\]")
_WITHOUT_WHAT_IS_MADE: Final = shutil.ignore_patterns("private", "out")
COURSE: Final = ("--course", "course")


@dataclass(frozen=True, slots=True)
class Desk:
    """An author's folder, with a course, a workbook and what commands keep.

    Attributes:
        base: the folder.
        environment: of every command.
    """

    base: Path
    environment: Mapping[str, str]

    def forget(self) -> None:
        """Throw away what commands kept of courses, not what libraries keep of fonts."""
        shutil.rmtree(self.base / "cache" / "gripcourse", ignore_errors=True)

    def call(self, *words: str) -> tuple[float, float]:
        """Run a command; return seconds of the processor and by the clock.

        Raises:
            RuntimeError: it failed.
        """
        start = perf_counter()
        started = subprocess.Popen(  # noqa: S603 (our own words)
            [sys.executable, "-m", "gripcourse", *words],
            cwd=self.base,
            env=self.environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
        )
        with started:
            said = started.stderr.read() if started.stderr else b""
            _, status, used = os.wait4(started.pid, 0)
            started.returncode = os.waitstatus_to_exitcode(status)
        if started.returncode not in {0, 1}:
            raise RuntimeError(said.decode())
        return used.ru_utime + used.ru_stime, perf_counter() - start

    def change(self, file: str) -> None:
        """Widen the first bounds that a file of the course states, by a little."""
        path = self.base / "course" / "variants" / file
        text = path.read_text(encoding="utf-8")
        widened = _BOUNDS.sub(lambda found: _wider(found[1], found[2]), text, count=1)
        path.write_text(widened, encoding="utf-8")


def _wider(low: str, high: str) -> str:
    return f"bounds = [{low}, {float(high) * (1 + 1e-6)!r}]"


Preparation: TypeAlias = Callable[[Desk], None]


@dataclass(frozen=True, slots=True)
class Row:
    """One line of the table.

    Attributes:
        name: as it is printed.
        commands: what is measured, together.
        prepare: what is done before each time, unmeasured.
    """

    name: str
    commands: tuple[tuple[str, ...], ...]
    prepare: Preparation


def nothing_kept(desk: Desk) -> None:
    """As after an installation."""
    desk.forget()


def kept_by(*command: str) -> Preparation:
    """As after a command, and no other one."""

    def prepare(desk: Desk) -> None:
        desk.forget()
        desk.call(*command)

    return prepare


def again(*command: str) -> Preparation:
    """As after the same command."""
    return lambda desk: (desk.call(*command), None)[1]


def changed(file: str, *command: str) -> Preparation:
    """As after a command and a change of one file."""

    def prepare(desk: Desk) -> None:
        desk.call(*command)
        desk.change(file)

    return prepare


def nothing_issued(first: Preparation) -> Preparation:
    """As in a course of which nobody has an assignment."""

    def prepare(desk: Desk) -> None:
        first(desk)
        for name in ("out", "fresh"):
            shutil.rmtree(desk.base / name, ignore_errors=True)
        shutil.copytree(desk.base / "course", desk.base / "fresh", ignore=_WITHOUT_WHAT_IS_MADE)

    return prepare


def new_course(desk: Desk) -> None:
    """As before the first course of one's own."""
    desk.forget()
    shutil.rmtree(desk.base / "fresh", ignore_errors=True)


VALIDATE: Final = ("validate", *COURSE)
VALIDATE_ONE: Final = ("validate", "--scheme", "screw", *COURSE)
VALIDATE_BELTS: Final = ("validate", "--course", str(EXAMPLE))
SOLVE: Final = ("solve", "019", *COURSE)
CHECK: Final = ("check", "works/u000.xlsx", *COURSE)
ISSUE: Final = (
    *("issue", "--roster", "roster.csv", "--table", "table.csv", "--out", "out"),
    *("--workers", "0", "--course", "fresh"),
)
ROWS: Final = (
    Row("--help", (("--help",),), nothing_kept),
    Row("solve, nothing kept", (SOLVE,), nothing_kept),
    Row("solve, the course kept", (SOLVE,), kept_by(*SOLVE)),
    Row("check, nothing kept", (CHECK,), nothing_kept),
    Row("check, the course kept", (CHECK,), kept_by(*CHECK)),
    Row("validate, nothing kept", (VALIDATE,), nothing_kept),
    Row("validate, again", (VALIDATE,), again(*VALIDATE)),
    Row("part of 15 of 17 schemes changed", (VALIDATE,), changed("sections/pin.toml", *VALIDATE)),
    Row("part of 6 schemes changed", (VALIDATE,), changed("sections/lever_pivot.toml", *VALIDATE)),
    Row("part of 2 schemes changed", (VALIDATE,), changed("sections/spur_teeth.toml", *VALIDATE)),
    Row("one scheme changed", (VALIDATE,), changed("schemes/screw/scheme.toml", *VALIDATE)),
    Row("validate --scheme, nothing kept", (VALIDATE_ONE,), nothing_kept),
    Row("validate --scheme, the course kept", (VALIDATE_ONE,), kept_by(*SOLVE)),
    Row("validate --scheme, again", (VALIDATE_ONE,), again(*VALIDATE_ONE)),
    Row(
        "validate --scheme, it changed",
        (VALIDATE_ONE,),
        changed("schemes/screw/scheme.toml", *VALIDATE),
    ),
    Row("validate belt_drive, nothing kept", (VALIDATE_BELTS,), nothing_kept),
    Row("validate belt_drive, again", (VALIDATE_BELTS,), again(*VALIDATE_BELTS)),
    Row("init and validate", (("init", "fresh"), ("validate", "--course", "fresh")), new_course),
    Row(
        "init --empty and validate",
        (("init", "--empty", "fresh"), ("validate", "--course", "fresh")),
        new_course,
    ),
    Row("issue to one, nothing kept", (ISSUE,), nothing_issued(nothing_kept)),
    Row("issue to one, the course kept", (ISSUE,), nothing_issued(kept_by(*SOLVE))),
)


def main() -> None:
    """Measure every row that is asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=int, default=5)
    parser.add_argument("--rows", nargs="+", default=[""], help="what their names hold")
    asked = parser.parse_args()
    rows = [row for row in ROWS if any(part in row.name for part in asked.rows)]
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        cache = {"XDG_CACHE_HOME": str(base / "cache")}
        without = {"PYTHONDONTWRITEBYTECODE"}
        kept = {name: value for name, value in os.environ.items() if name not in without}
        desk = Desk(base, kept | cache)
        hand_in(base, 1)
        desk.call(*VALIDATE)  # what libraries keep of fonts
        least: dict[str, tuple[float, float]] = {}
        # By turns, so that what else the machine does meets all of them alike.
        for _ in range(asked.times):
            for row in rows:
                row.prepare(desk)
                taken = [desk.call(*command) for command in row.commands]
                used, waited = (sum(each) for each in zip(*taken, strict=True))
                before = least.get(row.name, (used, waited))
                least[row.name] = min(used, before[0]), min(waited, before[1])
    first = least[rows[0].name][0]
    print("                                    processor    clock   share")
    for name, (used, waited) in least.items():
        print(f"{name:<36}{used:8.2f} s{waited:7.2f} s{used / first:8.2f}")


if __name__ == "__main__":
    main()
