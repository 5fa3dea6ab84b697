"""One spelling for what people take for the same word, however a keyboard or a program wrote it."""

import unicodedata
from typing import Final

APOSTROPHES: Final = "'’‘ʼ`´′ʹ＇"
"""Ukrainian names have one; each keyboard and each office program has another sign for it."""

_HYPHENS: Final = "‐‑–—−"
_SAME: Final = str.maketrans(
    {"ё": "е", **dict.fromkeys(APOSTROPHES, "'"), **dict.fromkeys(_HYPHENS, "-")}
)


def plain(text: str) -> str:
    """Return a text without what people do not see: capitals, spare blanks, sorts of one sign."""
    folded = unicodedata.normalize("NFC", text).casefold().translate(_SAME)
    return " ".join(folded.split())
