"""The search for variants of one scheme: candidates of all its combinations judged together."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import compress
from typing import TYPE_CHECKING, Final, TypeAlias

import numpy as np

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.solver.family import Family, Rows, families_of
from gripcourse.solver.solve import Evaluation
from gripcourse.text.words import Message, message
from gripcourse.variants.constraint import Constraint
from gripcourse.variants.explain import in_short
from gripcourse.variants.feasible import Array, Feasibility, Mask, judge
from gripcourse.variants.space import Space
from gripcourse.variants.tally import Refusal, by_count, summed

if TYPE_CHECKING:
    from scipy.stats import qmc

    from gripcourse.variants.cases import SpaceCase


CHUNK = 1 << 14  # candidates in one evaluation: the fastest size for numpy
MOST_TRIED = 1 << 18  # candidates of one combination before giving up
_FEWEST, _FIRST_ROUND = 32, 256  # candidates of one combination; powers of two, as Sobol wants
_WIDE_CHOICE = 2048  # the same where some are preferred to others

TOO_NEAR: Final = message("too near to another variant")
"""Why a candidate is set aside that nothing speaks against but what was drawn before."""


@dataclass(frozen=True, slots=True)
class Batch:
    """Feasible candidates of one scheme, in the order in which they would be accepted.

    Attributes:
        family: the candidates, the infeasible left out; k of them.
        given: values in declared units, arrays of shape (k,), NaN where a candidate has none.
        evaluation: their values, SI, shape (k,).
        cases: number of the combination of each, shape (k,), ascending.
        wanted: how many variants each combination still lacks.
    """

    family: Family
    given: Mapping[str, Array]
    evaluation: Evaluation
    cases: Rows
    wanted: Mapping[int, int]


@dataclass(frozen=True, slots=True)
class Sifted:
    """What a further condition let through.

    Attributes:
        keep: which candidates of a batch, shape (k,).
        refusals: why others were set aside.
    """

    keep: Mask
    refusals: tuple[Refusal, ...]


Filter: TypeAlias = Callable[[Batch], Sifted]
"""A further condition on candidates: for example that they are far enough apart.

