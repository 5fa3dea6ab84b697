"""What stands where on laid out pages, in mm."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from weasyprint import HTML
from weasyprint.formatting_structure.boxes import LineBox, TableCellBox

# WeasyPrint ships no types, and has no other way to ask where a box stands.
# ruff: noqa: ANN401, SLF001

TEMPLATES = Path(__file__).parents[2] / "templates"
PIXELS = 96 / 25.4  # in a mm


def pages_of(html: str, styles: tuple[str, ...], templates: Path = TEMPLATES) -> list[Any]:
    """The pages of a document, as trees of boxes."""
    sheets = [templates / "style" / name for name in styles]
    return [page._page_box for page in HTML(string=html).render(stylesheets=sheets).pages]


def boxes(tree: Any, tag: str) -> Iterator[Any]:
    """Every element of a name below a box, or the box itself."""
    if tree.element_tag == tag:
        yield tree
    for child in getattr(tree, "children", ()):
        yield from boxes(child, tag)


def cells(tree: Any, tag: str) -> Iterator[Any]:
    """Every cell of a table of a name, `th` or `td`, and nothing inside of them."""
    return (one for one in boxes(tree, tag) if isinstance(one, TableCellBox))


def texts(tree: Any) -> Iterator[str]:
    """Every piece of text below a box."""
    if hasattr(tree, "text"):
        yield tree.text
    for child in getattr(tree, "children", ()):
        yield from texts(child)


def lines(tree: Any) -> Iterator[str]:
    """The text of each line below a box."""
    if isinstance(tree, LineBox):
        yield "".join(texts(tree))
        return
    for child in getattr(tree, "children", ()):
        yield from lines(child)


def text_edges(tree: Any) -> tuple[float, float] | None:
    """Where the text of a box begins and ends; None where it has none."""
    if hasattr(tree, "text"):
        left = tree.position_x
        return (left / PIXELS, (left + tree.width) / PIXELS) if tree.text.strip() else None
    found = [one for child in getattr(tree, "children", ()) if (one := text_edges(child))]
    return (min(left for left, _ in found), max(right for _, right in found)) if found else None
