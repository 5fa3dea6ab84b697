"""Ids for students whose list has none: from the mail address, else from the name.

An id once given stays: who is known already by mail address, or by name and group, keeps it.
"""

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TypeAlias

from gripcourse.text.spelling import plain
from gripcourse.text.words import Message, counted, message
from gripcourse.variants.model import Student

_NOT_OF_ID = re.compile(r"[^\w.-]+")
_LONGEST = 48  # leaves room for a number behind it

Said: TypeAlias = tuple[Message, Message]
"""What is wrong, and the remedy."""


def with_ids(
    students: Sequence[Student], known: Sequence[Student]
) -> tuple[tuple[Student, ...], tuple[Message, ...], list[tuple[int, Said]]]:
    """Give an id to each student who has none.

    Args:
        students: of one list, names not empty.
        known: of earlier lists, each with an id.

    Returns:
        The students in their order; a note where ids were made; by place in the list those whom
        nothing tells apart from another one.
    """
    nameless = [place for place, one in enumerate(students) if not one.id]
    if not nameless:
        return tuple(students), (), []
    doubles = _doubles(students, nameless)
    taken = {one.id.casefold() for one in (*students, *known) if one.id}
    found = list(students)
    made: list[str] = []
    for place in nameless:
        student = students[place]
        id_ = _known_id(student, known, students) or ""
        if not id_:
            id_ = _free(_wanted(student), taken)
            taken.add(id_.casefold())
            made.append(id_)
        found[place] = replace(student, id=id_)
    return tuple(found), _note(made), doubles


def _known_id(student: Student, known: Iterable[Student], listed: Iterable[Student]) -> str | None:
    """Return the id of the one known student who this is; None for nobody, or several.

    Who was listed without a group may have got one since, where the list has no namesake.
    """
    alone = sum(_same(one.name, student.name) for one in listed) == 1
    same = [one for one in known if student.email and _same(one.email, student.email)]
    same = same or [
        one
        for one in known
        if _same(one.name, student.name)
        and (_same(one.group, student.group) or (alone and not one.group))
        and not (one.email and student.email)
    ]
    return same[0].id if len(same) == 1 else None


def _doubles(students: Sequence[Student], nameless: Sequence[int]) -> list[tuple[int, Said]]:
    """Return those without ids who cannot be told from somebody above them."""
    seen: set[tuple[str, ...]] = set()
    found: list[tuple[int, Said]] = []
    for place in nameless:
        student = students[place]
        key = (
            (plain(student.email),)
            if student.email
            else (plain(student.name), plain(student.group))
        )
        if key in seen:
            what = (
                message("Somebody above '{name}' has the mail address {email} already.",
                        name=student.name, email=student.email)
                if student.email
                else message("'{name}' is in the list already, and no id tells both apart.",
                             name=student.name)
            )  # fmt: skip
            remedy = message("Give both an id or a mail address of their own.")
            found.append((place, (what, remedy)))
        seen.add(key)
    return found


def _wanted(student: Student) -> str:
    source = student.email.partition("@")[0] or "-".join(student.name.split())
    made = _NOT_OF_ID.sub("-", unicodedata.normalize("NFC", source).casefold())
    return made[:_LONGEST].strip("-.") or "student"


def _free(wanted: str, taken: set[str]) -> str:
    number = 1
    id_ = wanted
    while id_ in taken:
        number += 1
        id_ = f"{wanted}-{number}"
    return id_


def _note(made: Sequence[str]) -> tuple[Message, ...]:
    if not made:
        return ()
    said = counted(
        "The list has no id for {count} student; it was made of the mail address or the name and"
        " is kept from now on: {first}.",
        "The list has no ids for {count} students; they were made of mail addresses or names and"
        " are kept from now on, {first} for example.",
        len(made),
        first=made[0],
    )
    return (said,)


def _same(one: str, other: str) -> bool:
    return plain(one) == plain(other)
