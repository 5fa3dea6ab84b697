"""The pages of the reference course, made once."""

import html
import re
from collections.abc import Mapping
from html.parser import HTMLParser

import pytest

from gripcourse.course.compose import compose
from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Quantity
from gripcourse.documents.reference.pages import pages
from gripcourse.text.amounts import NO_BREAK_SPACE
from gripcourse.text.words import Words

# What is computed has an article, what is given a row of a table.
_BEGINNING = re.compile('<(?:article|tr) id="([^"]*)"')
_WITHOUT_END = frozenset({"meta", "br", "wbr", "mspace"})


class Page(HTMLParser):
    """What is on a page: its text, anchors and links; every element must be closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.source = text
        self.ids: list[str] = []
        self.links: list[str] = []
        self.rows: list[list[str]] = []
        self._open: list[str] = []
        self._of_entry: list[str] = []
        self._spoken: dict[str, list[str]] = {}
        self.feed(text)
        self.close()
        assert self._open == []
        self.entries = self._entries()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in _WITHOUT_END:
            self._open.append(tag)
        for name, value in attrs:
            if name == "id":
                self.ids.append(value or "")
                if tag in {"article", "tr"}:
                    self._of_entry = self._spoken.setdefault(value or "", [])
            if name == "href":
                self.links.append(value or "")
        if tag == "tr":
            self.rows.append([])
        if tag in {"td", "th"}:
            self.rows[-1].append("")
        if tag == "sub":
            self.handle_data("_")  # as declarations write it

    def handle_endtag(self, tag: str) -> None:
        if tag not in _WITHOUT_END:
            assert self._open.pop() == tag

    def handle_data(self, data: str) -> None:
        # Signs that keep a number and its unit together, and what stands in a unit.
        data = data.replace(NO_BREAK_SPACE, " ").replace("\N{WORD JOINER}", "")
        self._of_entry.append(data)
        if "td" in self._open or "th" in self._open:
            self.rows[-1][-1] += data

    def says(self, name: str, text: str) -> bool:
        """Tell whether a text of the course is in an entry of a declaration."""
        text = text.replace(NO_BREAK_SPACE, " ")
        escaped = html.escape(text, quote=True)
        return any(escaped in source or text in said for source, said in self.entries.get(name, ()))

    def _entries(self) -> dict[str, list[tuple[str, str]]]:
        """Return the entries of each declaration: as they are written, and as they are read."""
        found: dict[str, list[tuple[str, str]]] = {}
        _, *parts = _BEGINNING.split(self.source)
        for id_, source in zip(parts[::2], parts[1::2], strict=True):
            entry = source, "".join(self._spoken[html.unescape(id_)])
            found.setdefault(id_.partition(".")[0], []).append(entry)
        return found


@pytest.fixture(scope="session")
def english(course: Course) -> Mapping[str, str]:
    return pages(course, Words("en"))


@pytest.fixture(scope="session")
def read(english: Mapping[str, str]) -> Mapping[str, Page]:
    """Every page by the name of its file."""
    return {name: Page(text) for name, text in english.items()}


@pytest.fixture(scope="session")
def declared(course: Course) -> Mapping[str, list[Quantity]]:
    """Every declaration that a scheme has with any two choices, each once, by scheme."""
    found: dict[str, dict[int, Quantity]] = {}  # parts may have one file of a scheme's changes
    for scheme in course.schemes.values():
        own = found.setdefault(scheme.id, {})
        for options in pair_option_sets(scheme):
            own |= {id(one): one for one in compose(course, scheme, options).values()}
    return {scheme: list(own.values()) for scheme, own in found.items()}
