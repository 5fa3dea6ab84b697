"""What stands in a cell is read back as the number that was meant."""

from collections.abc import Mapping

import numpy as np
import pytest

from gripcourse.course.quantity import Kind
from gripcourse.simulation.arithmetic import DigitRounding, written
from gripcourse.simulation.cells import cell_of, unfit_unit, with_unit
from gripcourse.simulation.model import Behaviour, Carrying, Conduct, Style
from gripcourse.solver.plan import Plan
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.measure import Understood
from gripcourse.submission.raw import RawCell
from gripcourse.submission.understand import understand
from gripcourse.text.units import dimension

UNITS = ("mm", "m", "N", "kN", "kgf", "Pa", "MPa", "N*m", "deg", "rad", "%", "")


def behaviour(style: Style, figures: int = 3, seed: int = 0) -> Behaviour:
    return Behaviour(
        conduct=Conduct.HONEST,
        figures=figures,
        rounding=DigitRounding.ROUND,
        carrying=Carrying.TYPED,
        style=style,
        pi=np.pi,
        constants={},
        neighbour="",
        seed=seed,
    )


@pytest.fixture
def reference(plan: Plan) -> Mapping[str, float]:
    assert plan.scheme.example is not None
    given = {one.id: plan.scheme.example.given[one.id] for one in plan.givens}
    return solve_variant(plan, given)


def read(plan: Plan, name: str, typed: float | str | None) -> Understood:
    cell = RawCell(value=typed, number_format="General", error=False, formula="", cell="")
    found = understand(plan.quantities[name], cell)
    assert isinstance(found, Understood), (name, typed)
    return found


@pytest.mark.parametrize("language", ["en", "ru", "uk"])
@pytest.mark.parametrize("style", list(Style))
def test_every_style_is_read_back(
    plan: Plan, reference: Mapping[str, float], style: Style, language: str
) -> None:
    for number, quantity in enumerate(plan.answered):
        how = behaviour(style, seed=number)
        value = reference[quantity.id]
        if quantity.kind is Kind.FORMULA:
            value = float(written(value, how.figures, cuts=False))
        found = read(plan, quantity.id, cell_of(quantity, value, how, language, UNITS))
        assert found.unit_fits
        assert found.value == pytest.approx(value, rel=1e-9), quantity.id


def test_text_has_comma_and_groups(plan: Plan) -> None:
    quantity = plan.quantities["drive_force"]
    how = behaviour(Style.TEXT, figures=6)
    assert cell_of(quantity, 12345.6, how, "ru", UNITS) == "12\u00a0345,6"
    assert cell_of(quantity, 1840.0, behaviour(Style.TEXT), "ru", UNITS) == "1840"
    assert cell_of(quantity, 2.5, behaviour(Style.TEXT), "uk", UNITS) == "2,50"
    assert cell_of(quantity, 2.5, behaviour(Style.TEXT), "en", UNITS) == "2.50"


def test_another_unit_is_told(plan: Plan) -> None:
    quantity = plan.quantities["drive_force"]
    found = cell_of(quantity, 1840.0, behaviour(Style.TEXT_IN_OTHER_UNIT), "ru", UNITS)
    assert found == "1,84 кН"


def test_nothing_is_typed_where_there_is_no_value(plan: Plan) -> None:
    quantity = plan.quantities["drive_force"]
    assert cell_of(quantity, float("nan"), behaviour(Style.NUMBER), "ru", UNITS) is None


def test_a_unit_that_does_not_fit_measures_something_else(plan: Plan) -> None:
    quantity = plan.quantities["drive_force"]
    rng = np.random.default_rng(1)
    for _ in range(20):
        unit = unfit_unit(quantity, UNITS, rng)
        assert unit is not None
        assert dimension(unit) != dimension("N")
        typed = with_unit(quantity, 1840.0, unit, behaviour(Style.TEXT), "ru")
        assert not read(plan, quantity.id, typed).unit_fits
