"""One spelling for what people take for the same word, however a keyboard or a program wrote it."""

import re
import unicodedata
from typing import Final

APOSTROPHES: Final = "'’‘ʼ`´′ʹ＇"
"""Ukrainian names have one; each keyboard and each office program has another sign for it."""

LOST_SIGN: Final = "?"
"""What spreadsheet programs write for a letter that an old code page lacks, such as a Greek one."""

_HYPHENS: Final = "‐‑–—−"
_SAME: Final = str.maketrans(
    {"ё": "е", **dict.fromkeys(APOSTROPHES, "'"), **dict.fromkeys(_HYPHENS, "-")}
)
# Cyrillic letters that look like Latin ones, in small or in capital letters.
_ALIKE: Final = str.maketrans("авсенһіјкмоԛрѕтухԝԁѵ", "abcehhijkmoqpstyxwdv")
_LETTERS: Final = "абвгґдеєжзиіїйклмнопрстуфхцчшщъыьэюя"
_PRIVATE: Final = 0xE000  # behind all other letters
_IN_ORDER: Final = str.maketrans(
    {one: chr(_PRIVATE + at) for at, one in enumerate(_LETTERS)} | {"'": ""}  # as dictionaries do
)
_NUMBER: Final = re.compile(r"([0-9]{1,9})")


def plain(text: str) -> str:
    """Return a text without what people do not see: capitals, spare blanks, sorts of one sign."""
    folded = unicodedata.normalize("NFC", text).casefold().translate(_SAME)
    return " ".join(folded.split())


def as_seen(text: str) -> str:
    """Return a plain text in which letters that look the same are: Cyrillic, Latin, wide ones."""
    return unicodedata.normalize("NFKC", plain(text)).translate(_ALIKE)


def alphabetical(text: str) -> list[str | int]:
    """Return by what names and groups are sorted: as people do, in any of the three languages.

    By their codes Є, І and Ї stand before А, Ґ behind Я, and РТК-9 behind РТК-10.
    """
    letters = plain(text).translate(_IN_ORDER)
    return [int(part) if at % 2 else part for at, part in enumerate(_NUMBER.split(letters))]


def may_have_been(whole: str, damaged: str) -> bool:
    """Tell whether a text is another one in which a code page put a sign for those it lacks."""
    signs = zip(whole, damaged, strict=False)
    return len(whole) == len(damaged) and all(two in {one, LOST_SIGN} for one, two in signs)
