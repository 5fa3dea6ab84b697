"""Who handed a file in: told by the signed workbook first, by its path second, else by a person.

A path tells only what a learning platform wrote by its one pattern, or a name that is a student's
id and nothing else. Words that happen to be an id (`Lab 1`, `report (2)`) tell nothing. Where
workbook and path disagree, or the workbook with itself, somebody handed in another's work or took
another's name: a person asks.
"""

import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import PurePath
from types import MappingProxyType
from typing import Final

from gripcourse.grading.known_by import KnownBy
from gripcourse.grading.made_for import is_signed_as, version_made_for, versions_of
from gripcourse.grading.path_pattern import PathPattern
from gripcourse.grading.platforms import PlatformPart, platform_part
from gripcourse.submission.model import Identity
from gripcourse.text.shown import first_of
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued, names_of

_NONE_EARLIER: Mapping[str, Sequence[Issued]] = MappingProxyType({})
_NONE_JOINED: Mapping[str, str] = MappingProxyType({})
_NONE_FORMER: Mapping[str, Sequence[str]] = MappingProxyType({})
_SHOWN: Final = 5  # namesakes


@dataclass(frozen=True, slots=True)
class HandedIn:
    """Whose file it is.

    Attributes:
        issued: the version that the student's workbook was made for; None where a person must
            say, or nobody can.
        known_by: what told it.
        doubt: why a person must say; None where there is no doubt, or nothing to go by.
    """

    issued: Issued | None
    known_by: KnownBy
    doubt: Message | None = None


_NOBODYS = HandedIn(None, KnownBy.NOTHING)


@dataclass(frozen=True, slots=True)
class _People:
    """Whom a path may name: entries, ids that were joined with others', and former names."""

    register: Mapping[str, Issued]
    joined: Mapping[str, str]
    former: Mapping[str, Sequence[str]]
    earlier: Mapping[str, Sequence[Issued]]

    def id_of(self, id_: str) -> str:
        """Return the id by which the register knows whom an id names."""
        return self.joined.get(id_, id_)

    def issued_to(self, id_: str) -> Issued:
        """Return what was issued last to whom an id names, under that id."""
        versions = versions_of(self.id_of(id_), self.register, self.earlier)
        return version_made_for(None, versions, id_)

    def names_of(self, entry: Issued) -> Iterator[str]:
        """Yield how a person is written, was before, and is under ids that were joined."""
        id_ = entry.student.id
        second = self.register[id_].joined if id_ in self.register else ()
        yield from (entry.student.name, *self.former.get(id_, ()), *(one.name for one in second))


def identify(  # noqa: PLR0913 (all that may tell it)
    file: str,
    identity: Identity | None,
    register: Mapping[str, Issued],
    pattern: PathPattern | None = None,
    earlier: Mapping[str, Sequence[Issued]] = _NONE_EARLIER,
    joined: Mapping[str, str] = _NONE_JOINED,
    *,
    former: Mapping[str, Sequence[str]] = _NONE_FORMER,
) -> HandedIn:
    """Tell who handed a file in, and which version of the assignment it was made for.

    Args:
        file: path of the file.
        identity: what the workbook says; None where it could not be read.
        register: entries by student id, whose signatures were verified with the course's key.
        pattern: of the instructor's own order of folders; None for none.
        earlier: versions before those of the register by student id, oldest first.
        joined: by id that was joined with another's, the id of the student.
        former: by student id, how the register wrote the person before: a platform may still.
    """
    people = _People(register, joined, former, earlier)
    stated = None if pattern is None else pattern.part_of(file)
    by_path = _by_path(file, stated, people)
    named = "" if identity is None else people.id_of(identity.student)
    if identity is not None and named in register:
        made_for = version_made_for(identity, versions_of(named, register, earlier))
        if is_signed_as(identity, made_for):
            if people.id_of(identity.other) in register:
                return _doubtful(_two_inside(identity))
            said = _contradiction(file, made_for, by_path, stated, people)
            return _doubtful(said) if said else HandedIn(made_for, KnownBy.SIGNATURE)
    if by_path.issued is None:
        return _doubtful(_unsigned(named)) if named in register else by_path
    path_says = by_path.issued.student.id
    if named not in {"", path_says}:
        return _doubtful(_two_names(named, path_says))
    versions = versions_of(path_says, register, earlier)
    made_for = version_made_for(identity, versions, by_path.issued.signed_for)
    return HandedIn(made_for, by_path.known_by)


def named_by_person(
    student: str,
    identity: Identity | None,
    register: Mapping[str, Issued],
    earlier: Mapping[str, Sequence[Issued]] = _NONE_EARLIER,
    named_as: str = "",
) -> HandedIn:
    """Take a person's word for who handed a file in; the student is on the register."""
    made_for = version_made_for(identity, versions_of(student, register, earlier), named_as)
    return HandedIn(made_for, KnownBy.PERSON)


