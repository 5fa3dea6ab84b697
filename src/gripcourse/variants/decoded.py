"""The text of a file that an office saved, in whatever encoding it did."""

import codecs
import io
import re
from dataclasses import dataclass
from typing import Final

from gripcourse.errors import Problem, TableError
from gripcourse.machine.content import Readable, shown_name
from gripcourse.machine.table_bounds import around
from gripcourse.text.words import Message, message

_ENCODINGS: Final = ("cp1251", "cp866", "koi8_u")
"""In which offices of the course's languages still save text."""
_OF_MACS: Final = "mac_cyrillic"
# A name, a word, an abbreviation: what people write begins with a capital, or has them alone.
_WORD: Final = re.compile(r"[А-ЯЁІЇЄҐ]?[а-яёіїєґ]+|[А-ЯЁІЇЄҐ]+")
_FOREIGN: Final = re.compile(r"[^\x00-\x7f]+")
_MOSTLY, _PLAINLY_MORE = 0.9, 0.2  # shares of letters
_BEGINNING: Final = 1 << 12  # bytes
_PAGES: Final = (0x00, 0x04)  # first bytes of Latin and Cyrillic letters, digits and separators
_FEWEST_KNOWN: Final = 0.9  # share of these; the others are № and quotation marks


@dataclass(frozen=True, slots=True)
class TextOfFile:
    """A file of text. All of it is never in memory at once: its letters may take four bytes each.

    Attributes:
        content: of the file.
        encoding: in which all of it can be read.
        notes: how it was read where it could have been read in another way.
    """

    content: bytes
    encoding: str
    notes: tuple[Message, ...] = ()

    def opened(self) -> io.TextIOWrapper:
        """Return the text with its own line ends."""
        return io.TextIOWrapper(io.BytesIO(self.content), self.encoding, newline="")


def decoded(source: Readable, content: bytes) -> TextOfFile:
    """Tell how a file is read: as Unicode where it can be, else as its letters make most likely."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        _check(source, content, "utf-16")
        return TextOfFile(content, "utf-16")
    if (unmarked := _unmarked_utf16(content)) is not None:
        _check(source, content, unmarked)
        return TextOfFile(content, unmarked)
    try:
        content.decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        encoding = _guessed(content, fault.start)
        if encoding is None:
            line = fault.object[: fault.start].count(b"\n") + 1
            raise _not_text(source, line) from fault
    else:
        return TextOfFile(content, "utf-8-sig")
    note = message(
        "{file} is no Unicode text and was read as {encoding}: look at the names. To be sure, save"
        " it as “CSV UTF-8”.",
        file=shown_name(source),
        encoding=encoding,
    )
    return TextOfFile(content, encoding, (note,))


def _unmarked_utf16(content: bytes) -> str | None:
    """Tell a text of two bytes a letter that does not say so, as programs of databases export it.

    One of both bytes is then nearly always that of two alphabets, and a nought for each blank,
    digit and separator; the other one never is a nought.
    """
    beginning = content[:_BEGINNING]
    if len(content) % 2 or b"\0" not in beginning:
        return None
    for encoding, first in (("utf-16-be", 0), ("utf-16-le", 1)):
        pages, others = beginning[first::2], beginning[1 - first :: 2]
        known = sum(map(pages.count, _PAGES))
        if 0 in pages and 0 not in others and known >= _FEWEST_KNOWN * len(pages):
            return encoding
    return None


def _check(source: Readable, content: bytes, encoding: str) -> None:
    try:
        content.decode(encoding)
    except UnicodeDecodeError as fault:
        raise _not_text(source, 1) from fault


def _guessed(content: bytes, place: int) -> str | None:
    """Return the encoding that a text most likely has; None for what is no text.

    Args:
        content: of the file.
        place: of the first letter that is no ASCII.
    """
    import charset_normalizer  # noqa: PLC0415 (for old files alone)

    if b"\0" in content:
        return None
    enough = around(content, place)
    if _is_of_a_mac(enough):
        return _OF_MACS
    best = charset_normalizer.from_bytes(enough, cp_isolation=list(_ENCODINGS)).best()
    if best is None:
        return None
    try:
        content.decode(best.encoding)
    except UnicodeDecodeError:  # elsewhere there is a letter that the encoding has not
        return None
    return best.encoding


def _is_of_a_mac(content: bytes) -> bool:
    """Tell whether a text has words as old spreadsheet programs on macOS saved them, and only so.

    Small letters are those of Windows there, capitals those of DOS: names are torn in both.
    """
    rival = max(_share_of_words(content, one) for one in _ENCODINGS)
    share = _share_of_words(content, _OF_MACS)
    return share >= _MOSTLY and share >= rival + _PLAINLY_MORE


def _share_of_words(content: bytes, encoding: str) -> float:
    """Return the share of the letters beyond ASCII that are in words as people write them."""
    found: list[str] = _FOREIGN.findall(content.decode(encoding, errors="replace"))
    letters = sum(map(len, found))
    return sum(len(one) for one in found if _WORD.fullmatch(one)) / letters if letters else 0.0


def _not_text(source: Readable, line: int) -> TableError:
    what = message("The file is not in UTF-8: line {line} cannot be read.", line=line)
    remedy = message("Save it again as “CSV UTF-8”: Excel has it in its list of file types.")
    return TableError([Problem(shown_name(source), "", what, remedy)])
