"""A document as SVG: lines as wide as their layers say, words that can be read and searched."""

from collections.abc import Sequence
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape, quoteattr

from gripcourse.drawing.paper.svg_number import number
from gripcourse.drawing.paper.text import FONT_FAMILY
from gripcourse.text.shown import shown

if TYPE_CHECKING:
    from ezdxf.document import Drawing

    from gripcourse.drawing.paper.svg_entities import Stroke


def svg_text(document: "Drawing", width_mm: float, height_mm: float, title: str) -> str:
    """Draw a document black on white.

    Entities are drawn by their geometry (LINE, LWPOLYLINE, CIRCLE, ARC, ELLIPSE, SPLINE, SOLID,
    HATCH, TEXT, MTEXT of one line), blocks by what stands in them (INSERT, DIMENSION).

    Args:
        document: made by `new_document`.
        width_mm: of the sheet, whose lower left corner is the origin.
        height_mm: of the sheet.
        title: what a reader who does not see the drawing is told.

    Returns:
        One `<svg>` element without ids and classes, so that many may stand on one page. One unit
        of it is one millimetre; words are text, not outlines.
    """
    from gripcourse.drawing.paper.svg_entities import picture_of  # noqa: PLC0415 (ezdxf: 0.3 s)

    picture = picture_of(document, height_mm)
    width, height = number(width_mm), number(height_mm)
    size = f'width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}"'
    label = shown(title)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img" aria-label={quoteattr(label)}>',
        f'<title>{escape(label)}</title><rect width="{width}" height="{height}" fill="#fff"/>',
        '<g fill="none" stroke="#000" stroke-linejoin="round">',
        *(_path(stroke, data) for stroke, data in picture.strokes.items()),
        "</g>",
    ]
    if picture.fills:
        parts.append(f'<path d="{"".join(picture.fills)}"/>')
    parts.append(f"<g font-family=\"'{FONT_FAMILY}','Liberation Sans','DejaVu Sans',sans-serif\">")
    return "\n".join([*parts, *picture.words, "</g>", "</svg>\n"])


def _path(stroke: "Stroke", data: Sequence[str]) -> str:
    dashes = " ".join(number(one) for one in stroke.dashes)
    dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
    return f'<path stroke-width="{number(stroke.width)}"{dashed} d="{"".join(data)}"/>'
