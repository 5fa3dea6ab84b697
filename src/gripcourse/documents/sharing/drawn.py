"""How lines were drawn."""

from dataclasses import dataclass, field
from typing import Any, TypeAlias

Font: TypeAlias = Any
"""A font of Pango's."""

Call: TypeAlias = tuple[str, tuple[Any, ...]]
"""A method of a page's stream, and with what it is called."""

Widths: TypeAlias = tuple[tuple[int | None, ...], ...]
"""Widths of a line's glyphs as its document knows them, font by font."""


@dataclass(frozen=True, slots=True)
class FontUsed:
    """A font of a line: Pango's, which lives as long as `holder`, and what is taken from it."""

    font: Font
    holder: object
    key: int
    letters: tuple[tuple[int, str], ...]
    glyphs: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class LineDrawing:
    """The calls that draw a line, and for each font the widths that its document did not know."""

    calls: tuple[Call, ...]
    widths: tuple[dict[int, int], ...]


@dataclass(slots=True)
class DrawnLine:
    """The fonts of a line, none before it is drawn, and how it was drawn.

    That depends on the widths of glyphs that its document knows already: the first size in which a
    glyph is drawn decides on it. So there is a drawing for each such case.
    """

    fonts: tuple[FontUsed, ...] = ()
    drawings: dict[Widths, LineDrawing] = field(default_factory=dict)
