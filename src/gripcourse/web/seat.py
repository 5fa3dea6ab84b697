"""An instructor at the desk: signed in, and every form of this session."""

import hashlib
import hmac
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from http import HTTPStatus
from typing import Final, TypeAlias

from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from gripcourse.access.lti.platforms import platforms_path
from gripcourse.text.words import Words, message
from gripcourse.web.pages import notice, page, visitor_words
from gripcourse.web.refusals import SIGN_IN, WebRefusal
from gripcourse.web.site import Site
from gripcourse.web.uploads import Sent, read_form

COOKIE: Final = "gripcourse-desk"
_FAULTS: Final = 10  # of the course's files, that a page names
_PURPOSE: Final = b"gripcourse form 1"


@dataclass(frozen=True, slots=True)
class Seat:
    """An instructor who is signed in.

    Attributes:
        site: the server.
        request: what is asked.
        name: who it is.
        form_key: that every form of this session carries, so that no other site can send one.
        sent: the form that came.
    """

    site: Site
    request: Request
    name: str
    form_key: str
    sent: Sent

    @property
    def words(self) -> Words:
        """The language of the desk."""
        return visitor_words(self.site, self.request)

    @property
    def home(self) -> str:
        """The path of the desk."""
        return f"{self.request.scope.get('root_path', '')}/desk/"

    def refuse(self, why: WebRefusal) -> Response:
        """Say why something is not done, with a way back."""
        return notice(self.site, self.request, self.words, why.said, why.status, self.home)

    def page(self, name: str, values: dict[str, object]) -> Response:
        """Show a page with what all pages of the desk have."""
        all_have = {
            "here": name,
            "course_language": self.site.context.course.language,
            "home": self.home,
            "who": self.name,
            "form_key": self.form_key,
            "grades": self.site.graded is not None,
            "faults": [one.say(self.words) for one in self.site.living.faults[:_FAULTS]],
            "platforms": platforms_path(self.site.context.course.root).is_file(),
        }
        return page(self.site, self.request, name, self.words, all_have | values)


Answer: TypeAlias = Callable[[Seat], Response]


def desk_route(site: Site, path: str, answer: Answer, method: str = "GET") -> Route:
    """Return a route of the desk: whoever asks is signed in, and every form of this session."""
    endpoint = _seated(site, answer)
    return Route(f"/desk/{path}", endpoint, methods=[method], name=answer.__name__)


def _seated(site: Site, answer: Answer) -> Callable[[Request], Awaitable[Response]]:
    async def endpoint(request: Request) -> Response:
        session = request.cookies.get(COOKIE, "")
        name = await run_in_threadpool(site.context.desk.session_name, session, site.clock())
        words = visitor_words(site, request)
        if name is None:
            return notice(site, request, words, SIGN_IN.said, HTTPStatus.FORBIDDEN)
        form_key = hmac.new(session.encode(), _PURPOSE, hashlib.sha256).hexdigest()
        sent = Sent({}, None)
        if request.method == "POST":
            sent = await read_form(request)
            given = sent.texts.get("form_key", "")
            if not hmac.compare_digest(given.encode(), form_key.encode()):
                said = message("This form is not of this session. Open the page again.")
                return notice(site, request, words, said, HTTPStatus.FORBIDDEN)
        return await run_in_threadpool(answer, Seat(site, request, name, form_key, sent))

    return endpoint
