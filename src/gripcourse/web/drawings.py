"""Drawings at the desk: which ones a student handed in, and their pages as pictures."""

import time
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import Final
from urllib.parse import quote

from starlette.responses import FileResponse, Response
from starlette.routing import Route

from gripcourse.access.desk.model import HandIn
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.files import make_private_folder, write_bytes
from gripcourse.machine.jobs.lost import Lost
from gripcourse.text.words import message
from gripcourse.usecases.serving.hand_in import kept_path
from gripcourse.web import acts
from gripcourse.web.checking import PaintJob
from gripcourse.web.pictures import PaintedPage
from gripcourse.web.refusals import NOT_FOUND, Code, WebRefusal
from gripcourse.web.seat import Seat, desk_route
from gripcourse.web.site import Site

_SECONDS_APART: Final = 600.0
PICTURES: Final = ".pictures"
"""Folder of what was painted, among what is private; hidden, so that no backup carries it."""
NOT_SHOWN: Final = WebRefusal(
    Code.NOT_USABLE, message("This drawing cannot be shown. Download it to look at it.")
)


@dataclass(frozen=True, slots=True)
class ShownDrawing:
    """A page of a drawing as it is shown beside a rubric.

    Attributes:
        hand_in: the file.
        page, pages: counted from 1; None where it cannot be painted.
        picture: address of the picture.
    """

    hand_in: HandIn
    page: int
    pages: int | None
    picture: str


def drawing_routes(site: Site) -> list[Route]:
    """Return the routes of drawings."""
    path = "student/{student}/drawing/{number:int}/{page:int}.png"
    return [desk_route(site, path, drawing_picture)]


def drawing_picture(seat: Seat) -> Response:
    """Send a page of a drawing as a picture of our own."""
    path = seat.request.path_params
    kept = acts.kept_file(seat.site, str(path["student"]), int(path["number"]))
    if kept is None or not kept.is_drawing:
        return seat.refuse(NOT_FOUND)
    picture = painted(seat.site, kept, int(path["page"]))
    if picture is None:
        return seat.refuse(NOT_SHOWN)
    headers = {"Cache-Control": "private, max-age=3600"}
    return FileResponse(picture[0], media_type="image/png", headers=headers)


def shown_drawing(seat: Seat, kept: HandIn, page: int) -> ShownDrawing:
    """Paint a page of a drawing, and return what a page of the desk needs to show it."""
    picture = painted(seat.site, kept, page)
    pages = None if picture is None else picture[1]
    page = page if pages is not None and 1 <= page <= pages else 1
    student = quote(kept.student, safe="")
    address = f"{seat.home}student/{student}/drawing/{kept.number}/{page}.png"
    return ShownDrawing(kept, page, pages, address)


def drawings_of(hand_ins: Iterable[HandIn]) -> tuple[HandIn, ...]:
    """Return the drawings among files, the newest first; of files called the same only that one."""
    last: dict[str, HandIn] = {}
    for one in (one for one in hand_ins if one.is_drawing):
        last.pop(one.name, None)
        last[one.name] = one
    return tuple(reversed(last.values()))


def painted(site: Site, kept: HandIn, page: int) -> tuple[Path, int] | None:
    """Return the picture of a page and how many pages there are; it is painted once."""
    folder = site.context.private / PICTURES
    kind = PurePath(kept.name).suffix.lower().removeprefix(".")
    for known in folder.glob(f"{kept.digest}-{kind}-{page}-of-*.png"):
        return known, int(known.stem.rpartition("-")[2])
    failed = folder / f"{kept.digest}-{kind}.failed"
    if _is_recent(failed):
        return None
    make_private_folder(folder)
    data = kept_path(site.context, kept.digest).read_bytes()
    picture = site.checkers.do(PaintJob(NamedBytes(kept.name, data), page))
    if isinstance(picture, Lost):
        write_bytes(failed, b"", private=True)
        return None
    assert isinstance(picture, PaintedPage)  # noqa: S101 (what the workers return)
    page = page if 1 <= page <= picture.pages else 1
    path = folder / f"{kept.digest}-{kind}-{page}-of-{picture.pages}.png"
    write_bytes(path, picture.png, private=True)
    return path, picture.pages


def _is_recent(failed: Path) -> bool:
    """Tell whether painting failed lately: it may take a worker from students for long each time.

    Later it is tried again, as the machine may only have been busy.
    """
    # Where the clock was set back, a time to come is not lately either.
    return failed.is_file() and abs(time.time() - failed.stat().st_mtime) < _SECONDS_APART
