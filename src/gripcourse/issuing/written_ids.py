"""Ids and names as a list writes them, where what is kept is another text or a damaged one."""

import re
import unicodedata
from collections.abc import Iterable
from typing import Final

from gripcourse.text.shown import first_of
from gripcourse.text.spelling import LOST_SIGN
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Student

_UNFIT: Final = re.compile(r"[\s/\\]+")  # in an id that is to name a folder
_UNSEEN: Final = re.compile("[\u200b-\u200f\u2060\ufeff]")
_NAMED: Final = 10  # students whom a note names


def as_folder(id_: str) -> str:
    """Return an id as it names a folder: offices write `20-МР/031` and `КВ 12345678`.

    One letter can be written as one sign or as two, and folders would differ. A quotation mark
    before a number tells spreadsheet programs that it is a text.
    """
    seen = _UNSEEN.sub("", unicodedata.normalize("NFC", id_)).removeprefix("'").strip()
    return _UNFIT.sub("-", seen)


def written_note(ids: Iterable[tuple[str, str]]) -> tuple[Message, ...]:
    """Name ids that cannot name a folder as the list writes them.

    Args:
        ids: as they are written, and as they are kept.
    """
    changed = [f"{id_} ({written})" for written, id_ in ids if _UNFIT.search(written)]
    if not changed:
        return ()
    said = message(
        "These ids name folders and are written without blanks and strokes: {ids}.",
        ids=first_of(changed, _NAMED),
    )
    return (said,)


def lost_note(students: Iterable[Student]) -> tuple[Message, ...]:
    """Name whose name was damaged when the list was saved in an old code page."""
    names = [one.name for one in students if LOST_SIGN in one.name]
    if not names:
        return ()
    said = message(
        "A letter of these names was lost when the list was saved: {names}. Save it again as"
        " “CSV UTF-8” or .xlsx.",
        names=first_of(names, _NAMED),
    )
    return (said,)
