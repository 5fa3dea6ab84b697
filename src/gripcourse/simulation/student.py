"""One virtual student: from a behaviour and an issued variant to a filled workbook and the truth.

Everything is a pure function of the behaviour, so that who copies from somebody can be computed
without that somebody's workbook.
"""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

import numpy as np

from gripcourse.batch.context import GradingContext
from gripcourse.batch.one_file import methods_of
from gripcourse.course.quantity import Kind, Quantity, Rounding
from gripcourse.policy.slips import SlipKind
from gripcourse.simulation.arithmetic import Array
from gripcourse.simulation.behaviour import hand_of
from gripcourse.simulation.calculation import Calculation, Deviation, WorkedStep, calculate
from gripcourse.simulation.cells import cell_of, unfit_unit, with_unit
from gripcourse.simulation.model import (
    Action,
    ActionKind,
    Behaviour,
    Conduct,
    Mix,
    SimulatedWork,
    Style,
)
from gripcourse.simulation.places import (
    Effect,
    Ground,
    draw_slip,
    effect,
    make_ground,
    slip_kinds,
    twins_of,
)
from gripcourse.solver.plan import Plan
from gripcourse.variants.model import Issued

_TAINTING = frozenset({ActionKind.SLIP, ActionKind.ROUNDED_DOWN, ActionKind.COPIED})
"""What makes the student's later numbers others than they should be."""


@dataclass(frozen=True, slots=True)
class Classroom:
    """Whom and what a virtual cohort consists of.

    Attributes:
        context: course, policy and what was issued.
        mix: how students work.
        behaviours: what each does, by student id.
    """

    context: GradingContext
    mix: Mix
    behaviours: Mapping[str, Behaviour]


@dataclass(frozen=True, slots=True)
class _Student:
    """One student with everything that the work needs."""

    room: Classroom
    issued: Issued
    plan: Plan
    behaviour: Behaviour
    ground: Ground

    @property
    def language(self) -> str:
        return self.issued.student.language or self.room.context.course.language

    @property
    def units(self) -> tuple[str, ...]:
        return units_of(self.room.context)

    def calculated(self, deviations: Mapping[str, Deviation]) -> Calculation:
        return calculate(self.plan, self.issued.variant.given, self.ground.hand, deviations)


@dataclass(frozen=True, slots=True)
class _Drawn:
    """What a student does otherwise, with the calculation that it leads to."""

    deviations: Mapping[str, Deviation]
    done: Calculation
    tried: int
    hidden: int


def units_of(context: GradingContext) -> tuple[str, ...]:
    """Return the units that people take for each other."""
    slip = context.policy.slips.kinds.get(SlipKind.UNIT)
    return slip.units if slip is not None else ()


def work_of(student: str, room: Classroom) -> SimulatedWork:
    """Let one student work.

    Args:
        student: id.
        room: the cohort that the student belongs to.
    """
    behaviour = room.behaviours[student]
    if behaviour.conduct is Conduct.COPIED_WORKBOOK:
        actions = work_of(behaviour.neighbour, room).actions
        return SimulatedWork(student, behaviour.neighbour, behaviour, actions, 0, 0)
    one = _seated(student, room)
    rng = np.random.default_rng(behaviour.seed)
    drawn = _draw_deviations(one, rng)
    actions = _actions(one, drawn, rng)
    return SimulatedWork(student, student, behaviour, actions, drawn.tried, drawn.hidden)


def _seated(student: str, room: Classroom) -> _Student:
    issued = room.context.register[student]
    plan, methods = methods_of(room.context, issued.variant)
    behaviour = room.behaviours[student]
    hand = hand_of(behaviour)
    policy, given = room.context.policy, issued.variant.given
    ground = make_ground(plan, policy, methods, hand, given, room.mix.apart)
    return _Student(room, issued, plan, behaviour, ground)


def _draw_deviations(one: _Student, rng: np.random.Generator) -> _Drawn:
    """Try places until what is done there can be seen; a student without such a place is honest."""
    if one.behaviour.conduct is Conduct.COPIED_ANSWERS:
        copied = _copied(one, rng)
        return _Drawn(copied, one.calculated(copied), 0, 0)
    tried = hidden = 0
    while tried < one.room.mix.tries:
        proposed = _proposed(one, rng)
        if not proposed:
            break
        tried += 1
        done = one.calculated(proposed)
        effects = {
            effect(one.ground, name, done)
            for name, deviation in proposed.items()
            if deviation.done is not ActionKind.WRONG_UNIT
        }
        if effects <= {Effect.APART}:
            return _Drawn(proposed, done, tried, hidden)
        hidden += Effect.HIDDEN in effects
    return _Drawn({}, one.calculated({}), tried, hidden)


