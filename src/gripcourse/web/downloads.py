"""Downloads of the desk: all hand-ins, and what was graded last, published or not."""

from collections.abc import Sequence

from starlette.responses import FileResponse, Response, StreamingResponse
from starlette.routing import Route

from gripcourse.machine.packing import ToPack, packed
from gripcourse.usecases.publishing.downloads import (
    HAND_INS_ZIP,
    REPORTS_ZIP,
    TABLES,
    graded_table,
    hand_ins_to_pack,
    reports_to_pack,
)
from gripcourse.web.refusals import NOT_FOUND
from gripcourse.web.seat import Seat, desk_route
from gripcourse.web.site import Site

ZIP = "application/zip"


def download_routes(site: Site) -> list[Route]:
    """Return the routes of downloads."""
    return [
        desk_route(site, HAND_INS_ZIP, hand_ins),
        desk_route(site, f"graded/{REPORTS_ZIP}", reports),
        desk_route(site, "graded/{name}", table),
    ]


def hand_ins(seat: Seat) -> Response:
    """Send every file that was handed in."""
    return _packed(seat, HAND_INS_ZIP, hand_ins_to_pack(seat.site.context))


def reports(seat: Seat) -> Response:
    """Send the reports of everybody as they were printed last."""
    return _packed(seat, REPORTS_ZIP, reports_to_pack(seat.site.graded))


def table(seat: Seat) -> Response:
    """Send a table of the last batch, or its cohort report."""
    path = graded_table(seat.site.graded, str(seat.request.path_params["name"]))
    if path is None:
        return seat.refuse(NOT_FOUND)
    return FileResponse(path, media_type=TABLES[path.name], filename=path.name)


def names_of_tables(site: Site) -> tuple[str, ...]:
    """Return which of them there are."""
    names = tuple(one for one in TABLES if graded_table(site.graded, one) is not None)
    return (*names, REPORTS_ZIP) if reports_to_pack(site.graded) else names


def zip_response(name: str, files: Sequence[ToPack]) -> Response:
    """Send files as a zip that is made while it is sent."""
    headers = {"Content-Disposition": f'attachment; filename="{name}"'}
    return StreamingResponse(packed(files), media_type=ZIP, headers=headers)


def _packed(seat: Seat, name: str, files: Sequence[ToPack]) -> Response:
    return zip_response(name, files) if files else seat.refuse(NOT_FOUND)
