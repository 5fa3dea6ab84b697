"""Variants computed together have the values that each has alone."""

import numpy as np
import pytest

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.course.quantity import Kind
from gripcourse.solver.family import evaluate_family, families_of, family_of
from gripcourse.solver.plan import make_plan, usual_values
from gripcourse.solver.solve import evaluate, to_si


@pytest.mark.parametrize("scheme", ["wedge_slide", "prism_lever", "vacuum_cups"])
def test_a_family_computes_what_every_composition_computes(course: Course, scheme: str) -> None:
    choices = list(pair_option_sets(course.schemes[scheme]))
    plans = [make_plan(course, scheme, options) for options in choices]
    usual = [to_si(plan, usual_values(plan)) for plan in plans]
    ((rows, family),) = families_of(course, [plan.composition for plan in plans])
    assert rows.tolist() == list(range(len(plans)))
    known = {id_: np.array([one.get(id_, np.nan) for one in usual]) for id_ in set().union(*usual)}
    together = evaluate_family(family, known).values
    for place, (plan, own) in enumerate(zip(plans, usual, strict=True)):
        alone = evaluate(plan, own).values
        assert {
            one.quantity.id for one in family.members if place in np.arange(len(rows))[one.at]
        } == plan.quantities.keys()
        for id_, value in alone.items():
            assert together[id_][place] == pytest.approx(float(value), rel=1e-12, nan_ok=True)


def test_a_declaration_that_compositions_share_is_a_member_once(course: Course) -> None:
    choices = pair_option_sets(course.schemes["screw"])
    ((_, family),) = families_of(course, [Composition.of("screw", one) for one in choices])
    assert len({id(one.quantity) for one in family.members}) == len(family.members)
    assert len(family.compositions) > 10


def test_a_family_of_some_variants_keeps_their_declarations(course: Course) -> None:
    choices = [Composition.of("screw", one) for one in pair_option_sets(course.schemes["screw"])]
    ((_, family),) = families_of(course, choices)
    few = family.restricted(np.array([1, 4]))
    for place, at in enumerate((1, 4)):
        assert few.plan(place).composition == family.plan(at).composition
        assert {one.quantity.id for one in few.givens if place in np.arange(2)[one.at]} == {
            one.id for one in family.plan(at).givens
        }


def test_a_single_composition_is_a_family(course: Course) -> None:
    plan = make_plan(
        course, "electromagnet", next(pair_option_sets(course.schemes["electromagnet"]))
    )
    family = family_of(plan, 2)
    assert [one.quantity for one in family.givens] == [
        one for one in plan.quantities.values() if one.kind is Kind.GIVEN
    ]
    known = {id_: np.full(2, value) for id_, value in to_si(plan, usual_values(plan)).items()}
    assert evaluate_family(family, known).values["mass"].shape == (2,)
