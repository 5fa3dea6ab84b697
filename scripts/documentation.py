"""The documentation site, from the pages in docs/ and from what the program can tell of itself.

    scripts/documentation.py SITE

Everything that is not written by hand is made beside SITE, in a copy of docs/: the commands from
their declarations, the functions from their docstrings, the formula reference from the course.
"""

import importlib.util
import shutil
import subprocess
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, cast

from typer.core import TyperGroup
from typer.main import get_command

import gripcourse
from gripcourse.cli.main import app
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.documents.reference.diagram import diagram_of
from gripcourse.documents.reference.occurrence import content_of
from gripcourse.exports.key_page import key_page
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.reference import write_reference
from gripcourse.usecases.authoring.schema import FILE_KINDS

if TYPE_CHECKING:
    # The library gives these types no public name.
    from typer._click import Command, Context, HelpFormatter

REPOSITORY = Path(__file__).parents[1]
BORROWED = {"why/changes.md": "CHANGELOG.md", "why/measured.md": "benchmarks/results.md"}
"""Pages that stand elsewhere in the repository, by the names that they have on the site."""
DEAR = ("formulas.md", "functions/index.rst")
"""Pages that take minutes to make."""
GENERATED = ("commands.md", "keys.md", *DEAR)
PUBLIC = "gripcourse.api"
_LANGUAGE = Words("en")


def main(site: Path) -> None:
    """Build the site; warnings are errors.

    Raises:
        subprocess.CalledProcessError: Sphinx found something wrong and has said what.
    """
    work = site.parent / f"{site.name}-work"
    for old in (site, work):
        shutil.rmtree(old, ignore_errors=True)
    pages = gather_pages(work)
    write_functions(pages / "functions")
    course = load_course(REPOSITORY)
    write_formulas(course, pages, work / "extra")
    command = sphinx_command("html", pages, site)
    doctrees = ["--doctree-dir", str(work / "doctrees"), "--jobs", "auto"]
    subprocess.run([*command, *doctrees], check=True)  # noqa: S603 (own words)


def gather_pages(work: Path) -> Path:
    """Copy the pages that are written by hand, beside what the commands and the keys tell.

    Args:
        work: where the copy is made; it is made for it.

    Returns:
        The folder of the pages.
    """
    pages = work / "docs"
    shutil.copytree(REPOSITORY / "docs", pages)
    for name, origin in BORROWED.items():
        borrowed = (REPOSITORY / origin).read_text(encoding="utf-8")
        _write(pages / name, borrowed.replace("](docs/", "](../"))
    (work / "examples").symlink_to(REPOSITORY / "examples")
    _write(pages / "commands.md", command_pages())
    _write(pages / "keys.md", key_page(FILE_KINDS))
    return pages


def sphinx_command(builder: str, pages: Path, site: Path) -> list[str]:
    """Return the command that makes a site of pages; each warning is an error."""
    strict = ["--fail-on-warning", "--quiet", str(pages), str(site)]
    return [sys.executable, "-m", "sphinx", "--builder", builder, *strict]


