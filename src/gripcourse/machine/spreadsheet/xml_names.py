"""How many names the elements and attributes of a part have: a parser keeps each of them.

One element with seven hundred thousand attributes takes 260 megabytes before anybody sees it, and
so do two hundred thousand elements of which each is called otherwise.
"""

import re
from typing import Final

from gripcourse.machine.spreadsheet.refusals import WhyRefused
from gripcourse.machine.spreadsheet.xml_scan import MOST_NAMES, RefusedError

LONG: Final = 1 << 20  # bytes of a part; the names of a shorter one take 40 megabytes at most
_PORTION: Final = 1 << 20  # bytes that are looked through at a time; a name that is cut makes two
# Of elements, and of attributes, which stand behind white space. All encodings that a parser takes
# spell these signs as ASCII does, but those of two bytes.
_NAME: Final = re.compile(rb"<[^\s<>/!?]+|\s[^\s<>=/\"']+(?=\s*=\s*[\"'])")
_TWO_BYTES: Final = (b"\xff\xfe", b"\xfe\xff", b"<\0", b"\0<")

# No sign of the beginning of an element may stand in one, whatever its attributes say.
_LONG_TAG: Final = re.compile(rb"<[^<]{65536,}")


def check_long_tags(content: bytes) -> None:
    """Look through a long part whose names are counted while it is parsed.

    What the parser must have whole before anybody sees it is one element with its attributes: only
    where that may be long its names are counted here, in a tenth of the time of `check_names`.

    Raises:
        RefusedError: as there.
    """
    if len(content) <= LONG:
        return
    if content.startswith(_TWO_BYTES):
        raise RefusedError(WhyRefused.FOREIGN_CONTENT)
    for long in _LONG_TAG.finditer(content):
        names: set[bytes] = set()
        for found in _NAME.finditer(content, long.start(), long.end()):
            names.add(found[0])
            if len(names) > MOST_NAMES:
                raise RefusedError(WhyRefused.FOREIGN_CONTENT)


def check_names(content: bytes) -> None:
    """Look through a part before it is parsed.

    Raises:
        RefusedError: it has more names than programs write, or it is long and spelled in letters of
            two bytes, which none does.
    """
    if len(content) <= LONG:
        return
    if content.startswith(_TWO_BYTES):
        raise RefusedError(WhyRefused.FOREIGN_CONTENT)
    names: set[bytes] = set()
    for start in range(0, len(content), _PORTION):
        names.update(_NAME.findall(content, start, start + _PORTION))
        if len(names) > MOST_NAMES:
            raise RefusedError(WhyRefused.FOREIGN_CONTENT)
