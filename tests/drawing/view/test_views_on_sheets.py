"""How the views of a gripper lie on their sheet, in several variants of each scheme."""

from itertools import combinations, product
from typing import TYPE_CHECKING

import pytest

from gripcourse.drawing.paper.sheet import FORMATS, block_box, corner_box
from gripcourse.drawing.paper.title_block import TitleBlock
from gripcourse.drawing.view.general_view import general_view
from gripcourse.drawing.view.layout import SCALES
from gripcourse.errors import CourseError
from gripcourse.text.words import Words
from support.each import each

if TYPE_CHECKING:
    from conftest import Draw

HALF, NEARLY_HALF = 0.5, 0.42  # of the free field, that all views take
BY_FACES = 0.25  # of it, that the faces take without details


@each("any_variants", "any_variant")
def test_everything_has_its_own_place_on_the_sheet(draw: "Draw", any_variant: str) -> None:
    view = draw(any_variant).view
    sheet = view.arranged.sheet
    groups = [
        [box.moved(view.arranged.origins[name]) for box in face.boxes]
        for name, face in view.faces.items()
    ]
    places = [at for _, (_, at) in sorted(view.arranged.details.items())]
    groups += [[one.box.moved(at)] for one, at in zip(view.details, places, strict=True)]
    tables = (block_box(sheet, len(view.rows)), corner_box(sheet), view.arranged.lines)
    groups += [[one] for one in tables]
    for first, second in combinations(groups, 2):
        pairs = product(first, second)
        assert not [pair for pair in pairs if pair[0].overlaps(pair[1])]
    boxes = [box for group in groups for box in group]
    assert not [one for one in boxes if sheet.frame.joined(one) != sheet.frame]


def test_the_views_take_half_of_what_tables_and_notes_leave_free(
    draw: "Draw", any_variants: list[str]
) -> None:
    """Of twenty variants at most one less: between two scales and two sheets there are gaps."""
    arranged = [draw(one).view.arranged for one in any_variants]
    assert sum(one.filled >= HALF for one in arranged) >= 0.95 * len(arranged)
    assert min(one.filled for one in arranged) >= NEARLY_HALF
    assert min(one.by_faces for one in arranged) >= BY_FACES


@each("any_variants", "any_variant")
def test_a_gripper_is_drawn_at_a_standard_scale_on_a_standard_sheet(
    draw: "Draw", any_variant: str
) -> None:
    arranged = draw(any_variant).view.arranged
    assert any(arranged.sheet in one for one in FORMATS)
    assert arranged.scale in SCALES


def test_views_that_no_sheet_has_room_for_are_named_with_file_and_key(draw: "Draw") -> None:
    drawn = draw("008")
    view = drawn.plan.scheme.view
    assert view is not None
    huge = {**drawn.values, "flange_diameter": 1e7}
    block = TitleBlock("008", "gripper", "General arrangement", "Somebody")
    with pytest.raises(CourseError) as caught:
        general_view(drawn.plan, view, huge, block, Words("en"))
    (problem,) = caught.value.problems
    assert problem.file.endswith("flange.toml")
    assert problem.key == "part[1]"
    assert "A2" in str(problem.what)
