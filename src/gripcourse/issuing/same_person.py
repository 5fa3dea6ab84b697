"""Who of the register a person on a list is, or may be: a second variant cannot be taken back."""

from functools import lru_cache
from typing import Final

from gripcourse.text.spelling import as_seen, may_have_been
from gripcourse.variants.model import Student
from gripcourse.variants.names import without_leading_zeros

_FEWEST_WORDS: Final = 2  # of a name: a surname alone is many people's
_KEPT: Final = 1 << 13  # names: everybody on a list is compared with everybody who is not on it


def has_same_name(one: Student, other: Student) -> bool:
    """Tell whether two names look the same: sorts of apostrophes and alphabets do not count."""
    return as_seen(one.name) == as_seen(other.name)


def is_in_same_group(one: Student, other: Student) -> bool:
    """Tell whether two groups are one: offices write РТК-41, РТК 41 and РТК41."""
    return letters_of(one.group) == letters_of(other.group)


def has_same_address(one: Student, other: Student) -> bool:
    """Tell whether both have one mail address."""
    return bool(one.email) and as_seen(one.email) == as_seen(other.email)


def has_other_address(one: Student, other: Student) -> bool:
    """Tell whether each has a mail address of their own."""
    return bool(one.email and other.email) and not has_same_address(one, other)


def has_cut_id(student: Student, known: Student) -> bool:
    """Tell whether a spreadsheet program took the first noughts of a known student's id away."""
    is_cut = without_leading_zeros(student.id) == without_leading_zeros(known.id)
    is_same = has_same_name(student, known) or has_same_address(student, known)
    return is_cut and is_same


def may_be(student: Student, known: Student, *, is_told_by_id: bool) -> bool:
    """Tell whether somebody new on a list may be a known student who is not on it.

    Args:
        student: who is new.
        known: of the register.
        is_told_by_id: whether an office gave each an id of their own: in another group that is
            another person.
    """
    words, others = _words(student.name), _words(known.name)
    is_same = words == others or may_have_been(_seen(known.name), _seen(student.name))
    if is_in_same_group(student, known):
        # A platform knows no patronymics, and has the first name first.
        fewer = min(words, others, key=len)
        is_same = is_same or (len(fewer) >= _FEWEST_WORDS and words | others in (words, others))
        return is_same or (not is_told_by_id and _has_other_surname(student, known))
    return is_same and not is_told_by_id and not has_other_address(student, known)


@lru_cache(maxsize=_KEPT)
def _seen(name: str) -> str:
    return as_seen(name)


def _has_other_surname(one: Student, other: Student) -> bool:
    """Tell whether two names are the same but for the surname, as after a marriage."""
    pairs = [_seen(each.name).replace(",", " ").split() for each in (one, other)]
    (surname, *rest), (other_surname, *other_rest) = (names or [""] for names in pairs)
    return len(rest) >= _FEWEST_WORDS and rest == other_rest and surname != other_surname


@lru_cache(maxsize=_KEPT)
def _words(name: str) -> frozenset[str]:
    return frozenset(as_seen(name).replace(",", " ").split())


@lru_cache(maxsize=_KEPT)
def letters_of(group: str) -> str:
    """Return the letters and digits of a group, by which it is the same however it is written."""
    return "".join(filter(str.isalnum, as_seen(group)))
