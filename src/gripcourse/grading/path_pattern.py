"""Where an instructor's own order of folders says whose a file is: `{name}/{id}*.xlsx`.

Students choose names of files, so no name may cost time: a part of a path is compared from its end,
each sign once for each piece of the pattern, and nothing is ever tried again.
"""

import re
import unicodedata
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import PurePath
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.grading.platforms import PlatformPart
from gripcourse.text.words import message

_ID: Final = "{id}"
_NAME: Final = "{name}"
_ANY: Final = "*"
_ONE: Final = "?"
_PIECE: Final = re.compile(r"\{id\}|\{name\}|\*|\?|[^{}*?]+")


@dataclass(frozen=True, slots=True)
class PathPattern:
    """A pattern of paths; see `path_pattern`.

    Attributes:
        written: as the instructor wrote it.
        parts: pieces of each part between strokes: signs that stand for something, and plain text.
        ids: of the register, by themselves as they are and in small letters: systems of files
            differ in whether capitals count, and no list has two ids that differ in them alone.
    """

    written: str
    parts: tuple[tuple[str, ...], ...]
    ids: Mapping[str, str]

    def part_of(self, file: str) -> PlatformPart | None:
        """Return whose a file is by its path; None where the path is of another form."""
        path = unicodedata.normalize("NFC", PurePath(file).as_posix()).split("/")
        if len(path) < len(self.parts):
            return None
        found: dict[str, str] = {}
        for pieces, part in zip(self.parts, path[-len(self.parts) :], strict=True):
            told = self._told(pieces, part)
            if told is None:
                return None
            found |= told
        return PlatformPart(found.get(_ID, ""), found.get(_NAME, ""), joined=False)

    def _told(self, pieces: tuple[str, ...], part: str) -> Mapping[str, str] | None:
        """Return what stands for id and name where a part of a path is of a form; else None.

        What may be of any length is as long as can be, the first before the others.
        """
        # Where in the part each piece may begin, so that all that follows fits, to the end.
        begins = [{len(part)}]
        for piece in reversed(pieces):
            after = begins[0]
            begins.insert(0, {at for at in range(len(part) + 1) if self._end(piece, part, at, after)
                              is not None})  # fmt: skip
        if 0 not in begins[0]:
            return None
        at, told = 0, {}
        for piece, after in zip(pieces, begins[1:], strict=True):
            end = self._end(piece, part, at, after)
            if end is None:
                return None
            if piece in {_ID, _NAME}:
                told[piece] = part[at:end]
            at = end
        if _ID in told:
            told[_ID] = self._id_of(told[_ID])
        return told

    def _end(self, piece: str, part: str, at: int, after: set[int]) -> int | None:
        """Return where a piece that begins somewhere ends last; None where it cannot."""
        if piece in {_ANY, _NAME}:
            least = at + (piece == _NAME)
            last = max(after, default=-1)
            return last if last >= least else None
        if piece == _ONE:
            return at + 1 if at + 1 in after else None
        if piece == _ID:
            return max((end for end in after if self._is_id(part, at, end)), default=None)
        end = at + len(piece)
        is_there = part[at:end].casefold() == piece.casefold()
        return end if end in after and is_there else None

    def _id_of(self, text: str) -> str:
        """Return an id as the register has it; empty for what is none."""
        return self.ids.get(text) or self.ids.get(text.casefold(), "")

    def _is_id(self, part: str, at: int, end: int) -> bool:
        """Tell whether an id stands there, wholly: s1 is not the beginning of s10."""
        return bool(self._id_of(part[at:end])) and not (end < len(part) and part[end].isalnum())


def path_pattern(written: str, ids: Iterable[str]) -> PathPattern:
    """Read a pattern for the end of a path.

    Args:
        written: `{id}` stands for an id of the register, `{name}` for a folder or a part of a name
            with the student's name, `*` for anything within a name, `?` for one sign.
        ids: of the register.

    Raises:
        UsageError: it says nothing of a student, or says it twice.
    """
    pieces = _PIECE.findall(written)
    named = [one for one in pieces if one in {_ID, _NAME}]
    if not named or len(set(named)) != len(named) or "".join(pieces) != written:
        what = message("'{text}' does not say where a student's id or name stands.", text=written)
        remedy = message("Write {id} or {name}, each once, for example {example}.",
                         id="{id}", name="{name}", example="{name}/{id}*.xlsx")  # fmt: skip
        raise UsageError([Problem("", "", what, remedy, parameter="pattern")])
    path = unicodedata.normalize("NFC", PurePath(written).as_posix())
    parts = tuple(tuple(_PIECE.findall(part)) for part in path.split("/"))
    known = tuple(ids)
    small = {one.casefold(): one for one in known}
    return PathPattern(written, parts, small | {one: one for one in known})


def fits_none(pattern: PathPattern | None, files: Iterable[str]) -> str:
    """Return a pattern as it was written where it fits none of the files; else nothing."""
    if pattern is None or any(pattern.part_of(file) is not None for file in files):
        return ""
    return pattern.written
