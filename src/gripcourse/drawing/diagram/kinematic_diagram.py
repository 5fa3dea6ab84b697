"""The kinematic diagram of a variant as a drawing: DXF for a CAD program, SVG for a page."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.drawing.diagram.layout import WIDEST, DiagramLayout, lay_out
from gripcourse.drawing.diagram.letters import DROP, SUBSCRIPT, Written
from gripcourse.drawing.diagram.marks import ArcMark, Fill, Mark, Path, RingMark, is_circle
from gripcourse.drawing.diagram.places import shown_positions
from gripcourse.drawing.paper.document import TEXT_HEIGHT, LineKind, dxf_bytes, new_document
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.text import add_text
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts.layout import Modelspace

_TRIANGLE = 3


@dataclass(frozen=True, slots=True)
class KinematicDiagram:
    """A diagram ready to be written.

    Attributes:
        document: the drawing; its sheet is as large as the diagram.
        width, height: of the sheet, mm.
        scale: millimetres of paper for a millimetre.
        title: what a reader who does not see the drawing is told.
    """

    document: "Drawing"
    width: float
    height: float
    scale: float
    title: str

    def svg(self) -> str:
        """Return the diagram as an SVG element for a page."""
        return svg_text(self.document, self.width, self.height, self.title)

    def dxf(self) -> bytes:
        """Return the diagram as a DXF file."""
        return dxf_bytes(self.document)


def kinematic_diagram(
    plan: Plan, values: Mapping[str, float], language: str, widest: float = WIDEST
) -> KinematicDiagram | None:
    """Draw a variant's kinematic diagram.

    It shows the mechanism where the smallest object is held (thick) and where the largest is
    (thin), to scale; joints, drives and contacts are symbols of one size (GOST 2.770).

    Args:
        plan: of the scheme with the variant's options.
        values: of quantities in declared units; the givens at least, what is missing is computed.
        language: of the symbols and of the title.
        widest: mm that it may take of the page's width.

    Returns:
        The diagram, at most 95 mm high; None where the scheme declares none, or where the numbers
        give its joints no place.
    """
    layout = lay_out(plan, values, language, widest)
    if layout is None:
        return None
    document = new_document(language)
    space = document.modelspace()
    for mark in layout.marks:
        _draw(mark, space)
    for written in layout.written:
        _write(written, space)
    title = alternative_text(plan, layout, Words(language))
    return KinematicDiagram(document, layout.width, layout.height, layout.scale, title)


def line_titles(plan: Plan, words: Words) -> tuple[str, str] | None:
    """Return what thick lines show and what thin ones do; None where one position is shown."""
    titles = [
        plan.course.positions[name].title.of(words.language)
        for name in shown_positions(plan)
        if name in plan.course.positions
    ]
    return (titles[0], "; ".join(titles[1:])) if len(titles) > 1 else None


def alternative_text(plan: Plan, layout: DiagramLayout, words: Words) -> str:
    """Say what the diagram shows: its scheme, its positions, and what its symbols stand for."""
    shown = {one.symbol for one in layout.written if one.is_quantity}
    meant = [
        f"{quantity.symbol.of(words.language)} — {quantity.title.of(words.language)}"
        for quantity in plan.quantities.values()
        if quantity.symbol.of(words.language) in shown
    ]
    lines = line_titles(plan, words)
    if lines is None:
        said = message(
            "Diagram of the scheme: {scheme}. Symbols: {symbols}.",
            scheme=plan.scheme.title,
            symbols="; ".join(meant),
        )
    else:
        said = message(
            "Diagram of the scheme: {scheme}. Thick lines: {thick}; thin lines: {thin}. "
            "Symbols: {symbols}.",
            scheme=plan.scheme.title,
            thick=lines[0],
            thin=lines[1],
            symbols="; ".join(meant),
        )
    return words.say(said)


def _draw(mark: Mark, space: "Modelspace") -> None:
    match mark:
        case Path(points, line, closed):
            space.add_lwpolyline(points, close=closed, dxfattribs={"layer": line.value})
        case ArcMark(centre, radius, _, _, line) if is_circle(mark):
            space.add_circle(centre, radius, dxfattribs={"layer": line.value})
        case ArcMark(centre, radius, start, sweep, line):
            first, last = sorted((math.degrees(start), math.degrees(start + sweep)))
            space.add_arc(centre, radius, first, last, dxfattribs={"layer": line.value})
        case RingMark(centre, radius, line):
            space.add_circle(centre, radius, dxfattribs={"layer": line.value})
        case Fill(points) if len(points) == _TRIANGLE:
            space.add_solid(points, dxfattribs={"layer": LineKind.OUTLINE.value})
        case Fill(points):
            hatch = space.add_hatch(dxfattribs={"layer": LineKind.OUTLINE.value})
            hatch.paths.add_polyline_path(points, is_closed=True)


def _write(written: Written, space: "Modelspace") -> None:
    x, y = written.at
    add_text(space, written.base, (x, y), TEXT_HEIGHT)
    if written.below:
        add_text(space, written.below, (x + written.offset, y - DROP), SUBSCRIPT)
