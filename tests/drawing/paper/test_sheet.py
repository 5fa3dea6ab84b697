"""What stands in the title block and the parts list of a sheet, whatever it says."""

import xml.etree.ElementTree as ET
from collections.abc import Callable
from io import BytesIO
from typing import TYPE_CHECKING

import pytest
from ezdxf import recover

from gripcourse.drawing.paper.cells import NORMAL
from gripcourse.drawing.paper.document import dxf_bytes, new_document
from gripcourse.drawing.paper.sheet import A3, Notes, block_box, draw_notes, draw_sheet, note_lines
from gripcourse.drawing.paper.strokes import Box, box_of
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.text import READ_WELL, Point, read_text, text_width
from gripcourse.drawing.paper.title_block import TitleBlock
from gripcourse.text.words import Words, message
from support.each import each

if TYPE_CHECKING:
    from ezdxf.entities.text import Text

    from conftest import Draw

LEAST = 2.5  # mm, letters of GOST 2.304 that a title block is read by
SVG = "{http://www.w3.org/2000/svg}"


@pytest.mark.parametrize("in_russian", [True, False])
@each("small_variants", "small_variant")
def test_no_text_of_a_sheet_leaves_its_cell(
    draw: "Draw", small_variant: str, other_language: Callable[[str], str], *, in_russian: bool
) -> None:
    """The names on it are as long as names are: of sixty letters and more.

    Every scheme in Russian, and in one of the other languages.
    """
    made = draw(small_variant, "ru" if in_russian else other_language(small_variant)).view
    sheet = made.arranged.sheet
    table = block_box(sheet, len(made.rows))
    space = made.document.modelspace()
    around = table.grown(1e-6)
    lines = [
        box_of([(one.dxf.start.x, one.dxf.start.y), (one.dxf.end.x, one.dxf.end.y)])
        for one in space.query("LINE")
    ]
    grid = [one for one in lines if around.joined(one) == around]
    texts = [one for one in space.query("TEXT") if table.overlaps(box_of([point_of(one)]))]
    assert len(texts) > 20
    for one in texts:
        box = box_of_text(one)
        assert table.joined(box) == table, read_text(one)
        assert not [line for line in grid if line.overlaps(box)], read_text(one)
    # The name of who drew it stands in full beside the cell that is too narrow for it.
    said = [read_text(one) for one in texts]
    (cut,) = (one.rstrip("…") for one in said if "…" in one)
    whole = " ".join(one for one in said if "…" not in one).replace("- ", "-")
    assert whole.count(cut) == len(["drawn", "checked"])


@pytest.mark.parametrize("name", ['<b>&"', "%%c", r"\P{x}", "{", "^J", "Їжаченко-Шульга О. О."])
def test_any_student_can_be_written_into_the_title_block(name: str) -> None:
    block = TitleBlock("011 GA", "gripper", "General arrangement", student=name)
    made = new_document("uk")
    draw_sheet(made.modelspace(), A3, block, "1:1", Words("uk"))
    svg = svg_text(made, A3.width, A3.height, name)
    texts = [one.text for one in ET.fromstring(svg).iter(f"{SVG}text")]  # noqa: S314 - our own drawing
    assert name in texts
    document, audit = recover.read(BytesIO(dxf_bytes(made)))
    assert not audit.errors
    assert name in [read_text(one) for one in document.modelspace().query("TEXT")]


@pytest.mark.parametrize(
    "name", ["Иванова Анна Петровна", "Шевченко Оксана Костянтинівна", "Їжак Юрій Ґедзьович"]
)
def test_the_name_of_who_drew_it_stands_in_one_line_of_letters_of_the_standard(name: str) -> None:
    block = TitleBlock("011 GA", "gripper", "General arrangement", student=name)
    made = new_document("uk")
    draw_sheet(made.modelspace(), A3, block, "1:1", Words("uk"))
    surname, *_ = name.split()
    texts = {read_text(one): one for one in made.modelspace().query("TEXT")}
    (written,) = (one for text, one in texts.items() if text.startswith(surname))
    assert written.dxf.height >= LEAST
    assert written.dxf.width >= READ_WELL
    assert not [text for text in texts if text in name.split()[1:]]


