"""Drawings beside the rubric: pictures of our own making, whatever a student sends."""

import hashlib
import io
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING
from xml.etree.ElementTree import ParseError

import ezdxf
import pytest
from PIL import Image
from pypdf import PdfWriter

from gripcourse.machine.content import NamedBytes
from gripcourse.machine.jobs.standing import StandingWorkers
from gripcourse.usecases.serving.hand_in import hand_in, latest
from gripcourse.web.drawings import PICTURES
from gripcourse.web.pictures import PAINTED, picture_of

if TYPE_CHECKING:
    from starlette.testclient import TestClient

    from web.conftest import Server

PAGE = "/desk/marking/s01/general_view_drawing"


def pdf(pages: int) -> bytes:
    writer, stream = PdfWriter(), io.BytesIO()
    for _ in range(pages):
        writer.add_blank_page(420, 297)
    writer.write(stream)
    return stream.getvalue()


def dxf() -> bytes:
    drawing, stream = ezdxf.new(), io.StringIO()
    drawing.modelspace().add_line((0, 0), (10, 5))
    drawing.write(stream)
    return stream.getvalue().encode()


def raster(kind: str) -> bytes:
    stream = io.BytesIO()
    Image.new("RGBA" if kind == "png" else "L", (3000, 1000), "black").save(stream, kind)
    return stream.getvalue()


SVG = b"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10" onload="alert(1)">
<script>alert(1)</script><image href="file:///etc/passwd"/><rect width="9" height="9"/></svg>"""
FILES = {
    ".pdf": (pdf(3), 3),
    ".png": (raster("png"), 1),
    ".jpg": (raster("jpeg"), 1),
    ".jpeg": (raster("jpeg"), 1),
    ".svg": (SVG, 1),
    ".dxf": (dxf(), 1),
}


@pytest.mark.parametrize("suffix", sorted(PAINTED))
def test_every_kind_of_drawing_is_painted(suffix: str) -> None:
    data, pages = FILES[suffix]
    made = picture_of(data, f"чертёж{suffix.upper()}", 1)
    assert made.pages == pages
    with Image.open(io.BytesIO(made.png), formats=("PNG",)) as image:
        assert 500 < max(image.size) <= 2200
        darkest = image.convert("L").getextrema()[0]
    assert (darkest < 100) == (suffix != ".pdf")  # the pages of ours are blank


@pytest.mark.parametrize(
    "data",
    [
        b"no drawing",
        SVG[:-9],
        b'<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">'
        + b"".join(
            b'<!ENTITY %c "%s">' % (name, b"&%c;" % (name - 1) * 10) for name in range(99, 106)
        )
        + b']><svg xmlns="http://www.w3.org/2000/svg"><text>&i;</text></svg>',
    ],
    ids=["no XML", "broken off", "entities"],
)
def test_an_svg_that_cannot_be_read_is_no_blank_sheet(data: bytes) -> None:
    with pytest.raises(ParseError):
        picture_of(data, "view.svg", 1)


def send(server: "Server", name: str, data: bytes) -> int:
    issued = server.classroom.register["s01"]
    return hand_in(server.context, issued, NamedBytes(name, data), server.clock.now).hand_in.number


@pytest.mark.parametrize("name", ["ч" * 125 + ".pdf", "ч" * 300 + ".PDF"])
def test_a_drawing_with_a_long_name_is_never_taken_for_the_workbook(
    server: "Server", name: str
) -> None:
    issued = server.classroom.register["s02"]
    work = hand_in(server.context, issued, NamedBytes("w.xlsx", b"PK work"), server.clock.now)
    kept = hand_in(server.context, issued, NamedBytes(name, name.encode()), server.clock.now)
    assert kept.hand_in.is_drawing
    assert len(kept.hand_in.name) == 120
    assert (
        latest(server.context, {"s02": server.context.desk.hand_ins("s02")})["s02"] == work.hand_in
    )


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("IMG_0001.HEIC", b"\0\0\0\x18ftypheic"),
        ("photo.xlsx", b"\xff\xd8\xff\xe0"),
        ("view.dwg", b"AC1032"),
        ("answers.csv", b"a;b"),
    ],
)
def test_what_is_no_workbook_takes_the_place_of_none(
    server: "Server", filled: bytes, name: str, data: bytes
) -> None:
    """Neither photograph, table of text nor a CAD program's own drawing; its receipt says so."""
    sent, context = send(server, "work.xlsx", filled), server.context
    number, client, home = send(server, name, data), server.client(), server.home("s01")
    assert latest(context, {"s01": context.desk.hand_ins("s01")})["s01"].number == sent
    said = [client.get(f"{home}receipt/{one}").text for one in (sent, number)]
    assert ["не рабочая книга" in one for one in said] == [False, True]
    archive = send(server, "all.zip", b"PK\3\4 of works")
    assert latest(context, {"s01": context.desk.hand_ins("s01")})["s01"].number == archive


