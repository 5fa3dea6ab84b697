"""A server for a course of three students, asked without a network."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from itertools import count
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from gripcourse.access.desk.store import open_desk
from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.exports.grades import grades_text
from gripcourse.machine.content import NamedBytes
from gripcourse.machine.database.home import home_of
from gripcourse.machine.files import write_bytes
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.grading.batch_tables import GRADES_CSV, GRADES_JSON, json_text
from gripcourse.usecases.grading.grade import REPORTS
from gripcourse.usecases.issuing.handout import Handout, IssuingContext, sheet_path, workbook_path
from gripcourse.usecases.issuing.issue import issue_order
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.publishing.publish import current, withdraw
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import collect_hand_ins
from gripcourse.usecases.serving.links import token_of
from gripcourse.usecases.serving.living import LivingCourse
from gripcourse.usecases.serving.sign_in import offer_sign_in
from gripcourse.variants.model import Issued
from gripcourse.web.app import make_app
from gripcourse.web.checking import make_checkers
from gripcourse.web.site import Site
from gripcourse.workbook.write import write_answer_workbook
from support.classroom import KEY, Classroom, forget_one_jaw, open_classroom
from support.clock import BEGAN, Clock


@dataclass(frozen=True, slots=True)
class Server:
    """A server that is running, and the class that it is for."""

    classroom: Classroom
    context: DeskContext
    graded: Path
    clock: Clock = field(default_factory=Clock)

    def client(self, root_path: str = "", *, raises: bool = True) -> TestClient:
        """Return a browser that has never been here; each has a server process of its own.

        Args:
            root_path: below which the server stands.
            raises: whether what goes wrong in the server is raised here too.
        """
        site = Site(
            living=LivingCourse(self.context, seconds=0),
            checkers=make_checkers(self.context, 1, None),
            clock=self.clock,
            assignments=self.classroom.order.out,
            graded=self.graded,
        )
        return TestClient(make_app(site), "http://testserver", raises, root_path)

    def home(self, student: str, days: float = 30) -> str:
        """Return the path of a student's personal link."""
        expires = (self.clock.now + timedelta(days=days)).replace(microsecond=0)
        return f"/s/{token_of(self.context, student, expires)}/"

    def filled(self, student: str, folder: Path) -> bytes:
        """Return the workbook of a student who made a mistake."""
        return self.classroom.hand_in(
            student, forget_one_jaw, folder / f"filled_{student}.xlsx"
        ).read_bytes()

    def grade(self, folder: Path) -> None:
        """Grade what the first student handed in, with a report that nobody reads."""
        files = collect_hand_ins(self.context, folder / "work")
        context = GradingContext(self.context.course, self.context.policy, self.context.register())
        graded = [
            Graded(grade_file(NamedBytes(one.name, one.read_bytes()), context), "")
            for one, kept in files.items()
            if kept.student == "s01"
        ]
        place = home_of(self.context.course.root)
        reports = [one.report for one in keep(graded, context, place, self.clock.now)]
        (self.graded / REPORTS).mkdir(parents=True, exist_ok=True)
        (self.graded / REPORTS / "s01.pdf").write_bytes(b"%PDF report")
        (self.graded / GRADES_JSON).write_text(json_text(reports, Words("en")), encoding="utf-8")
        (self.graded / GRADES_CSV).write_text(grades_text(reports), encoding="utf-8-sig")
        assert reports


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


@pytest.fixture(scope="session")
def minutes() -> Iterator[int]:
    """One minute after the other, as long as there are tests."""
    return count(1)


@pytest.fixture
def server(opened: Server, minutes: Iterator[int]) -> Iterator[Server]:
    """The same server on its first day, a minute later for each test.

    Else all would hand in at once, which is more than one student may do. What a test publishes is
    withdrawn behind it.
    """
    opened.clock.now = BEGAN + timedelta(minutes=next(minutes))
    was_published = current(opened.context)
    yield opened
    if current(opened.context) and not was_published:
        withdraw(opened.context, "Dr. Ноль", "", opened.clock.now)
    opened.clock.now = BEGAN


@pytest.fixture
def added_to_policy(server: Server) -> Iterator[Path]:
    """Where a file comes to the policy after works were graded; it goes with the test."""
    path = server.context.course.root / "grader" / "early&late.toml"
    yield path
    path.unlink(missing_ok=True)


@pytest.fixture
def filled(server: Server, tmp_path: Path) -> bytes:
    """The workbook of the first student, filled in."""
    return server.filled("s01", tmp_path)


@pytest.fixture
def signed_in(server: Server) -> TestClient:
    """An instructor's browser."""
    return sign_in(server)


def sign_in(server: Server) -> TestClient:
    """Return a browser in which an instructor is signed in."""
    client = server.client()
    token = offer_sign_in(server.context, "Dr. Ноль", server.clock.now)
    assert client.post(f"/desk/sign-in/{token}").status_code == 200
    return client


def form_key(client: TestClient) -> str:
    """Return what every form of a session carries."""
    found = re.search(r'name="form_key" value="([0-9a-f]{64})"', client.get("/desk/").text)
    assert found is not None
    return found[1]
