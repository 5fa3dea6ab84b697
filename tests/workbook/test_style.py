import math

import pytest

from gripcourse.workbook.style import decimals_shown, row_height, symbol_runs


@pytest.mark.parametrize(
    ("symbol", "runs"),
    [
        ("D", [("italic", "D")]),
        ("D_тр", [("italic", "D"), ("sub", "тр")]),
        ("Δ", [("upright", "Δ")]),
        ("[σ]_см", [("upright", "["), ("italic", "σ"), ("upright", "]"), ("sub", "см")]),
        ("", []),
    ],
)
def test_a_symbol_is_split_into_italics_and_subscripts(
    symbol: str, runs: list[tuple[str, str]]
) -> None:
    assert symbol_runs(symbol) == runs


def test_the_symbol_of_a_verdict_keeps_its_relation() -> None:
    assert "".join(text for _, text in symbol_runs("F_д ≥ F")) == "Fд ≥ F"


@pytest.mark.parametrize(
    ("value", "decimals"),
    [(63.0, 0), (60.0844, 4), (0.0600844, 7), (22941.18, 1), (math.nan, 0), (1e-30, 12)],
)
def test_a_computed_value_shows_about_six_figures(value: float, decimals: int) -> None:
    assert decimals_shown(value) == decimals


def test_a_row_grows_with_its_longest_text() -> None:
    assert row_height([("x", 10.0)]) < row_height([("x", 10.0), ("x" * 40, 10.0)])