It is asked batch by batch and in order, with the numbers that are still wanted, so that it may stop
there and remember exactly what it let through.
"""


@dataclass(slots=True)
class _Reasons:
    """How often candidates were refused, by what is said of it; one count for each combination."""

    size: int
    said: dict[str, Message] = field(default_factory=dict)
    counts: dict[str, Rows] = field(default_factory=dict)

    def add(self, what: Message, cases: Rows) -> None:
        """Count candidates of these combinations."""
        key = str(what)
        self.said.setdefault(key, what)
        counts = self.counts.setdefault(key, np.zeros(self.size, dtype=np.intp))
        counts += np.bincount(cases, minlength=self.size)

    def of(self, case: int | None) -> tuple[Refusal, ...]:
        """Return the refusals of one combination, or of all together."""
        return by_count(
            Refusal(self.said[key], int(counts.sum() if case is None else counts[case]))
            for key, counts in self.counts.items()
        )


class Search:
    """The search for variants of one space; it remembers what it found."""

    def __init__(
        self,
        course: Course,
        space: Space,
        further: Filter | None,
        rng: np.random.Generator,
        *,
        evenly: bool = True,
    ) -> None:
        """Begin.

        Args:
            course: whose scheme it is.
            space: what is drawn from.
            further: a further condition on feasible candidates.
            rng: scrambles the sequence of points.
            evenly: whether there is such a sequence; else chance alone puts them.
        """
        self._course, self._space, self._further = course, space, further
        self._points = _Points(rng, evenly=evenly)
        self._cases: dict[int, SpaceCase] = {}
        self._reasons = _Reasons(len(space.cases))
        self.rows: list[dict[tuple[float, ...], Mapping[str, float]]] = [
            {} for _ in range(len(space.cases))
        ]
        self.set_aside: tuple[Refusal, ...] = ()
        self.tried = np.zeros(len(space.cases), dtype=np.intp)
        self.sound = 0

    def find(self, wanted: Mapping[int, int], most: int = MOST_TRIED) -> dict[int, int]:
        """Try candidates until each combination has so many more, or so many were tried.

        Args:
            wanted: how many more variants, by number of the combination.
            most: candidates of a combination before giving up.

        Returns:
            How many each combination still lacks; those that lack none are left out.
        """
        goal = {case: len(self.rows[case]) + count for case, count in wanted.items() if count}
        limit = {case: int(self.tried[case]) + most for case in goal}
        for case in goal:
            self._cases.setdefault(case, self._space.cases[case])
        self._points.begin(id_ for case in goal for id_ in self._cases[case].given)
        size = 0
        while lacking := self._lacking(goal):
            open_cases = [case for case in lacking if self.tried[case] < limit[case]]
            if not open_cases:
                break
            size = min(2 * size, CHUNK) or _first_round(
                lacking, has_choice=self._further is not None
            )
            together = max(CHUNK // size, 1)
            for start in range(0, len(open_cases), together):
                cases = open_cases[start : start + together]
                self._round(cases, size, {case: lacking[case] for case in cases})
        return self._lacking(goal)

    def refusals(self, case: int | None = None) -> tuple[Refusal, ...]:
        """Return why candidates were refused, of one combination or of all."""
        return self._reasons.of(case)

    def easiest(self) -> list[int]:
        """Return the combinations of which anything was found, by the candidates that it took."""
        found = [case for case, rows in enumerate(self.rows) if rows]
        return sorted(found, key=lambda case: self.tried[case] / len(self.rows[case]))

    def _lacking(self, goal: Mapping[int, int]) -> dict[int, int]:
        short = {case: count - len(self.rows[case]) for case, count in goal.items()}
        return {case: count for case, count in short.items() if count > 0}

    def _round(self, cases: Sequence[int], size: int, wanted: Mapping[int, int]) -> None:
        """Judge so many candidates of each of some combinations."""
        given, numbers = self._candidates(cases, size)
        self.tried[list(cases)] += size
        compositions = [
            Composition.of(self._space.scheme, self._space.cases.combinations[case])
            for case in cases
        ]
        constraints = {id(one): one for case in cases for one in self._cases[case].constraints}
        found = families_of(self._course, [compositions[at] for at in numbers])
        for rows, family in found:
            own = {id_: values[rows] for id_, values in given.items()}
            self._judge(family, own, np.asarray(cases)[numbers[rows]], wanted,
                        tuple(constraints.values()))  # fmt: skip

    def _judge(
        self,
        family: Family,
        given: Mapping[str, Array],
        cases: Rows,
        wanted: Mapping[int, int],
        constraints: Sequence[Constraint],
    ) -> None:
        feasibility = judge(family, given, constraints)
        said: dict[str, tuple[Message, Mask]] = {}
        for reason, where in feasibility.refused.items():
            what = in_short(family.plan(int(np.argmax(where))), reason)
            _, so_far = said.get(str(what), (what, np.zeros_like(where)))
            said[str(what)] = what, so_far | where  # two constraints may have one title
        for what, where in said.values():
            self._reasons.add(what, cases[where])
        batch = _batch(family, given, feasibility, cases, wanted)
        self.sound += len(batch.cases)
        keep = np.ones(len(batch.cases), dtype=np.bool_)
        if self._further is not None:
            sifted = self._further(batch)
            keep = sifted.keep
            self.set_aside = summed((*self.set_aside, *sifted.refusals))
        ids = list(batch.given)
        table = np.array([batch.given[id_] for id_ in ids]).reshape(len(ids), len(keep))
        left, doubles = dict(wanted), []
        for place in np.flatnonzero(keep):
            case = int(batch.cases[place])
            if not left[case]:
                continue
            there = ~np.isnan(table[:, place])
            key = tuple(table[there, place].tolist())
            if key in self.rows[case]:
                doubles.append(case)
                continue
            self.rows[case][key] = dict(zip(compress(ids, there), key, strict=True))
            left[case] -= 1
        self.sound -= len(doubles)
        if doubles:
            told = message("the same numbers as another variant")
            self._reasons.add(told, np.array(doubles, dtype=np.intp))

    def _candidates(self, cases: Sequence[int], size: int) -> tuple[dict[str, Array], Rows]:
        """Return given values of so many candidates of each combination, and whose they are."""
        count = len(cases) * size
        given: dict[str, Array] = {}
        for number, place in enumerate(cases):
            case = self._cases[place]
            at = slice(number * size, (number + 1) * size)
            points = self._points.next(size)
            for id_, values in case.given.items():
                allowed = np.asarray(values)
                column = points(id_)
                own = given.setdefault(id_, np.full(count, np.nan))
                own[at] = allowed[(column * len(allowed)).astype(np.intp)]
            for id_, follower in case.followers.items():
                led = [follower.values[value] for value in given[follower.leader][at]]
                given.setdefault(id_, np.full(count, np.nan))[at] = led
        return given, np.repeat(np.arange(len(cases)), size)


class _Points:
    """Points of the unit cube, one coordinate for each given, evenly spread over a scheme."""

    def __init__(self, rng: np.random.Generator, *, evenly: bool) -> None:
        self._rng, self._evenly = rng, evenly
        self._columns: dict[str, int] = {}
        self._sequence: qmc.Sobol | None = None

    def begin(self, ids: Iterable[str]) -> None:
        """Name the givens that have a coordinate of the sequence; later ones are left to chance."""
        if self._evenly and self._sequence is None:
            from scipy.stats import qmc  # noqa: PLC0415 - costs 700 ms, only drawing pays

            self._columns = {id_: at for at, id_ in enumerate(dict.fromkeys(ids))}
            dimensions = max(len(self._columns), 1)
            self._sequence = qmc.Sobol(dimensions, scramble=True, rng=self._rng)

    def next(self, size: int) -> Callable[[str], Array]:
        """Return the coordinate of the next points, by given; shape (size,), from 0 below 1."""
        if self._sequence is None:
            return lambda _id: self._rng.random(size)
        points = self._sequence.random(size)

        def coordinate(id_: str) -> Array:
            at = self._columns.get(id_)
            return self._rng.random(size) if at is None else points[:, at]

        return coordinate


def _first_round(lacking: Mapping[int, int], *, has_choice: bool) -> int:
    """Return how many candidates of each combination to begin with: many where few are searched.

    Args:
        lacking: how many variants each combination lacks.
        has_choice: whether a further condition prefers some candidates to others.
    """
    share = CHUNK // (2 * len(lacking))
    even = 1 << max(share.bit_length() - 1, 0)
    if has_choice:
        return min(max(2 * _FEWEST, even), _WIDE_CHOICE)
    wanted = 1 << max(2 * max(lacking.values()) - 1, 1).bit_length()
    return min(max(_FEWEST, min(even, _FIRST_ROUND), wanted), CHUNK)


def _batch(
    family: Family,
    given: Mapping[str, Array],
    feasibility: Feasibility,
    cases: Rows,
    wanted: Mapping[int, int],
) -> Batch:
    positions = np.flatnonzero(feasibility.feasible)

    def some(values: Mapping[str, Array]) -> dict[str, Array]:
        return {id_: one[positions] for id_, one in values.items()}

    evaluation = feasibility.evaluation
    return Batch(
        family.restricted(positions),
        some(given),
        Evaluation(some(evaluation.values), some(evaluation.computed)),
        cases[positions],
        wanted,
    )