def test_a_drawing_that_was_called_otherwise_first_can_be_handed_in_by_its_right_name(
    server: "Server",
) -> None:
    issued, desk = server.classroom.register["s02"], server.context.desk
    names = ("work.xlsx", "view", "view.pdf", "view.pdf")
    files = [NamedBytes(name, b"sheet" if "view" in name else b"answers") for name in names]
    for one in files:
        hand_in(server.context, issued, one, server.clock.now)
    assert [one.name for one in desk.hand_ins("s02")][-3:] == ["work.xlsx", "view", "view.pdf"]


def test_a_name_without_a_suffix_is_shortened_too(server: "Server") -> None:
    issued = server.classroom.register["s03"]
    kept = hand_in(server.context, issued, NamedBytes(f"a.{'b' * 300}", b"1"), server.clock.now)
    assert kept.hand_in.name == f"a.{'b' * 118}"


def test_a_drawing_is_shown_beside_the_rubric_and_never_as_it_was_sent(
    server: "Server", signed_in: "TestClient", filled: bytes, tmp_path: Path
) -> None:
    work = send(server, "work.xlsx", filled)
    server.grade(tmp_path)
    old, new = send(server, "view.svg", SVG), send(server, "view.pdf", pdf(2))
    broken = send(server, "broken.dxf", b"no drawing")
    assert (
        latest(server.context, {"s01": server.context.desk.hand_ins("s01")})["s01"].number == work
    )
    page = signed_in.get(f"{PAGE}?drawing={new}&page=2").text
    picture = f"/desk/student/s01/drawing/{new}/2.png"
    assert f'<img src="{picture}"' in page
    shown = signed_in.get(picture)
    assert shown.headers["content-type"] == "image/png"
    assert shown.content.startswith(b"\x89PNG")
    assert "default-src 'none'" in shown.headers["content-security-policy"]
    assert f"?drawing={old}" in page
    assert "<script" not in signed_in.get(f"{PAGE}?drawing={old}").text
    assert "<img" not in signed_in.get(f"{PAGE}?drawing={broken}").text
    for path in (f"s01/drawing/{broken}/1.png", f"s01/drawing/{work}/1.png", "s02/drawing/1/1.png"):
        assert signed_in.get(f"/desk/student/{path}").status_code in {404, 422}
    sent = signed_in.get(f"/desk/student/s01/file/{old}")
    assert sent.headers["content-type"] == "application/octet-stream"
    assert re.match("attachment", sent.headers["content-disposition"])
    for page_text in ("0", "9", "x", "99999999"):
        assert signed_in.get(f"{PAGE}?drawing={new}&page={page_text}").status_code == 200


def test_a_drawing_is_no_workbook_to_check_and_its_receipt_says_so(server: "Server") -> None:
    client, home = server.client(), server.home("s03")
    files = {"file": ("Вид.PDF", pdf(1))}
    checked = client.post(f"{home}check", files=files)
    assert checked.status_code == 422
    assert "This is a drawing" in checked.text
    assert "kept as a drawing" in client.post(f"{home}hand-in", files=files).text
    assert 'accept=".xlsx,' in client.get(home).text
    assert ".dxf" in client.get(home).text


def test_a_drawing_that_cannot_be_painted_takes_no_worker_each_time_it_is_looked_at(
    server: "Server", signed_in: "TestClient", monkeypatch: pytest.MonkeyPatch
) -> None:
    number = send(server, "bomb.svg", b"no drawing either")
    asked: list[object] = []
    usual = StandingWorkers.do

    def counted(workers: StandingWorkers, item: object) -> object:
        asked.append(item)
        return usual(workers, item)

    monkeypatch.setattr(StandingWorkers, "do", counted)
    page = f"/desk/student/s01/drawing/{number}/1.png"
    assert [signed_in.get(page).status_code for _ in range(2)] == [422, 422]
    assert len(asked) == 1
    failed = next(
        (server.context.private / PICTURES).glob(
            f"{hashlib.sha256(b'no drawing either').hexdigest()}-*.failed"
        )
    )
    long_ago = failed.stat().st_mtime - 601
    os.utime(failed, (long_ago, long_ago))
    signed_in.get(page)
    assert len(asked) == 2
    failed.unlink()
