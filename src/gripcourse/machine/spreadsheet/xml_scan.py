"""The XML of an archive, checked against bounds while it is parsed."""

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import chain
from operator import attrgetter
from typing import Final
from xml.etree.ElementTree import Element, TreeBuilder, XMLParser
from xml.parsers import expat

from gripcourse.machine.spreadsheet.addresses import column_number
from gripcourse.machine.spreadsheet.refusals import WhyRefused

MOST_SHEETS: Final = 100
DEEPEST: Final = 100  # elements inside each other; office programs stay below 20
MOST_COVERED: Final = 100_000  # cells; the reader makes one for each cell that a range covers
MOST_RANGES: Final = 5_000
MOST_RELATIONS: Final = 10_000  # of all parts; each link to the network is one
# Comments and instructions of one part; office programs write none. At each the parser copies the
# text that it has so far: ten thousand of them behind a text of eight megabytes take 6 seconds.
MOST_ASIDES: Final = 100
# Of a part of which a tree is made. The parser keeps each end of a line, and the letters before it,
# by themselves: lines of one letter take forty times their length.
MOST_LINES: Final = 1_000_000

MOST_NAMES: Final = 10_000  # all formats of office programs together have some thousands

_MOST: Final[Mapping[str, tuple[int, WhyRefused]]] = {
    "sheet": (MOST_SHEETS, WhyRefused.TOO_LARGE),
    "relation": (MOST_RELATIONS, WhyRefused.TOO_LARGE),
    "range": (MOST_RANGES, WhyRefused.MERGED),
    "covered": (MOST_COVERED, WhyRefused.MERGED),
}
_RANGES: Final = frozenset({"mergeCell", "hyperlink", "comment"})
_COUNTED: Final = _RANGES | {"sheet", "Relationship"}
OF_ANY_SPACE: Final = _COUNTED | {"AlternateContent"}
"""Elements that count in whatever namespace."""
_TAG_OF: Final = attrgetter("tag")
_CORNERS: Final = re.compile(r"\$?([A-Za-z]{1,3})\$?(\d{1,7})(?::\$?([A-Za-z]{1,3})\$?(\d{1,7}))?")


class RefusedError(Exception):
    """A file that must not be read any further.

    Attributes:
        reason: for the person who sent it.
    """

    def __init__(self, reason: WhyRefused) -> None:
        self.reason = reason
        super().__init__(reason)


@dataclass(frozen=True, slots=True)
class Bounds:
    """What a file may hold.

    Attributes:
        part, total: bytes of XML, unpacked, by the sizes that the archive declares.
        elements: of XML.
        tree: bytes of a part of which a tree is made.
        tree_elements: of such a part.
    """

    part: int
    total: int
    elements: int
    tree: int
    tree_elements: int


@dataclass(frozen=True, slots=True)
class PartCounts:
    """What a part holds of what is bounded.

    Attributes:
        elements: of XML.
        counted: how many sheets, relations, ranges and covered cells.
    """

    elements: int
    counted: Mapping[str, int]


