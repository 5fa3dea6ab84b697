"""Drawing variants: a seeded low-discrepancy sequence over the spaces, refusing the unsolvable.

Candidates are tried in rounds of growing size, each solved in one evaluation. The same course,
spaces, count and seed give the same variants.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.errors import Problem, TableError
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.text.words import message
from gripcourse.variants.cases import SpaceCase
from gripcourse.variants.counts import counts_of
from gripcourse.variants.explain import in_short, list_text
from gripcourse.variants.feasible import Array, Feasibility, Mask, Reason, reasons_infeasible
from gripcourse.variants.model import Variant
from gripcourse.variants.space import Space
from gripcourse.variants.tally import Refusal, Tally, by_count, summed

_FIRST_ROUND = 256  # candidates; a power of two, as a Sobol sequence wants it
_CHUNK = 1 << 14  # candidates in one evaluation: the fastest size for numpy
_MOST_TRIED = 1 << 18  # candidates of one case before giving up
_STAND_INS = 16  # cases that may stand in for another
_FEW_TRIED = 1 << 12  # candidates of each of them
_REASONS_TOLD = 3


@dataclass(frozen=True, slots=True)
class Batch:
    """Feasible candidates of one case, in the order in which they would be accepted.

    Attributes:
        plan: of the scheme and its options.
        given: values in declared units, arrays of shape (n,).
        feasibility: of the candidates before the infeasible ones were left out.
        positions: where the candidates stand in `feasibility`, shape (n,).
    """

    plan: Plan
    given: Mapping[str, Array]
    feasibility: Feasibility
    positions: NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Sifted:
    """What a further condition let through.

    Attributes:
        keep: which candidates of a batch, shape (n,).
        refusals: why others were set aside.
    """

    keep: Mask
    refusals: tuple[Refusal, ...]


Filter: TypeAlias = Callable[[Batch, int], Sifted]
"""A further condition on candidates: for example that they are far enough apart.

