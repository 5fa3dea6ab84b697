"""The parts of a workbook's archive, found as a spreadsheet program finds them: by relationships.

What is not asked for is never unpacked: pictures, charts and pivot tables cost nothing here and
cannot be damaged.
"""

import posixpath
import zipfile
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final
from xml.etree.ElementTree import Element, XMLPullParser

_OFFICE_DOCUMENT: Final = "officeDocument"
_USUAL_WORKBOOK: Final = "xl/workbook.xml"
# Bytes of XML parsed at a time: the parser looks through a long attribute again with each portion.
_PORTION: Final = 1 << 20


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


@dataclass(frozen=True, slots=True)
class Package:
    """An open archive.

    Attributes:
        archive: whose parts were checked.
        members: names in the archive by what they mean: slashes forward, letters small.
    """

    archive: zipfile.ZipFile
    members: Mapping[str, str]

    def has(self, part: str) -> bool:
        """Tell whether there is such a part."""
        return part.lower() in self.members

    def content(self, part: str) -> bytes:
        """Unpack a part.

        Raises:
            KeyError: there is no such part.
        """
        return self.archive.read(self.members[part.lower()])

    def elements(self, part: str) -> Iterator[Element]:
        """Yield the elements of a part as they end; who has read one may clear it.

        Raises:
            KeyError: there is no such part.
        """
        content = memoryview(self.content(part))
        parser: XMLPullParser[Element] = XMLPullParser(("end",))
        for start in range(0, len(content), _PORTION):
            parser.feed(content[start : start + _PORTION])
            yield from _ended(parser)
        parser.close()
        yield from _ended(parser)

    def related(self, part: str) -> tuple[Related, ...]:
        """Return the parts that a part points to; of the archive itself where it is empty."""
        folder, name = posixpath.split(part)
        relations = posixpath.join(folder, "_rels", f"{name}.rels")
        if not self.has(relations):
            return ()
        return tuple(
            Related(
                identifier=one.get("Id", ""),
                kind=one.get("Type", "").rpartition("/")[2],
                part=posixpath.normpath(posixpath.join("/", folder, one.get("Target", ""))).lstrip(
                    "/"
                ),
            )
            for one in self.elements(relations)
            if local(one) == "Relationship" and one.get("TargetMode") != "External"
        )

    def workbook_part(self) -> str:
        """Return the name of the part that lists sheets and names."""
        found = (one.part for one in self.related("") if one.kind == _OFFICE_DOCUMENT)
        return next(found, _USUAL_WORKBOOK)


def _ended(parser: "XMLPullParser[Element]") -> Iterator[Element]:
    events: Iterator[Any] = parser.read_events()
    for _, element in events:
        yield element


def package_of(archive: zipfile.ZipFile) -> Package:
    """Return the parts of an archive; some packers write backslashes and capitals."""
    return Package(archive, {part_name(name): name for name in archive.namelist()})


def part_name(member: str) -> str:
    """Return what the name of a member means."""
    return member.replace("\\", "/").lstrip("/").lower()


def local(element: Element) -> str:
    """Return a tag without its namespace; a strict and a usual workbook differ in theirs."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def attribute(element: Element, name: str) -> str | None:
    """Return an attribute by its name in whatever namespace."""
    found = (value for key, value in element.items() if key.rpartition("}")[2] == name)
    return next(found, None)


def child(element: Element, name: str) -> Element | None:
    """Return the first child with a name, None for none."""
    return next((one for one in element if local(one) == name), None)
