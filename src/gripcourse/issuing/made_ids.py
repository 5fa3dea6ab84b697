"""Ids for students whose list has none: from the mail address, else from the name.

An id once given stays: who is known already by mail address, or by name and group, keeps it, also
where a later list has an id of its own or lost the noughts of the first. Nobody who may be known
gets a second variant before a person has said so.
"""

import re
import unicodedata
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Final

from gripcourse.issuing.asked_about import ADDED, IdColumn, Said, by_id, doubles, joined_doubles
from gripcourse.issuing.known_people import KnownPeople
from gripcourse.issuing.same_person import (
    has_cut_id,
    has_other_address,
    has_same_address,
    has_same_name,
    is_in_same_group,
    letters_of,
    may_be,
)
from gripcourse.text.words import Message, counted, message
from gripcourse.variants.model import Student

_NOT_OF_ID = re.compile(r"[^\w.-]+")
_NUMBER_BEHIND = re.compile(r"-\d+$")
_LONGEST = 48  # leaves room for a number behind it
_NAMED = 10  # ids that a note names


@dataclass(frozen=True, slots=True)
class Joined:
    """Persons who were listed under a second id, which was joined with theirs.

    Attributes:
        students: as they were listed then.
        ids: by each such id, that of the person.
    """

    students: Sequence[Student] = ()
    ids: Mapping[str, str] = field(default_factory=dict)

    def with_own_ids(self) -> tuple[Student, ...]:
        """Return them as they were listed, with the ids that they have."""
        return tuple(replace(one, id=self.ids[one.id]) for one in self.students)


NOBODY: Final = Joined()


def with_ids(
    students: Sequence[Student],
    known: Sequence[Student],
    joined: Joined = NOBODY,
    column_at: Callable[[int], IdColumn] = lambda _: ADDED,
) -> tuple[tuple[Student, ...], tuple[Message, ...], list[tuple[int, Said]]]:
    """Give everybody the id by which the register knows them, and one to each who has none.

    Args:
        students: of one list, names not empty.
        known: of earlier lists, each with an id.
        joined: which of these have been called otherwise.
        column_at: tells of a place in the list where an id is written there.

    Returns:
        The students in their order; notes where ids were made, or are others than the list's; by
        place in the list those whom nothing tells apart from another one, or of whom only a person
        can say whether the register knows them.
    """
    known = (*known, *joined.with_own_ids())
    register, listed = KnownPeople.of(known), KnownPeople.of(students)
    found = [joined.ids.get(one.id) or _known_id(one, register, listed) for one in students]
    kept_ids = {*found}
    again = [
        "" if id_ else _as_before(one, register, kept_ids) for one, id_ in _pairs(students, found)
    ]
    ids = [one or other for one, other in zip(found, again, strict=True)]
    without_id = [place for place, one in enumerate(students) if not one.id]
    problems = doubles(students, without_id, column_at)
    problems += joined_doubles(students, ids, joined.ids)
    problems += _doubtful(students, ids, known, column_at)
    taken = {one.id.casefold() for one in (*students, *known, *joined.students) if one.id}
    made: list[str] = []
    numbers: dict[str, int] = {}
    for place, student in enumerate(students):
        if not (ids[place] or student.id):
            ids[place] = _free(_wanted(student.name, student.email), taken, numbers)
            taken.add(ids[place].casefold())
            made.append(ids[place])
    groups = {letters_of(one.group): one.group for one in known if letters_of(one.group)}
    all_ = tuple(
        one if id_ == one.id else replace(one, id=id_ or one.id, group=_as_known(one.group, groups))
        for one, id_ in _pairs(students, ids)
    )
    kept = [(one.id, id_) for one, id_ in _pairs(students, ids) if one.id and id_ != one.id and id_]
    return all_, (*_kept_note(kept), *_note(made)), problems


def _as_known(group: str, known: Mapping[str, str]) -> str:
    """Return how the register writes a group: deadlines and figures go by it."""
    return known.get(letters_of(group), group)


