"""Courses with one thing changed in their files by chance, and what `validate` says of them.

    PYTHONPATH=src:tests python -m support.changed_course COURSE [changes] [seed]

says of each change whether `validate` says the same with what earlier runs kept as without it.
"""

# ruff: noqa: T201 (a program says what it finds)
import os
import random
import re
import shutil
import sys
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Final

from gripcourse.errors import GripcourseError, Problem
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.validate import scheme_problems, validated

_NUMBER: Final = r"\d+(?:\.\d+)?"
# What is looked for in which files, and what stands there afterwards.
_KINDS: Final = {
    "factor": ("*.toml", rf'(?<=formula = ")({_NUMBER})(?=\*)|(?<=\*)({_NUMBER})', "7"),
    "sign": ("*.toml", r"(?<=[a-z_0-9)])\+(?=[a-z(])", "-"),
    "unit": ("*.toml", r'(?<=unit = )"[^"]+"', '"kg"'),
    "range": ("*.toml", rf"(?<=low = ){_NUMBER}", "0.011"),
    "bound": ("*.toml", rf"(?<=bounds = \[){_NUMBER}", "0.5"),
    "default": ("*.toml", rf"(?<=default = ){_NUMBER}", "3"),
    "missing key": ("*.toml", r"(?m)^(?:symbol|unit|source|title|section|kind) = .*\n", ""),
    "missing language": ("*.toml", r', uk = "[^"]*"', ""),
    "name": ("*.toml", r'(?<=formula = ")[a-z_]+', "mass"),
    "catalogue": ("*.csv", rf"(?m)(?<=,){_NUMBER}$", "4321"),
    "comment": ("*.toml", r"\Z", "\n# more\n"),
    "text": ("*.toml", r'(?<=en = ")[a-z]+', "another"),
}
_FOLDERS: Final = ("sections", "schemes/*", "catalogues", "options", "spaces", "equilibrium", ".")


@dataclass(frozen=True, slots=True)
class Change:
    """A change of one file.

    Attributes:
        kind: of what is changed.
        file: its name below the course.
        before, after: its whole text.
    """

    kind: str
    file: str
    before: str
    after: str

    def make(self, root: Path) -> None:
        """Change a course."""
        (root / self.file).write_text(self.after, encoding="utf-8")

    def undo(self, root: Path) -> None:
        """Change it back."""
        (root / self.file).write_text(self.before, encoding="utf-8")


def random_changes(root: Path, count: int, seed: int) -> list[Change]:
    """Return changes by chance, each of another place, of every kind alike.

    Args:
        root: of the course; it is not changed.
        count: of changes.
        seed: of chance.
    """
    chance = random.Random(seed)  # noqa: S311 (nothing secret)
    places = {kind: _places(root, kind) for kind in _KINDS}
    kinds = [kind for kind, found in places.items() if found for _ in range(count)]
    chosen = [kinds[place * len(kinds) // count] for place in range(count)]
    return [_change(root, kind, *chance.choice(places[kind])) for kind in chosen]


def _places(root: Path, kind: str) -> list[tuple[Path, int, int]]:
    """Return each file with each beginning and end of what a kind of change may replace."""
    pattern, wanted, _ = _KINDS[kind]
    home = root / "variants"
    paths = [path for one in _FOLDERS for path in sorted(home.glob(f"{one}/{pattern}"))]
    return [
        (path, found.start(), found.end())
        for path in paths
        if path.name != "roster.csv"
        for found in re.finditer(wanted, path.read_text(encoding="utf-8"))
    ]


def _change(root: Path, kind: str, path: Path, start: int, end: int) -> Change:
    text = path.read_text(encoding="utf-8")
    after = text[:start] + _KINDS[kind][2] + text[end:]
    return Change(kind, path.relative_to(root).as_posix(), text, after)


def said_with(cache: Path, root: Path, schemes: Iterable[str] = ()) -> str:
    """Return what a process says that knows nothing but what a cache keeps; see `said_of`."""
    with get_context("fork").Pool(1) as pool:
        return pool.apply(_said_with, (cache, root, tuple(schemes)))


def _said_with(cache: Path, root: Path, schemes: Iterable[str]) -> str:
    os.environ["XDG_CACHE_HOME"] = str(cache)
    return said_of(root, schemes)


def said_of(root: Path, schemes: Iterable[str] = ()) -> str:
    """Return all that `validate` says of a course, and of some of its schemes alone."""
    words = Words("en")
    found = list(validated(root).problems)
    for scheme in schemes:
        try:
            found += scheme_problems(root, scheme)
        except GripcourseError as error:
            found += error.problems
    return "\n".join(f"{_place(one, words)}: {one.say(words)} {one.excerpt}" for one in found)


def _place(problem: Problem, words: Words) -> str:
    key = problem.key if isinstance(problem.key, str) else words.say(problem.key)
    return f"{problem.file}, {key}"


def main() -> None:
    """Change a course again and again; compare what is said of it."""
    origin = Path(sys.argv[1])
    count, seed = (int(one) for one in (*sys.argv[2:], "40", "1")[:2])
    different = 0
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        root, warm = Path(shutil.copytree(origin, base / "course")), base / "warm"
        schemes = sorted(one.name for one in (root / "variants" / "schemes").iterdir())[:1]
        print("as it is:", said_with(warm, root, schemes) or "nothing is said", flush=True)
        for number, change in enumerate(random_changes(root, count, seed)):
            change.make(root)
            first, again = (said_with(warm, root, schemes) for _ in range(2))
            cold = said_with(base / f"cold{number}", root, schemes)
            is_same = first == again == cold
            different += not is_same
            lines = len(cold.splitlines())
            print(f"{change.kind:16} {change.file:50} {lines:3} lines {is_same}", flush=True)
            if not is_same:
                print(f"--- cold\n{cold}\n--- first\n{first}\n--- again\n{again}", flush=True)
            change.undo(root)
    print(f"{different} of {count} differ")
    sys.exit(different > 0)


if __name__ == "__main__":
    main()
