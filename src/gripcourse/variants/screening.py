"""What a drawn variant must satisfy besides being solvable: the rules that an audit measures."""

from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.policy.model import Policy
from gripcourse.solver.family import Rows
from gripcourse.text.words import message
from gripcourse.variants.accepted import Accepted
from gripcourse.variants.answers import Group, items_of
from gripcourse.variants.apart import limits_of
from gripcourse.variants.fair import near_steps
from gripcourse.variants.feasible import Mask
from gripcourse.variants.overlaps import Overlap, OverlapCheck, overlap_in_short, overlaps_of
from gripcourse.variants.search import Batch, Filter, Sifted
from gripcourse.variants.slip_distance import too_near
from gripcourse.variants.tally import Refusal, summed

_AT_ONCE = 4  # candidates of a combination that are looked at closely, for each that is wanted


def buildable(check: OverlapCheck) -> Filter:
    """Make the filter of a free drawing: whatever the rules, bodies do not stand in each other.

    Args:
        check: tells whether bodies stand in each other.
    """

    def sift(batch: Batch) -> Sifted:
        group = Group(batch.family, np.arange(len(batch.cases)), batch.evaluation.values, {})
        waiting = _by_case(batch, _first_of_each(batch, np.arange(len(batch.cases))))
        keep = np.zeros(len(batch.cases), dtype=np.bool_)
        lacking = dict(batch.wanted)
        overlaps: list[Overlap] = []
        # Few are refused: more candidates than are lacking are looked at only in the place of them.
        while looked_at := _next_of_each(waiting, lacking):
            refused = dict(overlaps_of(group, looked_at, check))
            overlaps += refused.values()
            for place in looked_at:
                keep[place] = place not in refused
                lacking[int(batch.cases[place])] -= int(keep[place])
        refusals = (Refusal(overlap_in_short(one), 1) for one in overlaps)
        return Sifted(keep, summed(refusals))

    return sift


def sifter(
    policy: Policy,
    sections: int,
    check: OverlapCheck | None = None,
    others: Sequence[Group] = (),
) -> Filter:
    """Make the filter of one drawing; it remembers what it let through.

    What costs most comes last, and only for as many candidates as may be needed.

    Args:
        policy: the rules for variants.
        sections: how many sections the course has.
        check: tells whether bodies stand in each other; None where nobody knows the bodies.
        others: variants of other tables, solved: what is drawn keeps as far from them as from
            each other, however near they are to one another.
    """
    accepted = Accepted(limits_of(policy), sections)
    for other in others:
        items = items_of((replace(other, rows=np.arange(other.family.size)),), policy, Kind.FORMULA)
        answers = accepted.answers(items, other.family.size)
        for place in range(other.family.size):
            accepted.add(answers, place)

    def sift(batch: Batch) -> Sifted:
        count = len(batch.cases)
        group = Group(batch.family, np.arange(count), batch.evaluation.values, {})
        slips = _any(too_near(group, policy).values(), count)
        edges = _any(near_steps(group, policy.variants.step_margin).values(), count) & ~slips
        open_ = _first_of_each(batch, np.flatnonzero(~slips & ~edges))
        overlaps = {} if check is None else dict(overlaps_of(group, open_, check))
        open_ = [place for place in open_ if place not in overlaps]
        close = group.restricted(np.array(open_, dtype=np.intp))
        answers = accepted.answers(items_of((close,), policy, Kind.FORMULA), len(open_))
        keep = np.zeros(count, dtype=np.bool_)
        wanted, alike = dict(batch.wanted), 0
        for number, place in enumerate(open_):
            case = int(batch.cases[place])
            if wanted[case]:
                keep[place] = accepted.take(answers, number)
                wanted[case] -= int(keep[place])
                alike += int(not keep[place])
        refusals = (
            Refusal(message("too near to another variant"), alike),
            Refusal(message("a slip gives nearly the right result"), int(slips.sum())),
            Refusal(message("a size lies at the edge of its step"), int(edges.sum())),
            *(Refusal(overlap_in_short(one), 1) for one in overlaps.values()),
        )
        return Sifted(keep, summed(refusals))

    return sift


def _first_of_each(batch: Batch, places: Rows) -> list[int]:
    """Return the first few candidates of each combination."""
    left = {case: _AT_ONCE * wanted for case, wanted in batch.wanted.items()}
    found = []
    for place in places:
        case = int(batch.cases[place])
        if left[case]:
            left[case] -= 1
            found.append(int(place))
    return found


def _by_case(batch: Batch, places: Sequence[int]) -> dict[int, deque[int]]:
    """Return places of a batch by combination, in order."""
    found: dict[int, deque[int]] = {}
    for place in places:
        found.setdefault(int(batch.cases[place]), deque()).append(place)
    return found


def _next_of_each(waiting: Mapping[int, deque[int]], lacking: Mapping[int, int]) -> list[int]:
    """Take as many places of each combination as it lacks, as far as there are any; ascending."""
    return sorted(
        places.popleft()
        for case, places in waiting.items()
        for _ in range(min(lacking[case], len(places)))
    )


def _any(masks: Iterable[Mask], count: int) -> Mask:
    found = np.zeros(count, dtype=np.bool_)
    for mask in masks:
        found |= mask
    return found
