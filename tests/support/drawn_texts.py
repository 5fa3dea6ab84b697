"""What is written on a general view, as the picture of it says."""

import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING

from gripcourse.drawing.paper.svg import svg_text

if TYPE_CHECKING:
    from conftest import Drawn

SVG = "{http://www.w3.org/2000/svg}"


def parsed(drawn: "Drawn") -> ET.Element:
    sheet = drawn.view.arranged.sheet
    svg = svg_text(drawn.view.document, sheet.width, sheet.height, "general view")
    return ET.fromstring(svg)  # noqa: S314 - our own drawing


def written(drawn: "Drawn") -> list[str]:
    return [one.text or "" for one in parsed(drawn).iter(f"{SVG}text")]
