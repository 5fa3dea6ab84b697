"""The document that every drawing stands in: millimetres of paper, GOST lines, letters, dimensions.

A document is an `ezdxf` drawing whose modelspace is the sheet: the origin is its lower left corner,
one unit is one millimetre of paper, y points upwards. What an entity looks like follows from its
layer alone, and the layers are the values of `LineKind`.
"""

import re
from enum import StrEnum
from io import StringIO
from typing import TYPE_CHECKING

from gripcourse.drawing.paper.text import FONT_FAMILY, FONT_FILE, TEXT_STYLE
from gripcourse.text.conventions import decimal_sign

if TYPE_CHECKING:
    from ezdxf.document import Drawing


class LineKind(StrEnum):
    """What a line means; the name of its layer (GOST 2.303)."""

    OUTLINE = "OUTLINE"  # visible edges, the frame
    THIN = "THIN"  # imagined intersections, leader lines, thin lines of the title block
    CENTRE = "CENTRE"  # axes, dash-dot
    HIDDEN = "HIDDEN"  # hidden edges, dashed
    PHANTOM = "PHANTOM"  # neighbouring things and other positions, dash with two dots
    HATCH = "HATCH"  # sections
    DIMENSION = "DIMENSION"  # dimension and extension lines with their numbers
    TEXT = "TEXT"  # words


DIMENSION_STYLE = "GOST"
TEXT_HEIGHT = 3.5  # mm, capital letters of dimensions and notes (GOST 2.304)
ARROW = 3.5  # mm, GOST 2.307 asks for 2.5 at least

# Programs that know their own line types only find these by name.
_SOLID, _DASHED, _DASH_DOT, _DASH_TWO_DOTS = ("CONTINUOUS", "HIDDEN", "CENTER", "DIVIDE")
# Strokes (positive) and gaps (negative) of paper, mm. GOST 2.303: strokes of 2 to 8 mm for hidden
# edges, of 5 to 30 mm for axes and neighbouring things.
_LINETYPES = {
    _DASHED: ("Hidden edges __ __ __", (4.0, -1.5)),
    _DASH_DOT: ("Axes ____ . ____", (10.0, -1.5, 0.5, -1.5)),
    _DASH_TWO_DOTS: ("Other positions ____ . . ____", (10.0, -1.5, 0.5, -1.5, 0.5, -1.5)),
}
THICK, FINE = 50, 18  # hundredths of a millimetre, as DXF counts line weights
_LAYERS = {
    LineKind.OUTLINE: (_SOLID, THICK),
    LineKind.THIN: (_SOLID, FINE),
    LineKind.CENTRE: (_DASH_DOT, FINE),
    LineKind.HIDDEN: (_DASHED, FINE),
    LineKind.PHANTOM: (_DASH_TWO_DOTS, FINE),
    LineKind.HATCH: (_SOLID, FINE),
    LineKind.DIMENSION: (_SOLID, FINE),
    LineKind.TEXT: (_SOLID, FINE),
}
_DXF_VERSION = "R2010"
_MILLIMETRES = 4  # $INSUNITS
_METRIC = 1  # $MEASUREMENT
_CUT_ZEROS = 8  # DIMZIN: 63 rather than 63,0
# What differs between two runs: dates, and identifiers that are drawn at random.
_DATES = re.compile(r"(\$TDU?(?:CREATE|UPDATE)\n *40\n)[^\n]*")
_IDENTIFIERS = re.compile(r"(\$(?:VERSION|FINGERPRINT)GUID\n *2\n)[^\n]*")
_MARKER = re.compile(r"^(\d+(?:\.\w+)+) @ \d{4}-\d\d-\d\dT[^\n]*$", re.MULTILINE)
_NO_DATE = "2451544.5"  # the first of January 2000 as a Julian date
_NO_IDENTIFIER = "{00000000-0000-0000-0000-000000000000}"


def new_document(language: str) -> "Drawing":
    """Make an empty document.

    Args:
        language: of the reader; decides the decimal sign of dimensions.

    Returns:
        A drawing with the layers of `LineKind`, the text style `TEXT_STYLE` and the dimension style
        `DIMENSION_STYLE` (arrows, numbers above the line and along it, GOST 2.307).
    """
    # 0.3 s: only who draws pays for it
    from ezdxf.filemanagement import new  # noqa: PLC0415

    document = new(_DXF_VERSION)
    document.header["$INSUNITS"] = _MILLIMETRES
    document.header["$MEASUREMENT"] = _METRIC
    document.header["$LTSCALE"] = 1.0
    document.header["$LWDISPLAY"] = 1
    for name, (description, pattern) in _LINETYPES.items():
        total = sum(abs(one) for one in pattern)
        document.linetypes.add(name, pattern=[total, *pattern], description=description)
    for kind, (linetype, weight) in _LAYERS.items():
        document.layers.add(kind.value, linetype=linetype, lineweight=weight)
    document.styles.add(TEXT_STYLE, font=FONT_FILE).set_extended_font_data(FONT_FAMILY)
    _add_dimension_style(document, language)
    return document


def dxf_bytes(document: "Drawing") -> bytes:
    """Write a document as a DXF file that is the same in every run: no date, nothing random."""
    # Else the library takes them from a set, in another order in every process.
    for name in sorted(document.entitydb.dxf_types_in_use()):
        document.classes.add_class(name)
    stream = StringIO()
    document.write(stream)
    text = _DATES.sub(rf"\g<1>{_NO_DATE}", stream.getvalue())
    text = _IDENTIFIERS.sub(rf"\g<1>{_NO_IDENTIFIER}", text)
    return _MARKER.sub(r"\1", text).encode("utf-8", "surrogateescape")


def _add_dimension_style(document: "Drawing", language: str) -> None:
    style = document.dimstyles.add(
        DIMENSION_STYLE,
        dxfattribs={
            "dimtxsty": TEXT_STYLE,
            "dimtxt": TEXT_HEIGHT,
            "dimasz": ARROW,
            "dimtsz": 0.0,  # arrows, no oblique ticks
            "dimblk": "",  # the filled arrow
            "dimexo": 0.0,
            "dimexe": 2.0,
            "dimgap": 1.0,
            "dimtad": 1,  # the number above its line
            "dimtih": 0,  # and along it
            "dimtoh": 0,
            "dimtix": 1,  # kept between the extension lines
            "dimtofl": 1,
            "dimjust": 0,
            "dimdec": 2,
            "dimadec": 1,
            "dimzin": _CUT_ZEROS,
            "dimazin": 2,
            "dimdsep": ord(decimal_sign(language)),
            "dimlunit": 2,
            "dimaunit": 0,
            "dimlwd": FINE,
            "dimlwe": FINE,
            "dimscale": 1.0,
            "dimlfac": 1.0,
        },
    )
    style.copy_to_header(document)  # some programs look for it there only