def _proposed(one: _Student, rng: np.random.Generator) -> Mapping[str, Deviation]:
    """Draw what a student may do, whatever it comes to; nothing for who does everything right."""
    plan, policy = one.plan, one.room.context.policy
    match one.behaviour.conduct:
        case Conduct.SLIP:
            return _slips(one, 1, rng)
        case Conduct.TWO_SLIPS:
            return _slips(one, 2, rng)
        case Conduct.BARE_UNIT:
            unit = {str(SlipKind.UNIT): 1.0}
            kinds = unit if SlipKind.UNIT in policy.slips.kinds else {}
            slip = draw_slip(plan, one.ground.candidates_of, kinds, rng)
            return {} if slip is None else {slip[0]: Deviation(ActionKind.BARE_UNIT, slip[1])}
        case Conduct.WRONG_UNIT:
            computed = [one.id for one in plan.answered if one.kind is Kind.FORMULA]
            return {str(rng.choice(computed)): Deviation(ActionKind.WRONG_UNIT)} if computed else {}
        case Conduct.ROUNDED_DOWN:
            sizes = [one.id for one in plan.answered if _is_rounded_up(one)]
            return {str(rng.choice(sizes)): Deviation(ActionKind.ROUNDED_DOWN)} if sizes else {}
        case _:
            return {}


def _is_rounded_up(quantity: Quantity) -> bool:
    """Tell whether a size may not be below what is required; to the nearest may go down."""
    return quantity.choice is not None and quantity.choice.rounding is Rounding.UP


def _slips(one: _Student, count: int, rng: np.random.Generator) -> Mapping[str, Deviation]:
    kinds = slip_kinds(one.room.context.policy)
    drawn = [draw_slip(one.plan, one.ground.candidates_of, kinds, rng) for _ in range(count)]
    return {slip[0]: Deviation(ActionKind.SLIP, slip[1]) for slip in drawn if slip is not None}


def _copied(one: _Student, rng: np.random.Generator) -> Mapping[str, Deviation]:
    """Take over most of what a neighbour typed, where the two have the same quantities."""
    neighbour = work_of(one.behaviour.neighbour, one.room)
    asked = {quantity.id for quantity in one.plan.answered}
    return {
        action.quantity: Deviation(ActionKind.COPIED, copied=action.value, cell=action.typed)
        for action in neighbour.actions
        if action.quantity in asked
        and action.value is not None
        and rng.random() < one.room.mix.copied
    }


def _actions(one: _Student, drawn: _Drawn, rng: np.random.Generator) -> tuple[Action, ...]:
    tainted = _tainted(one.plan, drawn.deviations)
    leaves_blanks = one.behaviour.conduct is Conduct.BLANKS
    blank = {
        quantity.id
        for quantity in one.plan.answered
        if np.isnan(drawn.done.steps[quantity.id].typed)
        or (leaves_blanks and rng.random() < one.room.mix.blank)
    }
    return tuple(
        _blank(quantity, drawn.done)
        if quantity.id in blank
        else _action(one, quantity, drawn, tainted, rng)
        for quantity in one.plan.answered
    )


def _action(
    one: _Student,
    quantity: Quantity,
    drawn: _Drawn,
    tainted: Collection[str],
    rng: np.random.Generator,
) -> Action:
    step = drawn.done.steps[quantity.id]
    deviation = drawn.deviations.get(quantity.id)
    if deviation is None:
        done = ActionKind.FOLLOWS if quantity.id in tainted else ActionKind.RIGHT
        return _told(quantity, done, step, _cell(one, quantity, float(step.typed)))
    candidate = deviation.candidate
    twins = () if candidate is None else twins_of(one.ground, quantity.id, candidate, drawn.done)
    return replace(
        _told(quantity, deviation.done, step, _deviating_cell(one, quantity, drawn, rng)),
        slip=candidate.id if candidate is not None else None,
        kind=candidate.kind if candidate is not None else "",
        twins=twins,
    )


def _told(
    quantity: Quantity, done: ActionKind, step: WorkedStep, cell: float | str | None
) -> Action:
    return Action(quantity.id, done, None, "", (), _tidy(step.typed), _tidy(step.right), cell)


def _blank(quantity: Quantity, done: Calculation) -> Action:
    right = _tidy(done.steps[quantity.id].right)
    return Action(quantity.id, ActionKind.BLANK, None, "", (), None, right, None)


def _tidy(value: Array) -> float | None:
    """Remove what floating point adds, 63 not 63.00000000000001; None where there is no value."""
    return float(f"{float(value):.14g}") if np.isfinite(value) else None


def _cell(one: _Student, quantity: Quantity, value: float) -> float | str | None:
    return cell_of(quantity, value, one.behaviour, one.language, one.units)


def _deviating_cell(
    one: _Student, quantity: Quantity, drawn: _Drawn, rng: np.random.Generator
) -> float | str | None:
    deviation = drawn.deviations[quantity.id]
    typed = float(drawn.done.steps[quantity.id].typed)
    match deviation.done:
        case ActionKind.COPIED:
            return deviation.cell
        case ActionKind.WRONG_UNIT:
            unit = unfit_unit(quantity, one.units, rng)
            return with_unit(quantity, typed, unit or "", one.behaviour, one.language)
        case ActionKind.BARE_UNIT if one.behaviour.style is not Style.NUMBER:
            bare = replace(one.behaviour, style=Style.TEXT)
            return cell_of(quantity, typed, bare, one.language, one.units)
        case _:
            return _cell(one, quantity, typed)


def _tainted(plan: Plan, deviations: Mapping[str, Deviation]) -> frozenset[str]:
    """Return what is computed from something wrong, directly or not."""
    wrong = {name for name, deviation in deviations.items() if deviation.done in _TAINTING}
    for name in plan.quantities:
        if wrong.intersection(plan.inputs[name]):
            wrong.add(name)
    return frozenset(wrong)
