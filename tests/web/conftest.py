"""A server for a course of three students, asked without a network."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from gripcourse.policy.model import Policy
from gripcourse.usecases.desk import DeskContext, open_context
from gripcourse.usecases.links import token_of
from gripcourse.web.app import make_app
from gripcourse.web.checking import make_checkers
from gripcourse.web.site import Site
from support.classroom import Classroom, forget_one_jaw, open_classroom

BEGAN = datetime(2026, 10, 1, 9, 30, tzinfo=UTC)


@dataclass(slots=True)
class Clock:
    """A clock that a test may move."""

    now: datetime = BEGAN

    def __call__(self) -> datetime:
        return self.now


@dataclass(frozen=True, slots=True)
class Server:
    """A server that is running, and the class that it is for."""

    classroom: Classroom
    context: DeskContext
    graded: Path
    clock: Clock = field(default_factory=Clock)

    def client(self) -> TestClient:
        """Return a browser that has never been here; each has a server process of its own."""
        site = Site(
            context=self.context,
            checkers=make_checkers(self.context, 1, None),
            clock=self.clock,
            assignments=self.classroom.order.out,
            graded=self.graded,
        )
        return TestClient(make_app(site), "http://testserver", follow_redirects=True)

    def home(self, student: str, days: float = 30) -> str:
        """Return the path of a student's personal link."""
        expires = (self.clock.now + timedelta(days=days)).replace(microsecond=0)
        return f"/s/{token_of(self.context, student, expires)}/"

    def filled(self, student: str, folder: Path) -> bytes:
        """Return the workbook of a student who made a mistake."""
        return self.classroom.hand_in(
            student, forget_one_jaw, folder / f"filled_{student}.xlsx"
        ).read_bytes()


@pytest.fixture(scope="session")
def opened(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Server:
    """A class with its documents; tests add to it and find only what they added."""
    folder = tmp_path_factory.mktemp("web")
    classroom = open_classroom(folder, policy)
    issuing = classroom.issue()
    assert all(not one.faults for one in issuing.handouts)
    return Server(classroom, open_context(classroom.course.root), folder / "graded")


@pytest.fixture
def server(opened: Server) -> Iterator[Server]:
    """The same server on its first day."""
    opened.clock.now = BEGAN
    yield opened
    opened.clock.now = BEGAN


@pytest.fixture
def filled(server: Server, tmp_path: Path) -> bytes:
    """The workbook of the first student, filled in."""
    return server.filled("s01", tmp_path)
