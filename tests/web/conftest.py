"""A server for a course of three students, asked without a network."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from gripcourse.desk.store import open_desk
from gripcourse.machine.database.home import home_of
from gripcourse.machine.files import write_bytes
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.desk import DeskContext
from gripcourse.usecases.handout import Handout, IssuingContext, sheet_path, workbook_path
from gripcourse.usecases.issue import issue_order
from gripcourse.usecases.links import token_of
from gripcourse.variants.model import Issued
from gripcourse.web.app import make_app
from gripcourse.web.checking import make_checkers
from gripcourse.web.site import Site
from gripcourse.workbook.write import write_answer_workbook
from support.classroom import KEY, Classroom, forget_one_jaw, open_classroom
from support.databases import postgresql_server

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


def quick_handout(context: IssuingContext, entry: Issued) -> Handout:
    """Write the real workbook, and a sheet that nobody reads."""
    student, words = entry.student.id, Words(entry.student.language)
    sheet, workbook = sheet_path(context.out, student), workbook_path(context.out, student)
    write_bytes(sheet, b"%PDF of " + student.encode())
    plan = context.plan(entry.variant.composition)
    write_answer_workbook(workbook, plan, entry, context.course, words)
    return Handout(student, (sheet, workbook), ())


@pytest.fixture(scope="session")
def opened(tmp_path_factory: pytest.TempPathFactory, policy: Policy) -> Server:
    """A class with its documents; tests add to it and find only what they added."""
    folder = tmp_path_factory.mktemp("web")
    classroom = open_classroom(folder, policy)
    course = classroom.course
    issue_order(course, policy, classroom.order, 0, lambda _: None, issue_one=quick_handout)
    desk = open_desk(home_of(course.root), course.id)
    return Server(classroom, DeskContext(course, policy, KEY, desk), folder / "graded")


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
