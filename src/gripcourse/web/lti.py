"""The way in from a learning platform: it opens the assignment, and somebody is at his page.

Two requests: the platform says that somebody comes and is asked who (`login`); the browser brings
its signed answer (`launch`). Nobody is led anywhere but to our own pages, whatever is asked for.
"""

import logging
import secrets
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import timedelta
from http import HTTPStatus
from typing import Final
from urllib.parse import parse_qsl, urlencode

from anyio import CapacityLimiter, fail_after, to_thread
from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import JSONResponse, RedirectResponse, Response
from starlette.routing import Route

from gripcourse.access.lti.key_sets import KeySets
from gripcourse.access.lti.launch import Launch, PlatformRole, read_launch
from gripcourse.access.lti.platforms import Platform, load_platforms
from gripcourse.access.lti.refused import LaunchRefusal, LaunchRefusedError
from gripcourse.access.lti.states import MINUTES, Signer, check_state, is_of, new_state, nonce_of
from gripcourse.access.lti.tool_key import public_keys
from gripcourse.access.lti.web_client import make_client
from gripcourse.text.words import Message, message
from gripcourse.usecases.serving.links import token_of
from gripcourse.usecases.serving.lti import NotTold, note_place, store_of, student_of
from gripcourse.usecases.serving.sign_in import offer_sign_in
from gripcourse.web.guard import content_policy
from gripcourse.web.pages import notice, page, visitor_words
from gripcourse.web.queues import Queues
from gripcourse.web.rates import REFUSED_LINKS
from gripcourse.web.site import Site
from gripcourse.web.uploads import address_of, count

_log = logging.getLogger(__name__)

LINK_HOURS: Final = 12
"""How long the personal link is good that a student gets by a launch."""

_LARGEST_FORM: Final = 100_000
_SECONDS_OF_FORM: Final = 30.0
_MOST_FIELDS: Final = 50
_BROWSER_BYTES: Final = 24
_LONGEST_COOKIE: Final = 100
_IN_A_PAGE: Final = frozenset({"iframe", "frame", "embed", "object"})

_OLD: Final = message(
    "This way in was used already or is too old. Open the assignment in your learning platform"
    " again."
)
_UNTRUSTED: Final = message(
    "What came is not from your learning platform as it is known here, so nothing was opened."
    " Tell your instructor."
)
_SAID: Final[Mapping[LaunchRefusal, Message]] = {
    LaunchRefusal.PLATFORM: message(
        "This learning platform is not known here. Tell your instructor."
    ),
    LaunchRefusal.STATE: _OLD,
    LaunchRefusal.LATE: _OLD,
    LaunchRefusal.USED: _OLD,
    LaunchRefusal.TIME: _OLD,
    LaunchRefusal.BROWSER: message(
        "This did not begin in this browser, or it keeps no cookies. Open the assignment in your"
        " learning platform again, in a window of its own."
    ),
    LaunchRefusal.KEYS: message(
        "Your learning platform cannot be asked now whether this is from it. Try again later."
    ),
    LaunchRefusal.DENIED: message(
        "Your learning platform did not say who you are. Sign in there, and open the assignment"
        " there again."
    ),
    LaunchRefusal.MESSAGE: message(
        "Your learning platform asks for something else than to open the assignment, such as to"
        " choose content: there is nothing to choose here. As an instructor, add an external tool"
        " without selecting content, and open that."
    ),
    LaunchRefusal.ROLE: message(
        "Your learning platform does not say that you are a student or an instructor of its course."
    ),
}
_OTHER_COURSE: Final = message(
    "The course of your learning platform is not one that this belongs to. Its number there is"
    " {context}; tell your instructor."
)
_NOT_TOLD: Final[Mapping[NotTold, Message]] = {
    NotTold.UNKNOWN: message(
        "Nobody on the list of this course is known by what your learning platform says of you."
        " Your instructor sees that you wait and will say who you are; then open it again. Your"
        " number there: {user}"
    ),
    NotTold.AMBIGUOUS: message(
        "What your learning platform says of you fits several students on the list of this course."
        " Your instructor sees that you wait and will say who you are; then open it again. Your"
        " number there: {user}"
    ),
    NotTold.TAKEN: message(
        "Somebody else of your learning platform is the student that you would be here. Ask your"
        " instructor, who sees that you wait. Your number there: {user}"
    ),
}


