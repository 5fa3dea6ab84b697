import math
import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from io import BytesIO

import ezdxf
import pytest
from ezdxf import recover
from ezdxf.document import Drawing
from ezdxf.tools.text import plain_text
from hypothesis import given, settings
from hypothesis import strategies as st

from gripcourse.drawing.paper.document import (
    DIMENSION_STYLE,
    LineKind,
    dxf_bytes,
    new_document,
)
from gripcourse.drawing.paper.hatch import hatch_lines
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.text import add_text, fitted, one_line, read_text, text_width

SVG = "{http://www.w3.org/2000/svg}"
HOSTILE = (
    "x ^",
    '<b>&"',
    "%%c 5 %%",
    r"\P {x}",
    "^I",
    r"\U+0416",
    "100%%%",
    "Ø63 ±0,5 30°",
    "Їжак",
)


def hatched(document: Drawing) -> Drawing:
    hatch = document.modelspace().add_hatch(dxfattribs={"layer": LineKind.HATCH})
    hatch.set_pattern_fill("GOST", definition=[[45, (0, 0), (-1.5, 1.5), []]])
    hatch.paths.add_polyline_path([(20, 20), (60, 20), (60, 40), (20, 40)], is_closed=True)
    return document


def dimensioned(document: Drawing) -> Drawing:
    dimension = document.modelspace().add_linear_dim(
        base=(0, 50), p1=(20, 30), p2=(82.5, 30), dimstyle=DIMENSION_STYLE
    )
    dimension.render()
    return document


def read_back(content: bytes) -> Drawing:
    document, audit = recover.read(BytesIO(content))
    assert not audit.errors
    assert not audit.fixes
    return document


def parsed(svg: str) -> ET.Element:
    return ET.fromstring(svg)  # noqa: S314 - our own drawing


def test_a_document_read_back_has_no_faults_and_all_layers() -> None:
    document = read_back(dxf_bytes(dimensioned(hatched(new_document("ru")))))
    assert {str(kind) for kind in LineKind} <= {layer.dxf.name for layer in document.layers}
    assert document.units == ezdxf.units.MM


@pytest.mark.parametrize("kind", [LineKind.CENTRE, LineKind.HIDDEN, LineKind.PHANTOM])
def test_broken_lines_are_long_enough_to_be_seen_as_broken(kind: LineKind) -> None:
    document = new_document("en")
    linetype = document.layers.get(kind).dxf.linetype
    strokes = document.linetypes.get(linetype).simplified_line_pattern()
    assert max(strokes) >= 2  # mm, GOST 2.303
    assert len(strokes) % 2 == 0


@pytest.mark.parametrize(("language", "written"), [("ru", "62,5"), ("uk", "62,5"), ("en", "62.5")])
def test_a_dimension_is_written_as_the_language_writes_numbers(language: str, written: str) -> None:
    svg = svg_text(dimensioned(new_document(language)), 100, 60, "")
    assert f">{written}<" in svg


@pytest.mark.parametrize("text", HOSTILE)
def test_any_text_is_shown_as_it_was_typed(text: str) -> None:
    document = new_document("ru")
    add_text(document.modelspace(), text, (10, 10), 3.5)
    svg = parsed(svg_text(document, 100, 60, text))
    assert [one.text for one in svg.iter(f"{SVG}text")] == [text]
    assert svg.findtext(f"{SVG}title") == text
    [read] = read_back(dxf_bytes(document)).modelspace().query("TEXT")
    assert read_text(read).replace("Ж", r"\U+0416") == text


@settings(max_examples=25)
@given(st.text(st.one_of(st.sampled_from("%^\\{}PpUuMm+0416cdo;~\n\t "), st.characters())))
def test_whatever_was_typed_is_read_back_from_the_file(text: str) -> None:
    document = new_document("uk")
    add_text(document.modelspace(), text, (10, 10), 3.5)
    [read] = read_back(dxf_bytes(document)).modelspace().query("TEXT")
    # The reading library drops a caret at the very end; other programs show it.
    assert plain_text(read.dxf.text) == one_line(text).rstrip("^")


def test_line_breaks_and_control_signs_become_spaces() -> None:
    document = new_document("ru")
    entity = add_text(document.modelspace(), "a\r\nb\tc\x00d\ud800", (0, 0), 3.5)
    assert read_text(entity) == "a b c d"


