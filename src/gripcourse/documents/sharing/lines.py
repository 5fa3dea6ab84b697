"""Lines of text: broken and shaped once, however many documents they stand in."""

from dataclasses import dataclass, field
from itertools import count
from operator import itemgetter
from typing import Any, Final

from weasyprint.text.line_break import Layout, split_first_line

from gripcourse.documents.sharing.bounded import Bounded
from gripcourse.documents.sharing.drawn import DrawnLine
from gripcourse.documents.sharing.values import is_settled

_MOST_LINES: Final = 12_000  # a report has a thousand
_MOST_STYLES: Final = 2000

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


@dataclass(slots=True)
class Shaped:
    """A line as Pango shaped it, and where a drawing of it is kept."""

    text: str
    direction: int
    drawn: DrawnLine = field(default_factory=DrawnLine)


@dataclass(frozen=True, slots=True)
class _Split:
    """What came of breaking a text: its first line, in the order in which WeasyPrint returns it."""

    shaped: Shaped
    numbers: tuple[Any, ...]  # length, where to go on, width, height, baseline
    unbroken: bool

    def fits(self, max_width: float | None) -> bool:
        return max_width is None or self.unbroken or bool(self.numbers[2] <= max_width)


class KeptLine(Layout):  # type: ignore[misc]
    """A line that is shaped anew by Pango only if it must be."""

    ascent = underline_position = strikethrough_position = None
    underline_thickness = strikethrough_thickness = None

    def __init__(self, shaped: Shaped, max_width: float | None, justification: float) -> None:
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


class SharedLines:
    """Does what a function of WeasyPrint does, with lines that were shaped before."""

    def __init__(self, fonts: object) -> None:
        self._fonts = fonts
        self._styles: Bounded[Any, int] = Bounded(_MOST_STYLES)
        self._next_style = count()
        self._whole: Bounded[Any, _Split] = Bounded(_MOST_LINES)
        self._split: Bounded[Any, _Split] = Bounded(_MOST_LINES)
        self._shaped: Bounded[Any, Shaped] = Bounded(_MOST_LINES)

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
        return KeptLine(found.shaped, max_width, justification_spacing), *found.numbers

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

    def _shape(self, layout: Any, known_as: int) -> Shaped:  # noqa: ANN401
        key = (layout.text, known_as, layout.justification_spacing)
        shaped = self._shaped.get(key)
        if shaped is None:
            shaped = Shaped(layout.text, layout.first_line_direction)
            self._shaped.put(key, shaped)
        return shaped
