"""What is written can be read by weak eyes and on a grey printer (WCAG 2.2, 1.4.3 and 1.4.11)."""

import re
from pathlib import Path

import pytest

from gripcourse.documents.report import charts as figures
from gripcourse.workbook import style

REPOSITORY = Path(__file__).parents[1]
SHEETS = sorted((REPOSITORY / "templates" / "style").glob("*.css"))
TEXT, SHAPE = 4.5, 3.0
NAMED = {"white": "#fff", "black": "#000"}
# Signs of formulas that are drawn as boxes and stand there only to be searched and read aloud.
UNSEEN = {"transparent", "inherit"}


def luminance(colour: str) -> float:
    """Return the relative luminance, 0…1."""
    digits = NAMED.get(colour, colour).removeprefix("#")
    if len(digits) == 3:
        digits = "".join(2 * digit for digit in digits)
    parts = [int(digits[at : at + 2], 16) / 255 for at in (0, 2, 4)]
    linear = [
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts
    ]
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def contrast(one: str, other: str) -> float:
    light, dark = sorted((luminance(one), luminance(other)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def colours(sheet: Path, declared: str) -> set[str]:
    """Return the colours of a property in a style sheet, its own names resolved."""
    text = re.sub(r"/\*.*?\*/", "", sheet.read_text(encoding="utf-8"), flags=re.DOTALL)
    names = dict(re.findall(r"(--[\w-]+)\s*:\s*(#\w+)", text))
    found = re.findall(rf"(?<![\w-]){declared}\s*:\s*(#\w+|var\(--[\w-]+\)|[a-z]+)", text)
    return {names.get(one[4:-1], one) for one in found} - UNSEEN - {"none", "url"}


def test_contrast_is_counted_as_the_standard_counts_it() -> None:
    assert contrast("#000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "white") == pytest.approx(4.48, abs=0.005)


@pytest.mark.parametrize("sheet", SHEETS, ids=lambda sheet: sheet.name)
def test_text_stands_out_from_whatever_it_stands_on(sheet: Path) -> None:
    written, grounds = colours(sheet, "color"), colours(sheet, "background")
    on_light = {one for one in written if luminance(one) < 0.5}
    light = {"white", *(one for one in grounds if luminance(one) > 0.5)}
    dark = {one for one in grounds if luminance(one) <= 0.5}
    weak = {(one, on): contrast(one, on) for one in on_light for on in light}
    weak |= {(one, on): contrast(one, on) for one in written - on_light for on in dark}
    assert {pair for pair, found in weak.items() if found < TEXT} == set()
    assert not written - on_light or dark


def test_verdicts_are_told_apart_without_colour() -> None:
    """Each has a sign and a word; their colours are for those who see them."""
    answers = (REPOSITORY / "templates" / "parts" / "answers.html.j2").read_text(encoding="utf-8")
    assert '<td class="{{ row.style }}">{{ row.sign }} {{ row.verdict }}</td>' in answers


def test_bars_of_a_plot_stand_out_in_grey() -> None:
    fill, edge = figures._FILL, figures._EDGE  # noqa: SLF001 (the colours are the look itself)
    assert contrast(edge, "white") >= SHAPE
    assert contrast(edge, fill) >= SHAPE
    assert luminance("white") - luminance(fill) > 0.25


def test_a_workbook_can_be_read_on_every_ground_that_it_has() -> None:
    grounds = ("white", style._HEAD, style._ANSWER, style._GIVEN)  # noqa: SLF001 (as above)
    for ink in (style._INK, style._FAINT, style._WARNING):  # noqa: SLF001 (as above)
        assert min(contrast(ink, ground) for ground in grounds) >= TEXT, ink
