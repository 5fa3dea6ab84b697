"""Reports → what the search for likeness compares."""

import math
from collections.abc import Collection
from typing import Final

from gripcourse.grading.folded import Derivation, derived
from gripcourse.grading.model import Finding, Report
from gripcourse.likeness.model import ComparedWork
from gripcourse.likeness.typed_numbers import Typed, TypedNumbers
from gripcourse.slips.model import USED, SlipId
from gripcourse.variants.model import Issued

_SAME = 1e-9  # relative: stored givens are decimal numbers


def work_of(report: Report, issued: Issued, issuer: str) -> ComparedWork:
    """Return the numbers of a judged submission.

    Args:
        report: of the submission.
        issued: to the student who handed it in.
        issuer: the author that issued workbooks name.
    """
    given = issued.variant.given
    # Mostly all is left as it was issued.
    used = () if report.givens == given else report.givens.items()
    changed = (
        Typed(quantity=name, value=value, half_unit=0.0, explained=False, slip=None)
        for name, value in used
        if name in given and not math.isclose(value, given[name], rel_tol=_SAME)
    )
    creator = "" if report.creator == issuer else report.creator
    numbers = derived(report.findings, TYPED).and_more(changed)
    return ComparedWork(report.student, numbers, creator)


def _typed(findings: Collection[Finding]) -> TypedNumbers:
    return TypedNumbers.of(
        Typed(
            quantity=finding.quantity,
            value=finding.given,
            half_unit=finding.half_unit,
            explained=_is_explained(finding),
            slip=_slip(finding),
        )
        for finding in findings
        if finding.given is not None
    )


TYPED: Final = Derivation("typed", _typed)
"""The answers that can be compared."""


def _is_explained(finding: Finding) -> bool:
    """Tell whether an answer is right or follows from the student's own numbers.

    The outcome alone does not say so: an answer that was accepted because it follows from a wrong
    given value follows from another's where that value was copied.
    """
    if finding.outcome.traits.equals_reference or _is_between(finding, finding.low, finding.high):
        return True
    near = (finding.reference, finding.expected)
    return any(_is_between(finding, value, value) for value in near)


def _is_between(finding: Finding, low: float | None, high: float | None) -> bool:
    """Tell whether an answer lies within its band of a range."""
    if finding.given is None or low is None or high is None:
        return False
    reach = max(finding.band, 2 * finding.half_unit, _SAME * abs(high)) * (1 + _SAME)
    return low - reach <= finding.given <= high + reach


def _slip(finding: Finding) -> SlipId | None:
    """Return the wrong method; that another number was used says nothing of its origin."""
    slip = finding.slip
    is_method = finding.outcome.traits.named and slip is not None and slip.kind != USED
    return slip if is_method else None
