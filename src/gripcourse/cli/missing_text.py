"""What is said of those who have handed nothing in."""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING, Final

from gripcourse.grading.platforms import platform_part
from gripcourse.text.shown import first_of, one_line
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.variants.model import Student

_NAMED: Final = 10


def missing_text(
    students: Sequence["Student"],
    handed_in: Collection[str],
    not_looked_at: Sequence[str],
    words: Words,
) -> Iterator[str]:
    """Say who has handed nothing in; `grades.csv` has a row for each.

    Args:
        students: who has not.
        handed_in: the names of those who have: of namesakes the id says who is meant.
        not_looked_at: files that may be somebody's work; a platform wrote whose into their paths.
        words: the reader's language.
    """
    if students:
        bearers = Counter(one.name for one in students)
        shared = {name for name, count in bearers.items() if count > 1 or name in handed_in} - {""}
        called = [
            f"{one_line(one.name)} ({one.id})"
            if one.name in shared
            else one_line(one.name) or one.id
            for one in students
        ]
        said = message(
            "Nothing handed in ({count}): {names}.",
            count=len(students),
            names=first_of(called, _NAMED),
        )
        yield words.say(said)
        parts = [part for one in not_looked_at if (part := platform_part(one)) is not None]
        theirs = [
            name
            for one, name in zip(students, called, strict=True)
            if any(part.is_named(one.name) for part in parts)
        ]
        if theirs:
            said = message(
                "Of these, a file that was not looked at may be the work of: {names}.",
                names=first_of(theirs, _NAMED),
            )
            yield words.say(said)