class HelpPage:
    """Takes as Markdown what a command tells of itself; stands in for a terminal's formatter."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
        """Take the line that shows how the command is called."""
        del prefix
        self.lines += ["```text", f"{prog} {args}".strip(), "```", ""]

    def write_paragraph(self) -> None:
        """Take an empty line."""
        self.lines.append("")

    def write_text(self, text: str) -> None:
        """Take a paragraph."""
        self.lines += [text, ""]

    @contextmanager
    def section(self, name: str) -> Iterator[None]:
        """Take a list under its heading."""
        self.lines += [f"**{name}**", ""]
        yield
        self.lines.append("")

    def write_dl(self, rows: Iterable[tuple[str, str]]) -> None:
        """Take terms with what they mean."""
        for term, text in rows:
            self.lines += [f"`{term}`", f": {text or '–'}", ""]


def command_pages() -> str:
    """Return a page with the help of every command, as `--help` tells it."""
    lines = ["# Commands", "", "What `gripcourse COMMAND --help` tells, in one place.", ""]
    for level, path, command in every_command():
        lines += [f"{'#' * (level + 1)} {path}", "", *_help_of(path, command), ""]
    return "\n".join(lines)


def every_command() -> Iterator[tuple[int, str, "Command"]]:
    """Yield every command with its depth and how it is called, groups before what they hold."""
    yield from _below(0, "gripcourse", get_command(app))


def _below(level: int, path: str, command: "Command") -> Iterator[tuple[int, str, "Command"]]:
    if level:
        yield level, path, command
    if isinstance(command, TyperGroup):
        for name, one in sorted(command.commands.items()):
            yield from _below(level + 1, f"{path} {name}", one)


def _help_of(path: str, command: "Command") -> list[str]:
    context: Context = command.context_class(command, info_name=path)
    page = HelpPage()
    command.format_help(context, cast("HelpFormatter", page))
    return page.lines


def write_functions(folder: Path) -> None:
    """Write a page for each room of the engine with its modules, the public one first."""
    rooms = _rooms()
    if importlib.util.find_spec(PUBLIC) is not None:
        rooms = {PUBLIC.rpartition(".")[2]: [PUBLIC], **rooms}
    for room, modules in rooms.items():
        lines = _heading(room, "=")
        for module in modules:
            lines += [*_heading(module, "-"), f".. automodule:: {module}", "   :members:", ""]
        _write(folder / f"{room}.rst", "\n".join(lines))
    listed = [*_heading("Functions", "="), "From the docstrings, room by room.", ""]
    listed += [".. toctree::", "   :maxdepth: 1", "", *(f"   {room}" for room in rooms), ""]
    _write(folder / "index.rst", "\n".join(listed))


def _heading(text: str, line: str) -> list[str]:
    return [text, line * len(text), ""]


def _rooms() -> dict[str, list[str]]:
    """Return the modules of the engine by the package that they stand in."""
    root = Path(str(gripcourse.__file__)).parent
    rooms: dict[str, list[str]] = {}
    for path in sorted(root.rglob("*.py")):
        *packages, name = path.relative_to(root).with_suffix("").parts
        dotted = ".".join(["gripcourse", *packages, *([] if name == "__init__" else [name])])
        if "migrations" in packages:
            continue  # scripts that only the tool of migrations can load
        if name != "__main__" and not name.startswith("_") and dotted != PUBLIC:
            rooms.setdefault(packages[0] if packages else name, []).append(dotted)
    return rooms


def write_formulas(course: Course, pages: Path, extra: Path) -> None:
    """Write the formula reference, and a page of the site that leads to it with all diagrams.

    Args:
        course: whose formulas are shown.
        pages: the folder of the site's own pages.
        extra: the folder of what the site takes as it is.
    """
    write_reference(course, extra / "formulas", _LANGUAGE, home="../index.html")
    lines = [
        "# Formula reference",
        "",
        '<a href="formulas/index.html">Every formula of the course</a>, scheme by scheme: where it',
        "comes from, when it applies, what is usually done wrong. The",
        '<a href="formulas/errata.html">errata of the sources</a> stand on a page of their own.',
        "`gripcourse reference --out reference` makes the same pages of any course.",
        "",
    ]
    for scheme in course.schemes.values():
        title = scheme.title.of("en")
        lines += [f'## <a href="formulas/{scheme.id}.html">{title[:1].upper()}{title[1:]}</a>', ""]
        drawn = diagram_of(content_of(course, scheme), _LANGUAGE)
        if drawn is not None:
            _write(pages / "diagrams" / f"{scheme.id}.svg", drawn)
            lines += [f"![kinematic diagram: {title}](diagrams/{scheme.id}.svg)", ""]
    _write(pages / "formulas.md", "\n".join(lines))


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
