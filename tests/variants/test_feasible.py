"""What makes a variant impossible is named once, at its cause."""

from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Rounding
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Formula
from gripcourse.solver.plan import Plan, default_options, make_plan, usual_values
from gripcourse.text.words import LANGUAGES, Texts, Words
from gripcourse.variants.constraint import Constraint
from gripcourse.variants.explain import in_short, why_infeasible
from gripcourse.variants.feasible import RefusalCause, reasons_infeasible

SOUND = {
    "mass": 60.0,
    "acceleration": 5.0,
    "friction": 0.15,
    "pressure": 10.0,
    "teeth": 17.0,
    "form_factor": 4.26,
    "arm": 100.0,
    "travel": 50.0,
}


@pytest.fixture
def plan(small_course: Course) -> Plan:
    return make_plan(small_course, "press", {"fluid": "oil"})


def test_a_sound_variant_has_no_reason(plan: Plan) -> None:
    assert why_infeasible(plan, SOUND) == ()


@pytest.mark.parametrize(
    ("change", "cause", "quantity", "said"),
    [
        ({"travel": 150.0}, RefusalCause.NO_VALUE, "angle", "travel = 150 mm; arm = 100 mm"),
        ({"friction": 0.0}, RefusalCause.NO_VALUE, "force", "friction = 0"),
        ({"friction": 1.5}, RefusalCause.BOUNDS, "friction", "between 0 and 1"),
        ({"mass": -60.0}, RefusalCause.BOUNDS, "mass", "is −60 kg"),
        ({"teeth": 17.5}, RefusalCause.NOT_WHOLE, "teeth", "whole number, not 17.5"),
        ({"acceleration": 0.0}, RefusalCause.BOUNDS, "force", "force"),
        ({"pressure": 16.0}, RefusalCause.VERDICT, "pressure_holds", "pressure = 16 MPa"),
        ({"mass": 5000.0, "pressure": 1.0, "friction": 0.01}, RefusalCause.NO_VALUE, "bore", "mm"),
    ],
)
def test_the_reason_names_quantity_and_values(
    plan: Plan, change: dict[str, float], cause: RefusalCause, quantity: str, said: str
) -> None:
    given = SOUND | change
    arrays = {id_: np.array([value]) for id_, value in given.items()}
    reasons = list(reasons_infeasible(plan, arrays).refused)
    assert (cause, quantity) in [(reason.cause, reason.quantity) for reason in reasons]
    sentences = [str(sentence) for sentence in why_infeasible(plan, given)]
    assert any(said in sentence for sentence in sentences), sentences


def test_a_verdict_that_may_come_out_either_way_refuses_nothing(plan: Plan) -> None:
    over = SOUND | {"pressure": 16.0}
    asked = replace(plan.quantities["pressure_holds"], must_hold=False)
    open_plan = replace(plan, quantities={**plan.quantities, asked.id: asked})
    assert why_infeasible(open_plan, over) == ()
    assert why_infeasible(plan, over) != ()


def test_a_size_far_past_the_last_of_its_series_is_not_its_nearest(plan: Plan) -> None:
    bore = plan.quantities["bore"]
    assert bore.choice is not None
    nearest = replace(bore, choice=replace(bore.choice, rounding=Rounding.NEAREST))
    near = replace(plan, quantities={**plan.quantities, bore.id: nearest})
    heavy = SOUND | {"mass": 5000.0, "pressure": 1.0, "friction": 0.01}
    assert why_infeasible(near, SOUND | {"pressure": 1.0}) == ()
    (reason,) = reasons_infeasible(near, {k: np.array([v]) for k, v in heavy.items()}).refused
    assert (reason.cause, reason.quantity) == (RefusalCause.NO_VALUE, "bore")


def test_what_follows_from_a_missing_value_is_not_named_again(plan: Plan) -> None:
    reasons = reasons_infeasible(
        plan, {k: np.array([v]) for k, v in (SOUND | {"friction": 0.0}).items()}
    )
    assert [reason.quantity for reason in reasons.refused] == ["force"]


def test_a_missing_given_is_named(plan: Plan) -> None:
    given = {id_: value for id_, value in SOUND.items() if id_ != "mass"}
    assert [str(one) for one in why_infeasible(plan, given)] == [
        "mass of the object (mass) has no value."
    ]


def test_a_constraint_is_told_with_its_values(plan: Plan) -> None:
    text = "mass <= 50"
    constraint = Constraint(Formula(text, parse(text), {"mass": "kg"}))
    (sentence,) = why_infeasible(plan, SOUND, [constraint])
    assert str(sentence) == "mass <= 50 does not hold, where mass = 60 kg."
    titled = replace(constraint, title=Texts(dict.fromkeys(LANGUAGES, "objects are light")))
    (sentence,) = why_infeasible(plan, SOUND, [titled])
    assert str(sentence) == (
        "Not so: objects are light. mass <= 50 does not hold, where mass = 60 kg."
    )
    heavy = {id_: np.array([value]) for id_, value in SOUND.items()}
    (reason,) = reasons_infeasible(plan, heavy, [titled]).refused
    assert str(in_short(plan, reason)) == "not so: objects are light"


def test_candidates_of_a_batch_are_judged_one_by_one(plan: Plan) -> None:
    arrays = {id_: np.full(3, value) for id_, value in SOUND.items()}
    arrays["travel"] = np.array([50.0, 150.0, 60.0])
    feasibility = reasons_infeasible(plan, arrays)
    assert feasibility.feasible.tolist() == [True, False, True]
    (reason,) = feasibility.refused
    assert str(in_short(plan, reason)) == "angle (angle) has no value"


def test_a_reason_is_told_in_the_readers_language(plan: Plan) -> None:
    (sentence,) = why_infeasible(plan, SOUND | {"mass": -60.5, "acceleration": 0.001})[:1]
    assert "масса объекта" in Words("ru").say(sentence)
    assert "−60,5 кг" in Words("ru").say(sentence)


def test_choices_that_do_not_go_together_and_angles_that_differ_are_refused(
    reference_course: Course,
) -> None:
    scheme = reference_course.schemes["screw"]
    usual = {**default_options(scheme), "grip_model": "contact", "jaw_shape": "flat"}
    plan = make_plan(reference_course, "screw", usual)
    (said,) = (one for one in why_infeasible(plan, usual_values(plan)) if "go with" in str(one))
    assert str(said).startswith("grip model: four points of contact: 'flat' of 'shape of the jaws'")
    plan = make_plan(reference_course, "screw", {**usual, "jaw_shape": "prism"})
    (first, *others) = next(rule.same for rule in scheme.rules if rule.same)
    given = {**usual_values(plan), **dict.fromkeys((first, *others), 60.0)}
    assert not any("must be one number" in str(one) for one in why_infeasible(plan, given))
    refused = [str(one) for one in why_infeasible(plan, {**given, others[-1]: 65.0})]
    assert any(f"({first})" in one and "must be one number" in one for one in refused)