def test_a_long_line_is_squeezed_and_then_cut() -> None:
    text = "general view of the gripper"
    whole = text_width(text, 5)
    assert fitted(text, 5, 1.06 * whole) == (text, 1.0)
    line, squeeze = fitted(text, 5, 0.8 * whole)
    assert (line, 0.75 < squeeze < 0.8) == (text, True)
    cut, squeeze = fitted(text, 5, 0.2 * whole)
    assert cut.endswith("…")
    assert text_width(cut, 5) * squeeze <= 0.2 * whole


def test_lines_in_the_picture_are_as_wide_as_on_paper() -> None:
    document = new_document("en")
    for kind in (LineKind.OUTLINE, LineKind.THIN):
        document.modelspace().add_line((0, 0), (10, 10), dxfattribs={"layer": kind})
    svg = parsed(svg_text(document, 210, 297, ""))
    assert [one.get("stroke-width") for one in svg.iter(f"{SVG}path")] == ["0.5", "0.18"]
    assert svg.get("width") == "210mm"
    assert svg.get("viewBox") == "0 0 210 297"


def test_two_pictures_may_stand_on_one_page() -> None:
    svg = parsed(svg_text(dimensioned(hatched(new_document("en"))), 99, 9, "x"))
    assert not [one for one in svg.iter() if one.get("id") or one.get("class")]


def test_every_kind_of_curve_is_drawn() -> None:
    document = new_document("en")
    space = document.modelspace()
    look = {"layer": LineKind.OUTLINE}
    space.add_circle((10, 10), 5, dxfattribs=look)
    space.add_arc((30, 10), 5, 300, 30, dxfattribs=look)
    space.add_ellipse((50, 10), (5, 0), 0.5, dxfattribs=look)
    space.add_lwpolyline([(60, 10), (70, 10, 1), (70, 20)], format="xyb", dxfattribs=look)
    space.add_spline([(80, 10), (85, 15), (90, 10)], dxfattribs=look)
    svg = parsed(svg_text(document, 100, 30, ""))
    [path] = svg.iter(f"{SVG}path")
    assert (path.get("d") or "").count("M") == 5


def test_hatch_lines_stay_inside_and_leave_holes_free() -> None:
    square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]
    hole = [(4.0, 4.0), (6.0, 4.0), (6.0, 6.0), (4.0, 6.0)]
    level = list(hatch_lines([square, hole], 0, 5))
    assert level == [
        (pytest.approx((0, 0)), pytest.approx((10, 0))),
        (pytest.approx((0, 5)), pytest.approx((4, 5))),
        (pytest.approx((6, 5)), pytest.approx((10, 5))),
    ]
    assert list(hatch_lines([], 45, 2)) == []


def test_a_last_digit_that_processors_round_otherwise_moves_no_hatch_line() -> None:
    lozenge = [(10.0, 0.0), (20.0, 10.0), (10.0, 20.0), (0.0, 10.0)]  # its edges along the lines
    moved = [(x + 1e-12, y - 1e-12) for x, y in lozenge]
    spacing = math.sqrt(2) * 2.5
    assert list(hatch_lines([moved], 45, spacing)) == list(hatch_lines([lozenge], 45, spacing))


def test_the_same_drawing_is_the_same_bytes_in_every_process() -> None:
    program = (
        "from hashlib import sha256\n"
        "from gripcourse.drawing.paper.document import dxf_bytes, new_document\n"
        "from gripcourse.drawing.paper.svg import svg_text\n"
        "document = new_document('ru')\n"
        "space = document.modelspace()\n"
        "space.add_line((0, 0), (10, 10), dxfattribs={'layer': 'OUTLINE'})\n"
        "space.add_linear_dim((0, 9), (0, 0), (10, 0), dimstyle='GOST').render()\n"
        "svg = svg_text(document, 10, 10, 'x').encode()\n"
        "print(sha256(dxf_bytes(document) + svg).hexdigest())\n"
    )
    digests = {
        subprocess.run(  # noqa: S603 (our own interpreter)
            [sys.executable, "-c", program],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("1", "4")  # sets of the library came in another order with these
    }
    assert len(digests) == 1
