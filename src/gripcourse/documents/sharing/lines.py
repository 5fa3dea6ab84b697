"""Lines of text: shaped once and drawn once, however many documents they stand in."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import count
from operator import itemgetter
from typing import Any, Final, TypeAlias

from weasyprint.draw.text import draw_first_line
from weasyprint.text.fonts import get_pango_font_key
from weasyprint.text.line_break import Layout, split_first_line

from gripcourse.documents.sharing.bounded import Bounded
from gripcourse.documents.sharing.values import is_settled

_MOST_LINES: Final = 20_000
_MOST_STYLES: Final = 2000
_MOST_DRAWINGS: Final = 8  # of one line

READ: Final = (
    "text_decoration_line",
    "white_space",
    "font_size",
    "direction",
    "lang",
    "font_language_override",
    "font_family",
    "font_style",
    "font_stretch",
    "font_weight",
    "font_kerning",
    "font_variant_ligatures",
    "font_variant_position",
    "font_variant_caps",
    "font_variant_numeric",
    "font_variant_alternates",
    "font_variant_east_asian",
    "font_feature_settings",
    "font_variation_settings",
    "word_spacing",
    "letter_spacing",
    "word_break",
    "overflow_wrap",
    "tab_size",
    "hyphens",
    "hyphenate_limit_chars",
    "hyphenate_limit_zone",
    "hyphenate_character",
)
"""What WeasyPrint reads of a style to break a text into lines and to shape one."""

_UNBROKEN: Final = ("nowrap", "pre")
_values = itemgetter(*READ)

_Font: TypeAlias = Any
_Glyphs: TypeAlias = tuple[int, ...]
_Call: TypeAlias = tuple[str, tuple[Any, ...]]


class _CannotBeKeptError(Exception):
    """A line is drawn with pictures, or with signs that no font has."""


@dataclass(frozen=True, slots=True)
class _FontUsed:
    """A font of a line: Pango's, which lives as long as `holder`, and what is taken from it."""

    font: _Font
    holder: object
    key: int
    letters: tuple[tuple[int, str], ...]
    glyphs: _Glyphs


@dataclass(frozen=True, slots=True)
class _Drawing:
    """The calls that draw a line, and for each font the widths that its document did not know."""

    calls: tuple[_Call, ...]
    widths: tuple[dict[int, int], ...]


@dataclass(slots=True)
class _Shaped:
    """A line as Pango shaped it.

    How it is drawn depends on the widths of glyphs that its document knows already: the first size
    in which a glyph is drawn decides on it. So there is a drawing for each such case.
    """

    text: str
    direction: int
    fonts: tuple[_FontUsed, ...] = ()
    drawings: dict[tuple[Any, ...], _Drawing] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class _Split:
    """What came of breaking a text: its first line, in the order in which WeasyPrint returns it."""

    shaped: _Shaped
    numbers: tuple[Any, ...]  # length, where to go on, width, height, baseline
    unbroken: bool

    def fits(self, max_width: float | None) -> bool:
        return max_width is None or self.unbroken or bool(self.numbers[2] <= max_width)


class Line(Layout):  # type: ignore[misc]
    """A line that is shaped anew by Pango only if it must be."""

    ascent = underline_position = strikethrough_position = None
    underline_thickness = strikethrough_thickness = None

    def __init__(self, shaped: _Shaped, max_width: float | None, justification: float) -> None:
        self.shaped = shaped
        self.text = shaped.text
        self.first_line_direction = shaped.direction
        self.max_width = max_width
        self.justification_spacing = justification
        self.is_awake = False

    def reactivate(self, style: Any) -> None:  # noqa: ANN401
        """Be about to be drawn."""
        self.drawn_in = style

    def wake(self) -> None:
        """Be shaped by Pango."""
        super().reactivate(self.drawn_in)
        self.is_awake = True

    def deactivate(self) -> None:
        """Let go of what Pango made."""
        if self.is_awake:
            super().deactivate()
        self.is_awake = False
        del self.drawn_in


