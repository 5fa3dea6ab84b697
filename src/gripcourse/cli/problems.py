"""Problems in the words of the command line: its options, and the command that mends them."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import reduce
from typing import Final

from gripcourse.errors import NextStep, Problem
from gripcourse.text.words import Message, Words, counted, message

# Parameters of the library that are called otherwise here; all others are called alike.
_OPTIONS: Final[Mapping[str, str]] = {
    "given": "--set",
    "lines": "--line",
    "quantities": "--quantity",
}
# What has no name on the command line but a place; called as its help calls it.
_PLACES: Final[Mapping[str, str]] = {"graded": "folder", "quantity": "item", "student": "student"}

TYPED: Final[Mapping[NextStep, str]] = {
    NextStep.ALLOW_LOWER: "--allow-lower",
    NextStep.CHECK_MACHINE: "gripcourse doctor",
    NextStep.GRADE: "gripcourse grade",
    NextStep.LEAVE_WITHDRAWAL: "--withdraw",
    NextStep.MAKE_COURSE: "gripcourse init",
    NextStep.NAME_COURSE: "--course",
    NextStep.NAME_GRADEBOOK: "--gradebook",
    NextStep.NAME_TABLE: "--table",
    NextStep.OVERRULE: "--override --comment",
    NextStep.REGRADE: "gripcourse regrade",
    NextStep.RENEW: "gripcourse renew",
    NextStep.SET_VALUES: "--set name=value",
    NextStep.SIMULATE: "gripcourse simulate",
}
"""What is typed for each step that the library can only name."""


_ONE_CAUSE: Final = 3  # places of which the same is said
_KEYS: Final = 4  # that are named of those that one sentence is about
_MOST: Final = 100  # that are said; whoever has more has one mistake many times


def said_of(problems: Sequence[Problem], words: Words) -> Iterator[str]:
    """Put problems into words, and say how many more there are than anybody reads."""
    merged = list(_merged(problems))
    yield from (spoken(one, words) for one in merged[:_MOST])
    if len(merged) > _MOST:
        left = len(merged) - _MOST
        more = counted("And {count} more problem. Correct these first.",
                       "And {count} more problems. Correct these first.", left)  # fmt: skip
        yield words.say(more)


def _merged(problems: Iterable[Problem]) -> Iterator[Problem]:
    """Say once what is said of several places; excerpts tell two places apart, and stay.

    What is said with the same names of three places and more, in whatever files, has one cause: a
    section, a constant or a unit that is called otherwise now. Where else is told in a line.
    """
    alike: dict[object, list[Problem]] = {}
    for one in problems:
        named = (str(one.what), one.parameter) if one.what.values else id(one)
        alike.setdefault(named, []).append(one)
    told: list[Problem] = []
    for group in alike.values():
        told += [_told_once(group)] if len(_places(group)) >= _ONE_CAUSE else group
    yield from _merged_in_files(told)


def _told_once(group: Sequence[Problem]) -> Problem:
    """Tell the first place as always, the others by their names, and the commonest remedy."""
    first, *others = _places(group)
    more = counted("And in {count} more place: {places}.",
                   "And in {count} more places: {places}.", len(others),
                   places=_keys(_named_once([first, *others])[1:]))  # fmt: skip
    remedies = Counter(str(one.remedy) for one in group)
    remedy = max((one.remedy for one in group), key=lambda one: remedies[str(one)])
    what = message("{what} {more}", what=group[0].what, more=more)
    return replace(group[0], what=what, remedy=remedy)


def _places(group: Iterable[Problem]) -> list[tuple[str, str | Message]]:
    """Return the places of problems, each once: a file and a key."""
    named = {(one.file, str(one.key)): one.key for one in group if one.file and one.key}
    return [(file, key) for (file, _), key in named.items()]


def _named_once(places: Sequence[tuple[str, str | Message]]) -> list[str | Message]:
    """Name places, the file of each only where it is another than that of the place before."""
    before = ("", *(file for file, _ in places))
    return [
        key if file == last else message("{left}: {right}", left=file, right=key)
        for last, (file, key) in zip(before, places, strict=False)
    ]


def _merged_in_files(problems: Iterable[Problem]) -> Iterator[Problem]:
    """Say once what is said of several keys of a file."""
    alike: dict[object, list[Problem]] = {}
    for one in problems:
        said = (one.file, one.parameter, str(one.what), str(one.remedy), one.step)
        alike.setdefault(said if one.key and not one.excerpt else (said, id(one)), []).append(one)
    for first, *others in alike.values():
        keys = list({str(one.key): one.key for one in (first, *others)}.values())
        yield replace(first, key=_keys(keys)) if others else first


def _keys(keys: Sequence[str | Message]) -> str | Message:
    named = reduce(_joined, keys[:_KEYS])
    more = len(keys) - _KEYS
    if more <= 0:
        return named
    return message("{keys} and {count} more", keys=named, count=more)


def _joined(left: str | Message, right: str | Message) -> str | Message:
    return message("{left}; {right}", left=left, right=right)


def spoken(problem: Problem, words: Words) -> str:
    """Put a problem into words for somebody who sits at the command line."""
    option = _OPTIONS.get(problem.parameter, f"--{problem.parameter.replace('_', '-')}")
    if problem.parameter in _PLACES:
        option = f"<{words.declared(_PLACES[problem.parameter])}>"
    remedy = problem.remedy
    if problem.step is not None:
        remedy = message(
            "{remedy} On the command line: {typed}.", remedy=remedy, typed=TYPED[problem.step]
        )
    named = replace(problem, parameter=option if problem.parameter else "", remedy=remedy)
    return named.say(words)
