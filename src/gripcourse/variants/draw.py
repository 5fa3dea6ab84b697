"""Drawing variants: a seeded low-discrepancy sequence over the spaces, refusing the unsolvable.

Candidates are tried in rounds of growing size, each solved in one evaluation. The same course,
spaces, count and seed give the same variants.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gripcourse.course.model import Course
from gripcourse.errors import Problem, TableError
from gripcourse.text.words import message
from gripcourse.variants.counts import counts_of
from gripcourse.variants.explain import list_text
from gripcourse.variants.model import Variant
from gripcourse.variants.search import TOO_NEAR, Filter, Search
from gripcourse.variants.space import Space
from gripcourse.variants.tally import Tally, by_count

_STAND_INS = 16  # combinations that may stand in for another
_FEW_TRIED = 1 << 12  # candidates of each of them
_REASONS_TOLD = 3


@dataclass(frozen=True, slots=True)
class Drawn:
    """Variants and how they were found."""

    variants: tuple[Variant, ...]
    tallies: tuple[Tally, ...]


@dataclass(frozen=True, slots=True)
class DrawingOrder:
    """What is to be drawn from one space.

    Attributes:
        scheme: id of the space's scheme.
        wanted: how many variants of each combination of options, by its number.
        seed: of everything that chance decides there.
        evenly: whether candidates are spread evenly, or left to chance alone.
    """

    scheme: str
    wanted: Mapping[int, int]
    seed: np.random.SeedSequence
    evenly: bool = True


@dataclass(frozen=True, slots=True)
class Found:
    """What was drawn from one space.

    Attributes:
        scheme: id of its scheme.
        rows: options and given numbers of each variant, combination by combination.
        tally: how it went; None where nothing was wanted.
    """

    scheme: str
    rows: tuple[tuple[Mapping[str, str], Mapping[str, float]], ...]
    tally: Tally | None


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
    ordered = zip(spaces, orders_of(spaces, count, seed), strict=True)
    found = (draw_space(course, space, order, further) for space, order in ordered)
    return mixed(tuple(found), count, seed)


def orders_of(spaces: Sequence[Space], count: int, seed: int) -> tuple[DrawingOrder, ...]:
    """Share variants out among spaces; see `draw`."""
    *own, _, sharing = _seeds(len(spaces), seed)
    counts = iter(counts_of(spaces, count, np.random.default_rng(sharing)))
    return tuple(
        DrawingOrder(space.scheme, {case: next(counts) for case in range(len(space.cases))}, one)
        for space, one in zip(spaces, own, strict=True)
    )


def draw_space(course: Course, space: Space, order: DrawingOrder, further: Filter | None) -> Found:
    """Draw the variants of one space; see `draw`."""
    rng = np.random.default_rng(order.seed)
    search = Search(course, space, further, rng, evenly=order.evenly)
    lacking = search.find(order.wanted)
    if lacking:
        _make_up(space, search, order.wanted, lacking, rng if further is not None else None)
    rows = tuple(
        (options, given)
        for options, found in zip(space.cases.combinations, search.rows, strict=True)
        for given in found.values()
    )
    if not search.tried.any():  # a share too small for a single variant is not searched for
        return Found(space.scheme, rows, None)
    tally = Tally(space.scheme, int(search.tried.sum()), search.sound, search.refusals(),
                  by_count(search.set_aside))  # fmt: skip
    return Found(space.scheme, rows, tally)


def nothing_left(course: Course, spaces: Sequence[Space]) -> Iterator[Problem]:
    """Yield which spaces leave nothing to draw, with what refuses how many candidates.

    Each is tried with its first and its last combination of options, with as many candidates as a
    drawing tries. Chance alone finds what is left: the even sequence takes longer to import.
    """
    for space in spaces:
        ends = {0, len(space.cases) - 1} if len(space.cases) else set()
        seed = np.random.SeedSequence(0)
        order = DrawingOrder(space.scheme, dict.fromkeys(ends, 1), seed, evenly=False)
        try:
            draw_space(course, space, order, None)
        except TableError as error:
            yield from error.problems


def mixed(found: Sequence[Found], count: int, seed: int) -> Drawn:
    """Mix and name what was drawn from spaces, in their order; see `draw`."""
    rows = [(one.scheme, *row) for one in found for row in one.rows]
    mixing = np.random.default_rng(_seeds(len(found), seed)[-2])
    order = mixing.permutation(len(rows)) if len(rows) > 1 else range(len(rows))
    width = max(3, len(str(count)))
    variants = tuple(
        Variant(f"{number:0{width}d}", *rows[position])
        for number, position in enumerate(order, start=1)
    )
    return Drawn(variants, tuple(one.tally for one in found if one.tally is not None))


def _seeds(spaces: int, seed: int) -> list[np.random.SeedSequence]:
    """Return a seed for each space, the one of mixing and the one of sharing out."""
    return np.random.SeedSequence(seed).spawn(spaces + 2)


def _make_up(
    space: Space,
    search: Search,
    wanted: Mapping[int, int],
    lacking: Mapping[int, int],
    rng: np.random.Generator | None,
) -> None:
    """Draw what combinations of options lack from others of their scheme.

    Variants that must stay apart may leave no room for one more with just these options. Options
    that cannot be solved at all are another matter: without a further condition nothing is made up.

    Args:
        space: what is drawn from.
        search: what was found in it.
        wanted: how many variants of each combination were wanted.
        lacking: how many of these are lacking.
        rng: chooses the others; None without a further condition.

    Raises:
        TableError: the others have no room either.
    """
    for case, missing in lacking.items():
        still = missing
        for other in () if rng is None else _stand_ins(search, len(space.cases), case, rng):
            still = sum(search.find({other: still}, _FEW_TRIED).values())
            if not still:
                break
        if still:
            alike = _count_too_near(search)
            if alike:
                raise _no_room(space, search, alike, sum(wanted.values()))
            raise _too_few(space, search, case, wanted[case])


def _stand_ins(search: Search, cases: int, case: int, rng: np.random.Generator) -> Iterator[int]:
    """Yield combinations that may stand in for one: some by chance, then those easily found."""
    others = [one for one in range(cases) if one != case]
    yield from map(int, rng.permutation(others)[:_STAND_INS])
    yield from [one for one in search.easiest() if one != case][:_STAND_INS]


def _count_too_near(search: Search) -> int:
    """Return how many candidates nothing but a variant that was drawn before spoke against."""
    return sum(one.count for one in search.set_aside if one.what == TOO_NEAR)


def _no_room(space: Space, search: Search, alike: int, wanted: int) -> TableError:
    found = sum(map(len, search.rows))
    return TableError([Problem(
        space.file,
        "",
        message(
            "Of '{scheme}' {wanted} variants are wanted, and after {found} there is no room for"
            " another: {alike} more were good in themselves, and each too near to one of these.",
            scheme=space.scheme, wanted=wanted, found=found, alike=alike,
        ),
        message(
            "Draw fewer of one scheme, let them share more in the policy (shared_points,"
            " shared_section_points), or do not keep them apart."
        ),
    )])  # fmt: skip


def _too_few(space: Space, search: Search, case: int, wanted: int) -> TableError:
    common = [
        message("{what}: {count}", what=one.what, count=one.count)
        for one in by_count((*search.refusals(case), *search.set_aside))[:_REASONS_TOLD]
    ]
    return TableError([Problem(
        space.file,
        "",
        message(
            "Of {tried} tried variants of '{scheme}' only {sound} can be handed out, {wanted} are"
            " wanted. Most often: {reasons}.",
            tried=int(search.tried[case]), scheme=space.scheme, sound=len(search.rows[case]),
            wanted=wanted, reasons=list_text(common) if common else "—",
        ),
        message("Widen or move the ranges of these quantities, or loosen the constraints."),
    )])  # fmt: skip
