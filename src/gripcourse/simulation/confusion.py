"""What was done against what was said: the confusion table, rates and every miss."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from gripcourse.grading.model import Finding, Report
from gripcourse.simulation.foreign.measures import ForeignEvaluation
from gripcourse.simulation.model import Action, ActionKind, Conduct, Mix, Required, SimulatedWork
from gripcourse.simulation.rates import Rate, added
from gripcourse.simulation.strategies import StrategyScore, missed


@dataclass(frozen=True, slots=True)
class JudgedWork:
    """What a student did, and what the grader says; the trace of a failure of ours, or nothing."""

    work: SimulatedWork
    report: Report
    incident: str = ""


class Said(StrEnum):
    """What the grader says of one answer."""

    CORRECT = "correct"
    CARRIED = "carried"
    NAMED = "named"  # a slip, the one that was made
    TIED = "tied"  # two slips, one of them the one that was made
    MISNAMED = "misnamed"  # a slip that was not made
    ROUGH = "rough"
    WRONG = "wrong"
    UNSUPPORTED = "unsupported"
    BLANK = "blank"
    UNREADABLE = "unreadable"
    NOT_JUDGED = "not_judged"


ACCEPTED = frozenset({Said.CORRECT, Said.CARRIED})
NAMES = frozenset({Said.NAMED, Said.TIED})


@dataclass(frozen=True, slots=True)
class AnswerVerdict:
    """One answer: what was done and what was said."""

    work: SimulatedWork
    action: Action
    finding: Finding
    said: Said


@dataclass(frozen=True, slots=True)
class GraderEvaluation:
    """How well the grader says what was done.

    Attributes:
        students: how many.
        table: answers by what was done and what was said.
        rates: what was measured; those that the policy holds the grader to come first.
        by_kind: share of the slips of each kind that were named.
        misses: answers that the grader says something wrong about, and the reason.
        tried, hidden: places that were tried for slips, and those whose effect nobody could see.
        incidents: traces of what failed on our side.
        strategies: what works earn that compute nothing; none where only files were graded.
        earned_at_most: that each may earn on average.
        foreign: the same of the second generator; None where only files were graded.
    """

    students: int
    table: Mapping[tuple[ActionKind, Said], int]
    rates: Mapping[str, Rate]
    by_kind: Mapping[str, Rate]
    misses: tuple[AnswerVerdict, ...]
    tried: int
    hidden: int
    incidents: tuple[str, ...]
    strategies: tuple[StrategyScore, ...]
    earned_at_most: float
    foreign: ForeignEvaluation | None = None

    def __add__(self, other: "GraderEvaluation") -> "GraderEvaluation":
        """Count two cohorts together."""
        both = [one for one in (self.foreign, other.foreign) if one is not None]
        return replace(
            self,
            students=self.students + other.students,
            table=Counter(self.table) + Counter(other.table),
            rates=added(self.rates, other.rates),
            by_kind=dict(sorted(added(self.by_kind, other.by_kind).items())),
            misses=(*self.misses, *other.misses),
            tried=self.tried + other.tried,
            hidden=self.hidden + other.hidden,
            incidents=(*self.incidents, *other.incidents),
            strategies=(*self.strategies, *other.strategies),
            foreign=both[0] + both[1] if len(both) > 1 else next(iter(both), None),
        )

    @property
    def missed(self) -> tuple[str, ...]:
        """Names of the required rates that are not reached."""
        paying = (one.strategy.value for one in missed(self.strategies, self.earned_at_most))
        foreign = () if self.foreign is None else self.foreign.missed
        own = (name for name, rate in self.rates.items() if not rate.reached)
        return (*own, *paying, *(f"foreign_{name}" for name in foreign))


def evaluate(
    judged: Sequence[JudgedWork], mix: Mix, strategies: Sequence[StrategyScore] = ()
) -> GraderEvaluation:
    """Set what was done against what was said.

    Args:
        judged: every student's work and report.
        mix: what the grader is held to, and which flags mean copying.
        strategies: what works earn that compute nothing.
    """
    verdicts = [one for each in judged for one in _verdicts(each)]
    return GraderEvaluation(
        students=len(judged),
        table=Counter((one.action.done, one.said) for one in verdicts),
        rates=dict(_rates(judged, verdicts, mix)),
        by_kind=_named_by_kind(verdicts),
        misses=tuple(one for one in verdicts if is_missed(one)),
        tried=sum(one.work.tried for one in judged),
        hidden=sum(one.work.hidden for one in judged),
        incidents=tuple(one.incident for one in judged if one.incident),
        strategies=tuple(strategies),
        earned_at_most=mix.required.strategy_earned,
    )


def is_missed(one: AnswerVerdict) -> bool:
    """Tell whether the grader says something wrong about an answer."""
    match one.action.done:
        case ActionKind.RIGHT | ActionKind.FOLLOWS:
            return one.said not in ACCEPTED
        case ActionKind.SLIP:
            return one.said not in NAMES
        case ActionKind.BARE_UNIT | ActionKind.WRONG_UNIT | ActionKind.ROUNDED_DOWN:
            return one.said in ACCEPTED
        case _:
            return False


def _is_joined(one: AnswerVerdict) -> bool:
    """Tell whether a wrong answer is not taken for right, but has cost with an earlier mistake.

    It is no number that is right or follows from what was typed: two mistakes of a work were taken
    for one that has cost already.
    """
    found, typed = one.finding, one.action.value
    if one.said is not Said.CARRIED or typed is None or not found.roots:
        return False
    if found.low is None or found.high is None:
        return True
    return abs(typed - min(max(typed, found.low), found.high)) > found.band


def _named_by_kind(verdicts: Iterable[AnswerVerdict]) -> dict[str, Rate]:
    kinds: dict[str, list[AnswerVerdict]] = defaultdict(list)
    for one in verdicts:
        if one.action.done is ActionKind.SLIP:
            kinds[one.action.kind].append(one)
    return {kind: _share(found, NAMES) for kind, found in sorted(kinds.items())}


def _verdicts(judged: JudgedWork) -> Iterator[AnswerVerdict]:
    """Yield a verdict per answer; another's workbook is judged as a whole."""
    findings = {one.quantity: one for one in judged.report.findings}
    for action in judged.work.actions:
        if judged.work.owner == judged.work.student and action.quantity in findings:
            finding = findings[action.quantity]
            yield AnswerVerdict(judged.work, action, finding, _said(action, finding))


