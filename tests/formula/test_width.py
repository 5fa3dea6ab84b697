"""What cannot be broken into lines fits the page: it is set smaller, as little as need be."""

import re

import pytest

from gripcourse.formula.boxes import Box, Row, Text, Value
from gripcourse.formula.markup import html
from gripcourse.formula.parse import parse
from gripcourse.formula.typeset import typeset
from gripcourse.formula.width import SMALLEST, WIDEST, scale_of, width

NUMBERS = {name: Value("123456.7", "N·m") for name in "abcdefgh"}


def size(formula: str) -> float:
    """The size in which a formula is set, as a share of the text's."""
    found = re.match(r'<span class="formula" style="font-size: ([\d.]+)em">', html(set_(formula)))
    return 1.0 if found is None else float(found[1])


def set_(formula: str) -> Box:
    return typeset(parse(formula), NUMBERS)


@pytest.mark.parametrize("formula", ["sqrt(a + b)", "a/b", "(a/b + c)*d", "a + b + c + d"])
def test_what_fits_keeps_its_size(formula: str) -> None:
    assert size(formula) == 1.0


@pytest.mark.parametrize(
    "formula",
    ["sqrt(a + b + c + d + e + f)", "(a + b + c + d + e + f)/2", "(a/b + c + d + e + f + g)*h"],
)
def test_a_long_root_fraction_or_bracket_is_set_smaller_until_it_fits(formula: str) -> None:
    assert SMALLEST <= size(formula) < 1.0


def test_a_sum_as_long_breaks_into_lines_instead() -> None:
    assert size("a + b + c + d + e + f + g + h") == 1.0


def test_a_box_grows_with_what_is_in_it() -> None:
    widths = [width(set_(one)) for one in ("a", "sqrt(a)", "sqrt(a + b)", "sqrt(a + b)/2")]
    assert widths == sorted(widths)


def test_nothing_is_set_smaller_than_can_be_read() -> None:
    assert scale_of(Row((Text("upright", "m" * 1000),))) == SMALLEST
    assert scale_of(Text("upright", "m" * int(WIDEST))) == 1.0
