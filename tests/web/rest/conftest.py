"""A server that programs ask, with something in it."""

import subprocess
from dataclasses import dataclass
from shutil import which
from typing import TYPE_CHECKING

import pytest
from starlette.testclient import TestClient

from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.usecases.serving.sign_in import offer_sign_in, sign_in
from gripcourse.web.app import make_app
from gripcourse.web.checking import make_checkers
from gripcourse.web.rest.declare import TokenRole
from gripcourse.web.site import Site

if TYPE_CHECKING:
    from starlette.types import ASGIApp

    from web.conftest import Server


@dataclass(frozen=True, slots=True)
class Api:
    """The server, and tokens for it."""

    server: "Server"

    def app(self) -> "ASGIApp":
        """Return a server process that nobody has asked yet."""
        server = self.server
        return make_app(
            Site(
                living=LivingCourse(server.context),
                checkers=make_checkers(server.context, 1, None),
                clock=server.clock,
                assignments=server.classroom.order.out,
                graded=server.graded,
            )
        )

    def batches_end_at_once(self, patch: pytest.MonkeyPatch) -> None:
        """Let a batch that is begun be a process that does nothing."""

        def begun(*_: object) -> "subprocess.Popen[bytes]":
            with subprocess.Popen([which("true") or ""]) as ended:  # noqa: S603 (of this machine)
                return ended  # Python waits for it first, and a slow machine leaves none running

        patch.setattr("gripcourse.web.desk_acts.begin_grading", begun)

    def client(self, *, raises: bool = True) -> TestClient:
        """Return a program that asks it; what goes wrong in the server is raised here, or said."""
        return TestClient(self.app(), "http://testserver", raises)

    def link(self, student: str, days: float = 30) -> str:
        """Return the token of a student."""
        return self.server.home(student, days).split("/")[2]

    def token(self, role: TokenRole) -> str:
        """Return a good token of a role."""
        if role is TokenRole.STUDENT:
            return self.link("s02")
        token = offer_sign_in(self.server.context, "Dr. Ноль", self.server.clock.now)
        if role is TokenRole.SIGN_IN:
            return token
        return sign_in(self.server.context, token, self.server.clock.now) or ""


@pytest.fixture(scope="session")
def api(opened: "Server") -> Api:
    return Api(opened)
