"""A spring is as wide as its author says, and has so many coils."""

import pytest

from gripcourse.course.diagram import Element
from gripcourse.drawing.diagram.gears import spring
from gripcourse.drawing.diagram.marks import Path
from gripcourse.drawing.diagram.places import PlacedElement

LYING = {"through": ((0.0, 0.0), (60.0, 0.0))}


@pytest.mark.parametrize(
    ("lengths", "coils", "radius"),
    [({}, 4.0, 1.3), ({"diameter": 20.0}, 7.5, 10.0), ({"diameter": 9.0}, 0.2, 4.5)],
)
def test_a_spring_has_the_width_and_the_coils_of_its_declaration(
    lengths: dict[str, float], coils: float, radius: float
) -> None:
    element = Element("spring", {}, {}, {}, "", (), False, "none", {}, "", "")
    placed = PlacedElement(element, LYING, {}, lengths, {}, {"coils": coils}, "", True)
    (path,) = spring(placed)
    assert isinstance(path, Path)
    first, *bends, last = path.points
    assert (first, last) == LYING["through"]
    assert [abs(y) for _, y in bends] == pytest.approx([radius] * 2 * max(1, round(coils)))