class Lines:
    """Does what two functions of WeasyPrint do, with lines that were shaped and drawn before."""

    def __init__(self, fonts: object) -> None:
        self._fonts = fonts
        self._styles: Bounded[Any, int] = Bounded(_MOST_STYLES)
        self._next_style = count()
        self._whole: Bounded[Any, _Split] = Bounded(_MOST_LINES)
        self._split: Bounded[Any, _Split] = Bounded(_MOST_LINES)
        self._shaped: Bounded[Any, _Shaped] = Bounded(_MOST_LINES)
        self._holders: Bounded[_Font, object] = Bounded(_MOST_STYLES)

    def split_first_line(  # noqa: PLR0913, PLR0917
        self,
        text: str,
        style: Any,  # noqa: ANN401
        context: object,
        max_width: float | None,
        justification_spacing: float,
        is_line_start: bool = True,  # noqa: FBT001, FBT002
        minimum: bool = False,  # noqa: FBT001, FBT002
    ) -> tuple[Any, ...]:
        """Break a text; one that fits is the same line in every width that it fits in."""
        asked = (text, style, context, max_width, justification_spacing, is_line_start, minimum)
        known_as = self._known_as(style)
        if known_as is None:
            return split_first_line(*asked)  # type: ignore[no-any-return]
        whole = (text, known_as, justification_spacing)
        found = self._whole.get(whole)
        if found is None or not found.fits(max_width):
            this = (*whole, max_width, is_line_start, minimum)
            found = self._split.get(this)
            if found is None:
                layout, *numbers = split_first_line(*asked)
                unbroken = style["white_space"] in _UNBROKEN
                shaped = self._shape(layout, known_as)
                found = _Split(shaped, tuple(numbers), unbroken)
                is_whole = numbers[1] is None and layout.text == text and "\n" not in text
                if is_whole and found.fits(max_width):
                    self._whole.put(whole, found)
                else:
                    self._split.put(this, found)
        return Line(found.shaped, max_width, justification_spacing), *found.numbers

    def draw_first_line(
        self,
        stream: Any,  # noqa: ANN401
        textbox: Any,  # noqa: ANN401
        text_overflow: str,
        block_ellipsis: object,
        matrix: Any,  # noqa: ANN401
    ) -> Sequence[object]:
        """Draw a line and return the pictures in it; a line that is kept has none."""
        asked = (textbox, text_overflow, block_ellipsis, matrix)
        line = textbox.pango_layout
        if type(line) is not Line:
            return draw_first_line(stream, *asked)  # type: ignore[no-any-return]
        if text_overflow == "ellipsis" or block_ellipsis != "none" or not textbox.text.strip():
            line.wake()
            return draw_first_line(stream, *asked)  # type: ignore[no-any-return]
        drawing = self._drawing(line.shaped, stream)
        if drawing is None:
            line.wake()
            sketch = _Sketch(stream)
            try:
                draw_first_line(sketch, *asked)
            except _CannotBeKeptError:
                return draw_first_line(stream, *asked)  # type: ignore[no-any-return]
            if not sketch.fonts:
                return draw_first_line(stream, *asked)  # type: ignore[no-any-return]
            drawing = self._keep(line, sketch)
        stream.set_text_matrix(*matrix.values)
        for name, arguments in drawing.calls:
            getattr(stream, name)(*arguments)
        for used, widths in zip(line.shaped.fonts, drawing.widths, strict=True):
            font = _font_in(stream, used)
            font.widths.update(widths)
            for glyph, letters in used.letters:
                font.to_unicode.setdefault(glyph, letters)
        return []

    def _known_as(self, style: Any) -> int | None:  # noqa: ANN401
        """Return a number for all styles in which a text is broken alike.

        It is None for lines with a decoration and for texts of drawings, whose styles have lists.
        """
        values = _values(style)
        if style.font_config is not self._fonts or values[0] != "none":
            return None
        try:
            known_as = self._styles.get(values)
        except TypeError:
            return None
        if known_as is None and is_settled(values):
            known_as = next(self._next_style)
            self._styles.put(values, known_as)
        return known_as

    def _shape(self, layout: Any, known_as: int) -> _Shaped:  # noqa: ANN401
        key = (layout.text, known_as, layout.justification_spacing)
        shaped = self._shaped.get(key)
        if shaped is None:
            shaped = _Shaped(layout.text, layout.first_line_direction)
            self._shaped.put(key, shaped)
        return shaped

    def _drawing(self, shaped: _Shaped, stream: Any) -> _Drawing | None:  # noqa: ANN401
        if not shaped.fonts:
            return None
        fonts = [_font_in(stream, used) for used in shaped.fonts]
        return shaped.drawings.get(_known_widths(fonts, shaped.fonts))

    def _keep(self, line: Line, sketch: "_Sketch") -> _Drawing:
        shaped = line.shaped
        shaped.fonts = shaped.fonts or tuple(self._used(one, line) for one in sketch.fonts)
        real = [one.real for one in sketch.fonts]
        new = tuple(
            {glyph: one.widths[glyph] for glyph in one.widths if glyph not in one.real.widths}
            for one in sketch.fonts
        )
        drawing = _Drawing(tuple(sketch.calls), new)
        if len(shaped.drawings) >= _MOST_DRAWINGS:
            shaped.drawings.clear()
        shaped.drawings[_known_widths(real, shaped.fonts)] = drawing
        return drawing

    def _used(self, font: "_SketchedFont", line: Line) -> _FontUsed:
        holder = self._holders.get(font.pango)
        if holder is None:
            holder = line.layout
            self._holders.put(font.pango, holder)
        letters = tuple(font.to_unicode.items())
        return _FontUsed(font.pango, holder, font.key, letters, tuple(font.to_unicode))


