"""Which choices of the options of a scheme go together: all combinations, or any two once."""

from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import combinations, product
from typing import TypeAlias

from gripcourse.course.model import Scheme
from gripcourse.course.option_rule import OptionRule

_Pair: TypeAlias = tuple[tuple[int, int], tuple[int, int]]
"""Two choices, each as the places of its option and of itself."""


def broken_rules(
    rules: Iterable[OptionRule], options: Mapping[str, str]
) -> Iterator[tuple[OptionRule, str]]:
    """Yield the rules that choices break, each with the option whose choice it forbids."""
    for rule in rules:
        option = rule.broken_by(options)
        if option:
            yield rule, option


def option_sets(scheme: Scheme) -> Iterator[dict[str, str]]:
    """Yield every combination of options of a scheme that its rules allow."""
    ids = [option.id for option in scheme.options]
    rules = scheme.rules
    for chosen in product(*(option.choices for option in scheme.options)):
        options = dict(zip(ids, (choice.id for choice in chosen), strict=True))
        if not any(rule.broken_by(options) for rule in rules):
            yield options


def pair_option_sets(scheme: Scheme) -> Iterator[dict[str, str]]:
    """Yield combinations of options in which any two choices that go together occur together.

    They are few where all combinations are thousands. What three options do to each other only is
    not seen in them.
    """
    for options in _covering(_Mixed.of(scheme)):
        yield dict(options)


@dataclass(frozen=True, slots=True)
class _Mixed:
    """A scheme that is equal to another when its options can be combined in the same ways."""

    scheme: Scheme = field(compare=False)
    choices: tuple[object, ...]
    rules: tuple[object, ...]

    @staticmethod
    def of(scheme: Scheme) -> "_Mixed":
        choices = ((one.id, *(choice.id for choice in one.choices)) for one in scheme.options)
        rules = ((*rule.when.items(), None, *rule.requires.items()) for rule in scheme.rules)
        return _Mixed(scheme, tuple(choices), tuple(rules))


# Whoever checks a course asks seven times, and once for every declared proof.
@lru_cache(maxsize=128)
def _covering(mixed: _Mixed) -> tuple[Mapping[str, str], ...]:
    cover = _Cover(mixed.scheme)
    open_pairs = cover.pairs()
    if not open_pairs:
        return tuple(option_sets(mixed.scheme))
    found = []
    while open_pairs:
        first = min(open_pairs)
        row = cover.completed(dict(first), open_pairs)
        open_pairs -= {first} if row is None else _met(row, open_pairs)
        if row is not None:
            found.append(cover.options(row))
    return tuple(found)


class _Cover:
    """The options of a scheme by place, to cover pairs of their choices with allowed rows."""

    def __init__(self, scheme: Scheme) -> None:
        self._names = [option.id for option in scheme.options]
        self._choices = [[choice.id for choice in option.choices] for option in scheme.options]
        self._rules = scheme.rules

    def pairs(self) -> set[_Pair]:
        """Return every pair of choices of two options, whether they go together or not."""
        sizes = [range(len(choices)) for choices in self._choices]
        return {
            ((one, first), (other, second))
            for one, other in combinations(range(len(sizes)), 2)
            for first in sizes[one]
            for second in sizes[other]
        }

    def options(self, row: Mapping[int, int]) -> dict[str, str]:
        """Return the choices of a row by their ids, in the order of the options."""
        return {self._names[at]: self._choices[at][choice] for at, choice in sorted(row.items())}

    def completed(
        self, row: Mapping[int, int], open_pairs: AbstractSet[_Pair]
    ) -> dict[int, int] | None:
        """Complete a row so that it covers many open pairs; None where the rules leave no way."""
        if self._is_broken(row):
            return None
        missing = next((at for at in range(len(self._choices)) if at not in row), None)
        if missing is None:
            return dict(row)
        rows = [{**row, missing: choice} for choice in range(len(self._choices[missing]))]
        rows.sort(key=lambda one: -len(_met(one, open_pairs)))
        found = (self.completed(one, open_pairs) for one in rows)
        return next((one for one in found if one is not None), None)

    def _is_broken(self, row: Mapping[int, int]) -> bool:
        return bool(self._rules) and any(broken_rules(self._rules, self.options(row)))


def _met(row: Mapping[int, int], open_pairs: AbstractSet[_Pair]) -> AbstractSet[_Pair]:
    """Return the open pairs of choices that occur in a row."""
    return open_pairs & set(combinations(sorted(row.items()), 2))
