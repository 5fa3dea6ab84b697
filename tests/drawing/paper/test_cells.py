"""What a cell of a table on a sheet says, whatever it takes to fit."""

import pytest

from gripcourse.drawing.paper.cells import NORMAL, Cells, Pen
from gripcourse.drawing.paper.document import new_document
from gripcourse.drawing.paper.text import read_text, text_width

SIZES = "l = 240; m_з = 3,15; z_2 = 50; R = 78,75; h_Г = 16; h_В = 22"


@pytest.mark.parametrize("width", [200.0, 100.0, 81.0, 60.0])
def test_no_word_of_the_sizes_is_lost_in_one_line_or_two(width: float) -> None:
    space = new_document("ru").modelspace()
    Cells(Pen(space), 0.0, 0.0).symbols(SIZES, (0.0, 0.0), (width, 8.0), NORMAL, most=2)
    written = "".join(read_text(one) for one in space.query("TEXT"))
    assert "".join(written.split()) == SIZES.replace("_", "").replace(" ", "")


def test_a_letter_stands_by_itself_beside_what_stands_under_it() -> None:
    """So no program that draws `3,15` closer together moves it away from there."""
    space = new_document("ru").modelspace()
    Cells(Pen(space), 0.0, 0.0).symbols(SIZES, (0.0, 0.0), (200.0, 8.0), NORMAL, most=1)
    runs = [(read_text(one), one.dxf.insert.x) for one in space.query("TEXT")]
    for letter, under in (("m", "з"), ("z", "2"), ("h", "Г"), ("h", "В")):
        number = next(n for n, (text, _) in enumerate(runs) if text == under)
        assert runs[number - 1][0] == letter
        assert runs[number][1] - runs[number - 1][1] == pytest.approx(text_width(letter, NORMAL))