def _said(action: Action, finding: Finding) -> Said:
    if not finding.outcome.traits.named:
        return Said(finding.outcome.value)
    names = {*action.twins} if action.slip is None else {action.slip, *action.twins}
    if finding.slip in names:
        return Said.NAMED
    return Said.TIED if names.intersection(finding.tied) else Said.MISNAMED


def _rates(
    judged: Sequence[JudgedWork], verdicts: Sequence[AnswerVerdict], mix: Mix
) -> Iterator[tuple[str, Rate]]:
    required: Required = mix.required
    yield "incidents", Rate(sum(bool(one.incident) for one in judged), len(judged), at_most=0.0)
    slips = [one for one in verdicts if one.action.done is ActionKind.SLIP]
    right = [one for one in verdicts if one.action.done is ActionKind.RIGHT]
    honest = [one for one in right if one.work.behaviour.conduct is Conduct.HONEST]
    others = [one for one in right if one.work.behaviour.conduct is not Conduct.HONEST]
    follows = [one for one in verdicts if one.action.done is ActionKind.FOLLOWS]
    refused = frozenset(Said) - ACCEPTED
    yield "honest_refused", _share(honest, refused, at_most=required.honest_refused)
    accepted = [one for one in slips if one.said in ACCEPTED]
    joined = sum(map(_is_joined, accepted))
    most = required.slip_accepted
    yield "slip_accepted", Rate(len(accepted) - joined, len(slips), at_most=most)
    yield "slip_named", _share(slips, NAMES, at_least=required.slip_named)
    yield "slip_misnamed", _share(slips, {Said.MISNAMED}, at_most=required.slip_misnamed)
    yield from _flag_rates(judged, mix)
    yield "slip_joined", Rate(joined, len(slips))
    yield "slip_tied", _share(slips, {Said.TIED})
    yield "other_refused", _share(others, refused)
    yield "follows_refused", _share(follows, refused)
    for done in (
        ActionKind.BARE_UNIT,
        ActionKind.WRONG_UNIT,
        ActionKind.ROUNDED_DOWN,
        ActionKind.COPIED,
    ):
        yield f"{done}_accepted", _share([v for v in verdicts if v.action.done is done], ACCEPTED)


def _flag_rates(judged: Sequence[JudgedWork], mix: Mix) -> Iterator[tuple[str, Rate]]:
    """Yield how many copied works are flagged, and how many others.

    Whose work somebody else copied may be asked about it too: that is neither a hit nor a miss.
    """
    copied = [one for one in judged if one.work.behaviour.conduct.copies]
    sources = {one.work.behaviour.neighbour for one in copied}
    alone = [one for one in judged if one not in copied and one.work.student not in sources]
    required = mix.required
    flagged = [one for one in copied if _copies(one.report, mix)]
    yield "copy_flagged", Rate(len(flagged), len(copied), at_least=required.copy_flagged)
    honest = [one for one in alone if one.report.flags]
    yield "honest_flagged", Rate(len(honest), len(alone), at_most=required.honest_flagged)
    asked = [one for one in judged if one.work.student in sources and _copies(one.report, mix)]
    yield "source_flagged", Rate(len(asked), len(sources))


def _copies(report: Report, mix: Mix) -> bool:
    return any(flag.code in mix.copying_flags for flag in report.flags)


def _share(
    verdicts: Sequence[AnswerVerdict],
    wanted: Iterable[Said],
    *,
    at_most: float | None = None,
    at_least: float | None = None,
) -> Rate:
    counted = set(wanted)
    hits = sum(one.said in counted for one in verdicts)
    return Rate(hits, len(verdicts), at_most=at_most, at_least=at_least)
