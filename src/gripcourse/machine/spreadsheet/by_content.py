"""Telling a workbook by what is in it, whatever its file is called.

A browser that looks at the first bytes calls a workbook `.zip`, since it is one; people rename what
a platform does not take. Nothing is unpacked here: the names of the members stand at the end.
"""

import os
import re
import struct
from collections.abc import Iterator
from typing import Final

from gripcourse.machine.archive import beginning_of_member
from gripcourse.machine.content import NamedBytes, PackedFile, Readable, content_of

_ARCHIVE: Final = b"PK\x03\x04"
# The first member of an OpenDocument file says what it is, unpacked and behind its name.
_OPEN_DOCUMENT: Final = re.compile(
    rb"PK\x03\x04.{26}mimetypeapplication/vnd\.oasis\.opendocument\.spreadsheet", re.DOTALL
)
_BEGINNING: Final = 128  # bytes
_LONGEST_END: Final = 1 << 20  # bytes; of a workbook's thousand members, their list has 150 000
# The end of an archive: its sign, how long the list of members is, and where it begins.
_END: Final = struct.Struct("<4s8xLL2x")
_SIGN_OF_END: Final = b"PK\x05\x06"
# An entry of that list: its sign, and how long the three texts are that stand behind it.
_ENTRY: Final = struct.Struct("<4s24xHHH12x")
_SIGN_OF_ENTRY: Final = b"PK\x01\x02"
_CONTENT_TYPES: Final = "[content_types].xml"
_WORKBOOKS: Final = frozenset({"xl/workbook.xml", "xl/workbook.bin"})


def is_workbook(source: Readable) -> bool:
    """Tell whether a file is a workbook by its content; one that cannot be read is none."""
    try:
        beginning = _beginning(source)
        if _OPEN_DOCUMENT.match(beginning):
            return True
        if not beginning.startswith(_ARCHIVE):
            return False
        names = frozenset(_members(*_end(source)))
    except OSError:
        return False
    return _CONTENT_TYPES in names and not names.isdisjoint(_WORKBOOKS)


def _members(end: bytes, size: int) -> Iterator[str]:
    """Yield the names of the members, in small letters, that the list at the end has.

    A workbook that was packed as it is has such a list too, inside of the archive that holds it:
    only the list counts that ends the file, and that lies where the archive says.

    Args:
        end: of the file.
        size: of the whole file.
    """
    place = end.rfind(_SIGN_OF_END)
    if place < 0 or len(end) - place < _END.size:
        return
    _, length, begin = _END.unpack_from(end, place)
    first = place - length
    if first < 0 or begin != size - len(end) + first:
        return
    while first + _ENTRY.size <= place:
        sign, *lengths = _ENTRY.unpack_from(end, first)
        if sign != _SIGN_OF_ENTRY:
            return
        first += _ENTRY.size
        name = end[first : first + lengths[0]].decode("latin-1")
        yield name.replace("\\", "/").removeprefix("/").lower()
        first += sum(lengths)


def _beginning(source: Readable) -> bytes:
    if isinstance(source, NamedBytes):
        return source.data[:_BEGINNING]
    if isinstance(source, PackedFile):
        return beginning_of_member(source.archive, source.place, _BEGINNING)
    with source.open("rb") as stream:
        return stream.read(_BEGINNING)


def _end(source: Readable) -> tuple[bytes, int]:
    """Return the last bytes of a file, and how many there are in all."""
    if isinstance(source, NamedBytes | PackedFile):
        content = content_of(source)
        return content[-_LONGEST_END:], len(content)
    with source.open("rb") as stream:
        size = stream.seek(0, os.SEEK_END)
        stream.seek(max(0, size - _LONGEST_END))
        return stream.read(), size
