"""The group as a table: who has handed in, who has a score, who asks for something."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum

from gripcourse.access.desk.model import HandIn, RegradeRequest
from gripcourse.gradebook.model import GradebookEntry, latest_marks_of_all
from gripcourse.gradebook.store import Gradebook
from gripcourse.text.spelling import alphabetical, plain
from gripcourse.usecases.serving.counted import CountedWork, counted_works
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import is_late, latest
from gripcourse.usecases.serving.taken import (
    checks_by_person,
    checks_of,
    hand_ins_by_person,
    hand_ins_of,
    requests_by_person,
    requests_of,
)
from gripcourse.variants.model import Issued, Student


@dataclass(frozen=True, slots=True)
class GroupMember:
    """A student of the group.

    Attributes:
        issued: the student and what was issued.
        hand_in: the last file; None for none.
        late: whether it came after the last day.
        files, checks: how many.
        requests: for another look that no mark of the item has answered since.
        work: the one that counts; None for none.
        marked: the marks of persons that count, by quantity.
    """

    issued: Issued
    hand_in: HandIn | None
    late: bool
    files: int
    checks: int
    requests: int
    work: CountedWork | None
    marked: Mapping[str, GradebookEntry]

    @property
    def points(self) -> float:
        """What the work that counts came to before lateness, with the marks of persons."""
        return 0.0 if self.work is None else self.work.sums.score

    @property
    def earned(self) -> float:
        """What lateness leaves of the points."""
        return 0.0 if self.work is None else self.work.earned


def newer_than(rows: Iterable[GroupMember], at: datetime) -> tuple[int, int]:
    """Return how many marks of persons and last workbooks came after something was graded."""
    found = tuple(rows)
    marks = sum(entry.mark.marked_at > at for row in found for entry in row.marked.values())
    return marks, sum(row.hand_in is not None and row.hand_in.at > at for row in found)


class GroupState(StrEnum):
    """What is looked for in a group."""

    ANY = ""
    MISSING = "missing"
    HANDED_IN = "handed_in"
    LATE = "late"
    ASKS = "asks"


@dataclass(frozen=True, slots=True)
class Wish:
    """Whom an instructor wants to see.

    Attributes:
        find: part of an id or of a name; empty for all.
        group: of the roster; empty for all.
        state: what is looked for.
    """

    find: str = ""
    group: str = ""
    state: GroupState = GroupState.ANY

    def meets(self, row: GroupMember) -> bool:
        """Tell whether a student is one of them."""
        person = row.issued.student
        states = {
            GroupState.ANY: True,
            GroupState.MISSING: row.hand_in is None and not row.issued.left,
            GroupState.HANDED_IN: row.hand_in is not None,
            GroupState.LATE: row.late,
            GroupState.ASKS: row.requests > 0,
        }
        return (
            plain(self.find) in plain(f"{person.id} {person.name}")
            and self.group in ("", person.group)
            and states[self.state]
        )


def by_group_and_name(one: Student) -> tuple[list[str | int], list[str | int]]:
    """Return by what students are sorted."""
    return alphabetical(one.group), alphabetical(one.name)


def groups_of(rows: Iterable[GroupMember]) -> list[str]:
    """Return the groups that there are, in order."""
    return sorted({row.issued.student.group for row in rows} - {""}, key=alphabetical)


def rows_of(context: DeskContext) -> tuple[GroupMember, ...]:
    """Return everybody, by group and name."""
    rows = _members(context, context.register(), None)
    return tuple(sorted(rows, key=lambda row: by_group_and_name(row.issued.student)))


def row_of(context: DeskContext, student: str) -> GroupMember | None:
    """Return one student of the group; None where the register has none of this id."""
    issued = context.register().get(student)
    return None if issued is None else _members(context, {student: issued}, student)[0]


def _members(
    context: DeskContext, group: Mapping[str, Issued], only: str | None
) -> list[GroupMember]:
    """Return students with what is kept of them; nothing of others is read where one is named."""
    joins = context.joins()
    hand_ins = (
        hand_ins_by_person(context.desk, joins)
        if only is None
        else {only: hand_ins_of(context.desk, only, joins)}
    )
    last = latest(context, hand_ins)
    files = {student: len(of) for student, of in hand_ins.items()}
    checks = (
        checks_by_person(context.desk, joins)
        if only is None
        else {only: checks_of(context.desk, only, joins)}
    )
    book, names = Gradebook(context.desk.engine, joins), None if only is None else {only}
    works = counted_works(context, names)
    marked = latest_marks_of_all(book.entries(names))
    asked = (
        requests_by_person(context.desk, joins)
        if only is None
        else {only: requests_of(context.desk, only, joins)}
    )
    requests = {
        student: sum(not is_answered(one, marked.get(student, {})) for one in all_)
        for student, all_ in asked.items()
    }
    return [
        GroupMember(
            issued=issued,
            hand_in=last.get(id_),
            late=id_ in last and is_late(context, issued, last[id_].at),
            files=files.get(id_, 0),
            checks=len(checks.get(id_, ())),
            requests=requests.get(id_, 0),
            work=works.get(id_),
            marked=marked.get(id_, {}),
        )
        for id_, issued in group.items()
    ]


def is_answered(one: RegradeRequest, marked: Mapping[str, GradebookEntry]) -> bool:
    """Tell whether somebody marked an item since a student asked for another look at it."""
    entry = marked.get(one.item)
    return entry is not None and entry.mark.marked_at > one.at
