"""The parts of a workbook's archive, found as a spreadsheet program finds them: by relationships.

Each part is gone through once, and checked on the way. Pictures, charts and pivot tables stay
packed: they cost nothing here and cannot be damaged. The works of a course share their theme, their
styles and their types of content: such a part is gone through once for all of them.
"""

import posixpath
import zipfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Final, TypeVar
from urllib.parse import unquote
from xml.etree.ElementTree import Element, ParseError
from xml.parsers import expat

from gripcourse.machine.spreadsheet.xml_names import LONG, check_long_tags, check_names
from gripcourse.machine.spreadsheet.xml_scan import (
    Bounds,
    PartCounts,
    XmlScan,
    local_name,
    may_hold_asides,
)

Made = TypeVar("Made")

_OFFICE_DOCUMENT: Final = "officeDocument"
_USUAL_WORKBOOK: Final = "xl/workbook.xml"
_CHUNK: Final = 1 << 16
_SHORT: Final = 1 << 15  # bytes of a part that may be the same in many works
_LONGEST_TARGET: Final = 0xFFFF
_KEPT: Final = 64  # such parts, two megabytes at most
UNSOUND: Final = (expat.ExpatError, ParseError, LookupError, UnicodeError)
"""What is raised of a part that is no sound XML; the latter two of encodings."""
_BEFORE_XML: Final = b"\xef\xbb\xbf\xff\xfe\0 \t\r\n"  # byte order marks and white space


@dataclass(frozen=True, slots=True)
class Related:
    """Part that another part points to.

    Attributes:
        identifier: by which the other part calls it.
        kind: last word of the relationship's type, for example `worksheet`.
        part: name in the archive, without a leading slash.
    """

    identifier: str
    kind: str
    part: str


class Package:
    """An open archive, of which some parts have been read; some packers write other names."""

    def __init__(self, archive: zipfile.ZipFile, scan: XmlScan) -> None:
        self._archive = archive
        self._scan = scan
        members = archive.infolist()
        self._members = {part_name(member.filename): member for member in members}
        self._roots: dict[str, Element] = {}
        self._by_name: dict[str, Mapping[str, Sequence[Element]]] = {}
        self._related: dict[str, tuple[Related, ...]] = {}
        self._seen: set[str] = set()
        self._damaged: list[str] = []

    def has(self, part: str) -> bool:
        """Tell whether there is such a part."""
        return part.lower() in self._members

    def root(self, part: str) -> Element:
        """Return the tree of a short part, which is kept: it may be asked for again.

        Raises:
            KeyError: there is no such part.
            Exception: whatever the bytes make a library raise.
        """
        if part not in self._roots:
            self._roots[part] = self.tree(part)
        return self._roots[part]

    def elements(self, part: str, name: str) -> Sequence[Element]:
        """Return the elements of a short part that are called so, in whatever namespace.

        They stand as in the part. Errors: see `root`.
        """
        if part not in self._by_name:
            self._by_name[part] = _by_name(self.root(part))
        return self._by_name[part].get(name, ())

    def sound_root(self, part: str) -> Element | None:
        """Return the tree of a short part that can be done without; None where it is damaged.

        Raises:
            KeyError: there is no such part.
            RefusedError: it holds what must not be read.
            Exception: what `zipfile` raises of damaged ones.
        """
        try:
            return self.root(part)
        except UNSOUND:
            self._damaged.append(part)
            return None

    def tree(self, part: str) -> Element:
        """Return the tree of a part that nobody else reads. Errors: as above."""
        return self._scan.root(self._content(part))

    def made_of(self, part: str, make: Callable[[Element], Made]) -> Made:
        """Return what is made of the tree of a part that nobody else reads. Errors: as above.

        Args:
            part: its name.
            make: called once for all parts with the same bytes; what it returns must not change.
        """
        content = self._content(part)
        if len(content) > _SHORT:
            return make(self._scan.root(content))
        made: Made
        made, seen = _made_of(content, make)
        self._scan.add(seen)
        return made

    def long_part(self, part: str, read: Callable[[bytes, XmlScan], Made]) -> Made:
        """Return what is read of a part of any length, of which no tree is made. Errors: as above.

        Args:
            part: its name.
            read: goes through it by `long_scan.go_through`.
        """
        return read(self._content(part, check_long_tags), self._scan)

    def _content(self, part: str, look: Callable[[bytes], None] = check_names) -> bytes:
        """Return the content of a part that nobody has read: none has two purposes."""
        name = part.lower()
        member = self._members[name]
        if name in self._seen:
            raise ValueError(part)
        self._seen.add(name)
        return self._unpacked(member, look)

    def check_others(self) -> tuple[str, ...]:
        """Check every part that nobody has read, in the order of the archive.

        Returns:
            The names of those that should be sound XML and are not, whoever met them: spreadsheet
            programs open a workbook without them.

        Raises:
            RefusedError: one holds what must not be read.
            Exception: what `zipfile` raises of damaged ones.
        """
        for name, member in self._members.items():
            if name not in self._seen:
                self._seen.add(name)
                self._check(member)
        return tuple(self._damaged)

    def _check(self, member: zipfile.ZipInfo) -> None:
        content = self._unpacked(member, check_names)
        try:
            if content:
                self._check_content(content)
        except UNSOUND:
            # Drawings of comments need not be sound XML.
            if member.filename.lower().endswith((".xml", ".rels")):
                self._damaged.append(member.filename)

    def _check_content(self, content: bytes) -> None:
        if len(content) > _SHORT:
            _go_through(content, self._scan)
        else:
            self._scan.add(_seen_in(content))

    def _unpacked(self, member: zipfile.ZipInfo, look: Callable[[bytes], None]) -> bytes:
        """Return a part that is XML, however it is called; nothing of others: they stay packed."""
        with self._archive.open(member) as stream:
            beginning = stream.read(_CHUNK)
            if beginning.lstrip(_BEFORE_XML)[:1] not in {b"<", b""}:
                return b""
            self._scan.unpack(member.file_size)
            content = beginning + stream.read()
        look(content)
        return content

    def related(self, part: str) -> tuple[Related, ...]:
        """Return the parts that a part points to; of the archive itself where it is empty."""
        if part not in self._related:
            self._related[part] = self._find_related(part)
        return self._related[part]

    def _find_related(self, part: str) -> tuple[Related, ...]:
        folder, name = posixpath.split(part)
        relations = posixpath.join(folder, "_rels", f"{name}.rels")
        if not self.has(relations):
            return ()
        return tuple(
            Related(
                identifier=one.get("Id", ""),
                kind=one.get("Type", "").rpartition("/")[2],
                part=self._target(folder, one.get("Target", "")),
            )
            for one in self.elements(relations, "Relationship")
            if one.get("TargetMode") != "External"
        )

    def _target(self, folder: str, target: str) -> str:
        """Return the part that a relationship means; some programs write it as an address."""
        if len(target) > _LONGEST_TARGET:  # a name that no archive can hold
            return ""
        found = (
            posixpath.normpath(posixpath.join("/", folder, spelled)).lstrip("/")
            for spelled in (target, unquote(target), target.replace("\\", "/"))
        )
        first = next(found)
        return first if self.has(first) else next((one for one in found if self.has(one)), first)

    def sheets(self, workbook: str) -> Mapping[str, str]:
        """Return the part of every sheet by its title; a sheet without a part is left out.

        Raises:
            ValueError: two sheets have one title, or two parts are called the same: programs
                disagree which of them is meant.
        """
        parts: dict[str, str] = {}
        for one in self.related(workbook):
            if one.kind != "worksheet" or not self.has(one.part):
                continue
            if parts.setdefault(one.identifier, one.part) != one.part:
                raise ValueError(one.identifier)
        sheets: dict[str, str] = {}
        for element in self.elements(workbook, "sheet"):
            part = parts.get(_attribute(element, "id") or "")
            if part is not None:
                title = element.get("name", "")
                if title in sheets:
                    raise ValueError(title)
                sheets[title] = part
        return sheets

    def lost_sheets(self, workbook: str) -> frozenset[str]:
        """Return the titles of the sheets whose cells are nowhere."""
        listed = self.elements(workbook, "sheet")
        return frozenset(one.get("name", "") for one in listed) - self.sheets(workbook).keys()

    def hidden_sheets(self, workbook: str) -> frozenset[str]:
        """Return the titles of the sheets that nobody sees."""
        found = self.elements(workbook, "sheet")
        return frozenset(
            one.get("name", "") for one in found if one.get("state", "visible") != "visible"
        )

    def workbook_part(self) -> str:
        """Return the name of the part that lists sheets and names."""
        found = (one.part for one in self.related("") if one.kind == _OFFICE_DOCUMENT)
        return next(found, _USUAL_WORKBOOK)


