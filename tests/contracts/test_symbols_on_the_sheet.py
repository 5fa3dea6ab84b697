"""Whoever has the printed sheet knows what every symbol on it stands for, and needs every given."""

from typing import TYPE_CHECKING

import pytest

from gripcourse.text.words import LANGUAGES, Words
from support.each import each
from support.sheet_symbols import beside_answers, idle_givens, undefined_symbols

if TYPE_CHECKING:
    from conftest import Composition


@pytest.mark.parametrize("language", LANGUAGES)
@each("compositions", "composition")
def test_every_symbol_on_a_sheet_stands_for_something_there(
    composition: "Composition", language: str
) -> None:
    plan, words = composition.plan, Words(language)
    assert undefined_symbols(plan, words, beside_answers(plan, words)) == set()


@pytest.mark.parametrize("language", LANGUAGES)
@each("compositions", "composition")
def test_a_formula_that_is_written_out_names_the_givens_that_it_alone_reads(
    composition: "Composition", language: str
) -> None:
    plan, words = composition.plan, Words(language)
    assert idle_givens(plan, words, beside_answers(plan, words)) == set()
