"""Of two mistakes with one number that one is named which another answer of the work shows."""

from dataclasses import replace
from math import radians, tan
from typing import TYPE_CHECKING

import pytest

from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words

if TYPE_CHECKING:
    from collections.abc import Callable

    from conftest import Case
    from gripcourse.grading.model import Finding
    from gripcourse.submission.model import Answer

RATIO, LATER, PATH = "force_ratio_at_max", "force_ratio_at_min", "stroke_required"


@pytest.fixture(scope="module")
def wedge(table: "tuple[Case, ...]") -> "Case":
    """A wedge with θ + ρ = 16.493361: the tangent of so many radians is 1."""
    one = next(one for one in table if one.plan.scheme.id == "wedge_slide")
    given = {**one.given, "wedge_angle": 13.343361, "friction_angle": 3.15}
    assert tan(given["wedge_angle"] + given["friction_angle"]) == pytest.approx(1, 1e-6)
    variant = replace(one.issued.variant, given=given)
    return replace(
        one, issued=replace(one.issued, variant=variant), reference=solve_variant(one.plan, given)
    )


def mistaken(
    wedge: "Case", typed: "Callable[..., Answer]", **values: float
) -> "tuple[str, dict[str, Finding]]":
    """Hand in a work with i = 2 at both ends, and what else is wrong; return what is said of i."""
    answers = wedge.following(**{RATIO: 2.0, LATER: 2.0}, **values)
    wrong = {RATIO: 2.0, LATER: 2.0, **values}
    found = wedge.findings(
        {**answers, **{name: typed(name, value, 5) for name, value in wrong.items()}}
    )
    return Words("en").say(found[RATIO].message), found


def test_alone_both_are_said(wedge: "Case", typed: "Callable[..., Answer]") -> None:
    said, _ = mistaken(wedge, typed)
    assert said.startswith("One of two known slips.")
    assert "tan(θ + ρ)" in said
    assert "Degrees and radians" in said


def test_degrees_for_radians_in_another_step_decide(
    wedge: "Case", typed: "Callable[..., Answer]"
) -> None:
    by_radians = wedge.reference["jaw_travel"] / tan(wedge.given["wedge_angle"])
    said, found = mistaken(wedge, typed, **{PATH: by_radians})
    assert said == "A known slip: Degrees and radians were mixed up: check the angle mode."
    assert found[PATH].roots == (RATIO,)  # it has cost there


def test_another_mistake_elsewhere_decides_nothing(
    wedge: "Case", typed: "Callable[..., Answer]"
) -> None:
    upside_down = wedge.reference["jaw_travel"] * tan(radians(wedge.given["wedge_angle"]))
    said, found = mistaken(wedge, typed, **{PATH: upside_down})
    assert found[PATH].slip
    assert said.startswith("One of two known slips.")
