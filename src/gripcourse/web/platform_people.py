"""Who came from a learning platform and waits at the desk to be told which student that is."""

from http import HTTPStatus

from starlette.responses import RedirectResponse, Response
from starlette.routing import Route

from gripcourse.access.lti.platforms import load_platforms
from gripcourse.usecases.serving.lti import (
    bind,
    chosen_platform,
    platform_names,
    store_of,
    why_not_told,
)
from gripcourse.web.group import by_group_and_name
from gripcourse.web.refusals import NOT_FOUND, unless_in_conflict
from gripcourse.web.seat import Seat, desk_route
from gripcourse.web.site import Site


def people_routes(site: Site) -> list[Route]:
    """Return the routes of this page."""
    return [desk_route(site, "people", people), desk_route(site, "people", known, "POST")]


def people(seat: Seat) -> Response:
    """Show who waits, and the students that nobody of the platform is yet."""
    context = seat.site.context
    names, store = platform_names(context.course.root), store_of(context)
    taken = {one.student for one in store.bonds().values()}
    students = [issued.student for id_, issued in context.register().items() if id_ not in taken]
    values: dict[str, object] = {
        "strangers": [
            (
                one,
                names.get((one.issuer, one.client), one.issuer),
                seat.words.say(why_not_told(one)),
            )
            for one in store.strangers()
        ],
        "students": sorted(students, key=by_group_and_name),
    }
    return seat.page("people", values)


def known(seat: Seat) -> Response:
    """Keep that somebody of a platform is a student."""
    context, texts = seat.site.context, seat.sent.texts
    wanted = texts.get("issuer", ""), texts.get("client", "")
    name = platform_names(context.course.root).get(wanted)
    if name is None or name not in load_platforms(context.course.root):
        return seat.refuse(NOT_FOUND)
    waits = {(one.issuer, one.client, one.user) for one in store_of(context).strangers()}
    user = texts.get("user", "")
    if (*wanted, user) not in waits or not texts.get("student"):
        return seat.refuse(NOT_FOUND)
    platform = chosen_platform(context.course.root, name)
    bond = context, platform, user, texts["student"], seat.name, seat.site.clock()
    refused = unless_in_conflict(lambda: bind(*bond))
    if refused is not None:
        return seat.refuse(refused)
    return RedirectResponse(f"{seat.home}people", HTTPStatus.SEE_OTHER)
