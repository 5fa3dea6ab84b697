"""What a cell of a table on a sheet says, whatever it takes to fit."""

import pytest

from gripcourse.drawing.paper.cells import NORMAL, Cells, Pen
from gripcourse.drawing.paper.document import new_document
from gripcourse.drawing.paper.text import read_text

SIZES = "l = 240; m_з = 3,15; z_2 = 50; R = 78,75; h_Г = 16; h_В = 22"


@pytest.mark.parametrize("width", [200.0, 100.0, 81.0, 60.0])
def test_no_word_of_the_sizes_is_lost_in_one_line_or_two(width: float) -> None:
    space = new_document("ru").modelspace()
    Cells(Pen(space), 0.0, 0.0).symbols(SIZES, (0.0, 0.0), (width, 8.0), NORMAL, most=2)
    written = "".join(read_text(one) for one in space.query("TEXT"))
    assert "".join(written.split()) == SIZES.replace("_", "").replace(" ", "")
