"""Root causes told from consequences: which wrong answers explain which later ones."""

from collections import defaultdict
from collections.abc import Mapping, Sequence

from gripcourse.grading.model import Against, Cause, Finding, Outcome
from gripcourse.grading.substitution import Substitution
from gripcourse.solver.plan import Plan
from gripcourse.words import Message, message

_AT_FAULT = frozenset({Outcome.SLIP, Outcome.WRONG})


def roots_of(plan: Plan, outcomes: Mapping[str, tuple[Outcome, Against]]) -> dict[str, set[str]]:
    """Return for each answer that follows from wrong ones the wrong answers at the root.

    Args:
        plan: whose quantities are in order of calculation.
        outcomes: of every answered quantity.
    """
    roots: dict[str, set[str]] = {}
    for name in plan.quantities:
        behind = {root for one in plan.inputs[name] for root in _behind(one, outcomes, roots)}
        outcome, against = outcomes.get(name, (None, None))
        follows = outcome is Outcome.CARRIED and against is Against.OWN_INPUTS
        # A step that was not written down passes on what led to it.
        if behind and (follows or outcome in {None, Outcome.BLANK, Outcome.UNREADABLE}):
            roots[name] = behind
    return {name: behind for name, behind in roots.items() if name in outcomes}


def _behind(
    name: str,
    outcomes: Mapping[str, tuple[Outcome, Against]],
    roots: Mapping[str, set[str]],
) -> set[str]:
    outcome, _ = outcomes.get(name, (None, None))
    return {name} if outcome in _AT_FAULT else roots.get(name, set())


def causes_of(
    plan: Plan, findings: Sequence[Finding], substituted: Sequence[Substitution]
) -> tuple[Cause, ...]:
    """Return what explains several answers, what explains most first."""
    explained: dict[str, list[str]] = defaultdict(list)
    order = {name: rank for rank, name in enumerate(plan.quantities)}
    for finding in sorted(findings, key=lambda one: order[one.quantity]):
        if finding.outcome is Outcome.CARRIED:
            for root in finding.roots:
                explained[root].append(finding.quantity)
    causes = [
        Cause(
            one.quantity,
            one.explains,
            _used(plan, one),
        )
        for one in substituted
    ]
    causes += [
        Cause(
            root,
            tuple(names),
            message(
                "Your {title} explains {count} later answers.",
                title=plan.quantities[root].title,
                count=len(names),
            ),
        )
        for root, names in explained.items()
    ]
    return tuple(sorted(causes, key=lambda one: -len(one.explains)))


def _used(plan: Plan, found: Substitution) -> Message:
    quantity = plan.quantities[found.quantity]
    if found.tied:
        return message(
            "{count} answers fit together if another number was used for {title} ({value}) or for "
            "{other}.",
            count=len(found.explains),
            title=quantity.title,
            value=found.value,
            other=plan.quantities[found.tied].title,
        )
    return message(
        "{count} answers fit together if {value} was used for {title}.",
        count=len(found.explains),
        value=found.value,
        title=quantity.title,
    )
