"""The text of a file that an office saved, in whatever encoding it did."""

import codecs
from typing import Final

from gripcourse.errors import Problem, TableError
from gripcourse.machine.content import Readable, shown_name
from gripcourse.machine.table_bounds import around
from gripcourse.text.words import Message, message

_ENCODINGS: Final = ("cp1251", "cp866", "koi8_u")
"""In which offices of the course's languages still save text."""


def decoded(source: Readable, content: bytes) -> tuple[str, tuple[Message, ...]]:
    """Decode a file: as Unicode where it can be, else as what its letters make most likely."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return _as_unicode(source, content, "utf-16"), ()
    try:
        return content.decode("utf-8-sig"), ()
    except UnicodeDecodeError as fault:
        guess = _guessed(content, fault.start)
        if guess is None:
            line = fault.object[: fault.start].count(b"\n") + 1
            raise _not_text(source, line) from fault
    text, encoding = guess
    note = message(
        "{file} is no Unicode text and was read as {encoding}: look at the names. To be sure, save"
        " it as “CSV UTF-8”.",
        file=shown_name(source),
        encoding=encoding,
    )
    return text, (note,)


def _as_unicode(source: Readable, content: bytes, encoding: str) -> str:
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as fault:
        raise _not_text(source, 1) from fault


def _guessed(content: bytes, place: int) -> tuple[str, str] | None:
    """Return a text and the encoding that it most likely has; None for what is no text.

    Args:
        content: of the file.
        place: of the first letter that is no ASCII.
    """
    import charset_normalizer  # noqa: PLC0415 (for old files alone)

    if b"\0" in content:
        return None
    enough = around(content, place)
    best = charset_normalizer.from_bytes(enough, cp_isolation=list(_ENCODINGS)).best()
    try:
        return None if best is None else (content.decode(best.encoding), best.encoding)
    except UnicodeDecodeError:  # elsewhere there is a letter that the encoding has not
        return None


def _not_text(source: Readable, line: int) -> TableError:
    what = message("The file is not in UTF-8: line {line} cannot be read.", line=line)
    remedy = message("Save it again as “CSV UTF-8”: Excel has it in its list of file types.")
    return TableError([Problem(shown_name(source), "", what, remedy)])
