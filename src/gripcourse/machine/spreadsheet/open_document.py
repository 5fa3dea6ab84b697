"""What LibreOffice leaves out of an OpenDocument spreadsheet that other programs wrote."""

import io
import zipfile
import zlib
from collections.abc import Iterator
from typing import Final
from xml.parsers import expat

_CONTENT: Final = "content.xml"
_PIECE: Final = "urn:oasis:names:tc:opendocument:xmlns:text:1.0 span"
_CHUNK: Final = 1 << 16
_DAMAGE: Final = (
    *(zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, KeyError),
    *(RuntimeError, ValueError, expat.ExpatError),
)


def loses_texts(data: bytes) -> bool:
    """Tell whether LibreOffice would leave out letters of cells, and say nothing of it.

    It drops a piece of a text that stands inside another piece; Gnumeric writes a text of several
    looks so. What was 34,5 would be 3, or nothing.

    Args:
        data: a whole file; one that is damaged loses nothing that LibreOffice would show.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive, archive.open(_CONTENT) as content:
            return _has_piece_in_piece(iter(lambda: content.read(_CHUNK), b""))
    except _DAMAGE:
        return False


def _has_piece_in_piece(chunks: Iterator[bytes]) -> bool:
    depth, deepest = 0, 0

    def enter(element: str, _attributes: dict[str, str]) -> None:
        nonlocal depth, deepest
        if element == _PIECE:
            depth += 1
            deepest = max(deepest, depth)

    def leave(element: str) -> None:
        nonlocal depth
        if element == _PIECE:
            depth -= 1

    parser = expat.ParserCreate(namespace_separator=" ")
    parser.StartElementHandler = enter
    parser.EndElementHandler = leave
    for chunk in chunks:
        parser.Parse(chunk)
        if deepest > 1:
            return True
    return False