It is asked batch by batch and in order, with the number that is still wanted, so that it may stop
there and remember exactly what it let through.
"""


@dataclass(frozen=True, slots=True)
class Drawn:
    """Variants and how they were found."""

    variants: tuple[Variant, ...]
    tallies: tuple[Tally, ...]


def draw(
    course: Course, spaces: Sequence[Space], count: int, seed: int, further: Filter | None = None
) -> Drawn:
    """Draw variants.

    Args:
        course: whose schemes are drawn.
        spaces: what is drawn from, each with its share.
        count: how many variants.
        seed: the same seed gives the same variants.
        further: a further condition on feasible candidates.

    Returns:
        The variants, named `001`, `002`, ..., schemes and options mixed, and the tallies.

    Raises:
        TableError: too few candidates can be solved; the main reasons are named.
    """
    search = [
        _Search(course, space, place, further)
        for space in spaces
        for place in range(len(space.cases))
    ]
    seeds = np.random.SeedSequence(seed).spawn(len(search) + 2)
    counts = counts_of(spaces, count, np.random.default_rng(seeds.pop()))
    found = [
        one.find(wanted, own) for one, wanted, own in zip(search, counts, seeds[:-1], strict=True)
    ]
    _make_up(search, counts, found, seeds)
    rows = [(one.space.scheme, one.options, row)
            for one, result in zip(search, found, strict=True) for row in result.rows]  # fmt: skip
    order = np.random.default_rng(seeds[-1]).permutation(len(rows)) if len(search) > 1 else None
    mixed = rows if order is None else [rows[position] for position in order]
    width = max(3, len(str(count)))
    variants = tuple(
        Variant(f"{number:0{width}d}", scheme, options, given)
        for number, (scheme, options, given) in enumerate(mixed, start=1)
    )
    return Drawn(variants, _tallies(search, found))


def _make_up(
    search: Sequence["_Search"],
    counts: Sequence[int],
    found: list["_Found"],
    seeds: Sequence[np.random.SeedSequence],
) -> None:
    """Draw what a combination of options lacks from others of its scheme.

    Variants that must stay apart may leave no room for one more with just these options. Options
    that cannot be solved at all are another matter: without a further condition nothing is made up.

    Raises:
        TableError: the others have no room either.
    """
    lacking = [wanted - len(own.rows) for wanted, own in zip(counts, found, strict=True)]
    for place, missing in enumerate(lacking):
        if not missing:
            continue
        one = search[place]
        others = [i for i, other in enumerate(search) if other.space is one.space and i != place]
        order = np.random.default_rng(seeds[place].spawn(1)[0]).permutation(others)
        still = missing
        for other in order[:_STAND_INS] if one.further is not None else ():
            more = search[other].find(still, seeds[other].spawn(1)[0], _FEW_TRIED)
            found[other] = found[other].joined(more)
            still -= len(more.rows)
            if not still:
                break
        if still:
            raise _too_few(one.space, counts[place], found[place])


@dataclass(frozen=True, slots=True)
class _Found:
    """What a search brought: accepted values, and counts of all that was tried."""

    rows: tuple[Mapping[str, float], ...]
    tried: int
    sound: int
    refusals: tuple[Refusal, ...]
    set_aside: tuple[Refusal, ...]

    def joined(self, more: "_Found") -> "_Found":
        """Add what a second search for the same combination brought."""
        return _Found(
            (*self.rows, *more.rows),
            self.tried + more.tried,
            self.sound + more.sound,
            by_count(summed((*self.refusals, *more.refusals))),
            summed((*self.set_aside, *more.set_aside)),
        )


@dataclass(frozen=True, slots=True)
class _Search:
    """The search for variants of one case."""

    course: Course
    space: Space
    place: int
    further: Filter | None

    @property
    def options(self) -> Mapping[str, str]:
        """The combination of options that is searched."""
        return self.space.cases.combinations[self.place]

    @property
    def case(self) -> SpaceCase:
        """What may be drawn for it."""
        return self.space.cases[self.place]

    def find(self, wanted: int, seed: np.random.SeedSequence, most: int = _MOST_TRIED) -> _Found:
        """Try candidates until enough are accepted, or so many were tried."""
        if not wanted:
            return _Found((), 0, 0, (), ())
        plan = plan_of(self.course, Composition.of(self.space.scheme, self.options))
        rows: dict[tuple[float, ...], Mapping[str, float]] = {}
        reasons: Counter[Reason] = Counter()
        set_aside: tuple[Refusal, ...] = ()
        doubles = feasible = tried = 0
        for drawn in self._candidates(wanted, np.random.default_rng(seed)):
            if len(rows) >= wanted or tried >= most:
                break
            given = {quantity.id: drawn[quantity.id] for quantity in plan.givens}
            feasibility = reasons_infeasible(plan, given, self.case.constraints)
            reasons.update({one: int(where.sum()) for one, where in feasibility.refused.items()})
            tried += len(feasibility.feasible)
            batch = _batch(plan, given, feasibility)
            feasible += len(batch.positions)
            keep = np.ones(len(batch.positions), dtype=np.bool_)
            if self.further is not None:
                sifted = self.further(batch, wanted - len(rows))
                keep = sifted.keep
                set_aside = summed((*set_aside, *sifted.refusals))
            for values in zip(*(values[keep] for values in batch.given.values()), strict=True):
                key = tuple(float(value) for value in values)
                doubles += key in rows
                rows.setdefault(key, dict(zip(batch.given, key, strict=True)))
        refusals = (
            *(Refusal(in_short(plan, one), number) for one, number in reasons.items()),
            Refusal(message("the same numbers as another variant"), doubles),
        )
        found = tuple(rows.values())[:wanted]
        return _Found(found, tried, feasible - doubles, by_count(refusals), set_aside)

    def _candidates(self, wanted: int, rng: np.random.Generator) -> Iterator[Mapping[str, Array]]:
        """Yield candidates in chunks, in declared units; round by round as many as before."""
        from scipy.stats import qmc  # noqa: PLC0415 - costs 700 ms, only drawing pays

        ids = list(self.case.given)
        sequence = qmc.Sobol(max(len(ids), 1), scramble=True, rng=rng)
        tried = 0
        while tried < _MOST_TRIED:
            size = max(tried, _FIRST_ROUND, 1 << max(2 * wanted - 1, 1).bit_length())
            points = sequence.random_base2(size.bit_length() - 1)
            tried += size
            for start in range(0, size, _CHUNK):
                yield self._values(ids, points[start : start + _CHUNK])

    def _values(self, ids: Sequence[str], points: Array) -> dict[str, Array]:
        """Turn points of the unit cube, shape (n, d), into allowed values."""
        given: dict[str, Array] = {}
        for place, id_ in enumerate(ids):
            allowed = np.asarray(self.case.given[id_])
            given[id_] = allowed[(points[:, place] * len(allowed)).astype(np.intp)]
        for id_, follower in self.case.followers.items():
            given[id_] = np.array([follower.values[value] for value in given[follower.leader]])
        return given


def _batch(plan: Plan, given: Mapping[str, Array], feasibility: Feasibility) -> Batch:
    positions = np.flatnonzero(feasibility.feasible)
    return Batch(
        plan, {id_: values[positions] for id_, values in given.items()}, feasibility, positions
    )


def _too_few(space: Space, wanted: int, found: _Found) -> TableError:
    common = [
        message("{what}: {count}", what=one.what, count=one.count)
        for one in by_count((*found.refusals, *found.set_aside))[:_REASONS_TOLD]
    ]
    return TableError([Problem(
        space.file,
        "",
        message(
            "Of {tried} tried variants of '{scheme}' only {sound} can be handed out, {wanted} are"
            " wanted. Most often: {reasons}.",
            tried=found.tried, scheme=space.scheme, sound=len(found.rows), wanted=wanted,
            reasons=list_text(common) if common else "—",
        ),
        message("Widen or move the ranges of these quantities, or loosen the constraints."),
    )])  # fmt: skip


def _tallies(search: Sequence[_Search], found: Sequence[_Found]) -> tuple[Tally, ...]:
    """Add the cases of each scheme up."""
    by_scheme: dict[str, list[_Found]] = {}
    for one, result in zip(search, found, strict=True):
        if result.tried:  # a share too small for a single variant is not searched for
            by_scheme.setdefault(one.space.scheme, []).append(result)
    return tuple(_tally(scheme, results) for scheme, results in by_scheme.items())


def _tally(scheme: str, results: Sequence[_Found]) -> Tally:
    return Tally(
        scheme,
        sum(result.tried for result in results),
        sum(result.sound for result in results),
        by_count(summed(refusal for result in results for refusal in result.refusals)),
        by_count(summed(refusal for result in results for refusal in result.set_aside)),
    )
