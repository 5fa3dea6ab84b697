"""How a table is kept and printed that has one row of headings, and more columns than a page."""

from datetime import datetime
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.worksheet import Worksheet

_PAPER_A4: Final = 9
_NO_DAY: Final = datetime(2000, 1, 1)  # noqa: DTZ001 (the same every day, wherever)


def set_table_page(sheet: "Worksheet", *, in_front: int = 0) -> None:
    """Set a sheet up for A4 paper that lies, with its headings on every page.

    Args:
        sheet: its first row has the headings.
        in_front: columns that stand on every page, where the table goes on to the right; 0 where
            all columns are drawn together into one page's width.
    """
    sheet.set_paper(_PAPER_A4)
    sheet.set_landscape()
    sheet.set_margins(left=0.4, right=0.4, top=0.5, bottom=0.6)
    sheet.set_footer("&L&A&C&P / &N")
    sheet.repeat_rows(0)
    if in_front:
        sheet.repeat_columns(0, in_front - 1)
    else:
        sheet.fit_to_pages(1, 0)


def set_no_moment(book: "Workbook") -> None:
    """Let a workbook not say when it was written: the same table is the same file."""
    book.set_properties({"created": _NO_DAY})
