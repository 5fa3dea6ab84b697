"""How words are set in a cell of a table: lines and height of letters, mm."""

import pytest

from gripcourse.drawing.paper.text import LEADING, set_in

CELL = (21.0, 8.0)  # of a column of materials
REACH_BELOW = 0.25  # of a letter's height, how far p and y reach below their line
SMALL = 2.5  # mm, the height next to 3.5 (GOST 2.304)


@pytest.mark.parametrize("material", ["Сталь 45 улучш.", "Сталь 40Х улучш.", "Медный провод"])
def test_two_lines_are_better_than_one_in_tiny_letters(material: str) -> None:
    found = set_in(material, 3.5, CELL, most=2)
    assert len(found.lines) == 2
    assert found.height >= SMALL


def test_what_fits_into_one_line_of_somewhat_narrower_letters_stays_in_one() -> None:
    found = set_in("По расчёту", 3.5, (22.0, 8.0), most=2)
    assert (found.lines, found.height) == (("По расчёту",), 3.5)
    assert found.squeeze > 0.8


@pytest.mark.parametrize("name", ["Шевченко О. К.", "Константинопольская", "RTK-41, 2 year"])
def test_letters_of_a_low_row_are_narrowed_rather_than_made_smaller(name: str) -> None:
    """Beneath 2.5 mm the letters of a title block are hard to read: its low rows hold one line."""
    found = set_in(name, SMALL, (21.0, 5.0), most=2)
    assert (found.lines, found.height) == ((name,), SMALL)
    assert found.squeeze >= 0.55


def test_a_name_that_one_line_cannot_hold_is_not_cut() -> None:
    found = set_in("Константинопольский-Черноризский Ю. А.", SMALL, (21.0, 5.0), most=2)
    assert found.lines == ("Константинопольский-", "Черноризский Ю. А.")
    assert found.height >= 1.8  # the least of GOST 2.304: as high as letters of 7 pt in print
    assert found.squeeze > 0.75


def test_a_date_that_a_narrow_cell_cannot_hold_is_written_in_smaller_letters() -> None:
    found = set_in("24.11.2026", SMALL, (8.0, 5.0), most=1)
    assert found.lines == ("24.11.2026",)
    assert found.height < SMALL
    assert found.squeeze == pytest.approx(0.55)


@pytest.mark.parametrize(
    ("words", "room", "lines"),
    [
        ("Проєктування захватного пристрою маніпуляційного промислового робота", (48.0, 15.0), 3),
        ("Сталь 40Х поліпш.", CELL, 2),
    ],
)
def test_lines_stand_clear_of_those_of_the_cell(
    words: str, room: tuple[float, float], lines: int
) -> None:
    found = set_in(words, 3.5, room, lines)
    assert len(found.lines) == lines
    high = found.height * (1.0 + LEADING * (lines - 1) + REACH_BELOW)
    assert room[1] - high > 2 * 0.5  # half a line above and below, and as much free


def test_sizes_are_broken_between_each_other_only() -> None:
    sizes = "l = 240; mз = 3,15; z2 = 50; R = 78,75; hГ = 16; hВ = 22; b = 14"
    found = set_in(sizes, 3.5, (79.0, 8.0), 2, between="; ")
    assert len(found.lines) == 2
    assert found.lines[0].endswith(";")
    assert " ".join(found.lines) == sizes
