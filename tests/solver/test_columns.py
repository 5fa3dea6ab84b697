"""Many variants computed together come to what each comes to by itself."""

import pickle
from collections.abc import Mapping

import numpy as np
import pytest
from numpy.typing import NDArray

from gripcourse.course.model import Course
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, to_si

MANY = 40_000  # more than are computed at once
SOME = (0, 1, 16_383, 16_384, MANY - 1)

Known = Mapping[str, NDArray[np.float64]]


@pytest.fixture(scope="module", params=["prism_lever", "rack_parallelogram", "worm_sector"])
def plan(request: pytest.FixtureRequest, course: Course) -> Plan:
    example = course.schemes[request.param].example
    assert example is not None
    return make_plan(course, request.param, example.options)


@pytest.fixture(scope="module")
def known(plan: Plan) -> Known:
    example = plan.scheme.example
    assert example is not None
    draw = np.random.default_rng(5)
    own = {name: value for name, value in example.given.items() if name in plan.quantities}
    return {name: one * draw.uniform(0.7, 1.4, MANY) for name, one in to_si(plan, own).items()}


def assert_each_by_itself(plan: Plan, known: Known) -> None:
    together = evaluate(plan, known)
    for row in SOME:
        alone = evaluate(plan, {name: one[row] if one.ndim else one for name, one in known.items()})
        for all_of_them, single in (
            (together.values, alone.values), (together.computed, alone.computed)
        ):  # fmt: skip
            assert all_of_them.keys() == single.keys()
            for name, value in single.items():
                column = np.broadcast_to(all_of_them[name], (MANY,))
                assert np.array_equal(column[row], value, equal_nan=True), name


def test_together_as_each_by_itself(plan: Plan, known: Known) -> None:
    assert_each_by_itself(plan, known)


def test_an_answer_may_be_known_of_some_variants(plan: Plan, known: Known) -> None:
    computed = evaluate(plan, known).computed["grip_force"]
    own = np.where(np.arange(MANY) % 3 == 0, computed * 1.1, np.nan)
    own[1] = np.inf  # supplied, and no number
    found = evaluate(plan, {**known, "grip_force": own}).values["grip_force"]
    assert np.isnan(found[1])
    assert np.array_equal(found[::3], own[::3])
    assert np.array_equal(found[2::3], computed[2::3])
    assert_each_by_itself(plan, {**known, "grip_force": own})


def test_an_answer_may_be_the_same_of_all_variants(plan: Plan, known: Known) -> None:
    assert_each_by_itself(plan, {**known, "grip_force": np.asarray(4000.0)})


def test_what_is_the_same_of_all_variants_is_one_number(plan: Plan, known: Known) -> None:
    found = evaluate(plan, known).values
    assert found["grip_force"].shape == (MANY,)
    assert all(found[one.id].shape == () for one in plan.constants if one.id not in known)


def test_what_is_given_is_neither_changed_nor_copied(plan: Plan, known: Known) -> None:
    before = {name: one.copy() for name, one in known.items()}
    found = evaluate(plan, known).values
    assert all(found[name] is one for name, one in known.items())
    assert all(np.array_equal(one, before[name]) for name, one in known.items())


def test_a_plan_that_was_computed_can_be_sent_away(plan: Plan, known: Known) -> None:
    evaluate(plan, known)
    sent = pickle.loads(pickle.dumps(plan))  # noqa: S301 (our own)
    assert sent.composition == plan.composition
    assert sent.made == {}
