"""A wrong sign in the condition that a choice steps up by does not go unnoticed."""

from pathlib import Path

from gripcourse.course.load import load_course
from gripcourse.proofs.calculations import calculations
from gripcourse.proofs.operators import flipped_formulas, noticed_by, with_formula
from gripcourse.solver.solve import solve_variant

SPRINGS = Path(__file__).parents[1] / "support" / "spring_course"


def test_a_flipped_condition_takes_the_first_wire_which_the_example_shows() -> None:
    """With τ >= [τ] the wire of 1.6 mm, at 747.5 MPa against 740, would be taken for 1.8 mm."""
    [calculation] = calculations(load_course(SPRINGS), ())
    [flipped] = [one for one in flipped_formulas(calculation.plan) if one.steps_up]
    assert (flipped.quantity.id, flipped.operator) == ("wire", "<=")
    assert solve_variant(with_formula(calculation.plan, flipped), calculation.known)["wire"] == 1.6
    assert noticed_by(calculation, [flipped]) == (True,)