def _font_in(stream: Any, used: _FontUsed) -> Any:  # noqa: ANN401
    """Return a font as a document knows it; it gets to know it where it does not."""
    return stream._fonts.get(used.key) or stream.add_font(used.font)[0]  # noqa: SLF001


def _known_widths(fonts: Sequence[Any], used: tuple[_FontUsed, ...]) -> tuple[Any, ...]:
    return tuple(
        [
            tuple([font.widths.get(glyph) for glyph in one.glyphs])
            for font, one in zip(fonts, used, strict=True)
        ]
    )


class _SketchedFont:
    """A font of which a line says anew which letter each glyph is, as no line before had."""

    def __init__(self, real: Any, pango: _Font) -> None:  # noqa: ANN401
        if real.bitmap or real.svg or real.png or real.colr:
            raise _CannotBeKeptError
        self.bitmap = self.svg = self.png = self.colr = False
        self.real = real
        self.pango = pango
        self.key: int = get_pango_font_key(pango)[0]
        self.hash = real.hash
        self.widths: dict[int, int] = dict(real.widths)
        self.to_unicode: dict[int, str] = {}

    def get_unused_glyph_id(self, _codepoint: int) -> int:
        raise _CannotBeKeptError


class _Sketch:
    """Stands for the stream of a page and writes down what is asked of it."""

    def __init__(self, stream: Any) -> None:  # noqa: ANN401
        self.stream = stream
        self.ink_rect, self.logical_rect = stream.ink_rect, stream.logical_rect
        self.calls: list[_Call] = []
        self.fonts: list[_SketchedFont] = []

    def set_text_matrix(self, *_where: float) -> None:
        """Leave out where the line stands: that is another place each time."""

    def add_font(self, pango_font: _Font) -> tuple[_SketchedFont, float]:
        real, size = self.stream.add_font(pango_font)
        for font in self.fonts:
            if font.real is real:
                return font, size
        self.fonts.append(_SketchedFont(real, pango_font))
        return self.fonts[-1], size

    def set_font_size(self, font: str, size: float) -> None:
        self.calls.append(("set_font_size", (font, size)))

    def set_text_rise(self, rise: float) -> None:
        self.calls.append(("set_text_rise", (rise,)))

    def show_text(self, text: str) -> None:
        self.calls.append(("show_text", (text,)))
