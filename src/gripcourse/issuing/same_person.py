"""Who of the register a person on a list is, or may be: a second variant cannot be taken back."""

from collections.abc import Iterable
from typing import Final

from gripcourse.text.spelling import as_seen
from gripcourse.variants.model import Student
from gripcourse.variants.names import without_noughts

_FEWEST_WORDS: Final = 2  # of a name: a surname alone is many people's


def has_same_name(one: Student, other: Student) -> bool:
    """Tell whether two names look the same: sorts of apostrophes and alphabets do not count."""
    return as_seen(one.name) == as_seen(other.name)


def is_in_same_group(one: Student, other: Student) -> bool:
    """Tell whether two groups are one: offices write РТК-41, РТК 41 and РТК41."""
    return _letters(one.group) == _letters(other.group)


def has_same_address(one: Student, other: Student) -> bool:
    """Tell whether both have one mail address."""
    return bool(one.email) and as_seen(one.email) == as_seen(other.email)


def has_other_address(one: Student, other: Student) -> bool:
    """Tell whether each has a mail address of their own."""
    return bool(one.email and other.email) and not has_same_address(one, other)


def has_cut_id(student: Student, known: Student) -> bool:
    """Tell whether a spreadsheet program took the first noughts of a known student's id away."""
    is_cut = without_noughts(student.id) == without_noughts(known.id)
    is_same = has_same_name(student, known) or has_same_address(student, known)
    return is_cut and is_same


def who_may_be(student: Student, known: Iterable[Student]) -> Student | None:
    """Return who of some known students somebody new may be; None where nobody is like that.

    Args:
        student: who is new; without an id where the list has none.
        known: of the register, none of whom is anybody on the list.
    """
    return next((one for one in known if _may_be(student, one)), None)


def _may_be(student: Student, known: Student) -> bool:
    words, others = _words(student), _words(known)
    fewer = min(words, others, key=len)
    if is_in_same_group(student, known):
        # A platform knows no patronymics, and has the first name first.
        is_named_so = len(fewer) >= _FEWEST_WORDS and words | others in (words, others)
        return is_named_so or has_same_name(student, known)
    return not student.id and words == others and not has_other_address(student, known)


def _words(student: Student) -> frozenset[str]:
    return frozenset(as_seen(student.name).replace(",", " ").split())


def _letters(group: str) -> str:
    return "".join(filter(str.isalnum, as_seen(group)))
