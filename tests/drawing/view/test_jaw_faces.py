"""The faces of jaws in general views touch the object that they hold, as their shape is chosen."""

from typing import TYPE_CHECKING

import pytest
import shapely

from gripcourse.course.view import Face
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import points_of
from gripcourse.drawing.view.contents import figure
from gripcourse.drawing.view.numbers import numbers_at

if TYPE_CHECKING:
    from conftest import Solve

PRISMS = ("005", "024", "040", "051", "061")
OTHERS = ("010", "023", "049", "021", "011")  # concave, convex, convex, flat, crossed


def gap(solved: "Solve", identifier: str) -> tuple[float, float]:
    """The distance from the object's middle to the nearest edge of the jaws, and its radius."""
    plan, values = solved(identifier)
    radius = values["diameter_min"] / 2
    view = plan.scheme.view
    assert view is not None
    numbers = numbers_at(plan, view, values, view.position)
    middle = float(numbers.values["object_x"]) * 1000
    lines = [
        shapely.LineString(points_of(one.stroke))
        for one in figure(plan, view, values).seen[Face.MAIN]
        if one.kind is LineKind.OUTLINE
    ]
    return min(shapely.distance(shapely.Point(middle, 0), one) for one in lines), radius


@pytest.mark.parametrize("identifier", [*PRISMS, *OTHERS])
def test_the_jaws_touch_the_smallest_object(solved: "Solve", identifier: str) -> None:
    found, radius = gap(solved, identifier)
    assert found == pytest.approx(radius, rel=0.01)
