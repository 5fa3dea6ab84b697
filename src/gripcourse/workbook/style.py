"""How workbooks look: formats, symbols with subscripts, the setup of a page."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, BinaryIO, Final, Literal, TypeAlias

from gripcourse.formula.boxes import Box, Script, Text, inner
from gripcourse.formula.prose import subscript_runs
from gripcourse.formula.typeset import declared_symbol
from gripcourse.text.shown import shown
from gripcourse.workbook.wrapping import lines_taken

if TYPE_CHECKING:
    from xlsxwriter import Workbook
    from xlsxwriter.format import Format
    from xlsxwriter.worksheet import Worksheet

# Both have free twins of the same widths, so that pages break alike in every office program.
_FONT: Final = "Arial"
_SYMBOL_FONT: Final = "Times New Roman"
_SIZE: Final = 10
_SYMBOL_SIZE: Final = 12

_INK: Final = "#1F2A37"
_FAINT: Final = "#5B6775"
_LINE: Final = "#B8C2CC"
_HEAD: Final = "#E4EAF1"
_ANSWER: Final = "#FFF6CC"
_ANSWER_LINE: Final = "#C9A400"
_GIVEN: Final = "#F4F7FA"
_WARNING: Final = "#B42318"

PAPER_A4: Final = 9
_LONGEST_HEADER: Final = 200  # of 255 characters that a page header may have
_LINE_OF_HEADER: Final = {False: 90, True: 130}  # characters; landscape: the second

MOST_DECIMALS: Final = 12

_LINE_HEIGHT: Final = 13.0  # points
_PADDING: Final = 6.0
# Points of rows on a page for each character of its width: the wider, the smaller it is printed.
_PAGE_HEIGHT: Final = 7.4
_DRAWN_TOGETHER: Final = 0.25  # of a page, as wide as the columns of a section make it

RunKind: TypeAlias = Literal["italic", "upright", "sub"]


@dataclass(frozen=True, slots=True)
class Styles:
    """The formats of one workbook; a format belongs to the workbook that made it."""

    title: "Format"
    heading: "Format"
    heading_line: "Format"
    paragraph: "Format"
    hint: "Format"
    hint_line: "Format"
    label: "Format"
    label_wrapped: "Format"
    particular: "Format"
    head: "Format"
    small_head: "Format"
    number: "Format"
    text: "Format"
    unit: "Format"
    given: "Format"
    computed: tuple["Format", ...]
    """By the number of decimals shown; the first shows whole numbers."""
    verdict: "Format"
    size: "Format"
    answer: "Format"
    manual: "Format"
    check: "Format"
    symbol: "Format"
    symbol_upright: "Format"
    italic: "Format"
    upright: "Format"
    sub: "Format"
    run: "Format"
    run_sub: "Format"


def new_book(stream: BinaryIO) -> "Workbook":
    """Return a workbook that is written into a stream when it is closed.

    Columns are as wide as so many digits of its usual font: xlsxwriter's own is one that few free
    systems have, and with another in its place all columns would have another width.
    """
    # A twentieth of a second to import: only those who make a workbook pay for it.
    from xlsxwriter import Workbook  # noqa: PLC0415

    usual = {"font_name": _FONT, "font_size": _SIZE}
    return Workbook(stream, {"in_memory": True, "default_format_properties": usual})


def make_styles(book: "Workbook") -> Styles:
    """Make the formats of a workbook."""

    def style(**properties: object) -> "Format":
        base = {"font_name": _FONT, "font_size": _SIZE, "font_color": _INK, "valign": "vcenter"}
        return book.add_format(base | properties)

    cell = {"border": 1, "border_color": _LINE}
    wrapped = cell | {"text_wrap": True}
    symbol = {"font_name": _SYMBOL_FONT, "font_size": _SYMBOL_SIZE}
    middle = cell | {"align": "center"}
    return Styles(
        title=style(bold=True, font_size=15),
        heading=style(bold=True, font_size=11),
        heading_line=style(bold=True, text_wrap=True),
        paragraph=style(text_wrap=True, valign="top"),
        hint=style(text_wrap=True, italic=True, font_color=_FAINT, valign="top"),
        hint_line=style(italic=True, font_color=_FAINT),
        label=style(font_color=_FAINT),
        label_wrapped=style(font_color=_FAINT, text_wrap=True),
        particular=style(bold=True),
        head=style(**wrapped, bold=True, bg_color=_HEAD, align="center"),
        small_head=style(**wrapped, bold=True, bg_color=_HEAD, align="center", font_size=8),
        number=style(**middle, font_color=_FAINT),
        text=style(**wrapped, indent=1),
        unit=style(**middle),
        given=style(**middle, bg_color=_GIVEN, bold=True),
        computed=(
            style(**middle),
            *(style(**middle, num_format=f"0.0{'#' * n}") for n in range(MOST_DECIMALS)),
        ),
        verdict=style(**middle),
        size=style(**middle),
        answer=style(
            border=1, border_color=_ANSWER_LINE, bg_color=_ANSWER, align="center", locked=False
        ),
        manual=style(**wrapped, italic=True, font_color=_FAINT, align="center"),
        check=style(text_wrap=True, font_color=_WARNING, font_size=9, indent=1),
        symbol=style(**middle | symbol, italic=True),
        symbol_upright=style(**middle | symbol, text_wrap=True),
        italic=style(**symbol, italic=True),
        upright=style(**symbol),
        sub=style(**symbol, font_script=2),
        run=style(),
        run_sub=style(font_script=2),
    )


def write_symbol(sheet: "Worksheet", row: int, column: int, symbol: str, styles: Styles) -> None:
    """Write a declared symbol as formulas print it: italics, subscripts."""
    runs = symbol_runs(symbol)
    if len(runs) < 2:  # noqa: PLR2004 - a rich text has two runs at least
        kind, text = runs[0] if runs else ("upright", "")
        sheet.write_string(
            row, column, text, styles.symbol if kind == "italic" else styles.symbol_upright
        )
        return
    formats = {"italic": styles.italic, "upright": styles.upright, "sub": styles.sub}
    parts: list[object] = []
    for kind, text in runs:
        parts += [formats[kind], text]
    sheet.write_rich_string(row, column, *parts, styles.symbol_upright)


def write_symbols(
    sheet: "Worksheet", row: int, column: int, text: str, look: "Format", styles: Styles
) -> None:
    """Write a title or a sentence; a symbol in it has its subscript below the line.

    Args:
        sheet: to write on.
        row: of the cell.
        column: likewise.
        text: with symbols as they are declared, `D_1`.
        look: of the cell, upright.
        styles: of the workbook.
    """
    runs = list(subscript_runs(text))
    if len(runs) < 2:  # noqa: PLR2004 - a rich text has two runs at least
        sheet.write_string(row, column, text, look)
        return
    parts = [
        part for run, below in runs for part in ((styles.run_sub if below else styles.run), run)
    ]
    sheet.write_rich_string(row, column, *parts, look)


def symbol_runs(symbol: str) -> list[tuple[RunKind, str]]:
    """Split a declared symbol, or several joined by signs, into runs of one look."""
    if not symbol:
        return []
    return [
        (kind, "".join(text for _, text in group))
        for kind, group in groupby(_runs(declared_symbol(symbol)), lambda run: run[0])
    ]


def _runs(box: Box) -> Iterator[tuple[RunKind, str]]:
    match box:
        case Text("relation", text):
            yield "upright", f" {text} "
        case Text(kind, text):
            yield ("italic" if kind == "variable" else "upright"), text
        case Script(base, sub, None) if sub is not None:
            yield from _runs(base)
            for _, text in _runs(sub):
                yield "sub", text
        case _:
            for part in inner(box):
                yield from _runs(part)


def decimals_shown(value: float) -> int:
    """Return how many decimals show a value with six figures at most; none for a whole number."""
    if not math.isfinite(value) or value == round(value):
        return 0
    return min(max(5 - math.floor(math.log10(abs(value))), 0), MOST_DECIMALS)


def row_height(texts: Iterable[tuple[str, float]]) -> float:
    """Return the height of a row, in points, that shows wrapped texts whole.

    Args:
        texts: each with the width of its column, in characters.
    """
    return _LINE_HEIGHT * max(lines_taken(text, width) for text, width in texts) + _PADDING


def pages_tall(
    heights: Iterable[float], width: float, *, drawn_together: float = _DRAWN_TOGETHER
) -> int:
    """Return on how many pages rows are printed.

    Rows that go a little beyond a page are drawn together into it: nobody wants the last three on
    a page of their own. More than a little would make the type too small to read.

    Args:
        heights: of the rows, in points.
        width: of all columns, in characters.
        drawn_together: what of a page is no reason for one more.
    """
    return max(1, math.ceil(sum(heights) / (_PAGE_HEIGHT * width) - drawn_together))


def set_page(
    sheet: "Worksheet", left: str, right: str, *, landscape: bool = False, tall: int = 0
) -> None:
    """Set a sheet up for A4 paper, as wide as the page, with a line above and page numbers.

    Args:
        sheet: to set up.
        left: what stands above the page at the left.
        right: and at the right.
        landscape: how the paper lies.
        tall: pages that it is fitted to; 0 for as many as it takes.
    """
    sheet.set_paper(PAPER_A4)
    if landscape:
        sheet.set_landscape()
    sheet.fit_to_pages(1, tall)
    sheet.set_margins(left=0.4, right=0.4, top=0.8, bottom=0.7)
    half = _LONGEST_HEADER // 2
    # Two texts that one line has no room for would be printed one over the other.
    between = "\n" if len(left) + len(right) > _LINE_OF_HEADER[landscape] else "&R"
    sheet.set_header(f"&L{_header_text(left, half)}{between}{_header_text(right, half)}")
    sheet.set_footer("&C&P / &N")
    sheet.hide_gridlines(2)


def _header_text(text: str, longest: int) -> str:
    """Write text into a page header, where `&` begins a code and `&&` is the sign itself."""
    written = shown(text).replace("&", "&&")[:longest]
    half_cut = (len(written) - len(written.rstrip("&"))) % 2
    return written[: len(written) - half_cut]
