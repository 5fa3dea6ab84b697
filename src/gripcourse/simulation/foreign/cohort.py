"""A cohort of the second generator: who does what, who copies from whom, what is handed in."""

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np

from gripcourse.batch.context import GradingContext
from gripcourse.course.quantity import Kind
from gripcourse.simulation.behaviour import drawn
from gripcourse.simulation.foreign.kinds import (
    BLANK,
    BLANKS,
    COPIED,
    DOINGS,
    MOVED,
    Doing,
)
from gripcourse.simulation.foreign.model import Calculated, ForeignWork
from gripcourse.simulation.foreign.student import calculate, draw_habits, draw_mistake, reached
from gripcourse.simulation.foreign.writing import cell, exactly, written
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.variants.model import Issued

_COPIES: Final = frozenset({Doing.COPY, Doing.MOVED_COPY, Doing.MIXTURE, Doing.STOLEN_FILE})
_DECIDED: Final = frozenset({Kind.CHOICE, Kind.VERDICT})
_NEEDED: Final = {Doing.MIXTURE: 2}


def draw_doings(entries: Sequence[Issued], seed: int) -> dict[str, tuple[Doing, tuple[str, ...]]]:
    """Draw what each student does, and whom those who copy copy from.

    Who would copy and has no neighbour with the same scheme works honestly.
    """
    rng = np.random.default_rng([seed, 2])
    doings = {entry.student.id: drawn(DOINGS, rng) for entry in entries}
    mates: dict[str, list[str]] = {}
    for entry in entries:
        if doings[entry.student.id] not in _COPIES:
            mates.setdefault(entry.variant.scheme, []).append(entry.student.id)
    found: dict[str, tuple[Doing, tuple[str, ...]]] = {}
    for entry in entries:
        doing, near = doings[entry.student.id], mates.get(entry.variant.scheme, [])
        needed = _NEEDED.get(doing, 1) if doing in _COPIES else 0
        if len(near) < needed:
            doing, needed = Doing.HONEST, 0
        chosen = rng.choice(near, needed, replace=False) if needed else ()
        found[entry.student.id] = (doing, tuple(map(str, chosen)))
    return found


def work_of(
    student: str,
    doings: Mapping[str, tuple[Doing, tuple[str, ...]]],
    context: GradingContext,
    seed: int,
) -> ForeignWork:
    """Let one student work.

    Args:
        student: id.
        doings: of the whole cohort.
        context: course and register.
        seed: of the cohort.
    """
    issued = context.register[student]
    plan = plan_of(context.course, issued.variant.composition)
    doing, sources = doings[student]
    rng = np.random.default_rng([seed, *student.encode()])
    habits, given = draw_habits(rng), issued.variant.given
    made = draw_mistake(plan, given, habits, rng) if doing is Doing.MISTAKE else None
    done, calculated = made or (None, calculate(plan, given, habits))
    neighbours = [work_of(one, doings, context, seed) for one in sources]
    texts = _handed_in(doing, plan, calculated, neighbours, rng)
    if doing not in _COPIES and rng.random() < BLANKS:
        texts = {name: text for name, text in texts.items() if rng.random() >= BLANK}
    language = issued.student.language or context.course.language
    cells = {
        one.id: cell(one, texts[one.id], habits, language, place)
        for place, one in enumerate(plan.answered)
        if one.id in texts
    }
    if doing is Doing.STOLEN_FILE:
        cells = dict(neighbours[0].cells)
    reaches = frozenset() if done is None else reached(plan, done)
    return ForeignWork(
        student=student,
        owner=sources[0] if doing is Doing.STOLEN_FILE else student,
        doing=Doing.HONEST if doing is Doing.MISTAKE and done is None else doing,
        habits=habits,
        done=done,
        reaches=reaches,
        shown=_shown(plan, reaches, cells),
        decisions=frozenset(one.id for one in plan.answered if one.kind in _DECIDED),
        calculated=calculated,
        cells=cells,
        sources=sources,
    )


def _shown(plan: Plan, reaches: frozenset[str], cells: Mapping[str, float | str]) -> frozenset[str]:
    """Return the filled answers that rest on blank ones which a mistake is in."""
    hidden = {name for name in reaches if name not in cells}
    shown: set[str] = set()
    for one in plan.answered:
        if not hidden.isdisjoint(plan.inputs[one.id]):
            (shown if one.id in cells else hidden).add(one.id)
    return frozenset(shown)


def _handed_in(
    doing: Doing,
    plan: Plan,
    own: Calculated,
    neighbours: Sequence[ForeignWork],
    rng: np.random.Generator,
) -> Mapping[str, str]:
    """Return what is written into a work, whosever numbers it is."""
    texts = dict(own.texts)
    if doing not in {Doing.COPY, Doing.MOVED_COPY, Doing.MIXTURE}:
        return texts
    for one in plan.answered:
        theirs = neighbours[int(rng.integers(len(neighbours)))]
        if one.id not in theirs.calculated.texts:
            continue
        text = theirs.calculated.texts[one.id]
        if doing is Doing.MOVED_COPY and not one.exact:
            moved = float(text) * (1 + rng.uniform(-MOVED, MOVED))
            text = written(moved, theirs.habits.writing, rng)
        if doing is not Doing.COPY or rng.random() < COPIED:
            texts[one.id] = text if not one.exact else exactly(float(text))
    return texts
