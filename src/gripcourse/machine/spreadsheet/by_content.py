"""Telling a workbook by what is in it, whatever its file is called.

A browser that looks at the first bytes calls a workbook `.zip`, since it is one; people rename what
a platform does not take. Nothing is unpacked here: the names of the members stand at the end.
"""

import os
import re
from typing import Final

from gripcourse.machine.archive import beginning_of_member
from gripcourse.machine.content import NamedBytes, PackedFile, Readable, content_of

_ARCHIVE: Final = b"PK\x03\x04"
# The first member of an OpenDocument file says what it is, unpacked and behind its name.
_OPEN_DOCUMENT: Final = re.compile(
    rb"PK\x03\x04.{26}mimetypeapplication/vnd\.oasis\.opendocument\.spreadsheet", re.DOTALL
)
_BEGINNING: Final = 128  # bytes
_LIST_OF_MEMBERS: Final = 1 << 20  # bytes at the end; a workbook's thousand names have 150 000
# An entry of that list: its sign, what is told of the member, its name.
_OF_A_WORKBOOK: Final = tuple(
    re.compile(rb"PK\x01\x02.{42}[/\\]?" + name, re.DOTALL | re.IGNORECASE)
    for name in (rb"\[Content_Types\]\.xml", rb"xl[/\\]workbook\.(?:xml|bin)")
)


def is_workbook(source: Readable) -> bool:
    """Tell whether a file is a workbook by its content; one that cannot be read is none."""
    try:
        beginning = _beginning(source)
        if _OPEN_DOCUMENT.match(beginning):
            return True
        if not beginning.startswith(_ARCHIVE):
            return False
        end = _end(source)
    except OSError:
        return False
    return all(one.search(end) for one in _OF_A_WORKBOOK)


def _beginning(source: Readable) -> bytes:
    if isinstance(source, NamedBytes):
        return source.data[:_BEGINNING]
    if isinstance(source, PackedFile):
        return beginning_of_member(source.archive, source.place, _BEGINNING)
    with source.open("rb") as stream:
        return stream.read(_BEGINNING)


def _end(source: Readable) -> bytes:
    if isinstance(source, NamedBytes | PackedFile):
        return content_of(source)[-_LIST_OF_MEMBERS:]
    with source.open("rb") as stream:
        size = stream.seek(0, os.SEEK_END)
        stream.seek(max(0, size - _LIST_OF_MEMBERS))
        return stream.read()
