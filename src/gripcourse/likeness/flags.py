"""Evidence in words: flags for the instructor. A student's report shows no flags."""

from collections.abc import Callable, Iterable, Sequence
from typing import Final

from gripcourse.grading.model import Flag, FlagCode
from gripcourse.likeness.model import Evidence, NumberKind
from gripcourse.text.words import Message, Texts, message

_STUDENTS: Final = 5  # that one flag names
_QUANTITIES: Final = 6

# The title of a quantity of a student's variant, by the ids of both.
Titles = Callable[[str, str], Texts | str]
# Whose a row of issued values is, where the student's id alone does not say which version it is.
VersionNames = Callable[[int], Message | None]

_IN_WORDS: Final = (
    (1e12, message("more than a million million to one")),
    (1e9, message("more than a thousand million to one")),
    (1e6, message("more than a million to one")),
    (1e3, message("more than a thousand to one")),
    (1e2, message("more than a hundred to one")),
    (1e1, message("more than ten to one")),
    (2.0, message("better than two to one")),
)


def odds_in_words(odds: float) -> Message:
    """Say odds to one, rounded down to a power that people have a word for."""
    hardly = message("hardly better than even")
    return next((said for least, said in _IN_WORDS if odds >= least), hardly)


def unnamed(_: int) -> None:
    """Name no version: everybody was issued to once."""


def flag_of(evidence: Evidence, titles: Titles, versions: VersionNames = unnamed) -> Flag:
    """Return the flag of evidence, for the submission of its first student."""
    numbers = () if evidence.kind is NumberKind.SAME_CREATOR else evidence.rests_on
    return Flag(
        FlagCode(evidence.kind.value),
        _said(evidence, titles, versions),
        evidence.students[1:],
        rests_on=numbers,
    )


def flags_by_student(
    found: Iterable[Evidence], titles: Titles, versions: VersionNames = unnamed
) -> dict[str, tuple[Flag, ...]]:
    """Return the flags of each student's submission."""
    flags: dict[str, tuple[Flag, ...]] = {}
    for evidence in found:
        student = evidence.students[0]
        flag = flag_of(evidence, titles, versions)
        if flag not in flags.get(student, ()):
            flags[student] = (*flags.get(student, ()), flag)
    return flags


def _said(evidence: Evidence, titles: Titles, versions: VersionNames) -> Message:
    version = None if evidence.row is None else versions(evidence.row)
    others = _names_text(evidence.students[1:], _STUDENTS) if version is None else version
    first, numbers = evidence.students[0], evidence.kind is not NumberKind.SAME_CREATOR
    named = [titles(first, one) if numbers else one for one in evidence.rests_on]
    names = _names_text(named, _QUANTITIES, "; " if numbers else ", ")
    odds = odds_in_words(evidence.odds)
    if evidence.kind is NumberKind.OTHER_VARIANT:
        return message(
            "Numbers that the student's own variant does not explain are those of the variant of "
            "{others}: {odds}, all comparisons counted. This rests on: {names}. It is evidence, "
            "not a verdict.",
            others=others,
            odds=odds,
            names=names,
        )
    if evidence.kind is NumberKind.COPIED_FROM:
        return message(
            "This student's own numbers stand in the work of {others} too, whose variant does not "
            "explain them: {odds}, all comparisons counted. This rests on: {names}. The question "
            "goes to them, not to the owner.",
            others=others,
            odds=odds,
            names=names,
        )
    if evidence.kind is NumberKind.SAME_ANSWERS:
        return message(
            "Numbers that the student's own variant does not explain are the same in the work of "
            "{others}: {odds}, all comparisons counted. This rests on: {names}. It is evidence, "
            "not a verdict.",
            others=others,
            odds=odds,
            names=names,
        )
    return message(
        "The workbook names the author “{names}”, as that of {others} does and few others: {odds}. "
        "Students who share a computer share this name.",
        others=others,
        odds=odds,
        names=names,
    )


def _names_text(names: Sequence[Texts | str], most: int, between: str = ", ") -> Message:
    """Name the first of many; titles, which may have commas in them, want another sign."""
    places = {f"name_{number}": name for number, name in enumerate(names[:most])}
    named = Message(between.join(f"{{{place}}}" for place in places), places)
    if len(names) <= most:
        return message("{names}", names=named)
    return message("{names} and {count} more", names=named, count=len(names) - most)
