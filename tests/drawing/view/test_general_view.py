"""What a general view says, in which language, and the file that it is."""

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import replace
from io import BytesIO
from typing import TYPE_CHECKING

import pytest
from ezdxf import recover

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.drawing.paper.document import dxf_bytes
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.title_block import TitleBlock
from gripcourse.drawing.view.general_view import general_view, sheet_svg
from gripcourse.text.words import Words
from support.drawn_texts import parsed, written
from support.each import each

if TYPE_CHECKING:
    from conftest import Draw


def test_every_scheme_has_a_general_view(course: Course) -> None:
    assert {name for name, scheme in course.schemes.items() if scheme.view is None} == set()


@each("small_variants", "small_variant")
def test_the_list_of_parts_has_a_row_for_every_position(draw: "Draw", small_variant: str) -> None:
    view = draw(small_variant).view
    assert [row.number for row in view.rows] == [str(n + 1) for n in range(len(view.rows))]
    shown = [one for face in view.faces.values() for one in face.leaders]
    assert {row.number for row in view.rows} <= {one.note.text for one in shown}
    assert len({row.title for row in view.rows}) == len(view.rows)


@each("small_variants", "small_variant")
def test_a_file_of_a_drawing_is_sound(
    draw: "Draw", small_variant: str, other_language: Callable[[str], str]
) -> None:
    """Every scheme in one language, every language in some schemes."""
    is_third = int(small_variant) % 3 == 0
    drawn = draw(small_variant, "ru" if is_third else other_language(small_variant))
    document, audit = recover.read(BytesIO(dxf_bytes(drawn.view.document)))
    assert not audit.errors
    assert not audit.fixes
    assert not document.audit().errors
    figure = drawn.view.figure
    asked = len(figure.measured) + len(figure.overall)
    asked += sum(len(one.dimensions) for one in drawn.view.details)
    assert len(document.modelspace().query("DIMENSION")) == asked


@pytest.mark.parametrize("in_russian", [True, False])
@each("small_variants", "small_variant")
def test_a_drawing_speaks_its_language(
    draw: "Draw", small_variant: str, other_language: Callable[[str], str], *, in_russian: bool
) -> None:
    """Every scheme in Russian, and in one of the other languages."""
    language = "ru" if in_russian else other_language(small_variant)
    drawn = draw(small_variant, language)
    words = Words(language)
    said = " ".join(written(drawn))  # a long title stands in two lines
    assert [row.title for row in drawn.view.rows if row.title not in said] == []
    sign = "." if language == "en" else ","
    other = "," if sign == "." else "."
    numbers = [text for text in written(drawn) if re.fullmatch(r"Ø?\d+[.,]\d", text)]
    assert not [text for text in numbers if other in text], words.language


@each("small_variants", "small_variant")
def test_a_drawing_fits_into_a_report(draw: "Draw", small_variant: str) -> None:
    drawn = draw(small_variant)
    assert len(ET.tostring(parsed(drawn))) < 60_000


def test_a_drawing_is_the_same_each_time(draw: "Draw") -> None:
    drawn = draw("002")
    view = drawn.plan.scheme.view
    assert view is not None
    block = TitleBlock("002", "gripper", "General arrangement", "Somebody")
    twice = [
        dxf_bytes(general_view(drawn.plan, view, drawn.values, block, Words("ru")).document)
        for _ in range(2)
    ]
    assert twice[0] == twice[1]


@pytest.mark.parametrize("places", [-3, 2])
@pytest.mark.parametrize("identifier", ["009", "045", "051"])
def test_a_last_digit_that_processors_round_otherwise_changes_no_byte(
    draw: "Draw", identifier: str, places: int
) -> None:
    drawn = draw(identifier)
    view = drawn.plan.scheme.view
    assert view is not None
    block = TitleBlock(identifier, "gripper", "General arrangement", "Somebody")
    moved = {name: one + places * math.ulp(one) for name, one in drawn.values.items()}
    some, others = (
        general_view(drawn.plan, view, values, block, Words("ru"))
        for values in (drawn.values, moved)
    )
    assert dxf_bytes(some.document) == dxf_bytes(others.document)
    assert sheet_svg(some, block) == sheet_svg(others, block)


def test_every_characteristic_that_a_view_names_is_printed(draw: "Draw") -> None:
    drawn = draw("001")
    assert drawn.plan.scheme.view is not None
    many = tuple(one.id for one in drawn.plan.answered if one.kind is Kind.FORMULA)[:9]
    view = replace(drawn.plan.scheme.view, characteristics=many)
    block = TitleBlock("001", "x", "x", "")
    notes = general_view(drawn.plan, view, drawn.values, block, Words("en")).notes
    assert len(notes[0].lines) == len(many)


@pytest.mark.parametrize("declares", [True, False])
def test_what_an_asterisk_means_is_said_once(draw: "Draw", *, declares: bool) -> None:
    """By the course's own requirement, else by the program."""
    plan, values = draw("001").plan, draw("001").values
    assert plan.scheme.view is not None
    view = plan.scheme.view if declares else replace(plan.scheme.view, requirements=())
    drawn = general_view(plan, view, values, TitleBlock("001", "x", "x", ""), Words("ru"))
    svg = svg_text(drawn.document, drawn.arranged.sheet.width, drawn.arranged.sheet.height, "x")
    assert svg.count("* Размеры для справок.") == 1
    assert "Технические требования" in svg
