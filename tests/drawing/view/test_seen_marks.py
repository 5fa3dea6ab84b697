"""Where the leader of a part ends, whatever lies in front of the part. Lengths in mm."""

import pytest

from gripcourse.course.view import Face
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.view.outlines import Outline
from gripcourse.drawing.view.placed_shapes import Shown
from gripcourse.drawing.view.seen_marks import seen_mark

BODY = Box(0.0, 0.0, 100.0, 100.0)
LINK = Box(30.0, -10.0, 60.0, 110.0)


def plate(box: Box, face: Face = Face.MAIN) -> Shown:
    outline = Outline((), mask=box.corners)
    return Shown(
        outline, LineKind.OUTLINE, hatch="", hidden_edges=False, face=face, ring=(), box=box
    )


def test_a_leader_moves_beside_what_covers_its_part_there() -> None:
    x, y = seen_mark((50.0, 40.0), [plate(BODY)], [plate(LINK)], 100.0)
    assert y == pytest.approx(40.0)
    assert LINK.right < x < LINK.right + 5.0


@pytest.mark.parametrize(
    ("mark", "in_front"),
    [
        ((80.0, 40.0), plate(LINK)),  # the part is seen there
        ((100.0, 40.0), plate(LINK)),  # at its edge
        ((50.0, 40.0), plate(LINK, Face.END)),  # that is another view
        ((50.0, 40.0), plate(BODY)),  # nothing is seen of it: nowhere is better
    ],
)
def test_a_leader_stays_where_it_is_declared(mark: tuple[float, float], in_front: Shown) -> None:
    assert seen_mark(mark, [plate(BODY)], [in_front], 100.0) == mark
