"""A row is as high as the lines that its text takes, by the widths of the letters themselves."""

from pathlib import Path

import pytest
from PIL import ImageFont

from gripcourse.course.compose import compose
from gripcourse.course.model import Course
from gripcourse.course.option_sets import pair_option_sets
from gripcourse.text.words import LANGUAGES
from gripcourse.workbook.wrapping import lines_taken

# Of the widths of Arial, of which office programs make the columns: a digit is 7 dots wide.
FONT = Path("/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf")
DOTS, DIGIT, EDGES = 10 * 96 / 72, 7, 9


@pytest.fixture(scope="module")
def titles(course: Course) -> set[str]:
    composed = (
        compose(course, one, next(iter(pair_option_sets(one)))) for one in course.schemes.values()
    )
    quantities = [one for found in composed for one in found.values()]
    return {one.title.of(language) for one in quantities for language in LANGUAGES}


@pytest.mark.skipif(not FONT.exists(), reason="Debian's fonts-liberation is not installed")
@pytest.mark.parametrize("width", [40, 46, 100])
def test_no_title_takes_more_lines_than_its_row_has_room_for(titles: set[str], width: int) -> None:
    font = ImageFont.truetype(str(FONT), 1000)
    room = (width * DIGIT - EDGES) * 1000 / DOTS

    def lines(text: str) -> int:
        taken, line = 1, ""
        for word in text.split():
            if line and font.getlength(f"{line} {word}") > room:
                taken, line = taken + 1, ""
            line = f"{line} {word}".strip()
        return taken

    guessed = {one: lines_taken(one, width) for one in titles}
    assert [one for one in titles if guessed[one] < lines(one)] == []
    assert sum(guessed[one] - lines(one) for one in titles) < 0.12 * len(titles)


def test_a_word_that_is_longer_than_a_line_is_broken() -> None:
    assert lines_taken("x" * 40, 10) == 5
