"""Going through a long part while it is parsed, without a tree of it."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final
from xml.parsers import expat

from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.xml_scan import (
    MOST_NAMES,
    OF_ANY_SPACE,
    PartCounts,
    RefusedError,
    XmlScan,
    refuse_declarations,
)

_LONG_TEXT: Final = 1 << 16  # bytes that are told at once
_SEPARATOR: Final = " "  # between a namespace and a name


class PartNames:
    """The names of the elements of a long part; it changes, because a parser calls back.

    Attributes:
        known: names without their namespace by what the parser calls an element; empty for one of
            another namespace than the part's own, unless its kind counts in all.
        interned: all names of elements and attributes.
    """

    def __init__(self) -> None:
        self.known: dict[str, str] = {}
        self.interned: dict[str, str] = {}
        self._own = ""

    def learn(self, element: str) -> str:
        """Return the name of an element that was not met before.

        Raises:
            RefusedError: there are more names than programs write.
        """
        space, _, name = element.rpartition(_SEPARATOR)
        if not self.known:
            self._own = space
        self.known[element] = found = name if space == self._own or name in OF_ANY_SPACE else ""
        self.check()
        return found

    def check(self) -> None:
        """See that there are not too many names.

        Raises:
            RefusedError: as above.
        """
        if len(self.interned) > MOST_NAMES:
            raise RefusedError(WhyRefused.FOREIGN_CONTENT)


@dataclass(frozen=True, slots=True)
class Handlers:
    """What is called while a part is parsed.

    Attributes:
        enter: at the beginning of each element, with its attributes.
        leave: at its end.
        write: with text between them, in pieces of any length.
    """

    enter: Callable[[str, dict[str, str]], None]
    leave: Callable[[str], None]
    write: Callable[[str], None]


def go_through(content: bytes, scan: XmlScan, names: PartNames, handlers: Handlers) -> None:
    """Tell somebody of the elements of a part, who looks at how deep they are.

    That there are not too many of them is seen before, by the sign that each begins with.

    Args:
        content: of the part.
        scan: of the archive.
        names: of its elements and attributes.
        handlers: are called.

    Raises:
        RefusedError: it holds too much, or what no spreadsheet program writes.
        expat.ExpatError, LookupError, UnicodeError: it is no sound XML.
    """
    scan.add(PartCounts(content.count(b"<") - content.count(b"</"), {}))
    parser = expat.ParserCreate(namespace_separator=_SEPARATOR, intern=names.interned)
    parser.buffer_text = True
    parser.buffer_size = _LONG_TEXT
    parser.StartElementHandler, parser.EndElementHandler = handlers.enter, handlers.leave
    parser.CharacterDataHandler = handlers.write
    parser.StartDoctypeDeclHandler = refuse_declarations
    parser.Parse(content, True)
