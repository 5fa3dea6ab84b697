"""Regrading at the desk: shown first, applied with a reason as it was shown, taken back."""

import hashlib
from collections.abc import Callable
from http import HTTPStatus
from pathlib import PurePath

from starlette.responses import RedirectResponse, Response
from starlette.routing import Route

from gripcourse.errors import GradebookError, GripcourseError
from gripcourse.gradebook.journal import Signed, applied, regrades
from gripcourse.gradebook.regrade import Shift
from gripcourse.gradebook.store import Gradebook
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.database.home import home_of
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import message
from gripcourse.usecases.desk import DeskContext
from gripcourse.usecases.hand_in import kept_path
from gripcourse.usecases.opening import grading_of
from gripcourse.usecases.regrade import Regrading, apply_regrade, regrade, undo_regrade
from gripcourse.web.refusals import Code, WebRefusal, refusal_of_problem
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
    return _page(seat, _found(seat))


def regrading_applied(seat: Seat) -> Response:
    """Let it count, if it still comes to what was shown."""
    found, texts = _found(seat), seat.sent.texts
    if texts.get("seen") != digest_of_changes(found):
        said = message("It comes to something else than was shown by now. Look at it again.")
        return seat.refuse(WebRefusal(Code.CONFLICT, said))
    lower = texts.get("allow_lower") == "yes"
    return _done(seat, lambda signed, place: apply_regrade(found, place, signed, allow_lower=lower))


def regrading_undone(seat: Seat) -> Response:
    """Take the last regrade that stands back."""
    return _done(seat, lambda signed, place: undo_regrade(place, signed))


def digest_of_changes(found: Regrading) -> str:
    """Return a name for what would change, the same for the same."""
    changes = [
        (one.work.student, one.work.digest, one.items, one.before, one.after, one.published)
        for one in found.to_apply
    ]
    return hashlib.sha256(repr(changes).encode()).hexdigest()


def works_handed_in(context: DeskContext) -> list[NamedBytes]:
    """Return every workbook that was handed in, called like its student, each once.

    Raises:
        OSError: one cannot be read.
    """
    works = (one for one in context.desk.hand_ins() if not one.is_drawing)
    files = {(one.student, one.digest): one for one in works}
    return [
        NamedBytes(
            f"{student}{PurePath(one.name).suffix.lower()}", kept_path(context, digest).read_bytes()
        )
        for (student, digest), one in files.items()
    ]


def _found(seat: Seat) -> Regrading:
    context = seat.site.context
    grading, place = grading_of(context.course, context.policy), home_of(context.course.root)
    files, workers = works_handed_in(context), seat.site.checkers.workers
    # A file is never opened by the server itself, but where a test wants everything in one process.
    workers = 0 if seat.site.checkers.pool is None else workers
    return regrade(files, grading, place, workers, seat.site.clock())


def _page(seat: Seat, found: Regrading | None) -> Response:
    context = seat.site.context
    register = context.register()
    titles: dict[str, str] = {}
    for change in () if found is None else found.to_apply:
        issued = register.get(change.work.student)
        plan = None if issued is None else plan_of(context.course, issued.variant.composition)
        for item in change.items if plan is not None else ():
            quantity = plan.quantities.get(item.quantity) if plan is not None else None
            titles[item.quantity] = (
                item.quantity if quantity is None else quantity.title.of(seat.words.language)
            )
    values: dict[str, object] = {
        "found": found,
        "seen": "" if found is None else digest_of_changes(found),
        "counts": {} if found is None else {one.value: len(found.going(one)) for one in Shift},
        "titles": titles,
        "names": {id_: issued.student.name for id_, issued in register.items()},
        "stands": applied(regrades(Gradebook(context.desk.engine))),
    }
    return seat.page("regrading", values)


def _done(seat: Seat, act: Callable[[Signed, str], object]) -> Response:
    signed = Signed(seat.name, seat.site.clock(), seat.sent.texts.get("why", "").strip())
    try:
        act(signed, home_of(seat.site.context.course.root))
    except GradebookError:
        raise
    except GripcourseError as error:
        return seat.refuse(refusal_of_problem(error, Code.CONFLICT))
    return RedirectResponse(f"{seat.home}regrading", HTTPStatus.SEE_OTHER)
