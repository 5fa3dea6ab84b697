"""What is said of those who have handed nothing in."""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from typing import TYPE_CHECKING, Final

from gripcourse.text.shown import first_of, one_line
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.variants.model import Student

_NAMED: Final = 10


def missing_text(
    students: Sequence["Student"], handed_in: Collection[str], words: Words
) -> Iterator[str]:
    """Say who has handed nothing in; `grades.csv` has a row for each.

    Args:
        students: who has not.
        handed_in: the names of those who have: of namesakes the id says who is meant.
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