def _pairs(students: Sequence[Student], ids: Sequence[str]) -> list[tuple[Student, str]]:
    return list(zip(students, ids, strict=True))


def _known_id(student: Student, known: KnownPeople, listed: KnownPeople) -> str:
    """Return the id of the one known student who this is; empty for nobody, or several.

    Who was listed without a group may have got one since, where the list has no namesake.
    """
    if student.id:
        return student.id if student.id in known.ids else ""
    alone = len(listed.namesakes(student)) == 1
    same = known.with_address_of(student) or [
        one
        for one in known.namesakes(student)
        if (is_in_same_group(one, student) or (alone and not one.group))
        and not has_other_address(one, student)
    ]
    return _only_id(same)


def _only_id(same: Iterable[Student]) -> str:
    """Return the id of one person, who may be known under two names; empty for nobody, or two."""
    ids = {one.id for one in same}
    return ids.pop() if len(ids) == 1 else ""


def _as_before(student: Student, known: KnownPeople, listed: Collection[str]) -> str:
    """Return the id that somebody had before the list said another; empty for nobody's.

    Either its noughts were cut off, or there was none and it was made.
    """
    if not student.id:
        return ""
    same = [
        one
        for one in known.namesakes_or_with_address_of(student)
        if one.id not in listed
        and (has_cut_id(student, one) or (_is_made(one) and _is_same(student, one)))
    ]
    return _only_id(same)


def _is_same(student: Student, known: Student) -> bool:
    is_named_so = has_same_name(student, known) and is_in_same_group(student, known)
    is_one = is_named_so and not has_other_address(student, known)
    return is_one or has_same_address(student, known)


def _may_be(student: Student, known: Student) -> bool:
    return may_be(student, known, is_told_by_id=bool(student.id) and not _is_made(known))


def _is_made(student: Student) -> bool:
    """Tell whether an id was made here: an office's means more."""
    wanted = {_wanted(student.name, student.email), _wanted(student.name, "")}
    return student.id in wanted or _NUMBER_BEHIND.sub("", student.id) in wanted


def _doubtful(
    students: Sequence[Student],
    ids: Sequence[str],
    known: Iterable[Student],
    column_at: Callable[[int], IdColumn],
) -> list[tuple[int, Said]]:
    """Return those new ones who may be known: who changed group, address or the way of writing."""
    listed = {*ids}
    absent = [one for one in known if one.id not in listed]
    found: list[tuple[int, Said]] = []
    for place, student in enumerate(students):
        candidates = () if ids[place] else absent
        same = next((one for one in candidates if _may_be(student, one)), None)
        if same is not None:
            group = f", {same.group}" if same.group else ""
            what = message(
                "'{name}' may be '{known}' ({id}{group}), who has a variant and is not in this"
                " list.",
                name=student.name,
                known=same.name,
                id=same.id,
                group=group,
            )
            found.append((place, (what, by_id(same.id, column_at(place)))))
    return found


def _wanted(name: str, email: str) -> str:
    source = email.partition("@")[0] or "-".join(name.split())
    made = _NOT_OF_ID.sub("-", unicodedata.normalize("NFC", source).casefold())
    return made[:_LONGEST].strip("-.") or "student"


def _free(wanted: str, taken: set[str], numbers: dict[str, int]) -> str:
    """Return an id that nobody has; up to the number of the last one that was wanted all are."""
    number = numbers.get(wanted, 1)
    id_ = wanted if number == 1 else f"{wanted}-{number}"
    while id_ in taken:
        number += 1
        id_ = f"{wanted}-{number}"
    numbers[wanted] = number
    return id_


def _kept_note(kept: Sequence[tuple[str, str]]) -> tuple[Message, ...]:
    if not kept:
        return ()
    pairs = [f"{written} → {id_}" for written, id_ in kept[:_NAMED]]
    said = message(
        "Who is in the register already keeps the id there, although the list has another:"
        " {pairs}.",
        pairs=", ".join(pairs) + (", …" if len(kept) > _NAMED else ""),
    )
    return (said,)


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
