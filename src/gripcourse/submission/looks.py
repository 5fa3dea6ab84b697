"""What the cells of a workbook show: their texts, their number formats, how days are counted."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from xml.etree.ElementTree import Element

from gripcourse.machine.spreadsheet.cell_value import (
    CellContent,
    NumberFormats,
    counts_from_1904,
    formats_of,
    shown_value,
    text_index,
)
from gripcourse.machine.spreadsheet.package import Package
from gripcourse.machine.spreadsheet.sheet_cells import (
    StoredCell,
    one_for_all,
    shared_texts,
)
from gripcourse.machine.spreadsheet.xml_scan import namespace


@dataclass(frozen=True, slots=True)
class Looks:
    """What is needed to tell what a cell of a workbook shows.

    Attributes:
        texts: that cells share, by number.
        formats: of its styles.
        from_1904: whether it counts days from 1904 on.
    """

    texts: Mapping[int, str]
    formats: NumberFormats
    from_1904: bool

    def shown(self, cell: StoredCell) -> tuple[CellContent, str]:
        """Return what a cell holds, and its number format."""
        number_format = self.formats.of(cell)
        content = shown_value(cell, number_format, self.texts, from_1904=self.from_1904)
        return content, number_format


def looks_of(package: Package, workbook: str, cells: Iterable[StoredCell]) -> Looks:
    """Read what some cells of a workbook need to be shown, and nothing else.

    Raises:
        KeyError: they share texts, and these are nowhere.
        ValueError: programs disagree which of these texts there are.
        Exception: see `Package.root` and `formats_of`.
    """
    cells = tuple(cells)
    by_kind = {one.kind: one.part for one in package.related(workbook)}
    indices = (text_index(one.text) for one in cells if one.kind == "s")
    wanted = {one for one in indices if one is not None}
    shared = _items(package.root(by_kind["sharedStrings"])) if wanted else []
    has_style = any(one.style for one in cells)
    return Looks(
        texts=shared_texts(shared, wanted),
        formats=formats_of(package, by_kind.get("styles") if has_style else None),
        from_1904=counts_from_1904(package, workbook),
    )


def _items(table: Element) -> Sequence[Element]:
    """Return the texts of a table of them; a program counts no others, wherever they stand."""
    return one_for_all(table).findall(f"{namespace(table)}si")
