"""Starting a server for a course."""

import os
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from gripcourse.usecases.desk import DeskContext
from gripcourse.web.app import make_app
from gripcourse.web.checking import make_checkers
from gripcourse.web.site import Site

_SECONDS_TO_END: Final = 20  # for what is on its way when the server is told to stop


@dataclass(frozen=True, slots=True)
class Serving:
    """Where a server listens and what it hands out.

    Attributes:
        host, port: to listen at.
        address: by which browsers reach it; https there makes cookies travel by https alone.
        assignments, graded: folders of issuing and grading; None for none.
        workers: processes that read uploads.
    """

    host: str
    port: int
    address: str
    assignments: Path | None
    graded: Path | None
    workers: int


def make_site(context: DeskContext, serving: Serving) -> Site:
    """Make what the pages are made from."""
    return Site(
        context=context,
        checkers=make_checkers(context, max(1, serving.workers)),
        clock=lambda: datetime.now(UTC),
        assignments=serving.assignments,
        graded=serving.graded,
        secure=serving.address.startswith("https://"),
    )


def look_into(serving: Serving) -> None:
    """Open the folders of what is handed out.

    Raises:
        OSError: one of them is none.
    """
    for folder in (serving.assignments, serving.graded):
        if folder is not None:
            with os.scandir(folder):
                pass


def serve(context: DeskContext, serving: Serving) -> None:
    """Serve until the process is told to stop."""
    import uvicorn  # noqa: PLC0415 (only who serves pays for it)

    # No log of addresses: a personal link in a log is a key in a log.
    uvicorn.run(
        make_app(make_site(context, serving)),
        host=serving.host,
        port=serving.port,
        access_log=False,
        server_header=False,
        log_level="warning",
        timeout_graceful_shutdown=_SECONDS_TO_END,
        ws="none",
    )
