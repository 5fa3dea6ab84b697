"""Pages: a template of the course's look, filled in the reader's language."""

from collections.abc import Callable
from datetime import datetime
from functools import cache
from http import HTTPStatus
from typing import Final
from zoneinfo import ZoneInfo

from starlette.requests import Request
from starlette.responses import HTMLResponse, Response

from gripcourse.documents.pdf import template_environment
from gripcourse.gradebook.deadlines import END_OF_DAY
from gripcourse.text.moments import hour_text, moment_text
from gripcourse.text.words import LANGUAGES, Message, Words
from gripcourse.variants.model import Issued
from gripcourse.web.site import Site

_LANGUAGE: Final = "visitor_language"
_HOME: Final = "visitor_home"


def page(
    site: Site,
    request: Request,
    name: str,
    words: Words,
    values: dict[str, object],
    status: HTTPStatus = HTTPStatus.OK,
) -> HTMLResponse:
    """Fill a template of `templates/web`.

    Args:
        site: the server.
        request: that is answered; pages link below the path that the server has.
        name: of the template, without its suffixes.
        words: language of the page.
        values: what the template gets besides `root`, `course` and `when`.
        status: of the answer.
    """
    course = site.context.course
    environment = template_environment(course.root / "templates", words.language)
    everywhere: dict[str, object] = {
        "root": str(request.scope.get("root_path", "")),
        "course": course.title.of(words.language),
    }
    # Templates call only what their environment offers. Other threads fill the same one: whoever
    # comes first or last offers the same function.
    environment.globals["when"] = _when_in(words.language, site.context.zone)
    template = environment.get_template(f"web/{name}.html.j2")
    return HTMLResponse(template.render(everywhere | values), status)


def hour_of(deadline: datetime | None, words: Words) -> str:
    """Write until what hour of its day a deadline is, in its own zone; empty for all of the day."""
    if deadline is None or deadline.time() == END_OF_DAY:
        return ""
    return hour_text(deadline, words)


def notice(
    site: Site,
    request: Request,
    words: Words,
    said: Message,
    status: HTTPStatus,
    back: str = "",
) -> Response:
    """Say one thing on a page of its own.

    Args:
        site: the server.
        request: that is answered.
        words: language of the page.
        said: what is said.
        status: of the answer.
        back: where a link leads to; empty for none.
    """
    values: dict[str, object] = {"said": words.say(said), "back": back}
    return page(site, request, "notice", words, values, status)


def visitor_words(site: Site, request: Request) -> Words:
    """Return the language of a visitor: the student's once the link was opened, else the browser's.

    Whatever goes wrong later, with the form for example, is said in that language too.
    """
    known: str | None = getattr(request.state, _LANGUAGE, None)
    return Words(known or asked_language(request) or site.context.course.language)


def student_words(site: Site, issued: Issued) -> Words:
    """Return the language of a student: the roster's, else the course's."""
    return Words(issued.student.language or site.context.course.language)


def remember_visitor(request: Request, words: Words, home: str = "") -> None:
    """Keep for the rest of a request what its visitor reads, and where the way back leads.

    Args:
        request: that is answered.
        words: language of the visitor.
        home: path of the visitor's page; empty for none.
    """
    setattr(request.state, _LANGUAGE, words.language)
    setattr(request.state, _HOME, home)


def way_back(request: Request) -> str:
    """Return where a link leads from a page that says what went wrong; empty for nowhere."""
    return str(getattr(request.state, _HOME, ""))


def asked_language(request: Request) -> str | None:
    """Return the first language of a request that we speak; None where it names none."""
    for wish in request.headers.get("accept-language", "").split(","):
        language = wish.strip()[:2].lower()
        if language in LANGUAGES:
            return language
    return None


@cache
def _when_in(language: str, zone: ZoneInfo | None) -> Callable[[datetime], str]:
    words = Words(language)
    return lambda moment: moment_text(moment, words, zone, seconds=True)
