"""Rows of a list of which only a person can say whose they are, and where to write the answer."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from gripcourse.text.spelling import as_seen
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Student

Said: TypeAlias = tuple[Message, Message]
"""What is wrong, and the remedy."""


@dataclass(frozen=True, slots=True)
class IdColumn:
    """Under which heading a list has the ids of students, or would have them.

    Attributes:
        heading: as the list writes it; where it has none, as it may be called there.
        is_there: whether the list has it.
    """

    heading: str = "id"
    is_there: bool = False


ADDED: Final = IdColumn()


def by_id(id_: str, column: IdColumn) -> Message:
    """Say how a list tells whether a row is somebody whom the register knows."""
    if column.is_there:
        return message(
            "The same person: write the id {id} into the row, in the column '{column}'. Somebody"
            " else: write both into the list, each with an id there.",
            id=id_,
            column=column.heading,
        )
    return message(
        "The same person: add a column '{column}' to the list and write the id {id} into the row."
        " Somebody else: write both into the list, each with an id in that column.",
        id=id_,
        column=column.heading,
    )


def joined_doubles(
    students: Sequence[Student], ids: Sequence[str], joined: Mapping[str, str]
) -> list[tuple[int, Said]]:
    """Return rows of somebody who is in the list already, under an id that was joined with it."""
    names = {id_: former for former, id_ in joined.items()}
    first: dict[str, int] = {}
    found: list[tuple[int, Said]] = []
    for place, id_ in enumerate(ids):
        if id_ in names and first.setdefault(id_, place) != place:
            what = message(
                "'{name}' is in the list already: {joined} was joined with {id}.",
                name=students[place].name,
                joined=names[id_],
                id=id_,
            )
            remedy = message("Leave one of the two rows, or take the joining back.")
            found.append((place, (what, remedy)))
    return found


def doubles(
    students: Sequence[Student], nameless: Sequence[int], column_at: Callable[[int], IdColumn]
) -> list[tuple[int, Said]]:
    """Return those without ids who cannot be told from somebody above them."""
    seen: set[tuple[str, ...]] = set()
    found: list[tuple[int, Said]] = []
    for place in nameless:
        student = students[place]
        key = (
            (as_seen(student.email),)
            if student.email
            else (as_seen(student.name), as_seen(student.group))
        )
        if key in seen:
            what = (
                message("Somebody above '{name}' has the mail address {email} already.",
                        name=student.name, email=student.email)
                if student.email
                else message("'{name}' is in the list already, and no id tells both apart.",
                             name=student.name)
            )  # fmt: skip
            remedy = message(
                "Give both a mail address of their own, or an id in a column '{column}'.",
                column=column_at(place).heading,
            )
            found.append((place, (what, remedy)))
        seen.add(key)
    return found
