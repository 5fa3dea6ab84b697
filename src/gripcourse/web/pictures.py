"""Drawings that students hand in, as pictures of our own making.

What a student sends is never shown as it is: a page might run what an SVG or a PDF file holds. It
is opened in a bounded worker, and what a browser gets is a PNG that was painted there.
"""

import io
from base64 import b64encode
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING, Any, Final
from xml.etree.ElementTree import fromstring

# pypdfium2, Pillow, ezdxf and WeasyPrint are imported in a worker, where a drawing is shown.
# ruff: noqa: PLC0415
from gripcourse.machine.process_wide import without_advice

if TYPE_CHECKING:
    from PIL.Image import Image

_LARGEST: Final = 2200
"""Pixels of the longer side: dimensions of an A1 sheet can be read."""
_MOST_PIXELS: Final = 120_000_000
"""Of a picture that is opened at all: a sheet of A0 scanned at 300 dots to the inch has 140."""
_SVG_PAGE: Final = """<style>@page {{ size: 420mm 297mm; margin: 0 }} body {{ margin: 0 }}
img {{ display: block; width: 420mm; height: 297mm; object-fit: contain }}</style>
<img src="data:image/svg+xml;base64,{code}">"""


@dataclass(frozen=True, slots=True)
class PaintedPage:
    """A page of a drawing.

    Attributes:
        png: the picture.
        pages: how many pages the drawing has.
    """

    png: bytes
    pages: int


def picture_of(data: bytes, name: str, page: int) -> PaintedPage:
    """Paint a page of a drawing.

    Args:
        data: the file.
        name: what it is called; its suffix tells what it is.
        page: counted from 1; one that is not there is the first.

    Raises:
        Exception: whatever a library says of a file that it cannot read; a worker answers that.
    """
    return _PAINTERS[PurePath(name).suffix.lower()](data, page)


def _pdf(data: bytes, page: int) -> PaintedPage:
    from pypdfium2 import PdfDocument

    with PdfDocument(data) as document:
        pages = len(document)
        sheet = document[page - 1 if 1 <= page <= pages else 0]
        scale = _LARGEST / max(*sheet.get_size(), 1.0)
        return PaintedPage(_png(sheet.render(scale=scale, may_draw_forms=False).to_pil()), pages)


def _raster(data: bytes, _: int) -> PaintedPage:
    from PIL import Image

    with Image.open(io.BytesIO(data), formats=("PNG", "JPEG")) as found:
        if found.width * found.height > _MOST_PIXELS:
            raise ValueError(found.size)
        found.thumbnail((_LARGEST, _LARGEST))
        return PaintedPage(_png(found), 1)


def _svg(data: bytes, _: int) -> PaintedPage:
    from weasyprint import HTML, URLFetcher

    # What is no SVG would be a blank sheet, as if nothing had been drawn.
    fromstring(data)  # noqa: S314 (in a bounded worker; expat bounds what entities come to)
    code = b64encode(data).decode()
    fetcher = URLFetcher(allowed_protocols=("data",))
    page = HTML(string=_SVG_PAGE.format(code=code), url_fetcher=fetcher).write_pdf()
    return _pdf(bytes(page), 1)


@without_advice("matplotlib")
def _dxf(data: bytes, _: int) -> PaintedPage:
    from ezdxf import recover
    from ezdxf.addons.drawing.config import BackgroundPolicy, ColorPolicy, Configuration
    from ezdxf.addons.drawing.frontend import Frontend
    from ezdxf.addons.drawing.matplotlib import MatplotlibBackend
    from ezdxf.addons.drawing.properties import RenderContext
    from matplotlib.figure import Figure

    document, _audit = recover.read(io.BytesIO(data))
    figure = Figure(figsize=(_LARGEST / 100, _LARGEST / 140), dpi=100)
    axes: Any = figure.add_axes((0, 0, 1, 1))
    black = Configuration(background_policy=BackgroundPolicy.WHITE, color_policy=ColorPolicy.BLACK)
    backend = MatplotlibBackend(axes, adjust_figure=False)
    Frontend(RenderContext(document), backend, config=black).draw_layout(document.modelspace())
    stream = io.BytesIO()
    figure.savefig(stream, format="png")
    return PaintedPage(stream.getvalue(), 1)


def _png(image: "Image") -> bytes:
    stream = io.BytesIO()
    image.convert("RGB").save(stream, format="PNG", compress_level=4)
    return stream.getvalue()


_PAINTERS: Final[Mapping[str, Callable[[bytes, int], PaintedPage]]] = {
    ".pdf": _pdf,
    ".png": _raster,
    ".jpg": _raster,
    ".jpeg": _raster,
    ".svg": _svg,
    ".dxf": _dxf,
}
PAINTED: Final = frozenset(_PAINTERS)
"""Suffixes of what can be shown."""
