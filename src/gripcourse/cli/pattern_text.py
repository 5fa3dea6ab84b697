"""What is said of a pattern of paths that tells nothing."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from gripcourse.text.shown import one_line
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.grading.model import Report


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