@dataclass(frozen=True, slots=True, eq=False)
class Door:
    """What the way in is made of.

    Attributes:
        site: the server.
        address: of the server, as browsers reach it; what a request says of it is not believed.
        keys: of platforms.
        signer: of what browsers bring back.
        queues: of those who are let in.
    """

    site: Site
    address: str
    keys: KeySets
    signer: Signer
    queues: Queues = field(default_factory=Queues)

    @property
    def cookie(self) -> str:
        """What the cookie is called: by https, by a name that no neighbouring site can set."""
        return "__Host-gripcourse-launch" if self.site.secure else "gripcourse-launch"

    def platforms(self) -> tuple[Platform, ...]:
        """Return the platforms as they are declared now."""
        return tuple(load_platforms(self.site.context.course.root).values())


def lti_routes(site: Site, address: str) -> list[Route]:
    """Return the routes of the way in.

    Raises:
        GripcourseError: our key or the file of platforms cannot be used.
    """
    context = site.context
    signer = Signer(context.key, context.course.id)
    door = Door(site, address.rstrip("/"), KeySets(make_client), signer)
    door.platforms()
    public_keys(context.course.root)

    async def login(request: Request) -> Response:
        fields = await _fields(request)
        return await run_in_threadpool(_begin, door, request, fields)

    async def launch(request: Request) -> Response:
        fields = await _fields(request)
        queue = _queue(door, request, fields)
        return await to_thread.run_sync(_enter, door, request, fields, limiter=queue)

    async def keys(_: Request) -> Response:
        published = await run_in_threadpool(public_keys, context.course.root)
        return JSONResponse(published, headers={"Cache-Control": "max-age=300"})

    return [
        Route("/lti/login", login, methods=["GET", "POST"], name="lti_login"),
        Route("/lti/launch", launch, methods=["POST"], name="lti_launch"),
        Route("/lti/keys.json", keys, methods=["GET"], name="lti_keys"),
    ]


async def _fields(request: Request) -> Mapping[str, str]:
    """Return the fields of a form or of the query; the first of each name.

    Raises:
        HTTPException: it is too much, or too slow.
    """
    sent = request.url.query.encode()
    try:
        if request.method == "POST":
            with fail_after(_SECONDS_OF_FORM):
                sent = await _short_body(request)
        pairs = parse_qsl(sent.decode(), keep_blank_values=True, max_num_fields=_MOST_FIELDS)
    except (ValueError, TimeoutError) as fault:
        raise HTTPException(HTTPStatus.BAD_REQUEST) from fault
    return dict(reversed(pairs))


async def _short_body(request: Request) -> bytes:
    sent = b""
    async for part in request.stream():
        sent += part
        if len(sent) > _LARGEST_FORM:
            raise ValueError(_LARGEST_FORM)
    return sent


def _begin(door: Door, request: Request, fields: Mapping[str, str]) -> Response:
    """Ask the platform who it is that comes."""
    site = door.site
    issuer, client, hint = (fields.get(name, "") for name in ("iss", "client_id", "login_hint"))
    found = [
        one for one in door.platforms() if one.issuer == issuer and client in {"", one.client_id}
    ]
    if len(found) != 1 or not hint:
        count(site, REFUSED_LINKS, address_of(request))
        return _refusal(door, request, LaunchRefusedError(LaunchRefusal.PLATFORM))
    platform = found[0]
    if request.headers.get("sec-fetch-dest", "") in _IN_A_PAGE:
        return _own_window(door, request, platform, fields)
    browser = request.cookies.get(door.cookie, "")
    if not browser or len(browser) > _LONGEST_COOKIE:
        browser = secrets.token_urlsafe(_BROWSER_BYTES)
    state = new_state(door.signer, platform, browser, site.clock())
    asked = {
        "scope": "openid",
        "response_type": "id_token",
        "response_mode": "form_post",
        "prompt": "none",
        "client_id": platform.client_id,
        "redirect_uri": f"{door.address}/lti/launch",
        "login_hint": hint,
        "state": state,
        "nonce": nonce_of(door.signer, state),
    }
    if "lti_message_hint" in fields:
        asked["lti_message_hint"] = fields["lti_message_hint"]
    joint = "&" if "?" in platform.authorization_url else "?"
    address = f"{platform.authorization_url}{joint}{urlencode(asked)}"
    response = RedirectResponse(address, HTTPStatus.SEE_OTHER)
    response.set_cookie(
        door.cookie,
        browser,
        max_age=MINUTES * 60,
        path="/",
        secure=site.secure,
        httponly=True,
        # The answer comes as a form of the platform's site: only such a cookie travels with it.
        samesite="none" if site.secure else "lax",
    )
    return response


