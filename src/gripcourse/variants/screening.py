"""What a drawn variant must satisfy besides being solvable: the rules that an audit measures."""

from collections.abc import Iterable

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.policy.model import Policy
from gripcourse.text.words import message
from gripcourse.variants.accepted import Accepted
from gripcourse.variants.answers import group_of, items_of
from gripcourse.variants.apart import limits_of
from gripcourse.variants.draw import Batch, Filter, Sifted
from gripcourse.variants.fair import near_steps
from gripcourse.variants.feasible import Mask
from gripcourse.variants.slip_distance import too_near
from gripcourse.variants.tally import Refusal


def sifter(policy: Policy, sections: int) -> Filter:
    """Make the filter of one drawing; it remembers what it let through.

    Args:
        policy: the rules for variants.
        sections: how many sections the course has.
    """
    accepted = Accepted(limits_of(policy), sections)

    def sift(batch: Batch, wanted: int) -> Sifted:
        count = len(batch.positions)
        group = group_of(batch.plan, batch.feasibility, batch.positions, np.arange(count))
        slips = _any(too_near(group, policy).values(), count)
        edges = _any(near_steps(group, policy.variants.step_margin).values(), count) & ~slips
        answers = accepted.answers(items_of((group,), policy, Kind.FORMULA), count)
        keep, alike = np.zeros((2, count), dtype=np.bool_)
        seen = np.ones(count, dtype=np.bool_)
        for place in np.flatnonzero(~slips & ~edges):
            if keep.sum() >= wanted:
                seen[place:] = False
                break
            keep[place] = accepted.take(answers, int(place))
            alike[place] = not keep[place]
        refusals = (
            Refusal(message("too near to another variant"), int(alike.sum())),
            Refusal(message("a slip gives nearly the right result"), int((slips & seen).sum())),
            Refusal(message("a size lies at the edge of its step"), int((edges & seen).sum())),
        )
        return Sifted(keep, refusals)

    return sift


def _any(masks: Iterable[Mask], count: int) -> Mask:
    found = np.zeros(count, dtype=np.bool_)
    for mask in masks:
        found |= mask
    return found
