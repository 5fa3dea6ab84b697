"""The sizes that a general view tells are those of the solution, in several variants of each."""

from typing import TYPE_CHECKING

import pytest

from gripcourse.course.quantity import Kind
from gripcourse.course.view import Face, Side
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Stroke, outside
from gripcourse.drawing.paper.text import Point
from gripcourse.drawing.view.extension_lines import reach
from gripcourse.drawing.view.lengths import FOR_REFERENCE, length_text
from gripcourse.drawing.view.numbers import numbers_at
from gripcourse.drawing.view.placed_shapes import shown
from gripcourse.text.words import Words
from support.drawn_texts import written
from support.each import each, named_if_it_fails

if TYPE_CHECKING:
    from conftest import Draw


def test_a_dimension_measures_the_quantity_that_it_names(
    draw: "Draw", any_variants: list[str], subtests: pytest.Subtests
) -> None:
    for any_variant in any_variants:
        with named_if_it_fails(subtests, variant=any_variant):
            drawn = draw(any_variant)
            assert drawn.view.figure.measured
            scale = drawn.view.arranged.factor
            for face in drawn.view.faces.values():
                for one in face.dimensions:
                    if one.wanted.text.endswith(FOR_REFERENCE):
                        continue
                    low, high = one.wanted.span
                    measured = [
                        known.declared.quantity
                        for known in drawn.view.figure.measured
                        if abs(drawn.values[known.declared.quantity] - (high - low) / scale) < 1e-6
                    ]
                    assert measured, (
                        f"{one.wanted.text} is no quantity of any_variant {any_variant}"
                    )


@each("any_variants", "any_variant")
def test_the_numbers_of_the_drawing_are_those_of_the_solution(
    draw: "Draw", any_variant: str
) -> None:
    drawn, words = draw(any_variant), Words("ru")
    texts = written(drawn)
    for one in drawn.view.figure.measured:
        value = drawn.values[one.declared.quantity]
        if drawn.plan.quantities[one.declared.quantity].kind is Kind.FORMULA:
            value = round(value, 1)
        assert f"{one.declared.sign}{length_text(value, words)}" in texts
    for position in drawn.view.figure.positions:
        for name in position.part.sizes:
            if name in drawn.values and drawn.plan.quantities[name].unit == "mm":
                number = length_text(drawn.values[name], words)
                assert any(f"= {number}" in text for text in texts)


@each("any_variants", "any_variant")
def test_extension_lines_begin_on_something(draw: "Draw", any_variant: str) -> None:
    drawn = draw(any_variant)
    for one in drawn.view.figure.measured:
        strokes = [seen.stroke for seen in drawn.view.figure.seen[one.declared.face]]
        for point in (one.start, one.end):
            assert is_near(point, strokes), (one.declared.file, one.declared.key)


def is_near(point: Point, strokes: list[Stroke]) -> bool:
    """Tell whether a point lies on a stroke, or on the axis of what is drawn."""
    around = [
        (point[0] + x, point[1] + y)
        for x, y in ((-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2))
    ]
    return min(map(abs, point)) < 1e-6 or any(
        list(outside(one, around)) != [one] for one in strokes
    )


@each("any_variants", "any_variant")
def test_the_largest_height_covers_the_other_position_too(draw: "Draw", any_variant: str) -> None:
    drawn = draw(any_variant)
    figure, view = drawn.view.figure, drawn.plan.scheme.view
    assert view is not None
    if view.other:
        numbers = numbers_at(drawn.plan, view, drawn.values, view.other)
        moved = [
            stroke
            for part in view.parts
            if part.moves
            for one in shown(part, numbers)
            if one.face is Face.MAIN and one.kind is LineKind.OUTLINE
            for stroke in one.outline.strokes
        ]
        low, high = reach(moved, Side.RIGHT)
        known = [one.value for one in figure.measured if one.declared.side is Side.RIGHT]
        known += [one.value for one in figure.overall if one.side is Side.RIGHT]
        assert high[1] - low[1] <= max(known) + 0.2
