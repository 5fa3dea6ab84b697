"""What trials of a mechanism show, gathered: one problem for each claim, whatever shows it."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.errors import Problem
from gripcourse.proofs.samples import Trial
from gripcourse.proofs.tried import in_comparisons, in_sets
from gripcourse.text.words import Message, message

_REMEDY: Final = message("Correct the formula of the quantity, or the declared mechanism.")


@dataclass(frozen=True, slots=True)
class Fault:
    """What one trial shows of one claim, condition, contact or solution.

    Attributes:
        key: where it is declared.
        what: the text of its formula, the name of a contact, or reactions that are left open.
        trial: the numbers.
        position: of the mechanism; empty for none.
        wrong: where it is not as it should be, shape (n,).
        declared, actual: both sides of a claim in SI, shape (n,); None of anything else.
    """

    key: str
    what: str
    trial: Trial
    position: str
    wrong: NDArray[np.bool_]
    declared: NDArray[np.float64] | None = None
    actual: NDArray[np.float64] | None = None


def problems(file: str, faults: Iterable[Fault]) -> Iterator[Problem]:
    """Yield one problem for each key at which something is wrong."""
    by_key: dict[str, list[Fault]] = {}
    for one in faults:
        by_key.setdefault(one.key, []).append(one)
    for key, tried in by_key.items():
        wrong = [one for one in tried if one.wrong.any()]
        if wrong:
            yield Problem(file, key, _said(key, tried, wrong), _REMEDY)


def _said(key: str, tried: list[Fault], wrong: list[Fault]) -> Message:
    first = wrong[0]
    place = int(np.flatnonzero(first.wrong)[0])
    options = (f"{name}={choice}" for name, choice in first.trial.plan.options.items())
    counts = (sum(int(one.wrong.sum()) for one in wrong), sum(len(one.wrong) for one in tried))
    known = {
        "schemes": ", ".join(dict.fromkeys(one.trial.plan.scheme.id for one in wrong)),
        "variant": first.trial.variants[place].id,
        "where": ", ".join(filter(None, (first.trial.plan.scheme.id, first.position, *options))),
    }
    if first.declared is not None and first.actual is not None:
        ratios = _ratios(wrong)
        return message(
            "{quantity} is not in equilibrium {tried} ({schemes}): the bodies give {low} to {high}"
            " times as much, for example {actual} instead of {declared}, in SI, in {variant}"
            " ({where}).",
            tried=in_comparisons(*counts),
            quantity=first.what,
            low=_figures(np.nanmin(ratios)),
            high=_figures(np.nanmax(ratios)),
            actual=_figures(first.actual[place]),
            declared=_figures(first.declared[place]),
            **known,
        )
    if key == "joint":
        return message(
            "Equilibrium has no single solution {tried} ({schemes}), for example in {variant}"
            " ({where}); it leaves open: {open}.",
            tried=in_sets(*counts),
            open=first.what or "—",
            **known,
        )
    if key.startswith("joint."):
        return message(
            "The contact {contact} pulls, or slips, {tried} ({schemes}), for example in {variant}"
            " ({where}).",
            tried=in_sets(*counts),
            contact=first.what,
            **known,
        )
    return message(
        "It does not hold {tried} ({schemes}), for example in {variant} ({where}).",
        tried=in_comparisons(*counts),
        **known,
    )


def _ratios(wrong: list[Fault]) -> NDArray[np.float64]:
    with np.errstate(all="ignore"):
        found = [
            (one.actual / one.declared)[one.wrong]
            for one in wrong
            if one.declared is not None and one.actual is not None
        ]
    return np.concatenate(found)


def _figures(value: float) -> float:
    return float(f"{value:.5g}")
