"""A course whose people come by a platform on this machine."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl, urlsplit

import httpx2
from starlette.testclient import TestClient
from starlette.types import ASGIApp

from gripcourse.access.desk.store import open_desk
from gripcourse.access.lti.platforms import Platform
from gripcourse.access.lti.user_rule import UserRule
from gripcourse.machine.database.home import home_of
from gripcourse.policy.model import Policy
from gripcourse.usecases.issuing.handout import Handout
from gripcourse.usecases.issuing.issue import issue_order
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.usecases.serving.lti import register_platform
from gripcourse.web.app import make_app
from gripcourse.web.checking import make_checkers
from gripcourse.web.lti import lti_routes
from gripcourse.web.platform_people import people_routes
from gripcourse.web.site import Site
from support.classroom import KEY, open_classroom
from support.clock import BEGAN, Clock
from support.platform import CLAIM, CLIENT_ID, TEACHER, TOOL, StandIn, running

ROSTER = """\
student,name,group,email,language,variant
s01,Иванова Анна,РТК-41,,ru,
s02,Шевченко Оксана,РТК-41,oksana@example.org,uk,
s03,Julia Carter,РТК-42,both@example.org,en,
s04,Jane Doe,РТК-42,both@example.org,en,
"""
PEOPLE: dict[str, dict[str, Any]] = {
    "anna": {f"{CLAIM}lis": {"person_sourcedid": "s01"}, "name": "Anna"},
    "oksana": {"email": "Oksana@Example.org"},
    "nobody": {"name": "Nobody Known", "email": "who@example.org"},
    "double": {"email": "both@example.org"},
    "contrary": {f"{CLAIM}lis": {"person_sourcedid": "s01"}, "email": "oksana@example.org"},
    "ray": {"name": "Dr. Ray", f"{CLAIM}roles": [TEACHER]},
}


@dataclass(frozen=True, slots=True)
class LtiCourse:
    """A course, a platform that is declared in it, and the clock of both."""

    context: DeskContext
    platform: StandIn
    clock: Clock = field(default_factory=Clock)

    @property
    def declared(self) -> Platform:
        return declared_as(self.platform)

    def client(self, **changes: object) -> TestClient:
        """Return a browser that has never been here; its server is its own."""
        return TestClient(self.app(**changes), TOOL, follow_redirects=False)

    def app(self, **changes: object) -> ASGIApp:
        """Return a server."""
        site = self.site(**changes)
        return make_app(site, [*lti_routes(site, TOOL), *people_routes(site)])

    def site(self, **changes: object) -> Site:
        """Return what its pages are made from."""
        return Site(
            living=LivingCourse(self.context),
            checkers=make_checkers(self.context, 1, None),
            clock=self.clock,
            **changes,  # type: ignore[arg-type]
        )

    def begin(self, client: TestClient, hint: str, **more: str) -> dict[str, str]:
        """Open the assignment in the platform; return what the tool asks it."""
        sent = {"iss": self.platform.address, "login_hint": hint, "target_link_uri": TOOL, **more}
        answer = client.get("/lti/login", params=sent)
        assert answer.status_code == 303, answer.text
        assert answer.headers["location"].startswith(f"{self.platform.address}/auth?")
        return dict(parse_qsl(urlsplit(answer.headers["location"]).query))

    def come(self, client: TestClient, hint: str) -> httpx2.Response:
        """Go the whole way, through the platform's own page."""
        asked = self.begin(client, hint)
        form = httpx2.get(f"{self.platform.address}/auth", params=asked, trust_env=False).text
        fields = [part.split('"') for part in form.split("<input ")[1:]]
        assert f'action="{TOOL}/lti/launch"' in form
        answer = client.post("/lti/launch", data={one[3]: one[5] for one in fields})
        assert isinstance(answer, httpx2.Response)
        return answer


@contextmanager
def on_its_first_day(school: LtiCourse) -> Iterator[LtiCourse]:
    """Give a course to one test, and take back what it did to records and platform."""
    records = school.context.course.root / "private"
    before = records.with_name("private-before")
    shutil.copytree(records, before)
    try:
        yield school
    finally:
        shutil.rmtree(records)
        before.rename(records)
        school.clock.now = BEGAN
        school.platform.down = False
        school.platform.scores.clear()
        school.platform.refuses.clear()
        school.platform.faults.clear()


def declared_as(platform: StandIn) -> Platform:
    """Return a platform as an administrator would declare it."""
    return Platform(
        name="moodle",
        issuer=platform.address,
        client_id=CLIENT_ID,
        authorization_url=f"{platform.address}/auth",
        token_url=f"{platform.address}/token",
        jwks_url=f"{platform.address}/jwks",
        deployments=("1",),
        contexts=("course-2",),
        known_by=(UserRule.SOURCEDID, UserRule.EMAIL),
        frames=(platform.address,),
        token_audience=f"{platform.address}/token",
    )


@contextmanager
def open_lti_course(folder: Path, policy: Policy) -> Iterator[LtiCourse]:
    """Make a course of which only the register was written, and run a platform for it."""
    classroom = open_classroom(folder, policy, ROSTER)
    course, nothing = classroom.course, Handout("", (), ())
    issue_order(course, policy, classroom.order, 0, lambda _: None, issue_one=lambda *_: nothing)
    context = DeskContext(course, policy, KEY, open_desk(home_of(course.root), course.id))
    clock = Clock()

    def seconds() -> float:
        return clock().timestamp()

    with running(seconds) as platform:
        platform.users.update(PEOPLE)
        register_platform(course.root, declared_as(platform))
        made = LtiCourse(context, platform, clock)
        platform.tool_keys = lambda: made.client().get("/lti/keys.json").json()
        yield made
