"""Symbols in sentences and titles: `D_max` is found there, so that it looks as in a formula."""

import re
from collections.abc import Iterator
from typing import Final

# A letter, perhaps in brackets, after a Δ or with primes, and its subscript, perhaps of two parts,
# w_2,req or d_в.тр; a power ends it, and so does a comma before a blank or the next symbol.
SYMBOL: Final = re.compile(
    r"(?<![\w\]])(?:\[[^\W\d_]{1,2}\]|Δ?[^\W\d_][′″'’]{0,2})_[-−]?[^\W_²³]{1,8}"
    r"(?:,[^\W_²³]{1,8}|\.[^\W\d_]{1,8})?(?![^\W²³])"
)

_SMALL: Final = str.maketrans(
    "0123456789aehijklmnoprstuvxβγρφχ", "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓᵦᵧᵨᵩᵪ"
)


def subscript_runs(text: str) -> Iterator[tuple[str, bool]]:
    """Split a text into runs, each with whether it is a subscript; none of them is empty."""
    begin = 0
    for found in SYMBOL.finditer(text):
        base, _, below = found[0].partition("_")
        yield text[begin : found.start()] + base, False
        yield below, True
        begin = found.end()
    if text[begin:]:
        yield text[begin:], False


def without_looks(text: str) -> str:
    """Write a text where there is one look only: `h_1` as `h₁`, and `d_ш` as `dш`.

    A subscript is small where there are small signs for all of it.
    """
    runs = (_below(run) if below else run for run, below in subscript_runs(text))
    return "".join(runs).replace("_", "")


def _below(run: str) -> str:
    small = run.translate(_SMALL)
    return small if set(small).isdisjoint(run) else run
