"""What a drawn variant must satisfy besides being solvable: the rules that an audit measures."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gripcourse.course.quantity import Kind
from gripcourse.policy.model import Policy
from gripcourse.solver.family import Rows
from gripcourse.text.words import Message, message
from gripcourse.variants.accepted import Accepted
from gripcourse.variants.answers import Group, items_of
from gripcourse.variants.apart import limits_of
from gripcourse.variants.balance import Balance, Outcomes, choose, outcomes_of
from gripcourse.variants.fair import near_steps
from gripcourse.variants.feasible import Mask
from gripcourse.variants.overlaps import Overlap, OverlapCheck, overlap_in_short, overlaps_of
from gripcourse.variants.search import TOO_NEAR, Batch, Filter, Sifted
from gripcourse.variants.slip_distance import too_near
from gripcourse.variants.tally import Refusal, summed

_AT_ONCE = 8  # candidates of a combination that are looked at closely, for each that is wanted
_CHOICE = 256  # candidates of a combination that are compared


def buildable(check: OverlapCheck) -> Filter:
    """Make the filter of a free drawing: whatever the rules, bodies do not stand in each other.

    Args:
        check: tells whether bodies stand in each other.
    """
    balance = Balance()

    def sift(batch: Batch) -> Sifted:
        waiting = _Waiting.of(batch, np.arange(len(batch.cases)), balance)
        overlaps: list[Overlap] = []
        # Few are refused: more candidates than are lacking are looked at only in the place of them.
        while looked_at := waiting.next():
            refused = dict(overlaps_of(waiting.group, looked_at, check))
            overlaps += refused.values()
            for place in looked_at:
                waiting.decide(place, keep=place not in refused)
        refusals = (Refusal(overlap_in_short(one), 1) for one in overlaps)
        return Sifted(waiting.keep, summed(refusals))

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
    accepted, balance = Accepted(limits_of(policy), sections), Balance()
    for other in others:
        items = items_of((replace(other, rows=np.arange(other.family.size)),), policy, Kind.FORMULA)
        answers = accepted.answers(items, other.family.size)
        for place in range(other.family.size):
            accepted.add(answers, place)

    def sift(batch: Batch) -> Sifted:
        count = len(batch.cases)
        group = _group(batch)
        slips, edges = too_near(group, policy), near_steps(group, policy.variants.step_margin)
        left_out = _any((*slips.values(), *edges.values()), count)
        waiting = _Waiting.of(batch, np.flatnonzero(~left_out), balance)
        overlaps: list[Overlap] = []
        alike = 0
        while looked_at := waiting.next():
            refused = {} if check is None else dict(overlaps_of(group, looked_at, check))
            overlaps += refused.values()
            close = group.restricted(np.array(looked_at, dtype=np.intp))
            answers = accepted.answers(items_of((close,), policy, Kind.FORMULA), len(looked_at))
            for number, place in enumerate(looked_at):
                keep = place not in refused and accepted.take(answers, number)
                alike += int(place not in refused and not keep)
                waiting.decide(place, keep=keep)
        refusals = (
            Refusal(TOO_NEAR, alike),
            *_of_slips(group, slips),
            *_of_edges(group, edges),
            *(Refusal(overlap_in_short(one), 1) for one in overlaps),
        )
        return Sifted(waiting.keep, summed(refusals))

    return sift


@dataclass(slots=True)
class _Waiting:
    """Candidates of a batch that may be drawn, the best balanced first.

    Attributes:
        group: the batch, solved.
        outcomes: of its candidates.
        balance: of what was drawn before.
        cases: number of the combination of each candidate.
        places: candidates that were not looked at yet, by combination.
        lacking: how many of each combination are lacking.
        left: how many more of each combination are looked at.
        keep: which candidates are drawn.
    """

    group: Group
    outcomes: Outcomes
    balance: Balance
    cases: Rows
    places: dict[int, list[int]]
    lacking: dict[int, int]
    left: dict[int, int]
    keep: Mask

    @staticmethod
    def of(batch: Batch, places: Rows, balance: Balance) -> "_Waiting":
        """Let some candidates of a batch wait."""
        by_case: dict[int, list[int]] = {}
        group, wanted = _group(batch), dict(batch.wanted)
        for place in places:
            waiting = by_case.setdefault(int(batch.cases[place]), [])
            if len(waiting) < _CHOICE + _AT_ONCE * wanted[int(batch.cases[place])]:
                waiting.append(int(place))
        return _Waiting(
            group,
            outcomes_of(group),
            balance,
            batch.cases,
            by_case,
            wanted,
            {case: _AT_ONCE * count for case, count in wanted.items()},
            np.zeros(len(batch.cases), dtype=np.bool_),
        )

    def next(self) -> list[int]:
        """Take as many candidates of each combination as it lacks, as far as there are any."""
        scheme = self.group.family.scheme
        lacking = {case: min(count, self.left[case]) for case, count in self.lacking.items()}
        ahead = self.balance.of(scheme, self.outcomes)
        chosen = choose(self.outcomes, ahead, self.places, lacking)
        for place in chosen:
            case = int(self.cases[place])
            self.places[case].remove(place)
            self.left[case] -= 1
        return chosen

    def decide(self, place: int, *, keep: bool) -> None:
        """Draw a candidate, or refuse it."""
        if keep:
            self.keep[place] = True
            self.lacking[int(self.cases[place])] -= 1
            self.balance.count(self.group.family.scheme, self.outcomes, place)


def _group(batch: Batch) -> Group:
    return Group(batch.family, np.arange(len(batch.cases)), batch.evaluation.values, {})


def _of_slips(group: Group, found: Mapping[tuple[str, str], Mask]) -> Iterator[Refusal]:
    """Name each slip that candidates were refused for: one of them may have several."""
    for (id_, slip), near in found.items():
        what = message(
            "the slip '{slip}' gives nearly the right result: {quantity}",
            slip=slip,
            quantity=_named(group, id_),
        )
        yield Refusal(what, int(near.sum()))


def _of_edges(group: Group, found: Mapping[str, Mask]) -> Iterator[Refusal]:
    for id_, near in found.items():
        what = message(
            "the size lies at the edge of its step: {quantity}", quantity=_named(group, id_)
        )
        yield Refusal(what, int(near.sum()))


def _named(group: Group, id_: str) -> Message:
    title = next(one.quantity.title for one in group.family.answered if one.quantity.id == id_)
    return message("{title} ({id})", title=title, id=id_)


def _any(masks: Iterable[Mask], count: int) -> Mask:
    found = np.zeros(count, dtype=np.bool_)
    for mask in masks:
        found |= mask
    return found
