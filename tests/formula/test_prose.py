"""Symbols in titles and sentences."""

import pytest

from gripcourse.formula.prose import subscript_runs, without_looks


def test_a_symbol_in_a_sentence_ends_with_its_subscript() -> None:
    assert list(subscript_runs("не менее h_Г1·√(σ_и/[σ]_и) и D_max/3")) == [
        ("не менее h", False),
        ("Г1", True),
        ("·√(σ", False),
        ("и", True),
        ("/[σ]", False),
        ("и", True),
        (") и D", False),
        ("max", True),
        ("/3", False),
    ]


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("h_1", "h₁"),
        ("D_max, Δl_12", "Dₘₐₓ, Δl₁₂"),
        ("d_ш", "dш"),
        ("not below m′_1; d'_2, w″_3", "not below m′₁; d'₂, w″₃"),
        ("d_c1", "dc1"),
        ("σ_и ≤ [σ]_и", "σи ≤ [σ]и"),
        ("bare words", "bare words"),
        ("", ""),
    ],
)
def test_where_there_is_one_look_a_subscript_is_small_signs_or_stands_beside(
    text: str, plain: str
) -> None:
    assert without_looks(text) == plain


def test_a_subscript_of_two_abbreviated_words_ends_before_the_end_of_a_sentence() -> None:
    assert list(subscript_runs("не менее d_в.тр.")) == [
        ("не менее d", False),
        ("в.тр", True),
        (".", False),
    ]
    assert without_looks("F_t. Далее k_0.5") == "Fₜ. Далее k₀.5"


def test_a_subscript_of_two_parts_is_one_and_a_list_is_none() -> None:
    assert list(subscript_runs("not below w_2,req;")) == [
        ("not below w", False),
        ("2,req", True),
        (";", False),
    ]
    assert [run for run, below in subscript_runs("d_1,d_2, and h_1, then") if below] == [
        *("1", "2", "1"),
    ]