@pytest.mark.parametrize(
    ("language", "name"),
    [
        ("en", "A3"),
        ("ru", "\N{CYRILLIC CAPITAL LETTER A}3"),
        ("uk", "\N{CYRILLIC CAPITAL LETTER A}3"),
    ],
)
def test_the_format_is_named_in_letters_that_its_reader_types(language: str, name: str) -> None:
    """GOST 2.301 names it so; who searches a Russian document for it types Cyrillic letters."""
    made = new_document(language)
    draw_sheet(made.modelspace(), A3, TitleBlock("", "", "", ""), "1:1", Words(language))
    assert [text for text in map(read_text, made.query("TEXT")) if text.split()[1:] == [name]]


def point_of(one: "Text") -> Point:
    at = one.dxf.get("align_point", one.dxf.insert)
    return at.x, at.y


def box_of_text(one: "Text") -> Box:
    """The box round capital letters of a line that is held half way up."""
    half = one.dxf.height / 2
    width = text_width(read_text(one), one.dxf.height) * one.dxf.width
    x, y = point_of(one)
    left = {"MIDDLE_LEFT": x, "MIDDLE_CENTER": x - width / 2}[one.get_align_enum().name]
    return Box(left, y - half, left + width, y + half)


def test_a_note_that_is_too_long_goes_on_in_the_next_line_in_letters_of_the_same_height() -> None:
    long = "Сердечники и ярма из отожжённой стали; торцы полюсов обработать совместно " * 3
    notes = (Notes(message("Technical requirements"), (long, "Масса расчётная.")),)
    space = new_document("ru").modelspace()
    width, height = 185.0, 6.0 * note_lines(notes)
    draw_notes(space, Box(0.0, 0.0, width, height), notes, Words("ru"))
    texts = list(space.query("TEXT"))
    assert {(one.dxf.height, one.dxf.width) for one in texts} == {(NORMAL, 1.0)}
    assert len(texts) == note_lines(notes) > 4
    boxes = [box_of_text(one) for one in texts]
    assert not [one for one in boxes if one.left < 0 or one.right > width or one.bottom < 0]
    said = " ".join(read_text(one) for one in texts)
    assert " ".join(f"1. {long} 2. Масса расчётная.".split()) in said


@pytest.mark.parametrize(
    ("name", "written"),
    [
        ("Голенищев-Кутузов Александр Константинович", "Голенищев-Кутузов"),
        ("Северин-Мрачковський Володимир-Станіслав Костянтинович", "Северин-Мрачковський"),
        ("Alexandra-Wilhelmina Featherstonehaugh-Cholmondeley", "Alexandra-Wilhelmina F…"),
    ],
)
@pytest.mark.parametrize(
    "school", ["", "Кафедра конструювання верстатів, інструментів та робототехнічних систем"]
)
def test_letters_of_a_long_name_are_as_high_as_the_standard_asks(
    name: str, written: str, school: str
) -> None:
    block = TitleBlock("011 GA", "gripper", "GA", student=name, organisation=school)
    made = new_document("uk")
    draw_sheet(made.modelspace(), A3, block, "1:1", Words("uk"))
    texts = list(made.modelspace().query("TEXT"))
    assert min(one.dxf.height for one in texts) >= LEAST
    assert written in map(read_text, texts)
    assert name in " ".join(map(read_text, texts)).replace("- ", "-")


def test_what_is_shortened_by_initials_is_not_written_twice() -> None:
    block = TitleBlock("011 GA", "", "", student="Шевченко Олександр Костянтинович")
    made = new_document("uk")
    draw_sheet(made.modelspace(), A3, block, "1:1", Words("uk"))
    assert "Олександр" not in " ".join(map(read_text, made.modelspace().query("TEXT")))
