"""What the second generator's students did against what the grader says."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from gripcourse.grading.model import Finding, FlagCode, Report
from gripcourse.simulation.foreign.costs import (
    Uncharged,
    answers,
    charged,
    is_moved,
    why_uncharged,
)
from gripcourse.simulation.foreign.kinds import MISTAKES, Doing, ForeignMistake
from gripcourse.simulation.foreign.misses import PAID
from gripcourse.simulation.foreign.model import JudgedForeign
from gripcourse.simulation.model import Mix
from gripcourse.simulation.rates import Rate, added
from gripcourse.slips.model import USED, SlipId

_OWNER = frozenset({FlagCode.COPIED_FROM})
_PAID_BY_CHANCE = 0.005  # share of the works with a mistake
# Share of answers: what is lost in a blank step by who rounds far is not always to be found.
_COARSE_REFUSED = 0.0001
_SPOILED = 2  # answers that a number used wrongly must spoil before it can be told


@dataclass(frozen=True, slots=True)
class MistakeRates:
    """What was said of one kind of mistake: shares of the works with it.

    Attributes:
        once: charged at most once.
        named: named as what it is; None where the grader has no word for it.
        misnamed: given a name that is another mistake's.
        blamed: in which another quantity is blamed.
    """

    once: Rate
    named: Rate | None
    misnamed: Rate
    blamed: Rate

    def __add__(self, other: "MistakeRates") -> "MistakeRates":
        """Count two samples together."""
        named = [one for one in (self.named, other.named) if one is not None]
        return MistakeRates(
            once=self.once + other.once,
            named=named[0] + named[1] if len(named) > 1 else next(iter(named), None),
            misnamed=self.misnamed + other.misnamed,
            blamed=self.blamed + other.blamed,
        )


@dataclass(frozen=True, slots=True)
class ForeignEvaluation:
    """How well the grader treats students whom its makers did not invent.

    Attributes:
        students: how many.
        rates: what was measured.
        by_kind: by kind of mistake.
        misses: works that the grader treats wrongly, each with what is wrong.
        incidents: traces of what failed on our side.
    """

    students: int
    rates: Mapping[str, Rate]
    by_kind: Mapping[ForeignMistake, MistakeRates]
    misses: tuple[tuple[str, JudgedForeign], ...]
    incidents: tuple[str, ...]

    def __add__(self, other: "ForeignEvaluation") -> "ForeignEvaluation":
        """Count two cohorts together."""
        return ForeignEvaluation(
            students=self.students + other.students,
            rates={name: rate + other.rates[name] for name, rate in self.rates.items()},
            by_kind=added(self.by_kind, other.by_kind),
            misses=(*self.misses, *other.misses),
            incidents=(*self.incidents, *other.incidents),
        )

    @property
    def missed(self) -> tuple[str, ...]:
        """Names of the required rates that are not reached."""
        return tuple(name for name, rate in self.rates.items() if not rate.reached)


def evaluate_foreign(judged: Sequence[JudgedForeign], mix: Mix) -> ForeignEvaluation:
    """Set what was done against what was said.

    Args:
        judged: every student's work and report.
        mix: what the grader is held to, and which flags mean copying.
    """
    kinds = {
        kind: [one for one in _mistaken(judged) if _kind(one) is kind] for kind in ForeignMistake
    }
    tests: tuple[tuple[str, Callable[[JudgedForeign], bool]], ...] = (
        ("honest_refused", lambda one: _is_honest(one) and any(_refused(one))),
        ("charged_more", lambda one: one.work.done is not None and charged(one) > 1),
        ("misnamed", _is_misnamed),
        ("blamed", _is_blamed),
        (PAID, lambda one: why_uncharged(one) is Uncharged.PAID),
        ("not_named", lambda one: _has_word(one) and not _is_named(one)),
    )
    return ForeignEvaluation(
        students=len(judged),
        rates=dict(_rates(judged, mix)),
        by_kind={kind: _by_kind(found) for kind, found in kinds.items() if found},
        misses=tuple((name, one) for name, test in tests for one in judged if test(one)),
        incidents=tuple(one.incident for one in judged if one.incident),
    )


def _mistaken(judged: Sequence[JudgedForeign], *, coarse: bool = False) -> list[JudgedForeign]:
    """Return the works with a mistake, of those who write enough figures or of the others."""
    return [one for one in judged if one.work.done is not None and one.work.habits.coarse is coarse]


def _rates(judged: Sequence[JudgedForeign], mix: Mix) -> Iterator[tuple[str, Rate]]:
    works, required = _mistaken(judged), mix.required
    yield "incidents", Rate(sum(bool(one.incident) for one in judged), len(judged), at_most=0.0)
    fine = [one for one in judged if _is_honest(one) and not one.work.habits.coarse]
    coarse = [one for one in judged if _is_honest(one) and one.work.habits.coarse]
    refused = [found for one in fine for found in _refused(one)]
    yield "honest_refused", Rate(sum(refused), len(refused), at_most=required.honest_refused)
    refused = [found for one in coarse for found in _refused(one)]
    yield "coarse_refused", Rate(sum(refused), len(refused), at_most=_COARSE_REFUSED)
    once = [one for one in works if charged(one) <= 1]
    yield "charged_once", Rate(len(once), len(works), at_least=required.charged_once)
    spoiling = [one for one in works if len(one.work.reaches) >= _SPOILED]
    once = [one for one in spoiling if charged(one) <= 1]
    yield "charged_once_of_spoiling", Rate(len(once), len(spoiling), at_least=required.charged_once)
    coarse_works = _mistaken(judged, coarse=True)
    least = required.charged_once
    yield "coarse_charged_once", _share(coarse_works, lambda one: charged(one) <= 1, at_least=least)
    yield from _uncharged(works)
    yield "misnamed", _share(works, _is_misnamed, at_most=required.misnamed)
    yield "blamed", _share(works, _is_blamed, at_most=required.blamed)
    word = [one for one in works if _has_word(one)]
    yield "named", _share(word, _is_named, at_least=required.named)
    yield from _copies(judged, mix)


def _uncharged(works: Sequence[JudgedForeign]) -> Iterator[tuple[str, Rate]]:
    """Yield why mistakes cost nothing; hardly any may because a wrong number was accepted.

    Beside a step that is left blank, and has cost, a number may by chance be what a known mistake
    in that step would lead to.
    """
    why = [why_uncharged(one) for one in works]
    for reason in Uncharged:
        most = _PAID_BY_CHANCE if reason is Uncharged.PAID else None
        yield f"uncharged_{reason.value}", Rate(why.count(reason), len(works), at_most=most)


def _copies(judged: Sequence[JudgedForeign], mix: Mix) -> Iterator[tuple[str, Rate]]:
    required, copying = mix.required, mix.copying_flags - _OWNER
    kinds = {
        "copies_flagged": (Doing.COPY, required.copy_flagged),
        "moved_copies_flagged": (Doing.MOVED_COPY, required.moved_copy_flagged),
        "mixtures_flagged": (Doing.MIXTURE, required.mixture_flagged),
        "stolen_flagged": (Doing.STOLEN_FILE, required.copy_flagged),
    }
    for name, (doing, least) in kinds.items():
        found = [one for one in judged if one.work.doing is doing]
        yield name, _share(found, lambda one: _has(one.report, copying), at_least=least)
    sources = {source for one in judged for source in one.work.sources}
    own = [one for one in judged if not one.work.sources and one.work.student not in sources]
    most = required.honest_flagged
    yield "own_flagged", _share(own, lambda one: _has(one.report, copying), at_most=most)
    stolen = {one.work.owner for one in judged if one.work.doing is Doing.STOLEN_FILE}
    only = stolen - {
        source
        for one in judged
        if one.work.doing is not Doing.STOLEN_FILE
        for source in one.work.sources
    }
    owners = [one for one in judged if one.work.student in only]
    yield (
        "owners_named",
        _share(
            owners,
            lambda one: _has(one.report, _OWNER) and not _has(one.report, copying),
            at_least=1.0,
        ),
    )


def _share(
    works: Sequence[JudgedForeign],
    test: Callable[[JudgedForeign], bool],
    *,
    at_most: float | None = None,
    at_least: float | None = None,
) -> Rate:
    return Rate(sum(map(test, works)), len(works), at_most=at_most, at_least=at_least)


def _by_kind(works: Sequence[JudgedForeign]) -> MistakeRates:
    word = [one for one in works if _has_word(one)]
    return MistakeRates(
        once=_share(works, lambda one: charged(one) <= 1),
        named=_share(word, _is_named) if word else None,
        misnamed=_share(works, _is_misnamed),
        blamed=_share(works, _is_blamed),
    )


def _kind(one: JudgedForeign) -> ForeignMistake | None:
    return None if one.work.done is None else one.work.done.kind


def _is_honest(one: JudgedForeign) -> bool:
    return one.work.doing is Doing.HONEST


def _refused(one: JudgedForeign) -> Iterator[bool]:
    """Tell of each answer whether it is refused; coarse ones may be called too rough."""
    for found in answers(one):
        rough = found.outcome.traits.coarse and one.work.habits.coarse
        right = found.outcome.traits.right and not found.outcome.traits.coarse
        yield not (right or rough)


def _names(found: Finding) -> AbstractSet[object]:
    return {slip for slip in (found.slip, *found.tied) if slip is not None}


def _is_right_name(one: JudgedForeign, found: Finding) -> bool:
    """Tell whether a name is the mistake's, or one that comes to the very same number.

    In an answer where a mistake of a blank step shows, only the latter.
    """
    done = one.work.done
    if done is None:
        return False
    here = found.quantity in one.work.reaches
    kinds = MISTAKES[done.kind].names
    return any(
        (here and slip.kind in kinds and (slip.kind != USED or slip.detail == done.root))
        or (found.quantity, slip) in one.twins
        for slip in (found.slip, *found.tied)
        if slip is not None
    )


def _named(one: JudgedForeign) -> Iterable[Finding]:
    return (found for found in answers(one) if found.outcome.traits.named)


def _is_misnamed(one: JudgedForeign) -> bool:
    """Tell whether a method is named that was not used."""
    return one.work.done is not None and any(
        found.slip is not None and found.slip.kind != USED and not _is_right_name(one, found)
        for found in _named(one)
    )


def _is_blamed(one: JudgedForeign) -> bool:
    """Tell whether something is said to be wrong where nothing is.

    Who leaves the place of the mistake blank shows it first in the next answers.
    """
    done = one.work.done
    if done is None:
        return False
    places = {done.root, *one.work.reaches, *one.work.shown}
    wrong = (found.quantity for found in answers(one) if found.outcome.traits.mistake)
    used = (
        _place_of(found.slip, (found.slip, *found.tied), done.root)
        for found in _named(one)
        if found.slip is not None and found.slip.kind == USED
    )
    causes = (
        _place_of(SlipId.used(cause.quantity), pair, done.root)
        for cause in one.report.causes
        for pair in [_named_together(one, cause.quantity)]
    )
    return not places.issuperset({*wrong, *used, *causes})


def _named_together(one: JudgedForeign, quantity: str) -> tuple[SlipId, ...]:
    """Return the two numbers of which one was used wrongly, where one is this quantity's."""
    for found in _named(one):
        if found.slip is not None and SlipId.used(quantity) in (found.slip, *found.tied):
            return (found.slip, *found.tied)
    return ()


def _place_of(slip: SlipId, named: Sequence[SlipId], root: str) -> str:
    """Return what is blamed; of two that are named together, the right one counts."""
    return root if SlipId.used(root) in named else slip.detail


def _has_word(one: JudgedForeign) -> bool:
    """Tell whether the grader could say what was done: it has a word, and enough to go by.

    A number that was used wrongly can be told from two answers that it moves, not from one.
    """
    done = one.work.done
    if done is None or not MISTAKES[done.kind].names or not charged(one):
        return False
    if USED not in MISTAKES[done.kind].names:
        return bool(one.work.reaches & one.work.cells.keys())
    moved = (
        found for found in answers(one) if found.quantity in one.work.reaches and is_moved(found)
    )
    return sum(1 for _ in moved) >= _SPOILED


def _is_named(one: JudgedForeign) -> bool:
    return any(_is_right_name(one, found) for found in _named(one))


def _has(report: Report, codes: AbstractSet[FlagCode]) -> bool:
    return any(flag.code in codes for flag in report.flags)
