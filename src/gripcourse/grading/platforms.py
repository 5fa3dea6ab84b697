"""What a learning platform writes into the paths of the files that it hands out.

Each platform has one strict pattern; anything else in a path was chosen by a person and tells
nothing. A number in a pattern may be the platform's own, so it is read together with the name
beside it.
"""

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import Final

from gripcourse.text.spelling import plain

# `Full Name_ID_assignsubmission_file/…`, or the same before the file's own name where the platform
# makes no folders. Groups have no number; a full name never holds an underscore.
_MOODLE: Final = re.compile(
    r"(?P<name>[^_]*)(?:_(?P<id>.+?))?_assignsubmission_[a-z]+(?:_.*)?", re.DOTALL
)
# `sortablename_LATE_123_456_file.xlsx`: letters and digits of the name, user, attachment, file.
# What was typed or linked there has no attachment.
_CANVAS: Final = re.compile(
    r"(?P<name>[^\W_]+)(?P<late>_LATE)?_(?P<id>\d+)_(?:\d+_.+|(?:text|link)\.html)",
    re.DOTALL | re.IGNORECASE,
)
_WORD: Final = re.compile(r"[^\W_]+")
# What Moodle writes for a name where nobody may know it, in the languages of its packs.
_NOBODY: Final = re.compile(r"(?:participant|участник|учасник)\s*\d*")
_MOST_WORDS: Final = 8  # of a name


@dataclass(frozen=True, slots=True)
class PlatformPart:
    """The part of a path that a platform wrote.

    Attributes:
        identifier: whose it is, as the platform or the department numbers people; empty for none.
        name: of the person, as the platform writes it; empty for none.
        joined: whether the words of the name stand without anything between them.
        late: whether the platform says that it came late, by its own deadline.
    """

    identifier: str
    name: str
    joined: bool
    late: bool = False

    def stands_for(self, *full_names: str) -> bool:
        """Tell whether the number is that of a person with one of these names.

        It is where the name beside it is one of them, or hidden; else it may be that of a team.
        """
        is_hidden = _NOBODY.fullmatch(self.name.casefold()) is not None
        return is_hidden or any(self.is_named(name) for name in full_names)

    def is_named(self, full_name: str) -> bool:
        """Tell whether this is the name of a person, in any order and perhaps not the whole."""
        theirs = words_of(full_name)
        if self.joined:
            return _is_made_of(_unmarked(self.name), theirs)
        ours = set(words_of(self.name))
        return bool(ours and theirs) and (ours <= set(theirs) or ours >= set(theirs))


def platform_part(file: str) -> PlatformPart | None:
    """Find what a platform wrote into a path; the part nearest to the root counts."""
    path = PurePath(unicodedata.normalize("NFC", file))
    for part in path.parts:
        if found := _MOODLE.fullmatch(part):
            return PlatformPart(found["id"] or "", found["name"], joined=False)
    if found := _CANVAS.fullmatch(path.name):
        return PlatformPart(found["id"], found["name"], joined=True, late=bool(found["late"]))
    return None


def words_of(name: str) -> tuple[str, ...]:
    """Return the words of a name in one spelling, without signs that platforms drop."""
    return tuple(_WORD.findall(_unmarked(name)))[:_MOST_WORDS]


def _unmarked(name: str) -> str:
    return plain(name).replace("'", "")


def _is_made_of(text: str, words: Sequence[str]) -> bool:
    """Tell whether a text is some of these words one after the other."""
    return any(
        text == word or (text.startswith(word) and _is_made_of(text[len(word) :], rest))
        for number, word in enumerate(words)
        for rest in ((*words[:number], *words[number + 1 :]),)
    )