def _by_path(file: str, stated: PlatformPart | None, people: _People) -> HandedIn:
    """Tell whose a path says it is; a platform's part of it leaves the rest nothing to say."""
    register = people.register
    if stated is not None:
        named = _of_pattern(stated, people)
        if len(named) > 1:
            return _doubtful(_several_of_name(stated.name, list(named)))
        entry = next(map(people.issued_to, named.values()), None)
        if entry is not None and (other := _other_by_name(stated, entry, people)):
            return _doubtful(_two_in_path(entry.student.id, other))
        return HandedIn(entry, KnownBy.PLATFORM if entry else KnownBy.NOTHING)
    part = platform_part(file)
    if part is not None:
        entry = _of_platform(part, people)
        return HandedIn(entry, KnownBy.PLATFORM if entry else KnownBy.NOTHING)
    path = PurePath(unicodedata.normalize("NFC", file))
    # Handouts are folders named after their students; a bare number may count anything.
    folder = path.parent.name if not path.parent.name.isdecimal() else ""
    called = [one for one in (path.stem, folder) if people.id_of(one) in register]
    told = dict.fromkeys(map(people.id_of, called))
    if len(told) > 1:
        return _doubtful(_two_in_path(*told))
    return HandedIn(people.issued_to(called[0]), KnownBy.FILE_NAME) if called else _NOBODYS


def _of_pattern(part: PlatformPart, people: _People) -> Mapping[str, str]:
    """Return whom an instructor's own pattern names; of several who share a name all.

    Returns:
        By the id of the person the one that is named, which may have been joined with it.
    """
    register, joined = people.register, people.joined
    if part.identifier:
        student = people.id_of(part.identifier)
        return {student: part.identifier} if student in register else {}
    second = (
        (student, person.id, person.name)
        for student in sorted(set(joined.values()) & register.keys())
        for person in register[student].joined
    )
    own = ((student, student, name) for student, name in names_of(register))
    # Who is called the same under both ids is named by the one that is kept.
    return {student: id_ for student, id_, name in chain(second, own) if part.is_named(name)}


def _of_platform(part: PlatformPart, people: _People) -> Issued | None:
    entry = people.register.get(people.id_of(part.identifier))
    if entry is None:
        return None
    # Platforms number people and attempts by themselves: such a number is a student's id only where
    # the name beside it is that student's.
    own_number = part.identifier.isdecimal() and not part.is_named(entry.student.name)
    return None if own_number else people.issued_to(part.identifier)


def _contradiction(
    file: str, signed: Issued, by_path: HandedIn, stated: PlatformPart | None, people: _People
) -> Message | None:
    """Say what speaks against the student of a signed workbook.

    Args:
        file: path of the file.
        signed: what the workbook is.
        by_path: whose the path says it is.
        stated: what an instructor's own pattern finds in the path; None for nothing.
        people: whom a path may name.
    """
    student = signed.student
    if by_path.issued is not None:
        told = by_path.issued.student.id
        return None if told == student.id else _two_names(student.id, told)
    if stated is not None and people.id_of(stated.identifier) == student.id:
        return None
    part = stated or platform_part(file)
    other = "" if part is None else _other_by_name(part, signed, people)
    return _two_names(student.id, other) if other else None


def _other_by_name(part: PlatformPart, entry: Issued, people: _People) -> str:
    """Return the id of another student whose name a path bears; empty where it is this one's.

    A platform may write a person as the register did before, or as under an id that was joined.
    """
    if any(part.is_named(name) for name in people.names_of(entry)):
        return ""
    known = names_of(people.register)
    return next((student for student, name in known if part.is_named(name)), "")


def _doubtful(said: Message) -> HandedIn:
    return HandedIn(None, KnownBy.NOTHING, said)


def _two_in_path(student: str, other: str) -> Message:
    return message(
        "Who handed this in? The names of the file and its folders say {student} and {other}. It"
        " was not graded and nobody's mark changes.",
        student=student,
        other=other,
    )


def _several_of_name(name: str, students: Sequence[str]) -> Message:
    return message(
        "Who handed this in? The name in the path, {name}, is that of {students}. It was not graded"
        " and nobody's mark changes.",
        name=name,
        students=first_of(students, _SHOWN),
    )


def _two_names(workbook: str, path: str) -> Message:
    return message(
        "Who handed this in? The workbook is that of {student}, the name of the file or folder says"
        " {other}. It was not graded and nobody's mark changes.",
        student=workbook,
        other=path,
    )


def _two_inside(identity: Identity) -> Message:
    return message(
        "Who handed this in? The hidden sheet of the workbook says {student}, its properties say"
        " {other}: somebody's identity was put into another's workbook. It was not graded and"
        " nobody's mark changes.",
        student=identity.student,
        other=identity.other,
    )


def _unsigned(student: str) -> Message:
    return message(
        "Who handed this in? The workbook names {student}, but without the signature that was"
        " issued, and nothing else says so. It was not graded and nobody's mark changes.",
        student=student,
    )
