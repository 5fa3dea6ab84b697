"""What is said of a pattern of paths that tells nothing, and of one that would tell something."""

from collections.abc import Callable, Collection, Iterator, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, Final

from gripcourse.text.shown import one_line
from gripcourse.text.words import Words, counted, message

if TYPE_CHECKING:
    from gripcourse.grading.model import Report
    from gripcourse.variants.model import Student

LOOKED_AT: Final = 20  # files of nobody in which names are looked for
_WHERE_NAMES_STAND: Final[dict[str, Callable[[PurePath], str]]] = {
    "{name}.xlsx": lambda path: path.stem,
    "{name}/*": lambda path: path.parent.name,
}
"""Patterns by what they say, each with the part of a path in which it looks for a name."""


def without_fit(pattern: str, reports: Sequence["Report"], words: Words) -> Iterator[str]:
    """Say that a pattern fits none of the files, with the path of one of them to compare.

    Args:
        pattern: that fits none; empty for none such.
        reports: of the files.
        words: the reader's language.
    """
    if not pattern or not reports:
        return
    said = message(
        "The pattern '{pattern}' fits no path here, so it does not say whose any file is. One of"
        " the paths is {path}.",
        pattern=one_line(pattern),
        path=one_line(reports[0].file),
    )
    yield words.say(said)


def for_names(files: Collection[str], missing: Sequence["Student"], words: Words) -> Iterator[str]:
    """Say which pattern tells whose files are that bear names of students, and nothing else does.

    Args:
        files: that are nobody's so far, a few of them.
        missing: students who have handed nothing in.
        words: the reader's language.
    """
    from gripcourse.grading.platforms import PlatformPart  # noqa: PLC0415 (not for --help)

    paths = [PurePath(one) for one in files]
    for pattern, part_of in _WHERE_NAMES_STAND.items():
        parts = [PlatformPart("", part_of(path), joined=False) for path in paths]
        named = sum(any(part.is_named(one.name) for one in missing) for part in parts)
        if named:
            said = counted(
                "The path of {count} of these files bears the name of a student: --pattern"
                " '{pattern}' says that such names count.",
                "The paths of {count} of these files bear names of students: --pattern '{pattern}'"
                " says that such names count.",
                named,
                pattern=pattern,
            )
            yield words.say(said)
            return
