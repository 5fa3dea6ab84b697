"""Whoever is told to read a table finds it on the sheet or in the workbook."""

import re
from collections.abc import Iterator

import numpy as np

from gripcourse.course.columns_read import columns_read
from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.formula.hertz import crossed_cylinders
from gripcourse.text.words import LANGUAGES, Texts

TABLE = re.compile(r"\btables?\b", re.IGNORECASE)
NUMBERED = re.compile(
    r"\b(?:tables?|figures?|fig\.|appendix|табл\w*|рис\w*|приложени\w*|додат\w*)\s+\d+",
    re.IGNORECASE,
)
OF_A_WORK = re.compile(
    r"guide|paper|textbook|GOST|ISO|пособи|стать|учебник|ГОСТ|посібник|статт|підручник"
)


def test_who_is_told_to_read_a_table_has_it_at_hand(course: Course) -> None:
    assert [
        (one.id, text.of("en"))
        for one in course.declarations()
        for text in texts_of(one)
        if TABLE.search(text.of("en")) and not columns_read(one, one.formula)
    ] == []


def test_a_table_or_figure_that_is_told_by_number_is_told_with_its_work(course: Course) -> None:
    texts = [text for one in course.declarations() for text in texts_of(one)]
    texts += [one.task for one in (*course.sections, *course.schemes.values())]
    said = [text.of(language) for text in texts for language in LANGUAGES]
    assert [one for one in said if NUMBERED.search(one) and not OF_A_WORK.search(one)] == []


def test_the_table_of_crossed_cylinders_gives_what_its_formula_gives(course: Course) -> None:
    table = course.catalogues["crossed_factor"].columns
    ratios = np.linspace(table["ratio"][0], 1, 500)
    read = np.interp(ratios, table["ratio"], table["factor"])
    assert np.allclose(read, crossed_cylinders(ratios), rtol=0.015)


def texts_of(one: Quantity) -> Iterator[Texts]:
    """Yield what a student may read of a quantity, without its source."""
    told = (one.title, one.explain, one.decides, one.one_end)
    yield from (text for text in told if text is not None)
    if one.note_decides and one.source.note is not None:
        yield one.source.note
    yield from (slip.hint for slip in one.slips)
    yield from (other.remark for other in one.alternatives)
