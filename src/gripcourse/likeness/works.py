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
_ROUNDED: Final = 0.002  # relative: what rounding on the way leaves of a number that follows


def work_of(report: Report, issued: Issued, issuer: str, version: int = 0) -> ComparedWork:
    """Return the numbers of a judged submission.

    Args:
        report: of the submission.
        issued: to the student who handed it in; the workbook was made for it.
        issuer: the author that issued workbooks name.
        version: see `ComparedWork`.
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
    return ComparedWork(report.student, numbers, creator, version)


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
    given value follows from another's where that value was copied. Nor does the band: numbers that
    somebody moved to hide where they come from lie within it, and not where rounding leaves them.
    """
    if finding.outcome.traits.equals_reference:
        return True
    if _is_between(finding, finding.reference, finding.reference, finding.band):
        return True
    rounded = _ROUNDED * abs(finding.given or 0.0)
    low, high = finding.low, finding.high
    return _is_between(finding, low, high, rounded) or _is_between(
        finding, finding.expected, finding.expected, rounded
    )


def _is_between(finding: Finding, low: float | None, high: float | None, reach: float) -> bool:
    """Tell whether an answer lies within reach of a range, or as near as it was typed."""
    if finding.given is None or low is None or high is None:
        return False
    reach = max(reach, 2 * finding.half_unit, _SAME * abs(high)) * (1 + _SAME)
    return low - reach <= finding.given <= high + reach


def _slip(finding: Finding) -> SlipId | None:
    """Return the wrong method; that another number was used says nothing of its origin."""
    slip = finding.slip
    is_method = finding.outcome.traits.named and slip is not None and slip.kind != USED
    return slip if is_method else None
