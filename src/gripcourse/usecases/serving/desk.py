"""The desk of a course, opened: what links, hand-ins and publications need."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol
from zoneinfo import ZoneInfo

from gripcourse.access.desk.store import Desk, open_desk
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.read import course_address, course_id
from gripcourse.issuing.register import Register
from gripcourse.issuing.signature import key_path, read_key
from gripcourse.issuing.store import VerifiedRegister
from gripcourse.issuing.withdrawal import Join
from gripcourse.machine.database.home import home_of
from gripcourse.policy.load import attempt_rule_of, load_policy
from gripcourse.policy.model import Policy
from gripcourse.policy.time_rules import AttemptRule
from gripcourse.usecases.serving.deadlines import DeskDeadlines
from gripcourse.variants.model import Issued


class DeskBooks(Protocol):
    """What links, signing in and the collecting of hand-ins need, and nothing of a calculation."""

    @property
    def course_id(self) -> str:
        """The id of the course."""

    @property
    def address(self) -> str:
        """Where the course says that it is found in the web; empty for nowhere."""

    @property
    def key(self) -> bytes:
        """The key of the signatures; it is never shown, logged or sent anywhere."""

    @property
    def desk(self) -> Desk:
        """Its part of the database."""

    @property
    def private(self) -> Path:
        """The folder that nobody but the owner reads."""

    def register(self) -> Mapping[str, Issued]:
        """Return what was issued up to now, by student."""

    def find(self, student: str) -> Issued | None:
        """Return what was issued to whom an id names, also where it was joined with another's."""

    def joins(self) -> tuple[Join, ...]:
        """Return which ids stand for one person now, in the order in which they were joined."""

    def attempt_rule(self) -> AttemptRule | None:
        """Return which of several works of a student counts; None where no rule says it."""


@dataclass(frozen=True, slots=True, eq=False)
class KeptBooks:
    """The books of a course whose declarations nobody looked at: they may be wrong meanwhile.

    Attributes:
        course_id, address, key, desk: see `DeskBooks`.
        root: of the course.
    """

    course_id: str
    address: str
    key: bytes
    desk: Desk
    root: Path

    def __repr__(self) -> str:
        """Leave the key out: this may stand in a log."""
        return f"KeptBooks({self.course_id})"

    def register(self) -> Mapping[str, Issued]:
        """Return what was issued up to now, by student."""
        return self._read().by_student()

    def find(self, student: str) -> Issued | None:
        """Return what was issued to whom an id names, also where it was joined with another's."""
        return self._read().find(student)

    def joins(self) -> tuple[Join, ...]:
        """Return which ids stand for one person now, in the order in which they were joined."""
        return self._read().joins

    def _read(self) -> Register:
        return VerifiedRegister(self.root, self.course_id, self.desk.engine).read()

    def attempt_rule(self) -> AttemptRule | None:
        """Return which of several works of a student counts; None where no rule says it."""
        return attempt_rule_of(self.root)

    @property
    def private(self) -> Path:
        """The folder that nobody but the owner reads."""
        return self.root / "private"


@dataclass(frozen=True, slots=True, eq=False)
class DeskContext:
    """A course that issued something, with its desk.

    Attributes:
        course, policy: loaded.
        key: of the signatures; it is never shown, logged or sent anywhere.
        desk: its part of the database.
        issued: what was issued, verified whenever it changed.
        deadlines: of the students, as grading counts them.
    """

    course: Course
    policy: Policy
    key: bytes
    desk: Desk
    issued: VerifiedRegister = field(init=False)
    deadlines: DeskDeadlines = field(init=False)

    def __post_init__(self) -> None:
        """Prepare to read register and deadlines, which are read when they are asked for."""
        issued = VerifiedRegister(self.course.root, self.course.id, self.desk.engine)
        object.__setattr__(self, "issued", issued)
        deadlines = DeskDeadlines(self.course.root, self.policy.late)
        object.__setattr__(self, "deadlines", deadlines)

    def __repr__(self) -> str:
        """Leave the key out: this may stand in a log."""
        return f"DeskContext({self.course.id})"

    def register(self) -> Mapping[str, Issued]:
        """Return what was issued up to now, by student."""
        return self.issued.read().by_student()

    def find(self, student: str) -> Issued | None:
        """Return what was issued to whom an id names, also where it was joined with another's."""
        return self.issued.read().find(student)

    def joins(self) -> tuple[Join, ...]:
        """Return which ids stand for one person now, in the order in which they were joined."""
        return self.issued.read().joins

    def attempt_rule(self) -> AttemptRule | None:
        """Return which of several works of a student counts; None where no rule says it."""
        return self.policy.attempts

    @property
    def course_id(self) -> str:
        """The id of the course."""
        return self.course.id

    @property
    def address(self) -> str:
        """Where the course says that it is found in the web; empty for nowhere."""
        return self.course.address

    @property
    def zone(self) -> ZoneInfo | None:
        """The zone in which deadlines are written; None where none is declared."""
        return None if self.policy.late is None else self.policy.late.time_zone

    @property
    def private(self) -> Path:
        """The folder that nobody but the owner reads."""
        return self.course.root / "private"


def open_context(root: Path) -> DeskContext:
    """Open the desk of a course.

    Raises:
        GripcourseError: course, policy, key or database cannot be used.
    """
    course = load_course(root)
    key = read_key(key_path(root))
    return DeskContext(course, load_policy(course), key, open_desk(home_of(root), course.id))


def open_books(root: Path) -> KeptBooks:
    """Open the desk of a course for what needs its register alone; its declarations may be wrong.

    Raises:
        GripcourseError: key or database cannot be used, or the main file cannot be read.
    """
    identifier, address = course_id(root), course_address(root)
    key = read_key(key_path(root))
    return KeptBooks(identifier, address, key, open_desk(home_of(root), identifier), root)
