"""Where an instructor's own order of folders says whose a file is: `{name}/{id}*.xlsx`."""

import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import PurePath
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.grading.platforms import PlatformPart
from gripcourse.text.words import message

_TOKEN: Final = re.compile(r"\{id\}|\{name\}|\*|\?")
_ANY: Final = {"*": "[^/]*", "?": "[^/]", "{name}": "(?P<name>[^/]+)"}
_WHOLE: Final = r"(?![^\W_])"  # no letter and no digit follows: s1 is not the beginning of s10


@dataclass(frozen=True, slots=True)
class PathPattern:
    """A pattern of paths; see `path_pattern`."""

    expression: re.Pattern[str]

    def part_of(self, file: str) -> PlatformPart | None:
        """Return whose a file is by its path; None where the path is of another form."""
        path = unicodedata.normalize("NFC", PurePath(file).as_posix())
        found = self.expression.fullmatch(path)
        if found is None:
            return None
        parts = found.groupdict("")
        return PlatformPart(parts.get("id", ""), parts.get("name", ""), joined=False)


def path_pattern(written: str, ids: Iterable[str]) -> PathPattern:
    """Read a pattern for the end of a path.

    Args:
        written: `{id}` stands for an id of the register, `{name}` for a folder or a part of a name
            with the student's name, `*` for anything within a name, `?` for one sign.
        ids: of the register.

    Raises:
        UsageError: it says nothing of a student, or says it twice.
    """
    tokens = _TOKEN.findall(written)
    rest = _TOKEN.sub("", written)
    named = [one for one in tokens if one.startswith("{")]
    if not named or len(set(named)) != len(named) or set("{}") & set(rest):
        what = message("'{text}' does not say where a student's id or name stands.", text=written)
        remedy = message("Write {id} or {name}, each once, for example {example}.",
                         id="{id}", name="{name}", example="{name}/{id}*.xlsx")  # fmt: skip
        raise UsageError([Problem("", "", what, remedy, parameter="pattern")])
    longest_first = sorted(map(re.escape, ids), key=len, reverse=True)
    known = f"(?P<id>{'|'.join(longest_first) or '(?!)'}){_WHOLE}"
    literals = [re.escape(one) for one in _TOKEN.split(unicodedata.normalize("NFC", written))]
    expressions = [known if one == "{id}" else _ANY[one] for one in tokens]
    joined = "".join(one + two for one, two in zip(literals, [*expressions, ""], strict=True))
    return PathPattern(re.compile(f"(?:.*/)?{joined}", re.DOTALL))
