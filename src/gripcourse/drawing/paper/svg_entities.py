"""The entities of a document as pieces of SVG. Imports ezdxf: reached through `svg` alone."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from xml.sax.saxutils import escape

from ezdxf.document import Drawing
from ezdxf.entities.arc import Arc
from ezdxf.entities.circle import Circle
from ezdxf.entities.dimension import Dimension
from ezdxf.entities.dxfentity import DXFEntity
from ezdxf.entities.insert import Insert
from ezdxf.entities.line import Line
from ezdxf.entities.mtext import MText
from ezdxf.entities.polygon import DXFPolygon
from ezdxf.entities.solid import Solid
from ezdxf.entities.text import Text
from ezdxf.path import from_hatch, make_path

from gripcourse.drawing.paper.hatch import hatch_lines
from gripcourse.drawing.paper.strokes import on_circle
from gripcourse.drawing.paper.svg_number import number
from gripcourse.drawing.paper.text import CAP_HEIGHT, Point, read_text
from gripcourse.text.shown import shown

_ANCHORS = ("start", "middle", "end", "start", "middle", "start")  # by DXF's horizontal alignment
_COLUMNS = ("start", "middle", "end")  # by an MTEXT's attachment point
_ROWS = (1.0, 0.5, 0.0)  # capital heights that the base line lies under that point
_MIDDLE = 4  # DXF's alignment half way up the line
_MIDDLE_VERTICAL = 2
_HALF_TURN, _FULL_TURN = 180.0, 360.0
_FLAT = 0.02  # mm that a chord may lie off its curve
_FULL_SIZE = 1.0


@dataclass(frozen=True, slots=True)
class Stroke:
    """How a line is drawn: its width, and its strokes and gaps in turn, mm."""

    width: float
    dashes: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Picture:
    """What a document shows: path data by stroke, filled shapes, lines of words.

    `height` is that of the sheet, mm: y of an SVG points downwards.
    """

    height: float
    strokes: dict[Stroke, list[str]]
    fills: list[str]
    words: list[str]


@dataclass(frozen=True, slots=True)
class _Line:
    """A line of words: where it is held, how, and how it looks."""

    text: str
    at: Point
    size: float
    anchor: str
    drop: float
    rotation: float
    squeeze: float = _FULL_SIZE


def picture_of(document: Drawing, height: float) -> Picture:
    """Collect what the modelspace of a document shows; `height` of its sheet in mm."""
    picture = Picture(height, {}, [], [])
    for entity in document.modelspace():
        _draw(entity, document, picture)
    return picture


def _draw(entity: DXFEntity, document: Drawing, picture: Picture) -> None:
    if entity.dxftype() == "POINT":  # definition points of dimensions
        return
    if isinstance(entity, Dimension | Insert):
        for inner in entity.virtual_entities():
            _draw(inner, document, picture)
    elif isinstance(entity, Text):
        picture.words.append(_words(_text(entity), picture.height))
    elif isinstance(entity, MText):
        picture.words.append(_words(_mtext(entity), picture.height))
    elif isinstance(entity, Solid):
        corners = [(one.x, one.y) for one in entity.wcs_vertices()]
        picture.fills.append(_ring(corners, picture.height))
    elif isinstance(entity, DXFPolygon):
        _hatch(entity, document, picture)
    else:
        strokes = picture.strokes.setdefault(_stroke(entity, document), [])
        strokes.append(_outline(entity, picture.height))


def _outline(entity: DXFEntity, height: float) -> str:
    if isinstance(entity, Line):
        start, end = entity.dxf.start, entity.dxf.end
        return _chain([(start.x, start.y), (end.x, end.y)], height)
    if isinstance(entity, Circle) and not isinstance(entity, Arc):
        return _circle((entity.dxf.center.x, entity.dxf.center.y), entity.dxf.radius, height)
    if isinstance(entity, Arc):
        return _arc(entity, height)
    path = make_path(entity)
    points = [(one.x, one.y) for one in path.flattening(_FLAT)]
    return _ring(points[:-1], height) if path.is_closed else _chain(points, height)


def _circle(centre: Point, radius: float, height: float) -> str:
    side = f"a{number(radius)} {number(radius)} 0 1 0 "
    reach = number(2 * radius)
    start = f"M{number(centre[0] - radius)} {number(height - centre[1])}"
    return f"{start}{side}{reach} 0{side}-{reach} 0"


def _arc(arc: Arc, height: float) -> str:
    centre, radius = arc.dxf.center, arc.dxf.radius
    ends = [
        on_circle((centre.x, centre.y), radius, angle)
        for angle in (arc.dxf.start_angle, arc.dxf.end_angle)
    ]
    wide = (arc.dxf.end_angle - arc.dxf.start_angle) % _FULL_TURN > _HALF_TURN
    start, end = (f"{number(x)} {number(height - y)}" for x, y in ends)
    return f"M{start}A{number(radius)} {number(radius)} 0 {int(wide)} 0 {end}"


def _hatch(entity: DXFPolygon, document: Drawing, picture: Picture) -> None:
    rings = [[(one.x, one.y) for one in path.flattening(_FLAT)] for path in from_hatch(entity)]
    if entity.dxf.solid_fill or entity.pattern is None:
        picture.fills.extend(_ring(ring, picture.height) for ring in rings)
        return
    strokes = picture.strokes.setdefault(_stroke(entity, document), [])
    for line in entity.pattern.lines:
        spacing = math.hypot(line.offset.x, line.offset.y)
        segments = hatch_lines(rings, line.angle, spacing)
        strokes.extend(_chain(segment, picture.height) for segment in segments)


def _stroke(entity: DXFEntity, document: Drawing) -> Stroke:
    layer = document.layers.get(entity.dxf.layer)
    weight = entity.dxf.get("lineweight", -1)
    linetype = entity.dxf.get("linetype", "BYLAYER")
    if linetype.upper() in {"BYLAYER", "BYBLOCK"}:
        linetype = layer.dxf.linetype
    dashes = document.linetypes.get(linetype).simplified_line_pattern()
    scale = entity.dxf.get("ltscale", _FULL_SIZE)
    weight = weight if weight >= 0 else layer.dxf.lineweight
    return Stroke(weight / 100, tuple(one * scale for one in dashes))


def _text(entity: Text) -> _Line:
    dxf = entity.dxf
    squeeze = dxf.get("width", _FULL_SIZE)
    across, up = dxf.get("halign", 0), dxf.get("valign", 0)
    if squeeze != _FULL_SIZE:
        # Held where its base line begins: some programs do not squeeze the way back to there.
        across, up = 0, 0
    at = dxf.align_point if (across or up) and dxf.hasattr("align_point") else dxf.insert
    middle = across == _MIDDLE or up == _MIDDLE_VERTICAL
    return _Line(
        text=read_text(entity),
        at=(at.x, at.y),
        size=dxf.height,
        anchor=_ANCHORS[across],
        drop=0.5 if middle else 0.0,
        rotation=dxf.get("rotation", 0.0),
        squeeze=squeeze,
    )


def _mtext(entity: MText) -> _Line:
    row, column = divmod(entity.dxf.get("attachment_point", 1) - 1, len(_COLUMNS))
    return _Line(
        text=" ".join(entity.plain_text(split=True)),
        at=(entity.dxf.insert.x, entity.dxf.insert.y),
        size=entity.dxf.char_height,
        anchor=_COLUMNS[column],
        drop=_ROWS[row],
        rotation=entity.get_rotation(),
    )


def _words(line: _Line, height: float) -> str:
    x, y = line.at[0], height - line.at[1]
    changes = []
    if line.rotation or line.squeeze != _FULL_SIZE:
        changes.append(f"translate({number(x)} {number(y)})")
        x, y = 0.0, 0.0
    if line.rotation:
        changes.append(f"rotate({number(-line.rotation)})")
    if line.squeeze != _FULL_SIZE:
        changes.append(f"scale({line.squeeze:.4f} 1)")
    change = f' transform="{" ".join(changes)}"' if changes else ""
    anchor = f' text-anchor="{line.anchor}"' if line.anchor != _COLUMNS[0] else ""
    place = f'x="{number(x)}" y="{number(y + line.drop * line.size)}"'
    size = number(line.size / CAP_HEIGHT)
    return f'<text {place} font-size="{size}"{anchor}{change}>{escape(shown(line.text))}</text>'


def _chain(points: Sequence[Point], height: float) -> str:
    written = (f"{number(x)} {number(height - y)}" for x, y in points)
    return "M" + "L".join(written)


def _ring(points: Sequence[Point], height: float) -> str:
    return f"{_chain(points, height)}Z"
