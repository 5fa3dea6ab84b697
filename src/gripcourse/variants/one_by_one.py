"""What an audit finds out about each variant by itself, scheme by scheme in several processes.

Slips and bodies are most of the work of an audit, and no scheme has to know another one for them.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from gripcourse.course.model import Course
from gripcourse.machine.jobs.workers import all_done, in_order, run_each
from gripcourse.policy.model import Policy
from gripcourse.variants.answers import solve_groups
from gripcourse.variants.model import Variant
from gripcourse.variants.overlaps import Overlap, OverlapCheck, overlaps_of
from gripcourse.variants.slip_distance import SlipCount, count_slips, summed_slips, too_near

COUNTED: Final = 64  # variants that slips of all kinds are counted in, evenly taken from a table
SECONDS: Final = 3600.0  # that a scheme may take: a limit for what hangs, not for large tables


@dataclass(frozen=True, slots=True)
class OneByOne:
    """What was found out about variants, each by itself.

    Attributes:
        slips: by position in the table, quantity and id of the slips that give nearly the right
            result; a variant without any is left out.
        overlaps: by position, the worst pair of bodies that stand in each other.
        counts: slips of all kinds, the most frequent first.
        counted: how many variants they were counted in.
    """

    slips: Mapping[int, tuple[tuple[str, str], ...]]
    overlaps: Mapping[int, Overlap]
    counts: tuple[SlipCount, ...]
    counted: int


@dataclass(frozen=True, slots=True)
class _Look:
    """Variants of one scheme, their positions in the table, and those whose slips are counted."""

    variants: tuple[Variant, ...]
    rows: tuple[int, ...]
    counted: tuple[Variant, ...]


@dataclass(frozen=True, slots=True)
class _Shared:
    """What every job needs; see `look_at_each`."""

    course: Course
    policy: Policy
    check: OverlapCheck | None


def look_at_each(
    course: Course,
    policy: Policy,
    variants: Sequence[Variant],
    check: OverlapCheck | None,
    workers: int,
) -> OneByOne:
    """Look at the variants of a table, each by itself.

    Args:
        course: whose variants they are.
        policy: the rules for variants, bands and slips.
        variants: the table.
        check: tells whether bodies stand in each other; None where nobody knows the bodies.
        workers: how many processes; 0 for none but this one. They change nothing of the result.
    """
    counted = _sample(len(variants))
    shared = _Shared(course, policy, check)
    jobs = run_each(_look, _jobs(variants, counted), shared, workers=workers, seconds=SECONDS)
    found = in_order(all_done(jobs))
    return OneByOne(
        slips={row: slips for one in found for row, slips in one.slips.items()},
        overlaps={row: overlap for one in found for row, overlap in one.overlaps.items()},
        counts=summed_slips(count for one in found for count in one.counts),
        counted=len(counted),
    )


def _jobs(variants: Sequence[Variant], counted: frozenset[int]) -> tuple[_Look, ...]:
    by_scheme: dict[str, list[int]] = {}
    for row, variant in enumerate(variants):
        by_scheme.setdefault(variant.scheme, []).append(row)
    return tuple(
        _Look(
            tuple(variants[row] for row in rows),
            tuple(rows),
            tuple(variants[row] for row in rows if row in counted),
        )
        for rows in by_scheme.values()
    )


def _sample(count: int) -> frozenset[int]:
    """Take positions at equal distances from a table that is larger than what is counted."""
    if count <= COUNTED:
        return frozenset(range(count))
    return frozenset(int(row) for row in np.linspace(0, count - 1, COUNTED))


def _look(job: _Look, shared: _Shared) -> OneByOne:
    slips: dict[int, list[tuple[str, str]]] = {}
    overlaps: dict[int, Overlap] = {}
    for group in solve_groups(shared.course, job.variants):
        rows = [job.rows[place] for place in group.rows]
        for key, near in too_near(group, shared.policy).items():
            for place in np.flatnonzero(near):
                slips.setdefault(rows[place], []).append(key)
        if shared.check is not None:
            found = overlaps_of(group, range(group.family.size), shared.check)
            overlaps |= {rows[place]: overlap for place, overlap in found}
    return OneByOne(
        {row: tuple(keys) for row, keys in slips.items()},
        overlaps,
        count_slips(solve_groups(shared.course, job.counted), shared.policy),
        len(job.counted),
    )
