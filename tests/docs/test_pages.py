"""The pages fit together and say what is so; nothing is built for it."""

import fnmatch
import importlib
import re
import shlex
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

import pytest

from documentation import BORROWED, GENERATED, command_pages, every_command, write_functions

if TYPE_CHECKING:
    from typer._click import Command

REPOSITORY = Path(__file__).parents[2]
DOCS = REPOSITORY / "docs"
PAGES = sorted(DOCS.rglob("*.md"))
SHOWN_ELSEWHERE = [REPOSITORY / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]

LISTS = re.compile(r"^```\{toctree\}\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)\)")
ADDRESS = re.compile(r"^(https?|mailto):")
CALL = re.compile(r"^(?:\$ |sudo )?(?:\S*/)?gripcourse\s+(.*)$")
FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`([^`\n]+)`")


def names() -> set[str]:
    """Every page of the site by its name from docs/, without its ending."""
    written = [path.relative_to(DOCS).as_posix() for path in PAGES]
    return {name.rpartition(".")[0] for name in (*written, *BORROWED, *GENERATED)}


def listed(page: Path) -> Iterator[str]:
    """Names of the pages that the lists of a page name."""
    folder = page.relative_to(DOCS).parent.as_posix()
    for block in LISTS.findall(page.read_text(encoding="utf-8")):
        for entry in (line for line in block.split("\n") if line and not line.startswith(":")):
            pattern = (PurePosixPath(folder) / entry).as_posix()
            found = [
                name
                for name in names()
                if name.count("/") == pattern.count("/") and fnmatch.fnmatchcase(name, pattern)
            ]
            assert found, f"{page.name}: no page is called {entry}"
            yield from found


def test_every_page_stands_in_a_list() -> None:
    assert names() - {name for page in PAGES for name in listed(page)} == {"index"}


def anchors(text: str) -> set[str]:
    """The addresses of the headings of a page."""
    headings = re.findall(r"^#+ +(.*)$", FENCE.sub("", text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", one.lower()).replace(" ", "-") for one in headings}


def holds(target: Path, anchor: str) -> bool:
    return not anchor or anchor in anchors(target.read_text(encoding="utf-8"))


@pytest.mark.parametrize("page", [*PAGES, *SHOWN_ELSEWHERE], ids=lambda path: path.name)
def test_every_link_leads_somewhere(page: Path) -> None:
    dead = []
    for link in LINK.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
        file, _, anchor = link.partition("#")
        target = (page.parent / file).resolve() if file else page
        made = {(DOCS / name).resolve() for name in (*BORROWED, *GENERATED)}
        if ADDRESS.match(link) or (page.is_relative_to(DOCS) and target in made):
            continue
        outside = page.is_relative_to(DOCS) and not target.is_relative_to(DOCS)
        if outside or not target.exists() or not holds(target, anchor):
            dead.append(link)
    assert dead == []


@pytest.mark.parametrize("origin", sorted(BORROWED.values()))
def test_a_page_that_the_site_borrows_links_to_pages_of_the_site(origin: str) -> None:
    links = LINK.findall(FENCE.sub("", (REPOSITORY / origin).read_text(encoding="utf-8")))
    inside = [link for link in links if not ADDRESS.match(link)]
    assert [link for link in inside if not link.startswith(("docs/", "#"))] == []


def calls(page: Path) -> Iterator[list[str]]:
    """What the pages tell to type behind `gripcourse`, in words."""
    text = page.read_text(encoding="utf-8")
    lines = [line for block in FENCE.findall(text) for line in joined(block).split("\n")]
    for piece in (*lines, *CODE.findall(FENCE.sub("", text))):
        if found := CALL.match(piece):
            yield shlex.split(found[1], comments=True)


def joined(block: str) -> str:
    """Put lines that go on behind a backslash together."""
    return re.sub(r"\\\n\s*", "", block)


@pytest.mark.parametrize("page", [*PAGES, *SHOWN_ELSEWHERE], ids=lambda path: path.name)
def test_every_command_exists_with_its_options(page: Path) -> None:
    known = {path: options_of(command) for _, path, command in every_command()}
    wrong = [
        " ".join(words)
        for words in calls(page)
        if not any(fits(words, path.split()[1:], options) for path, options in known.items())
    ]
    assert wrong == []


def options_of(command: "Command") -> set[str]:
    named = (name for one in command.params for name in one.opts)
    return {"--help", *(name for name in named if name.startswith("--"))}


def fits(words: list[str], path: list[str], options: set[str]) -> bool:
    """Tell whether words call a command, with no option that it does not have."""
    if words in (["COMMAND", "--help"], ["--help"]):
        return True
    if words and words[0] == "--language":
        words = words[2:]
    typed = {word for word in words[len(path) :] if word.startswith("--")}
    return words[: len(path)] == path and typed <= options


def test_the_page_of_commands_tells_what_each_one_takes() -> None:
    page = command_pages()
    for _, path, command in every_command():
        assert f"# {path}\n" in page
        for option in options_of(command):
            assert option in page


def test_every_module_that_a_page_describes_can_be_imported(tmp_path: Path) -> None:
    write_functions(tmp_path)
    pages = {path.stem: path.read_text(encoding="utf-8") for path in tmp_path.iterdir()}
    listed = re.findall(r"^   (\w+)$", pages.pop("index"), re.MULTILINE)
    assert sorted(listed) == sorted(pages)
    for page in pages.values():
        modules = re.findall(r"^\.\. automodule:: (.*)$", page, re.MULTILINE)
        assert modules
        for module in modules:
            assert importlib.import_module(module).__doc__, module
