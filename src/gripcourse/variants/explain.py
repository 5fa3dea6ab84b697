"""A refusal in a sentence: the quantity, its value, and the values it came from."""

from collections.abc import Iterable, Mapping, Sequence
from functools import reduce

import numpy as np

from gripcourse.course.model import Option, Scheme
from gripcourse.course.option_rule import OptionRule
from gripcourse.course.quantity import Choice, Quantity
from gripcourse.formula.evaluate import Array
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.formula.tree import names
from gripcourse.solver.plan import Plan
from gripcourse.solver.sizes import entry, reference_rounding
from gripcourse.text.units import factor, unit_text
from gripcourse.text.words import LANGUAGES, Message, Texts, message
from gripcourse.variants.constraint import Constraint
from gripcourse.variants.feasible import Feasibility, Reason, RefusalCause, reasons_infeasible


def why_infeasible(
    plan: Plan, given: Mapping[str, float], constraints: Sequence[Constraint] = ()
) -> tuple[Message, ...]:
    """Say why one variant cannot be handed out.

    Args:
        plan: of the variant's scheme and options.
        given: its values in declared units.
        constraints: conditions that it must satisfy as well.

    Returns:
        A sentence per reason; empty for a sound variant.
    """
    arrays = {id_: np.array([value]) for id_, value in given.items()}
    feasibility = reasons_infeasible(plan, arrays, constraints)
    return tuple(explain(plan, feasibility, reason, 0) for reason in feasibility.refused)


def explain(plan: Plan, feasibility: Feasibility, reason: Reason, row: int) -> Message:
    """Say what one candidate is refused for, with its values.

    Args:
        plan: that the batch was evaluated with.
        feasibility: the judged batch.
        reason: one of its reasons.
        row: position of the candidate in the batch.
    """
    if reason.rule is not None:
        return _broken_option_rule(plan, feasibility, reason, reason.rule, row)
    quantity = plan.quantities.get(reason.quantity)
    if quantity is None or reason.formula is not None:
        return _broken_rule(plan, feasibility, reason, row)
    value = _value(plan, feasibility, quantity.id, row)
    if reason.cause is RefusalCause.NO_VALUE:
        return _no_value(plan, feasibility, quantity, row)
    if reason.cause is RefusalCause.NOT_WHOLE:
        return message("{quantity} must be a whole number, not {value}.",
                       quantity=_named(quantity), value=value)  # fmt: skip
    low, high = quantity.bounds
    return message(
        "{quantity} is {value}; it must lie between {low} and {high}.",
        quantity=_named(quantity),
        value=value,
        low=low,
        high=with_unit(high, quantity),
    )


def in_short(plan: Plan, reason: Reason) -> Message:
    """Say what candidates are refused for, without values: for counting."""
    if reason.rule is not None:
        return _rule_in_short(plan, reason, reason.rule)
    quantity = plan.quantities.get(reason.quantity)
    if quantity is None:
        return _constraint_in_short(reason)
    named = _named(quantity)
    match reason.cause:
        case RefusalCause.NO_VALUE:
            return _no_value_in_short(quantity)
        case RefusalCause.BOUNDS:
            return message("{quantity} is out of bounds", quantity=named)
        case RefusalCause.NOT_WHOLE:
            return message("{quantity} is no whole number", quantity=named)
        case _:
            return _broken_in_short(reason, named)


def _broken_in_short(reason: Reason, named: Message) -> Message:
    match reason.cause:
        case RefusalCause.CONDITION:
            return message("no size of its series will do for {quantity}", quantity=named)
        case RefusalCause.VERDICT:
            return message("the answer is no: {quantity}", quantity=named)
        case _:
            rule = reason.formula.text if reason.formula else ""
            return message("{quantity}: {rule} does not hold", quantity=named, rule=rule)


def broken_option_rule(
    scheme: Scheme, options: Mapping[str, str], rule: OptionRule, forbidden: str
) -> Message:
    """Say which choices do not go together, and why.

    Args:
        scheme: that has the options.
        options: what was chosen.
        rule: that the choices break.
        forbidden: the option whose choice it does not allow.
    """
    by_id = {option.id: option for option in scheme.options}
    chosen = (_chosen(by_id[one], options[one]) for one in rule.when)
    wrong = by_id[forbidden]
    allowed = rule.requires[forbidden]
    return message(
        "{choices}: '{choice}' of '{option}' does not go with this, only {allowed}. {note}",
        choices=list_text(chosen),
        choice=_choice(wrong, options[forbidden]),
        option=wrong.title,
        allowed=list_text(_quoted(one.title) for one in wrong.choices if one.id in allowed),
        note=rule.note,
    )


def _chosen(option: Option, choice: str) -> Message:
    return message("{option}: {choice}", option=option.title, choice=_choice(option, choice))


def _quoted(choice: Texts) -> Message:
    return message("'{choice}'", choice=choice)


def _choice(option: Option, id_: str) -> Texts:
    return next(choice.title for choice in option.choices if choice.id == id_)


def _no_value_in_short(quantity: Quantity) -> Message:
    if quantity.steps_up:
        return message("no size of its series will do for {quantity}", quantity=_named(quantity))
    if quantity.choice is not None:
        return message("{quantity} is not in the catalogue", quantity=_named(quantity))
    return message("{quantity} has no value", quantity=_named(quantity))


