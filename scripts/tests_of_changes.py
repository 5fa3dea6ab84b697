"""The tests that a change may break first: those that mirror the changed files.

    scripts/tests_of_changes.py [BASE]

Prints paths for pytest. BASE is what the change is measured from; else where this branch left the
main one, else the last commit. `make test` runs everything: this is for the minutes in between.
"""

import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

REPOSITORY = Path(__file__).parents[1]
COURSE = ("variants", "grader")
OF_THE_COURSE = ("tests/usecases/authoring/test_validate.py", "tests/course", "tests/policy")
OF_THE_TEMPLATES = (
    "tests/usecases/authoring/test_templates.py",
    "tests/documents/test_registry.py",
)
OF_THE_PAGES = ("tests/docs/test_pages.py",)
OF_THE_PROGRAMS = "tests/benchmarks/test_import.py"


def main(arguments: Sequence[str]) -> None:
    """Print the paths, one to a line."""
    for path in tests_of(changed_files(_base(arguments)), REPOSITORY):
        print(path)


def tests_of(changed: Sequence[str], root: Path) -> list[str]:
    """Return the tests for changed files, with those about the repository as a whole.

    Args:
        changed: paths from the root of the repository.
        root: of the repository; only what is there is returned.
    """
    whole = [path.relative_to(root).as_posix() for path in (root / "tests").glob("test_*.py")]
    found = {*whole, *(test for path in changed for test in _mirrors(path))}
    there = {path for path in found if (root / path).exists()}
    inside = {path for path in there if any(path.startswith(f"{other}/") for other in there)}
    return sorted(there - inside)


def _mirrors(path: str) -> Iterator[str]:
    """Yield what tests a file, whether it exists or not."""
    file = Path(path)
    match file.parts:
        case ["src", "gripcourse", *rooms, _] if file.suffix == ".py":
            folder = "/".join(["tests", *rooms])
            yield f"{folder}/test_{file.name}"
        case ["scripts", _]:
            yield f"tests/scripts/test_{file.stem.replace('-', '_')}.py"
            yield OF_THE_PROGRAMS
        case ["benchmarks", _] if file.suffix == ".py":
            yield OF_THE_PROGRAMS
        case ["tests", *_, name] if name.startswith("test_"):
            yield path
        case ["tests", *rooms, "conftest.py"] if rooms:
            yield "/".join(["tests", *rooms])
        case ["docs", *_] | ["README.md"] | ["CONTRIBUTING.md"]:
            yield from OF_THE_PAGES
        case ["templates", *_]:
            name = file.name.partition(".")[0]
            yield f"tests/documents/report/test_{name}.py"
            yield f"tests/documents/test_{name}_sheet.py"
            yield from OF_THE_TEMPLATES
        case [folder, *_] if folder in COURSE:
            yield from OF_THE_COURSE


def changed_files(base: str) -> list[str]:
    """Return what differs from a commit, new files included."""
    known = _git("diff", "--name-only", base)
    new = _git("ls-files", "--others", "--exclude-standard")
    return [*known, *new]


def _base(arguments: Sequence[str]) -> str:
    if arguments:
        return arguments[0]
    for other in ("@{upstream}", "main", "master"):
        found = _git("merge-base", "HEAD", other, tolerant=True)
        if found:
            return found[0]
    return "HEAD"


def _git(*arguments: str, tolerant: bool = False) -> list[str]:
    command = ["git", "-C", str(REPOSITORY), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=not tolerant)  # noqa: S603
    return done.stdout.splitlines()


if __name__ == "__main__":
    main(sys.argv[1:])
