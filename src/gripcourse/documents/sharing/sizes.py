"""Sizes of boxes and heights of lines, worked out once for each set of values."""

from operator import itemgetter
from typing import Any, Final

from weasyprint.layout.percent import resolve_percentages
from weasyprint.text.line_break import strut

from gripcourse.documents.sharing.bounded import Bounded
from gripcourse.documents.sharing.values import is_settled

_MOST_BOXES: Final = 4000
_MOST_STRUTS: Final = 1000

_BORDERS: Final = tuple(f"border_{side}_width" for side in ("top", "right", "bottom", "left"))
SET: Final = (
    *(f"{what}_{side}" for what in ("margin", "padding") for side in ("left", "right")),
    *(f"{what}_{side}" for what in ("margin", "padding") for side in ("top", "bottom")),
    *(f"{least}{size}" for size in ("width", "height") for least in ("", "min_", "max_")),
    *_BORDERS,
)
"""What `resolve_percentages` sets on a box."""

READ: Final = ("border_collapse", "box_sizing", *SET)
"""What it reads of the box's style."""

STRUT_READ: Final = (
    "font_size",
    "line_height",
    "font_family",
    "font_style",
    "font_stretch",
    "font_weight",
    "font_variant_ligatures",
    "font_variant_position",
    "font_variant_caps",
    "font_variant_numeric",
    "font_variant_alternates",
    "font_variant_east_asian",
    "font_feature_settings",
    "font_variation_settings",
    "font_language_override",
    "lang",
)
"""What tells the strut of one style from another's, as WeasyPrint's own memory of struts has it."""

_values = itemgetter(*READ)
_strut_values = itemgetter(*STRUT_READ)


class SharedSizes:
    """Does what two functions of WeasyPrint do, with what was worked out before."""

    def __init__(self, fonts: object) -> None:
        self._fonts = fonts
        self._resolved: Bounded[Any, dict[str, Any]] = Bounded(_MOST_BOXES)
        self._struts: Bounded[Any, tuple[float, float]] = Bounded(_MOST_STRUTS)

    def resolve_percentages(self, box: Any, containing_block: Any) -> None:  # noqa: ANN401
        """Set the sizes of a box; they depend on what contains it where one is a percentage."""
        values = _values(box.style)
        attributes = box.__dict__
        before = None
        if values[0] == "collapse":  # borders that a table settled stay as they are
            before = tuple([attributes.get(one) for one in _BORDERS])
        key = (values, before)
        found = self._resolved.get(key)
        if found:
            attributes.update(found)
            return
        resolve_percentages(box, containing_block)
        if found is None:
            kept = {one: attributes[one] for one in SET} if _are_absolute(values) else {}
            self._resolved.put(key, kept)

    def strut(self, style: Any) -> tuple[float, float]:  # noqa: ANN401
        """Return height and baseline of a line with nothing in it."""
        if style.font_config is not self._fonts:
            return strut(style)  # type: ignore[no-any-return]
        values = _strut_values(style)
        try:
            found = self._struts.get(values)
        except TypeError:  # a list; styles of drawings have such
            return strut(style)  # type: ignore[no-any-return]
        if found is None:
            found = strut(style)
            if is_settled(values):
                self._struts.put(values, found)
        return found


def _are_absolute(values: tuple[Any, ...]) -> bool:
    return is_settled(values) and not any(getattr(one, "unit", None) == "%" for one in values)
