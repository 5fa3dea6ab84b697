"""Imports go one way: each part of the program knows only the parts below it."""

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

SOURCES = Path(__file__).parents[1] / "src" / "gripcourse"

# From the ground up. A part imports from the levels below its own; the parts of one level do not
# know each other. A room inside a room is a part of its own where it stands here.
LEVELS = (
    ("text",),
    ("errors",),
    ("machine",),
    ("machine.jobs",),
    ("formula",),
    ("course",),
    ("solver",),
    # Points and bands are counted before anything is judged: the audit of variants needs them too.
    ("policy",),
    ("slips",),
    # What is drawn can be built: variants are tested for bodies that go through one another.
    ("drawing",),
    ("variants",),
    ("workbook",),
    ("submission",),
    # What was issued and what is judged meet only in the values of `variants.model`.
    ("issuing", "grading", "access"),
    ("gradebook", "access.desk", "access.lti"),
    ("likeness", "grading.analytics"),
    ("batch",),
    ("simulation",),
    ("documents",),
    ("exports",),
    ("proofs",),
    ("usecases.authoring", "usecases.solving", "usecases.measuring", "usecases.serving"),
    ("usecases.issuing", "usecases.grading"),
    ("usecases.marks",),
    ("usecases.publishing",),
    ("usecases.term",),
    ("api",),
    ("cli.demo", "web"),
    ("cli",),
    # The bare package, and the program.
    ("", "__main__"),
)
# More than a reader can have in mind at once.
MOST_ROOMS = 25
LEVEL_OF = {part: level for level, parts in enumerate(LEVELS) for part in parts}

# Where a part may see only one module of another part.
WINDOWS = {
    ("documents", "grading"): "gripcourse.grading.model",
}


@dataclass(frozen=True, slots=True)
class Import:
    """Module `importer` (a dotted name) uses module `imported` on `line` of `file`."""

    file: str
    line: int
    importer: str
    imported: str


def imports_of(source: str, importer: str, file: str) -> Iterator[Import]:
    """Find imports of this package's modules, inside functions too."""
    package = importer if file.endswith("__init__.py") else importer.rpartition(".")[0]
    for node in ast.walk(ast.parse(source)):
        for imported in names_imported(node, package):
            if imported == "gripcourse" or imported.startswith("gripcourse."):
                yield Import(file, node.lineno, importer, imported)


def names_imported(node: ast.AST, package: str) -> list[str]:
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.ImportFrom):
        above = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
        module = ".".join([*above, *filter(None, [node.module])])
        # `from a import b` may import a module or a name.
        return [f"{module}.{alias.name}" for alias in node.names]
    return []


def part_of(module: str) -> str:
    """Name the part that a module belongs to; the bare package has the empty name."""
    _, *names = module.split(".")
    inner = ".".join(names[:2])
    return inner if inner in LEVEL_OF else "".join(names[:1])


def fault(found: Import) -> str | None:
    """Say what is wrong with an import, None if nothing is."""
    importer, imported = part_of(found.importer), part_of(found.imported)
    place = f"{found.file}:{found.line}: {found.importer} imports {found.imported}"
    if importer == imported or imported in {"", "__version__"}:
        return None
    if unknown := {importer, imported} - set(LEVEL_OF):
        return f"{place}, but {unknown.pop()} has no level yet: give it one in {__name__}"
    if LEVEL_OF[importer] <= LEVEL_OF[imported]:
        return f"{place}, but {importer} does not stand above {imported}"
    window = WINDOWS.get((importer, imported))
    if window and not found.imported.startswith(f"{window}."):
        return f"{place}, but {importer} may see only {window}"
    return None


def all_imports() -> list[Import]:
    found = []
    for path in sorted(SOURCES.rglob("*.py")):
        relative = path.relative_to(SOURCES.parent)
        parts = relative.with_suffix("").parts
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        found += imports_of(path.read_text(encoding="utf-8"), name, relative.as_posix())
    return found


def test_the_house_has_few_rooms() -> None:
    rooms = {path.parent.name for path in SOURCES.glob("*/__init__.py")}
    assert {"course", "grading"} <= rooms
    assert len(rooms) <= MOST_ROOMS, sorted(rooms)


def test_imports_go_one_way() -> None:
    found = all_imports()
    assert found
    faults = [sentence for sentence in map(fault, found) if sentence]
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize(
    ("importer", "source", "sentence"),
    [
        ("course.load", "from gripcourse.solver.plan import Plan", "course does not stand above"),
        (
            "solver.plan",
            "def f():\n    from gripcourse.cli import main as cli",
            "solver does not stand above",
        ),
        ("drawing.paper.svg", "import gripcourse.variants.table", "drawing does not stand above"),
        ("documents.student", "from gripcourse.grading.judge import judge", "may see only"),
        ("documents.student", "from gripcourse.grading import judge", "may see only"),
        (
            "grading.judge",
            "from gripcourse.usecases.issuing.handout import issue",
            "does not stand above",
        ),
        ("course.check", "from ..batch import run", "course does not stand above batch"),
        ("text.words", "from gripcourse.formula.tree import Node", "text does not stand above"),
        (
            "machine.files",
            "import gripcourse.machine.jobs.work",
            "does not stand above machine.jobs",
        ),
        ("access.lti.store", "from gripcourse.access.desk import model", "does not stand above"),
        (
            "usecases.issuing.issue",
            "import gripcourse.usecases.marks.regrade",
            "does not stand above usecases.marks",
        ),
        ("text.words", "from gripcourse.novelty import thing", "novelty has no level yet"),
    ],
)
def test_a_wrong_direction_is_noticed(importer: str, source: str, sentence: str) -> None:
    [found] = imports_of(source, f"gripcourse.{importer}", f"{importer}.py")
    assert sentence in (fault(found) or "")


@pytest.mark.parametrize(
    ("importer", "source"),
    [
        ("solver.plan", "from gripcourse.course.model import Course"),
        ("documents.student", "from gripcourse.grading.model import Report"),
        ("grading.judge", "from gripcourse.variants.model import Issued"),
        ("errors", "from gripcourse.text.words import Message"),
        ("course.load", "from . import model"),
        ("course.load", "from .model import Course"),
        ("machine.jobs.work", "from gripcourse.machine.files import folder"),
        ("cli", "from gripcourse import __version__"),
    ],
)
def test_a_right_direction_is_left_alone(importer: str, source: str) -> None:
    [found] = imports_of(source, f"gripcourse.{importer}", f"{importer}.py")
    assert fault(found) is None


def test_other_libraries_are_no_concern() -> None:
    source = "import numpy\nfrom gripcourses.words import other"
    assert list(imports_of(source, "gripcourse.text.words", "words.py")) == []