def _own_window(
    door: Door, request: Request, platform: Platform, fields: Mapping[str, str]
) -> Response:
    """Offer a window of its own to who came within a page of the platform.

    A browser may keep no cookies of ours there, and a page that shows us could lay something over
    what is pressed. This page does nothing but begin again, so it may be shown.
    """
    root = str(request.scope.get("root_path", ""))
    names = ("iss", "client_id", "login_hint", "lti_message_hint", "target_link_uri")
    again = urlencode({name: fields[name] for name in names if name in fields})
    values: dict[str, object] = {"again": f"{root}/lti/login?{again}"}
    words = visitor_words(door.site, request)
    response = page(door.site, request, "window", words, values)
    response.headers["Content-Security-Policy"] = content_policy(platform.frames)
    return response


def _queue(door: Door, request: Request, fields: Mapping[str, str]) -> CapacityLimiter | None:
    """Return where somebody waits who makes us ask a platform; None who is refused at once."""
    browser, state = request.cookies.get(door.cookie, ""), fields.get("state", "")
    try:
        return door.queues.of(check_state(door.signer, state, browser, door.site.clock()))
    except LaunchRefusedError:
        return None


def _enter(door: Door, request: Request, fields: Mapping[str, str]) -> Response:
    """Let somebody in of whom the platform says who it is."""
    try:
        launch = _launch(door, request.cookies.get(door.cookie, ""), fields)
    except LaunchRefusedError as fault:
        count(door.site, REFUSED_LINKS, address_of(request))
        return _refusal(door, request, fault)
    site, root = door.site, str(request.scope.get("root_path", ""))
    context, now = site.context, site.clock()
    if launch.role is PlatformRole.INSTRUCTOR:
        note_place(context, launch, now)
        token = offer_sign_in(context, _name_of(launch), now)
        return RedirectResponse(f"{root}/desk/sign-in/{token}", HTTPStatus.SEE_OTHER)
    told = student_of(context, launch, now)
    if isinstance(told, NotTold):
        _log.warning("launch: %s user of %s", told, launch.platform.name)
        said = replace(_NOT_TOLD[told], values={"user": launch.person.user})
        return notice(site, request, visitor_words(site, request), said, HTTPStatus.FORBIDDEN)
    note_place(context, launch, now)
    expires = (now + timedelta(hours=LINK_HOURS)).replace(microsecond=0)
    token = token_of(context, told.student.id, expires)
    return RedirectResponse(f"{root}/s/{token}/", HTTPStatus.SEE_OTHER)


def _launch(door: Door, browser: str, fields: Mapping[str, str]) -> Launch:
    """Read a launch, and use up what it answers to.

    Raises:
        LaunchRefusedError: it opens nothing.
    """
    state, now = fields.get("state", ""), door.site.clock()
    digest = check_state(door.signer, state, browser, now)
    platform = next((one for one in door.platforms() if is_of(one, digest)), None)
    if platform is None:
        raise LaunchRefusedError(LaunchRefusal.PLATFORM)
    if "error" in fields and "id_token" not in fields:
        raise LaunchRefusedError(LaunchRefusal.DENIED, platform.name)
    nonce = nonce_of(door.signer, state)
    launch = read_launch(fields.get("id_token", ""), platform, door.keys, nonce, now)
    if not store_of(door.site.context).use_state(state, now):
        raise LaunchRefusedError(LaunchRefusal.USED, platform.name)
    return launch


def _name_of(launch: Launch) -> str:
    """Return by what an instructor is known in what is kept."""
    person = launch.person
    return f"{person.name or person.email or person.user} ({launch.platform.name})"


def _refusal(door: Door, request: Request, fault: LaunchRefusedError) -> Response:
    # Nothing that came stands in the log: it may be somebody's key.
    _log.warning("launch refused: %s", fault)
    said = _SAID.get(fault.refused, _UNTRUSTED)
    if fault.refused is LaunchRefusal.CONTEXT:
        said = replace(_OTHER_COURSE, values={"context": fault.context})
    site, status = door.site, HTTPStatus.FORBIDDEN
    if fault.refused is LaunchRefusal.KEYS:
        status = HTTPStatus.SERVICE_UNAVAILABLE
    said = message("{what} ({code})", what=said, code=fault.refused.value)
    return notice(site, request, visitor_words(site, request), said, status)
