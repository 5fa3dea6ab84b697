"""Titles and sentences of a course as HTML: symbols, powers, and numbers that keep their units."""

import re
from functools import lru_cache
from typing import TYPE_CHECKING, Final

from gripcourse.formula.markup import html
from gripcourse.formula.prose import SYMBOL, subscript_runs
from gripcourse.formula.typeset import symbol_box
from gripcourse.text.amounts import NO_BREAK_SPACE
from gripcourse.text.shown import shown
from gripcourse.text.units import unit_names, unit_text
from gripcourse.text.words import LANGUAGES

# 20 ms to import: only who makes a document pays.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from markupsafe import Markup

# `Re^(0,8)`, `10^4`, `v^−0.09`: what stands in brackets holds none itself.
_POWER: Final = re.compile(r"\^(?:\(([^()]+)\)|([−-]?\d+(?:[.,]\d+)?))")

# `h_V/3`, `√(σ_b/[σ]_b)`: what is divided by a symbol or a number, and no two words; 12–14.
_SHORT: Final = re.compile(
    r"(?<!\S)(?=\S{3,30}(?!\S))\S*(?:\w[)\]]*/[(\[√]*(?:\d|[^\W\d_](?![^\W_²³])|[^\W\d_]{1,2}_)|\d–\d)\S*"
)

_ENDS: Final = re.compile(r"[/–-](?=.)")  # after which a line may end
_JOINER: Final = "\N{WORD JOINER}"

# `cos χ`, `= h_1 + h_2`: what a function is of, and what follows a sign of relation.
_FUNCTION: Final = re.compile(r"(?<![^\W_])(sin|cos|tan|tg|ctg) (?=\d|[^\W\d_](?![^\W_]))")
_RELATION: Final = re.compile(r"(?<= )([=<>≤≥≠≈]) (?=\S)")

# `ISO 5292`, `ГОСТ Р 52543`: capitals and a number.
_STANDARD: Final = re.compile(r"(?<=[^\W\d_a-zа-яёіїєґ]{2}) (?=\d)")


def seen(value: object) -> object:
    """Keep what no page can show out of it; what was made of formulas is known to be whole."""
    return shown(value) if type(value) is str else value


def prose(title: object) -> "Markup":
    """Return a title as HTML; a symbol in it, `v_1`, looks as it does in a formula."""
    from markupsafe import Markup, escape

    written = _unbroken(str(escape(_joined_inside(_kept_together(title)))))
    looking = SYMBOL.sub(lambda found: html(symbol_box(found[0])), written)
    return Markup(_raised(looking))  # noqa: S704 - escaped


def below(title: object) -> "Markup":
    """Return a title as HTML with the subscripts of its symbols; their letters stay as they are."""
    from markupsafe import Markup, escape

    looking = Markup("").join(
        Markup("<sub>{}</sub>").format(run) if low else escape(run)
        for run, low in subscript_runs(_kept_together(title))
    )
    return Markup(_raised(str(looking)))  # noqa: S704 - escaped


def _unbroken(escaped: str) -> str:
    """Let no line end after the slash of a short formula, nor inside a range of numbers."""
    return _SHORT.sub(_joined, escaped)


def _joined(found: re.Match[str]) -> str:
    # WeasyPrint ends a line after its first word where what must not be broken is a little too
    # wide for it. A sign that joins does no such harm; only what is set as a formula needs more.
    if SYMBOL.search(found[0]):
        return f'<span class="unbroken">{found[0]}</span>'
    return _ENDS.sub(rf"\g<0>{_JOINER}", found[0])


def _raised(escaped: str) -> str:
    """Raise the powers of a text that was escaped."""
    return _POWER.sub(lambda found: f"<sup>{found[1] or found[2]}</sup>", escaped)


def _joined_inside(together: str) -> str:
    """Let no line of a sentence end inside a unit, after a function's name or a relation."""
    for joined in (_FUNCTION, _RELATION):
        together = joined.sub(rf"\1{NO_BREAK_SPACE}", together)
    return _inside_a_unit().sub(rf"\g<0>{_JOINER}", together)


def _kept_together(title: object) -> str:
    """Let no line end before a unit, at the minus of a formula, inside the name of a standard."""
    together = _before_a_unit().sub(NO_BREAK_SPACE, str(seen(title)))
    together = _STANDARD.sub(NO_BREAK_SPACE, together)
    return together.replace(" − ", f"{NO_BREAK_SPACE}−{NO_BREAK_SPACE}")


@lru_cache(maxsize=1)
def _before_a_unit() -> re.Pattern[str]:
    return re.compile(rf"(?<=\d) (?=(?:{_units()})(?!\w))")


@lru_cache(maxsize=1)
def _inside_a_unit() -> re.Pattern[str]:
    """Find the slash of `л/мин` and `кг/м³`; a line may end after that of two words."""
    return re.compile(rf"(?<!\w)(?:{_units()})[²³]?/(?=(?:{_units()})(?![^\W²³]))")


def _units() -> str:
    written = {unit_text(name, language) for name in unit_names() for language in LANGUAGES}
    return "|".join(re.escape(one) for one in sorted(written - {""}, key=len, reverse=True))