def _constraint_in_short(reason: Reason) -> Message:
    if reason.title is not None:
        return message("not so: {title}", title=reason.title)
    return message("{rule} does not hold", rule=reason.formula.text if reason.formula else "")


def _rule_in_short(plan: Plan, reason: Reason, rule: OptionRule) -> Message:
    if reason.cause is RefusalCause.SAME:
        return message("{names} are not one number", names=_names(plan, reason, rule))
    return broken_option_rule(plan.scheme, plan.options, rule, reason.quantity)


def _broken_option_rule(
    plan: Plan, feasibility: Feasibility, reason: Reason, rule: OptionRule, row: int
) -> Message:
    if reason.cause is not RefusalCause.SAME:
        return broken_option_rule(plan.scheme, plan.options, rule, reason.quantity)
    return message(
        "{names} must be one number, but {values}. {note}",
        names=_names(plan, reason, rule),
        values=_values(plan, feasibility, (rule.same[0], reason.quantity), row),
        note=rule.note,
    )


def _names(plan: Plan, reason: Reason, rule: OptionRule) -> Message:
    first, other = plan.quantities[rule.same[0]], plan.quantities[reason.quantity]
    return message("{first} and {other}", first=_named(first), other=_named(other))


def list_text(said: Iterable[Message]) -> Message:
    """Join messages into one, separated by semicolons."""
    return reduce(lambda left, right: message("{left}; {right}", left=left, right=right), said)


def with_unit(value: float, quantity: Quantity) -> Message:
    """Write a value, given in the declared unit, with that unit as the reader writes it."""
    if not quantity.unit:
        return message("{value}", value=value)
    units = Texts({language: unit_text(quantity.unit, language) for language in LANGUAGES})
    return message("{value} {unit}", value=value, unit=units)


def _no_value(plan: Plan, feasibility: Feasibility, quantity: Quantity, row: int) -> Message:
    inputs = plan.inputs.get(quantity.id, ())
    formula = plan.reference_formula(quantity.id)
    if quantity.choice is not None and formula is not None:
        required = evaluate_formula(
            formula, quantity.unit, feasibility.evaluation.values, plan.columns
        )
        needed = np.ravel(required)[_position(required, row)]
        return _without_size(plan, quantity, quantity.choice, needed) or message(
            "{quantity}: the catalogue {catalogue} has no entry for {required}.",
            quantity=_named(quantity),
            catalogue=quantity.choice.column,
            required=with_unit(float(needed) / factor(quantity.unit), quantity),
        )
    if not inputs:
        return message("{quantity} has no value.", quantity=_named(quantity))
    return message(
        "{quantity} has no value: {formula}, where {values}.",
        quantity=_named(quantity),
        formula=formula.text if formula else "",
        values=_values(plan, feasibility, inputs, row),
    )


def _without_size(plan: Plan, quantity: Quantity, choice: Choice, needed: Array) -> Message | None:
    """Say that no large enough size satisfies the condition; None where none is large enough."""
    first = entry(plan, choice, reference_rounding(quantity, plan.convention), needed)
    if choice.condition is None or not np.isfinite(first):
        return None
    scale, last = factor(quantity.unit), plan.columns[choice.column].sizes[-1]
    return message(
        "{quantity}: no size of {catalogue} from {first} up to the last one, {last}, satisfies "
        "{condition}.",
        quantity=_named(quantity),
        catalogue=choice.column,
        first=with_unit(float(first) / scale, quantity),
        last=with_unit(float(last) / scale, quantity),
        condition=choice.condition.text,
    )


def _broken_rule(plan: Plan, feasibility: Feasibility, reason: Reason, row: int) -> Message:
    formula = reason.formula
    if formula is None:
        return in_short(plan, reason)
    values = _values(plan, feasibility, names(formula.tree), row)
    if reason.title is not None:
        return message("Not so: {title}. {rule} does not hold, where {values}.",
                       title=reason.title, rule=formula.text, values=values)  # fmt: skip
    if not reason.quantity:
        return message("{rule} does not hold, where {values}.", rule=formula.text, values=values)
    return message(
        "{quantity}: {rule} does not hold, where {values}.",
        quantity=_named(plan.quantities[reason.quantity]),
        rule=formula.text,
        values=values,
    )


def _values(plan: Plan, feasibility: Feasibility, ids: Sequence[str], row: int) -> Message:
    return list_text(
        message("{name} = {value}", name=id_, value=_value(plan, feasibility, id_, row))
        for id_ in ids
    )


def _value(plan: Plan, feasibility: Feasibility, id_: str, row: int) -> Message:
    quantity = plan.quantities[id_]
    values = feasibility.evaluation.values[id_]
    value = float(np.ravel(values)[_position(values, row)])
    return with_unit(value / factor(quantity.unit), quantity)


def _position(values: object, row: int) -> int:
    """A value that is the same for all candidates has one entry only."""
    return row if np.size(np.asarray(values)) > 1 else 0


def _named(quantity: Quantity) -> Message:
    return message("{title} ({id})", title=quantity.title, id=quantity.id)
