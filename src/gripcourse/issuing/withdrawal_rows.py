"""Withdrawals as rows of their table, and what they make of a register."""

from dataclasses import replace

from sqlalchemy import Connection, select

from gripcourse.issuing import schema
from gripcourse.issuing.register import Register
from gripcourse.issuing.withdrawal import (
    Withdrawal,
    as_of_person,
    joined_to,
    why_left,
    with_joined,
)
from gripcourse.machine.database.moments import in_utc, stored


def fetch_withdrawals(connection: Connection, course_id: str) -> tuple[Withdrawal, ...]:
    """Return all withdrawals of a course, oldest first."""
    table = schema.withdrawals
    question = select(table).where(table.c.course == course_id).order_by(table.c.number)
    return tuple(
        Withdrawal(row.student, row.same_as, row.undone, row.why, row.by, in_utc(row.at))
        for row in connection.execute(question)
    )


def withdrawal_row(course: str, number: int, withdrawal: Withdrawal) -> dict[str, object]:
    """Return the row of a withdrawal; they are numbered within a course."""
    return {
        "course": course,
        "number": number,
        "student": withdrawal.student,
        "same_as": withdrawal.same_as,
        "undone": withdrawal.undone,
        "by": withdrawal.person,
        "why": withdrawal.why,
        "at": stored(withdrawal.at),
    }


def as_withdrawn(register: Register) -> Register:
    """Let the withdrawals of a register count, whose entries are as they were issued."""
    joined, left = joined_to(register.withdrawals), why_left(register.withdrawals)
    entries = {
        one.student.id: replace(one, left=left.get(one.student.id, ""))
        for one in register.entries
        if one.student.id not in joined
    }
    others = [one for one in register.entries if one.student.id in joined]
    for person in joined.values():
        own = (one for one in others if joined[one.student.id] == person)
        entries[person] = with_joined(entries[person], own)
    earlier = tuple(
        as_of_person(one, entries[joined[one.student.id]].student)
        if one.student.id in joined
        else one
        for one in (*register.earlier, *others)
    )
    return replace(
        register,
        entries=tuple(entries.values()),
        earlier=earlier,
        joined=tuple(one.student for one in others),
    )