class XmlScan:
    """What was seen of an archive's XML so far; it changes, because a parser calls back."""

    def __init__(self, bounds: Bounds) -> None:
        self._bounds = bounds
        self._elements = 0
        self._unpacked = 0
        self._seen: Counter[str] = Counter()

    @property
    def seen(self) -> PartCounts:
        """What was seen so far."""
        return PartCounts(self._elements, dict(self._seen))

    def add(self, seen: PartCounts) -> None:
        """Count what a part holds that was gone through before, byte for byte the same.

        Raises:
            RefusedError: it is too much.
        """
        self._elements += seen.elements
        if self._elements > self._bounds.elements:
            raise RefusedError(WhyRefused.TOO_LARGE)
        for what, number in seen.counted.items():
            self._count(what, number)

    def unpack(self, size: int) -> None:
        """Count the declared size of a part, which `zipfile` never unpacks beyond.

        Pictures are not counted: nothing but XML is ever unpacked.

        Raises:
            RefusedError: it is too much.
        """
        self._unpacked += size
        if size > self._bounds.part or self._unpacked > self._bounds.total:
            raise RefusedError(WhyRefused.TOO_LARGE)

    def check(self, content: bytes, *, most_asides: int | None = None) -> None:
        """Go through a part without making a tree of it; prefixes need not mean anything.

        Args:
            content: of the part.
            most_asides: comments and instructions that it may have; None for any number.

        Raises:
            RefusedError: it holds too much, or what no spreadsheet program writes.
            expat.ExpatError, LookupError, UnicodeError: it is no sound XML.
        """
        depth, elements, most = 0, self._elements, self._bounds.elements
        asides = 0

        def enter(element: str, attributes: dict[str, str]) -> None:
            nonlocal depth, elements
            depth += 1
            elements += 1
            if depth > DEEPEST:
                raise RefusedError(WhyRefused.FOREIGN_CONTENT)
            if elements > most:
                raise RefusedError(WhyRefused.TOO_LARGE)
            name = element.rpartition(":")[2] if ":" in element else element
            if name in _COUNTED:
                self._count_one(name, attributes)

        def leave(_element: str) -> None:
            nonlocal depth
            depth -= 1

        def pass_by(*_aside: str) -> None:
            nonlocal asides
            asides += 1
            if asides > (most_asides or 0):
                raise RefusedError(WhyRefused.FOREIGN_CONTENT)

        parser = expat.ParserCreate()
        if most_asides is not None:
            parser.CommentHandler = parser.ProcessingInstructionHandler = pass_by
        parser.StartElementHandler = enter
        parser.EndElementHandler = leave
        parser.StartDoctypeDeclHandler = refuse_declarations
        # In one piece: with each further one the parser looks through a long attribute again.
        parser.Parse(content, True)
        self._elements = elements

    def look_at(self, depth: int, name: str, attributes: Mapping[str, str]) -> None:
        """Bound an element of a part that somebody else goes through.

        Raises:
            RefusedError: it stands too deep, or there are too many of its kind.
        """
        if depth > DEEPEST:
            raise RefusedError(WhyRefused.FOREIGN_CONTENT)
        if name in _COUNTED:
            self._count_one(name, attributes)

    def root(self, content: bytes) -> Element:
        """Check a part and return its tree.

        The tree is looked at when it is there, which is faster than looking at each element while
        it is made; what may have too many elements is gone through before.

        Raises:
            RefusedError: as above.
            Exception: what the parser raises of unsound XML.
        """
        if len(content) > self._bounds.tree:
            raise RefusedError(WhyRefused.TOO_LARGE)
        if content.count(b"\n") + content.count(b"\r") > MOST_LINES:
            raise RefusedError(WhyRefused.TOO_LARGE)
        left = min(self._bounds.elements - self._elements, self._bounds.tree_elements)
        # Each element begins with this byte in every encoding.
        if content.count(b"<") > left or may_hold_asides(content):
            XmlScan(replace(self._bounds, elements=left)).check(content, most_asides=MOST_ASIDES)
        # A builder that is asked about declarations makes a tree slower than one that is not.
        builder = _Builder() if _may_declare(content) else TreeBuilder()
        parser: XMLParser[Element] = XMLParser(target=builder)  # noqa: S314 (checked)
        parser.feed(content)
        root: Element = parser.close()
        level, depth, tags = [root], 0, {root.tag}
        while level:
            depth += 1
            self._elements += len(level)
            if depth > DEEPEST:
                raise RefusedError(WhyRefused.FOREIGN_CONTENT)
            if self._elements > self._bounds.elements:
                raise RefusedError(WhyRefused.TOO_LARGE)
            with_children = filter(len, level)
            level = list(chain.from_iterable(with_children))
            tags.update(map(_TAG_OF, level))
        for tag in tags:
            if local_name(tag) in _COUNTED:
                for element in root.iter(tag):
                    self._count_one(local_name(tag), element.attrib)
        return root

    def _count_one(self, name: str, attributes: Mapping[str, str]) -> None:
        if name == "sheet":
            self._count("sheet", 1)
        elif name == "Relationship":
            self._count("relation", 1)
        else:
            self._count("range", 1)
            self._count("covered", _covered(attributes.get("ref", "")))

    def _count(self, what: str, number: int) -> None:
        most, reason = _MOST[what]
        self._seen[what] += number
        if self._seen[what] > most:
            raise RefusedError(reason)


def _may_declare(content: bytes) -> bool:
    """Tell whether a part may declare a type; text without zero bytes spells it in ASCII."""
    return b"<!DOCTYPE" in content or b"\0" in content


def may_hold_asides(content: bytes) -> bool:
    """Tell whether a part may have more comments and instructions than programs write."""
    return b"\0" in content or content.count(b"<!--") + content.count(b"<?") > MOST_ASIDES


class _Builder(TreeBuilder):
    def doctype(self, *_declaration: object) -> None:
        refuse_declarations()


def namespace(element: Element) -> str:
    """Return what stands before the names of a part with this root."""
    space, end, _ = element.tag.rpartition("}")
    return space + end


def local(element: Element) -> str:
    """Return the tag of an element without its namespace."""
    return local_name(element.tag)


def local_name(name: str) -> str:
    """Return a name without its namespace; a strict and a usual workbook differ in theirs."""
    return name.rpartition("}")[2]


def refuse_declarations(*_declaration: object) -> None:
    """Refuse a part that declares a type, or entities.

    Raises:
        RefusedError: always.
    """
    raise RefusedError(WhyRefused.FOREIGN_CONTENT)


def _covered(reference: str) -> int:
    """Return how many cells a range covers; whole columns and rows are more than any limit."""
    found = _CORNERS.fullmatch(reference)
    if found is None:
        return MOST_COVERED + 1 if reference else 0
    left, top, right, bottom = found.groups()
    columns = abs(column_number(right or left) - column_number(left)) + 1
    return columns * (abs(int(bottom or top) - int(top)) + 1)
