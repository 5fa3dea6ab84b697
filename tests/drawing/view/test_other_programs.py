"""What CAD and office programs show of a drawing's DXF file is what our own picture shows."""

import os
import re
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest
from numpy.typing import NDArray
from weasyprint import HTML

from gripcourse.drawing.paper.document import dxf_bytes
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.text import read_text

if TYPE_CHECKING:
    from conftest import Draw, Drawn

Ink = NDArray[np.bool_]
VARIANT = "008"
ACROSS = 1260  # pixels of a picture: three to a millimetre of A3
DARK = 210
APART = 3  # pixels that a line may lie beside itself in another picture


@pytest.fixture(scope="module")
def drawn(draw: "Draw") -> "Drawn":
    return draw(VARIANT)


@pytest.fixture(scope="module")
def folder(drawn: "Drawn", tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the drawing lies, with what each program makes of it as PDF."""
    folder = tmp_path_factory.mktemp("programs")
    for name in ("librecad", "office"):
        (folder / f"{name}.dxf").write_bytes(dxf_bytes(drawn.view.document))
    environment = {
        **os.environ,
        **{name: str(folder) for name in ("HOME", "XDG_RUNTIME_DIR", "XDG_CONFIG_HOME")},
        "QT_QPA_PLATFORM": "offscreen",
    }
    profile = f"-env:UserInstallation={(folder / 'profile').as_uri()}"
    for command in (
        ("librecad", "dxf2pdf", "--fit", "librecad.dxf"),
        ("soffice", profile, "--headless", "--convert-to", "pdf", "office.dxf"),
    ):
        subprocess.run(command, cwd=folder, env=environment, check=True, capture_output=True)  # noqa: S603
    sheet = drawn.view.arranged.sheet
    size = f"@page{{size:{sheet.width}mm {sheet.height}mm;margin:0}}body{{margin:0}}"
    svg = svg_text(drawn.view.document, sheet.width, sheet.height, "general view")
    HTML(string=f"<style>{size}</style>{svg}").write_pdf(folder / "ours.pdf")
    return folder


def picture(pdf: Path) -> NDArray[np.uint8]:
    """The first page in shades of grey, cut to the sheet, as wide as ours."""
    command = ["pdftoppm", "-gray", "-singlefile", "-r", "220", str(pdf), str(pdf.with_suffix(""))]
    subprocess.run(command, check=True, capture_output=True)  # noqa: S603 (our own file)
    content = pdf.with_suffix(".pgm").read_bytes()
    header = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", content)
    assert header is not None
    width, height = map(int, header.groups())
    return np.frombuffer(content, np.uint8, offset=header.end()).reshape(height, width)


def ink(pdf: Path) -> Ink:
    """Where a picture is dark, its outermost lines on its borders, on our grid."""
    dark = picture(pdf) < DARK
    rows, columns = np.flatnonzero(dark.any(axis=1)), np.flatnonzero(dark.any(axis=0))
    dark = dark[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    places = np.argwhere(dark)
    down = round(ACROSS * dark.shape[0] / dark.shape[1])
    found = np.zeros((down, ACROSS), dtype=np.bool_)
    share = (np.array(found.shape) - 1) / (np.array(dark.shape) - 1)
    found[tuple(np.round(places * share).astype(int).T)] = True
    return found


def near(found: Ink) -> Ink:
    """Return the ink with what lies close beside it."""
    whole = found.copy()
    for axis in (0, 1):
        for _ in range(APART):
            whole |= np.roll(whole, 1, axis) | np.roll(whole, -1, axis)
    return whole


def strays(one: Path, other: Path) -> float:
    """Return the share of a picture's ink that has none of the other's beside it."""
    first, second = ink(one), near(ink(other))
    rows = min(len(first), len(second))
    return float((first[:rows] & ~second[:rows]).sum() / first.sum())


@pytest.mark.parametrize(("program", "lost"), [("librecad", 0.03), ("office", 0.06)])
def test_another_program_shows_what_our_picture_shows(
    folder: Path, program: str, lost: float
) -> None:
    """Letters differ in their shape; lines that are solid or hatching that is lost count more."""
    ours, theirs = folder / "ours.pdf", folder / f"{program}.pdf"
    assert strays(ours, theirs) < lost
    assert strays(theirs, ours) < 0.005


def test_an_office_program_shows_every_word_and_number(drawn: "Drawn", folder: Path) -> None:
    command = ["pdftotext", "-raw", str(folder / "office.pdf"), "-"]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout  # noqa: S603
    shown = "".join(text.split())  # a subscript stands in the word before it
    asked = {word for one in drawn.view.document.query("TEXT") for word in read_text(one).split()}
    assert not [word for word in asked if word not in shown]


def test_every_dimension_says_its_number_itself(drawn: "Drawn") -> None:
    """Programs that do not know of a factor of one dimension show what is written."""
    placed = [one.wanted.text for face in drawn.view.faces.values() for one in face.dimensions]
    written = [one.dxf.text for one in drawn.view.document.query("DIMENSION")]
    assert sorted(written) == sorted(placed)
