"""Root causes told from consequences: which wrong answers explain which later ones."""

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Final

from gripcourse.course.quantity import Kind
from gripcourse.formula.evaluate import evaluate_number
from gripcourse.grading.model import Against, Cause, Finding, Outcome
from gripcourse.grading.substitution import Substitution
from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import amount_text
from gripcourse.text.words import LANGUAGES, Message, Texts, Words, counted, message

_SAME: Final = 1e-9


def roots_of(
    plan: Plan,
    outcomes: Mapping[str, tuple[Outcome, Against]],
    own: Mapping[str, float],
    reference: Mapping[str, float],
) -> dict[str, set[str]]:
    """Return for each answer that follows from wrong ones the wrong answers at the root.

    Args:
        plan: whose quantities are in order of calculation.
        outcomes: of every answered quantity.
        own: every quantity at the student's own numbers, SI.
        reference: every quantity of the reference, SI.
    """
    roots: dict[str, set[str]] = {}
    for name in plan.quantities:
        if not _passes_on(outcomes.get(name)):
            continue
        found = {one: _behind(one, outcomes, roots) for one in plan.inputs[name]}
        wrong = [one for one, behind in found.items() if behind]
        if len(wrong) > 1:
            wrong = _that_matter(plan, name, wrong, own, reference) or wrong
        if wrong:
            roots[name] = set().union(*(found[one] for one in wrong))
    return {name: behind for name, behind in roots.items() if name in outcomes}


def _that_matter(
    plan: Plan,
    name: str,
    wrong: Sequence[str],
    own: Mapping[str, float],
    reference: Mapping[str, float],
) -> list[str]:
    """Return the wrong inputs without which a number would be another one.

    Of two forces the smaller explains nothing where the larger one counts.
    """
    quantity, formula = plan.quantities[name], plan.reference_formula(name)
    if formula is None or quantity.kind is not Kind.FORMULA:
        return list(wrong)
    here = evaluate_number(formula, quantity.unit, own, plan.columns)
    return [
        one
        for one in wrong
        if not math.isclose(
            here,
            evaluate_number(
                formula,
                quantity.unit,
                {**own, one: reference.get(one, math.nan)},
                plan.columns,
            ),
            rel_tol=_SAME,
        )
    ]


def _passes_on(found: tuple[Outcome, Against] | None) -> bool:
    """A step that was not written down passes on what led to it, as one that follows does."""
    if found is None:
        return True
    outcome, against = found
    follows = outcome.traits.follows and against is Against.OWN_INPUTS
    return follows or outcome.traits.missing


def _behind(
    name: str,
    outcomes: Mapping[str, tuple[Outcome, Against]],
    roots: Mapping[str, set[str]],
) -> set[str]:
    found = outcomes.get(name)
    at_fault = found is not None and found[0].traits.mistake
    return {name} if at_fault else roots.get(name, set())


def causes_of(
    plan: Plan, findings: Sequence[Finding], substituted: Sequence[Substitution]
) -> tuple[Cause, ...]:
    """Return what explains several answers, what explains most first."""
    explained: dict[str, list[str]] = defaultdict(list)
    order = {name: rank for rank, name in enumerate(plan.quantities)}
    for finding in sorted(findings, key=lambda one: order[one.quantity]):
        if finding.outcome.traits.follows:
            for root in finding.roots:
                explained[root].append(finding.quantity)
    causes = []
    for one in substituted:
        if one.is_slip:
            continue  # its answers have the blank step as their root
        # What follows from the first answer that the number spoiled follows from the number too.
        further = explained.pop(one.explains[0], [])
        names = sorted({*one.explains, *further}, key=lambda name: order[name])
        cause = one.quantity if one.named else one.explains[0]
        causes.append(Cause(cause, tuple(names), _used(plan, one)))
    causes += [
        Cause(
            root,
            tuple(names),
            counted(
                "Your {title} explains {count} later answer.",
                "Your {title} explains {count} later answers.",
                len(names),
                title=plan.quantities[root].short_title,
            ),
        )
        for root, names in explained.items()
    ]
    return tuple(sorted(causes, key=lambda one: -len(one.explains)))


def _used(plan: Plan, found: Substitution) -> Message:
    title = plan.quantities[found.quantity].short_title
    if not found.named:
        return message(
            "{title}: this and other wrong answers seem to have one wrong number in common; which "
            "one cannot be told.",
            title=plan.quantities[found.explains[0]].short_title,
        )
    if found.tied:
        return message(
            "{title} or {other}: these answers fit together if another number was used.",
            title=title,
            other=plan.quantities[found.tied].short_title,
        )
    if not _may_be_told(plan, found):
        return message(
            "{title}: these answers fit together if another number was used.", title=title
        )
    return message(
        "{title}: these answers fit together if {value} was used.",
        title=title,
        value=_value(plan, found),
    )


def spoiled_first(plan: Plan, found: Substitution) -> Message:
    """Say of the first answer that a wrong number spoiled what it follows from."""
    title, more = plan.quantities[found.quantity].short_title, len(found.explains) - 1
    if not found.named:
        return message(
            "Wrong. This answer and {count} more seem to have one wrong number in common; which "
            "one cannot be told. They cost once.",
            count=more,
        )
    if found.tied:
        return message(
            "A wrong number: this answer and {count} more follow if another one is used for "
            "{title} or for {other}.",
            count=more,
            title=title,
            other=plan.quantities[found.tied].short_title,
        )
    if not _may_be_told(plan, found):
        return message(
            "A wrong number: this answer and {count} more follow if another one is used for "
            "{title}.",
            count=more,
            title=title,
        )
    return message(
        "A wrong number: this answer and {count} more follow if {value} is used for {title}.",
        count=more,
        value=_value(plan, found),
        title=title,
    )


def spoiled_later(plan: Plan, found: Substitution) -> Message:
    """Say of a later answer that a wrong number spoiled what it follows from."""
    if not found.named:
        return message(
            "It seems to have a wrong number in common with {title}, which has cost already.",
            title=plan.quantities[found.explains[0]].short_title,
        )
    title = plan.quantities[found.quantity].short_title
    if found.tied or not _may_be_told(plan, found):
        return message(
            "Follows from another number for {title}, which has cost an earlier answer.",
            title=title,
        )
    return message(
        "Follows from the wrong number {value} for {title}, which has cost an earlier answer.",
        value=_value(plan, found),
        title=title,
    )


def _may_be_told(plan: Plan, found: Substitution) -> bool:
    """Tell whether the number that was used gives nothing away.

    What a given value was taken for is the student's own; what answers fit to in the place of
    another answer may be the reference, where that answer was typed wrongly but not used so.
    """
    is_issued = plan.quantities[found.quantity].kind in {Kind.GIVEN, Kind.CONSTANT}
    return is_issued and math.isfinite(found.value)


def _value(plan: Plan, found: Substitution) -> Texts:
    """Write the number that was used; its last digits are only as sure as the answers' are."""
    unit = plan.quantities[found.quantity].unit
    return Texts({
        language: amount_text(found.value, unit, Words(language), figures=4)
        for language in LANGUAGES
    })  # fmt: skip
