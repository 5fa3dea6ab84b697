"""Drawing what each virtual student does from the declared mix."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TypeVar

import numpy as np

from gripcourse.simulation.arithmetic import DISPLAY, DigitRounding, Hand
from gripcourse.simulation.model import Behaviour, Carrying, Conduct, Mix
from gripcourse.variants.model import Issued

_Chosen = TypeVar("_Chosen")


def draw_behaviours(entries: Sequence[Issued], mix: Mix, seed: int) -> dict[str, Behaviour]:
    """Draw what each student does, by student id.

    A student who would copy and has no neighbour with the same scheme works honestly.

    Args:
        entries: what was issued.
        mix: how often what is done.
        seed: the same seed gives the same behaviours.
    """
    rngs = [np.random.default_rng([seed, number]) for number in range(len(entries))]
    conducts = [drawn(mix.conduct, rng) for rng in rngs]
    sources = [
        entry for entry, conduct in zip(entries, conducts, strict=True) if not conduct.copies
    ]
    return {
        entry.student.id: _behaviour(
            mix, conduct, _neighbour(entry, sources, rng) if conduct.copies else "", rng
        )
        for entry, conduct, rng in zip(entries, conducts, rngs, strict=True)
    }


def hand_of(behaviour: Behaviour) -> Hand:
    """Return how one student computes and writes."""
    full = behaviour.rounding is DigitRounding.FULL
    return Hand(
        figures=np.asarray(DISPLAY if full else behaviour.figures),
        cuts=np.asarray(behaviour.rounding is DigitRounding.TRUNCATE),
        keeps=np.asarray(behaviour.carrying is Carrying.CALCULATOR),
        pi=np.asarray(behaviour.pi),
        constants={name: np.asarray(value) for name, value in behaviour.constants.items()},
    )


def _behaviour(mix: Mix, conduct: Conduct, neighbour: str, rng: np.random.Generator) -> Behaviour:
    return Behaviour(
        conduct=Conduct.HONEST if conduct.copies and not neighbour else conduct,
        figures=drawn(mix.figures, rng),
        rounding=drawn(mix.rounding, rng),
        carrying=drawn(mix.carrying, rng),
        style=drawn(mix.style, rng),
        pi=drawn(mix.pi, rng),
        constants={name: drawn(values, rng) for name, values in mix.constants.items()},
        neighbour=neighbour,
        seed=int(rng.integers(1 << 32)),
    )


def _neighbour(entry: Issued, sources: Iterable[Issued], rng: np.random.Generator) -> str:
    """Choose whom to copy from: who has the same scheme, and of those the most options."""
    alike: dict[int, list[str]] = {}
    for other in sources:
        if other.variant.scheme == entry.variant.scheme:
            same = len(entry.variant.options.items() & other.variant.options.items())
            alike.setdefault(same, []).append(other.student.id)
    return str(rng.choice(alike[max(alike)])) if alike else ""


def drawn(weights: Mapping[_Chosen, float], rng: np.random.Generator) -> _Chosen:
    """Draw one of several by weight."""
    total = sum(weights.values())
    number = rng.choice(len(weights), p=[weight / total for weight in weights.values()])
    return list(weights)[int(number)]
