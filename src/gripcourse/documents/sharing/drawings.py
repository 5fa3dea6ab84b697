"""Lines of text: drawn once, however many documents they stand in."""

from collections.abc import Sequence
from typing import Any, Final

from weasyprint.draw.text import draw_first_line
from weasyprint.text.fonts import get_pango_font_key

from gripcourse.documents.sharing.bounded import Bounded
from gripcourse.documents.sharing.drawn import Call, DrawnLine, Font, FontUsed, LineDrawing, Widths
from gripcourse.documents.sharing.lines import KeptLine

_MOST_FONTS: Final = 2000  # a font in two sizes is two
_MOST_LETTERS: Final = 10_000
_MOST_DRAWINGS: Final = 8  # of one line


class _CannotBeKeptError(Exception):
    """A line is drawn with pictures, or with signs that no font has."""


class SharedDrawings:
    """Does what a function of WeasyPrint does, with lines that were drawn before."""

    def __init__(self) -> None:
        self._holders: Bounded[Font, object] = Bounded(_MOST_FONTS)
        self._letters: Bounded[tuple[int, str], tuple[int, str]] = Bounded(_MOST_LETTERS)

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
        if type(line) is not KeptLine:
            return draw_first_line(stream, *asked)  # type: ignore[no-any-return]
        if text_overflow == "ellipsis" or block_ellipsis != "none" or not textbox.text.strip():
            line.wake()
            return draw_first_line(stream, *asked)  # type: ignore[no-any-return]
        drawn = line.shaped.drawn
        drawing = _known_drawing(drawn, stream)
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
        for used, widths in zip(drawn.fonts, drawing.widths, strict=True):
            font = _font_in(stream, used)
            font.widths.update(widths)
            for glyph, letters in used.letters:
                font.to_unicode.setdefault(glyph, letters)
        return []

    def _keep(self, line: KeptLine, sketch: "_Sketch") -> LineDrawing:
        drawn = line.shaped.drawn
        drawn.fonts = drawn.fonts or tuple(self._used(one, line) for one in sketch.fonts)
        real = [one.real for one in sketch.fonts]
        new = tuple(
            {glyph: one.widths[glyph] for glyph in one.widths if glyph not in one.real.widths}
            for one in sketch.fonts
        )
        drawing = LineDrawing(tuple(sketch.calls), new)
        if len(drawn.drawings) >= _MOST_DRAWINGS:
            drawn.drawings.clear()
        drawn.drawings[_known_widths(real, drawn.fonts)] = drawing
        return drawing

    def _used(self, font: "_SketchedFont", line: KeptLine) -> FontUsed:
        holder = self._holders.get(font.pango)
        if holder is None:
            holder = line.layout
            self._holders.put(font.pango, holder)
        letters = tuple([self._letter(*pair) for pair in font.to_unicode.items()])
        return FontUsed(font.pango, holder, font.key, letters, tuple([one for one, _ in letters]))

    def _letter(self, glyph: int, letter: str) -> tuple[int, str]:
        """Return one and the same pair for all lines: apart, they were most of a line's memory."""
        pair = (glyph, letter)
        known = self._letters.get(pair)
        if known is None:
            self._letters.put(pair, pair)
        return known or pair


def _known_drawing(drawn: DrawnLine, stream: Any) -> LineDrawing | None:  # noqa: ANN401
    if not drawn.fonts:
        return None
    fonts = [_font_in(stream, used) for used in drawn.fonts]
    return drawn.drawings.get(_known_widths(fonts, drawn.fonts))


def _font_in(stream: Any, used: FontUsed) -> Any:  # noqa: ANN401
    """Return a font as a document knows it; it gets to know it where it does not."""
    return stream._fonts.get(used.key) or stream.add_font(used.font)[0]  # noqa: SLF001


def _known_widths(fonts: Sequence[Any], used: tuple[FontUsed, ...]) -> Widths:
    return tuple(
        [
            tuple([font.widths.get(glyph) for glyph in one.glyphs])
            for font, one in zip(fonts, used, strict=True)
        ]
    )


class _SketchedFont:
    """A font of which a line says anew which letter each glyph is, as no line before had."""

    def __init__(self, real: Any, pango: Font) -> None:  # noqa: ANN401
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
        self.calls: list[Call] = []
        self.fonts: list[_SketchedFont] = []

    def set_text_matrix(self, *_where: float) -> None:
        """Leave out where the line stands: that is another place each time."""

    def add_font(self, pango_font: Font) -> tuple[_SketchedFont, float]:
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
