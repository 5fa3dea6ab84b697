"""Issuing assignments: from a roster and a variant table to a folder per student."""

from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from datetime import date
from functools import partial
from multiprocessing import get_context
from pathlib import Path

from gripcourse.assignment.allot import Terms, extend
from gripcourse.assignment.issue import Desk, Handout, issue_one
from gripcourse.assignment.register import read_register, register_path, write_register
from gripcourse.assignment.roster import read_roster
from gripcourse.assignment.signature import key_path, read_key
from gripcourse.cohort.packed import pack, unpack
from gripcourse.course.model import Course
from gripcourse.course.policy import Policy
from gripcourse.solver.plan import make_plan
from gripcourse.variants.model import Issued
from gripcourse.variants.table import read_table
from gripcourse.words import Message


@dataclass(frozen=True, slots=True)
class Order:
    """What is to be issued.

    Attributes:
        roster, table: files.
        out: folder to write the students' folders to.
        today: day of the issue.
        deadline: last day for handing in, None for none.
    """

    roster: Path
    table: Path
    out: Path
    today: date
    deadline: date | None


@dataclass(frozen=True, slots=True)
class Issuing:
    """What was issued: a handout per student, and notes for the instructor."""

    handouts: tuple[Handout, ...]
    notes: tuple[Message, ...]


def issue_order(
    course: Course,
    policy: Policy,
    order: Order,
    workers: int,
    on_done: Callable[[str], None],
) -> Issuing:
    """Issue variants to everybody on the roster and write their documents.

    The register is written before any document: nothing is handed out that it does not know.

    Args:
        course: its folder holds the key and the register.
        policy: printed in the documents.
        order: what to issue.
        workers: how many processes lay out documents.
        on_done: called with each student's id.

    Raises:
        GripcourseError: the roster, the table, the register or the key cannot be used; nothing
            was written.
    """
    students = read_roster(order.roster)
    variants = read_table(order.table, course)
    key = read_key(key_path(course.root))
    before = read_register(register_path(course.root), course.id)
    extended = extend(before, students, variants, Terms(key, order.today, order.deadline))
    write_register(register_path(course.root), extended.register)
    by_student = extended.register.by_student()
    entries = [by_student[student.id] for student in students]
    desk = Desk(course, policy, partial(make_plan, course), order.out)
    return Issuing(_write(desk, entries, workers, on_done), extended.notes)


def _issue_packed(entry: Issued, packed: bytes) -> Handout:
    desk: Desk = unpack(packed)
    return issue_one(desk, entry)


def _write(
    desk: Desk, entries: Sequence[Issued], workers: int, on_done: Callable[[str], None]
) -> tuple[Handout, ...]:
    # Fresh interpreters: a fork would copy the threads of a progress bar in an unknown state.
    with ProcessPoolExecutor(max(1, min(workers, len(entries))), get_context("spawn")) as pool:
        packed = pack(desk)
        jobs = {pool.submit(_issue_packed, entry, packed): entry.student.id for entry in entries}
        done = {}
        for job in as_completed(jobs):
            done[jobs[job]] = job.result()
            on_done(jobs[job])
    return tuple(done[entry.student.id] for entry in entries)