def _by_name(root: Element) -> Mapping[str, Sequence[Element]]:
    """Return the elements of a tree by their names without namespaces."""
    found: dict[str, list[Element]] = {}
    names: dict[str, str] = {}
    for element in root.iter():
        tag = element.tag
        if tag not in names:
            names[tag] = local_name(tag)
        found.setdefault(names[tag], []).append(element)
    return found


def _go_through(content: bytes, scan: XmlScan) -> None:
    # Both cost a tree too much, and nothing without one.
    if len(content) > LONG or may_hold_asides(content):
        scan.check(content)
        return
    try:
        scan.root(content)  # faster, but each prefix must mean something
    except (ParseError, LookupError, UnicodeError):
        scan.check(content)


@lru_cache(maxsize=_KEPT)
def _seen_in(content: bytes) -> PartCounts:
    scan = _scan_of_short()
    _go_through(content, scan)
    return scan.seen


@lru_cache(maxsize=_KEPT)
def _made_of(content: bytes, make: Callable[[Element], Any]) -> tuple[Any, PartCounts]:
    scan = _scan_of_short()
    return make(scan.root(content)), scan.seen


def _scan_of_short() -> XmlScan:
    return XmlScan(Bounds(_SHORT, _SHORT, _SHORT, _SHORT, _SHORT))


def part_name(member: str) -> str:
    """Return what the name of a member means."""
    name = member.replace("\\", "/")
    if "./" in name or "//" in name:
        name = posixpath.normpath(name) + "/" * name.endswith("/")
    return name.lstrip("/").lower()


def _attribute(element: Element, name: str) -> str | None:
    """Return an attribute by its name in whatever namespace."""
    found = (value for key, value in element.items() if local_name(key) == name)
    return next(found, None)
