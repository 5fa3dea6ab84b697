"""What CAD and office programs show of a drawing's DXF file is what our own picture shows."""

import os
import re
import subprocess
from collections.abc import Callable, Mapping
from functools import cache
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
# A slide in guides, prisms, suction cups, a screw: between them every kind of line, curve and
# hatching that a view has.
SCHEMES = ("wedge_slide", "prism_lever", "vacuum_cups", "screw")
FINE = 2  # pixels of a picture to a millimetre of paper
DARK = 210
APART = 3  # pixels that a line may lie beside itself in another picture


@pytest.fixture(scope="module")
def views(draw: "Draw", smallest: Mapping[str, str]) -> "Mapping[str, Drawn]":
    return {scheme: draw(smallest[scheme]) for scheme in SCHEMES}


@pytest.fixture(scope="module")
def folder(views: "Mapping[str, Drawn]", tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the drawings lie, with what each program makes of them as PDF."""
    folder = tmp_path_factory.mktemp("programs")
    print_views(views, folder)
    return folder


@pytest.fixture(scope="module")
def inked(views: "Mapping[str, Drawn]", folder: Path) -> Callable[[str, str], Ink]:
    """Where a scheme's drawing is dark as a program prints it; each is looked at once."""

    def look(scheme: str, program: str) -> Ink:
        return ink(folder / f"{scheme}.{program}.pdf", views[scheme].view.arranged.sheet.width)

    return cache(look)


def print_views(views: "Mapping[str, Drawn]", folder: Path) -> None:
    """Let each program make a PDF file of every drawing, all of them in one start."""
    environment = {
        **os.environ,
        **{name: str(folder) for name in ("HOME", "XDG_RUNTIME_DIR", "XDG_CONFIG_HOME")},
        "QT_QPA_PLATFORM": "offscreen",
    }
    profile = f"-env:UserInstallation={(folder / 'profile').as_uri()}"
    for command in (
        ("librecad", "dxf2pdf", "--fit"),
        ("soffice", profile, "--headless", "--convert-to", "pdf"),
    ):
        files = {scheme: folder / f"{scheme}.{command[0]}.dxf" for scheme in views}
        for scheme, one in views.items():
            files[scheme].write_bytes(dxf_bytes(one.view.document))
        subprocess.run(  # noqa: S603
            (*command, *(file.name for file in files.values())),
            cwd=folder,
            env=environment,
            check=True,
            capture_output=True,
        )
    for scheme, one in views.items():
        sheet = one.view.arranged.sheet
        size = f"@page{{size:{sheet.width}mm {sheet.height}mm;margin:0}}body{{margin:0}}"
        svg = svg_text(one.view.document, sheet.width, sheet.height, "general view")
        HTML(string=f"<style>{size}</style>{svg}").write_pdf(folder / f"{scheme}.ours.pdf")


def picture(pdf: Path) -> NDArray[np.uint8]:
    """The first page in shades of grey, cut to the sheet, as wide as ours."""
    command = ["pdftoppm", "-gray", "-singlefile", "-r", "220", str(pdf), str(pdf.with_suffix(""))]
    subprocess.run(command, check=True, capture_output=True)  # noqa: S603 (our own file)
    content = pdf.with_suffix(".pgm").read_bytes()
    header = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", content)
    assert header is not None
    width, height = map(int, header.groups())
    return np.frombuffer(content, np.uint8, offset=header.end()).reshape(height, width)


def ink(pdf: Path, width: float) -> Ink:
    """Where a picture of a sheet so wide is dark, its outermost lines on its borders."""
    dark = picture(pdf) < DARK
    rows, columns = np.flatnonzero(dark.any(axis=1)), np.flatnonzero(dark.any(axis=0))
    dark = dark[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    places = np.argwhere(dark)
    across = round(FINE * width)
    down = round(across * dark.shape[0] / dark.shape[1])
    found = np.zeros((down, across), dtype=np.bool_)
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


def strays(one: Ink, other: Ink) -> float:
    """Return the share of a picture's ink that has none of the other's beside it."""
    rows = min(len(one), len(other))
    return float((one[:rows] & ~near(other)[:rows]).sum() / one.sum())


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize(("program", "lost"), [("librecad", 0.03), ("soffice", 0.06)])
def test_another_program_shows_what_our_picture_shows(
    inked: Callable[[str, str], Ink], scheme: str, program: str, lost: float
) -> None:
    """Letters differ in their shape; lines that are solid or hatching that is lost count more."""
    ours, theirs = inked(scheme, "ours"), inked(scheme, program)
    assert strays(ours, theirs) < lost
    assert strays(theirs, ours) < 0.005


@pytest.mark.parametrize("scheme", SCHEMES)
def test_an_office_program_shows_every_word_and_number(
    views: "Mapping[str, Drawn]", folder: Path, scheme: str
) -> None:
    assert not missing_words(views[scheme], folder / f"{scheme}.soffice.pdf")


def missing_words(drawn: "Drawn", pdf: Path) -> list[str]:
    """Return what a drawing says and a program's picture of it does not."""
    command = ["pdftotext", "-raw", str(pdf), "-"]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout  # noqa: S603
    shown = "".join(text.split())  # a subscript stands in the word before it
    asked = {word for one in drawn.view.document.query("TEXT") for word in read_text(one).split()}
    return [word for word in asked if word not in shown]


@pytest.mark.parametrize("scheme", SCHEMES)
def test_every_dimension_says_its_number_itself(views: "Mapping[str, Drawn]", scheme: str) -> None:
    """Programs that do not know of a factor of one dimension show what is written."""
    view = views[scheme].view
    asked = [
        (one.wanted.text, factor)
        for laid, factor in (
            *((face, view.arranged.factor) for face in view.faces.values()),
            *((detail, detail.factor) for detail in view.details),
        )
        for one in laid.dimensions
    ]
    written = [
        (one.dxf.text, 1 / one.override().get("dimlfac"))
        for one in view.document.query("DIMENSION")
    ]
    assert len(written) == len(asked)
    for (text, factor), (asked_text, asked_factor) in zip(
        sorted(written), sorted(asked), strict=True
    ):
        assert text == asked_text
        assert factor == pytest.approx(asked_factor)
