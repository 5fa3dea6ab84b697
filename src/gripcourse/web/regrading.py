"""Regrading at the desk: shown first, applied with a reason as it was shown, taken back."""

from http import HTTPStatus

from starlette.responses import RedirectResponse, Response
from starlette.routing import Route

from gripcourse.gradebook.journal import Signed, applied, regrades
from gripcourse.gradebook.regrade import Shift
from gripcourse.gradebook.store import Gradebook
from gripcourse.usecases.marks.policy_said import policy_change_said
from gripcourse.usecases.marks.regrade import Regrading
from gripcourse.web.desk_acts import (
    apply_shown,
    digest_of_changes,
    regrading_now,
    signed_by,
    take_last_back,
)
from gripcourse.web.overview import titles_of
from gripcourse.web.refusals import WebRefusal
from gripcourse.web.seat import Seat, desk_route
from gripcourse.web.site import Site


def regrading_routes(site: Site) -> list[Route]:
    """Return the routes of regrading."""
    return [
        desk_route(site, "regrading", regrading),
        desk_route(site, "regrading", regrading_preview, "POST"),
        desk_route(site, "regrading/apply", regrading_applied, "POST"),
        desk_route(site, "regrading/undo", regrading_undone, "POST"),
    ]


def regrading(seat: Seat) -> Response:
    """Say what a regrade is, and which ones stand."""
    return _page(seat, None)


def regrading_preview(seat: Seat) -> Response:
    """Grade everything that was handed in again, and show what would change."""
    found = regrading_now(seat.site)
    return seat.refuse(found) if isinstance(found, WebRefusal) else _page(seat, found)


def regrading_applied(seat: Seat) -> Response:
    """Let it count, if it still comes to what was shown."""
    seen = seat.sent.texts.get("seen")
    made = apply_shown(seat.site, _signed(seat), seen, allow_lower=_may_lower(seat))
    return _done(seat, made)


def regrading_undone(seat: Seat) -> Response:
    """Take the last regrade that stands back."""
    made = take_last_back(seat.site, _signed(seat), allow_lower=_may_lower(seat))
    return _done(seat, made)


def _may_lower(seat: Seat) -> bool:
    """Tell whether somebody said that published results may get worse."""
    return seat.sent.texts.get("allow_lower") == "yes"


def _page(seat: Seat, found: Regrading | None) -> Response:
    context = seat.site.context
    students = (issued.student for issued in context.register().values())
    names = {one.id: one.name for one in students if one.name}
    missing = () if found is None else dict.fromkeys(one.student for one in found.missing)
    values: dict[str, object] = {
        "found": found,
        "seen": "" if found is None else digest_of_changes(found),
        "counts": {} if found is None else {one.value: len(found.going(one)) for one in Shift},
        "policies": [] if found is None else _policies(seat, found),
        "titles": titles_of(context, seat.words),
        "names": names,
        "missing": [names.get(one, one) for one in missing],
        "stands": applied(regrades(Gradebook(context.desk.engine))),
    }
    return seat.page("regrading", values)


def _policies(seat: Seat, found: Regrading) -> list[tuple[str, list[str]]]:
    """Return what is said of each earlier policy: a heading, and its lines."""
    said = ([seat.words.say(one) for one in policy_change_said(each)] for each in found.policies)
    return [(one[0], one[1:]) for one in said if one]


def _signed(seat: Seat) -> Signed:
    return signed_by(seat.site, seat.name, seat.sent.texts.get("why", ""))


def _done(seat: Seat, made: object) -> Response:
    if isinstance(made, WebRefusal):
        return seat.refuse(made)
    return RedirectResponse(f"{seat.home}regrading", HTTPStatus.SEE_OTHER)
