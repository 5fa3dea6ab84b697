"""Starting a server for a course."""

import os
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from starlette.routing import Route

from gripcourse.access.lti.platforms import platforms_path
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.files import make_private_folder
from gripcourse.text.words import message
from gripcourse.usecases.serving.living import LivingCourse
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


def make_site(living: LivingCourse, serving: Serving) -> Site:
    """Make what the pages are made from."""
    return Site(
        living=living,
        checkers=make_checkers(living.context, max(1, serving.workers)),
        clock=lambda: datetime.now(UTC),
        assignments=serving.assignments,
        graded=serving.graded,
        secure=serving.address.startswith("https://"),
    )


def look_into(serving: Serving) -> None:
    """Open the folders of what is handed out; the one that grading writes is made where none is.

    Raises:
        OSError: one of them is none.
    """
    if serving.graded is not None and not serving.graded.exists():
        make_private_folder(serving.graded)
    for folder in (serving.assignments, serving.graded):
        if folder is not None:
            with os.scandir(folder):
                pass


def platform_routes(site: Site, serving: Serving) -> list[Route]:
    """Return the way in from learning platforms; nothing where none is declared.

    Raises:
        GripcourseError: what is declared cannot be used, or its library is not installed.
    """
    declared = platforms_path(site.context.course.root)
    if not declared.is_file():
        return []
    try:
        from gripcourse.web.lti import lti_routes  # noqa: PLC0415 (only who declares one pays)
        from gripcourse.web.platform_people import people_routes  # noqa: PLC0415 (likewise)
    except ModuleNotFoundError as missing:
        what = message("Learning platforms need the package {name}.", name=str(missing.name))
        remedy = message("Install gripcourse with its extra 'lti'.")
        raise UsageError([Problem(str(declared), "", what, remedy)]) from missing
    return [*lti_routes(site, serving.address), *people_routes(site)]


def serve(living: LivingCourse, serving: Serving) -> None:
    """Serve until the process is told to stop.

    Raises:
        GripcourseError: a learning platform is declared that cannot be used.
    """
    import uvicorn  # noqa: PLC0415 (only who serves pays for it)

    from gripcourse.web.connections import EndingProtocol  # noqa: PLC0415 (likewise)

    site = make_site(living, serving)
    # No log of addresses: a personal link in a log is a key in a log.
    uvicorn.run(
        make_app(site, platform_routes(site, serving)),
        host=serving.host,
        port=serving.port,
        access_log=False,
        server_header=False,
        log_level="warning",
        timeout_graceful_shutdown=_SECONDS_TO_END,
        http=EndingProtocol,
        ws="none",
    )
