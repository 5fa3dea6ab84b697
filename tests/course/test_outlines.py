"""Bodies of a general view: what plain validation sees of them with the numbers of the example."""

from typing import TYPE_CHECKING

from gripcourse.proofs.calculations import calculations
from gripcourse.proofs.interference import crossed_in_example

if TYPE_CHECKING:
    from support.drafts import Draft

VIEW = "variants/schemes/rack_parallelogram/drawing.toml"
CORNERS = (
    '  ["face_x - face_half", "second_pin_y + lever_thickness/2"],\n',
    '  ["face_x - face_half", "face_y + face_3"],\n',
)


def test_an_outline_that_crosses_itself_is_told_with_its_place(draft: "Draft") -> None:
    course = draft.edit(VIEW, "".join(CORNERS), "".join(reversed(CORNERS))).load()
    example = next(calculations(course, ()))
    (problem,) = crossed_in_example(example)
    assert problem.file == VIEW
    assert str(problem.key).startswith("part[2].shape[1]")
    assert "crosses itself" in str(problem.what)
    assert "in order" in str(problem.remedy)
