"""A batch that comes step by step ends as if it had come at once, byte for byte."""

import hashlib
import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from itertools import pairwise
from pathlib import Path
from typing import Final

import pytest

from gripcourse.batch.kept_reports import KeptReports
from gripcourse.batch.one_file import GradingContext, judge_read
from gripcourse.batch.run import Graded, grade_files
from gripcourse.course.model import Course
from gripcourse.grading.model import FlagCode, Report
from gripcourse.machine.content import NamedBytes, Readable, content_of, shown_name
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.in_memory import judge_one, workbook_of
from gripcourse.simulation.mix import load_mix
from gripcourse.usecases.grading.batch_tables import (
    FILES_CSV,
    GRADES_CSV,
    GRADES_JSON,
    write_tables,
)
from gripcourse.usecases.marks.gradebook import keep

STUDENTS: Final = 14
NOW: Final = datetime(2026, 12, 9, 9, tzinfo=UTC)
LIKE_ANOTHER: Final = {
    FlagCode(one) for one in ("same_answers", "other_variant", "copied_from", "same_bytes")
}


@dataclass(frozen=True)
class Room:
    """What was issued, and what every work comes to by itself."""

    context: GradingContext
    alone: Mapping[str, Report]

    def grade(self, handed: Mapping[str, str], kept: KeptReports | None) -> tuple[Graded, ...]:
        files = [NamedBytes(name, handed[name].encode()) for name in sorted(handed)]
        return grade_files(files, self.context, 0, grade_one=self.graded, kept=kept)

    def graded(self, source: Readable, _context: GradingContext) -> Report:
        content = content_of(source)
        digest = hashlib.sha256(content).hexdigest()
        return replace(self.alone[content.decode()], file=shown_name(source), digest=digest)


@pytest.fixture(scope="module")
def room(course: Course, policy: Policy) -> Room:
    """Everybody has a work of their own, and one with the numbers that another typed."""
    classroom = make_classroom(course, policy, load_mix(course), STUDENTS, 11)
    own = {name: judge_one(name, classroom) for name in classroom.behaviours}
    names, register = tuple(own), classroom.context.register
    alone = {f"{name} {name}": one.report for name, one in own.items()}
    for name, other in pairwise(names):
        typed = {one.quantity: one.typed for one in own[other].work.actions}
        raw = workbook_of(name, register[name], typed)
        alone[f"{name} {other}"] = judge_read(raw, register[name], classroom.context)
    return Room(classroom.context, alone)


def steps(room: Room, chance: random.Random) -> Iterator[dict[str, str]]:
    """Yield what lies in the folder: some works come, others are replaced, a few are taken away."""
    handed: dict[str, str] = {}
    for _ in range(chance.randint(2, 4)):
        for one in chance.sample(sorted(room.alone), chance.randint(3, 9)):
            student = one.split()[0]
            again = "-2" if chance.random() < 0.2 else ""  # a second file of the same student
            handed[f"{student}{again}.xlsx"] = one
        for name in chance.sample(sorted(handed), chance.randint(0, 2)):
            del handed[name]
        yield dict(handed)


def tables(graded: tuple[Graded, ...], room: Room, folder: Path, gradebook: Path) -> list[bytes]:
    """Keep a batch in a gradebook, and return the tables of what comes of it."""
    folder.mkdir()
    entered = keep(graded, room.context, str(gradebook), NOW)
    write_tables([one.report for one in entered], room.context, folder)
    return [(folder / name).read_bytes() for name in (GRADES_CSV, FILES_CSV, GRADES_JSON)]


@pytest.mark.parametrize("seed", range(6))
def test_a_batch_that_came_in_steps_ends_as_one_that_came_at_once(
    room: Room, tmp_path: Path, seed: int
) -> None:
    likened = False
    for number, handed in enumerate(steps(room, random.Random(seed))):  # noqa: S311
        # Every run opens the folder anew.
        after_all = room.grade(handed, KeptReports(tmp_path / "kept", {}))
        at_once = room.grade(handed, None)
        assert [one.report for one in after_all] == [one.report for one in at_once]
        assert tables(after_all, room, tmp_path / f"{number}", tmp_path / "steps.sqlite") == tables(
            at_once, room, tmp_path / f"{number} at once", tmp_path / f"{number}.sqlite"
        )
        flags = {flag.code for one in at_once for flag in one.report.flags}
        likened = likened or bool(flags & LIKE_ANOTHER)
    assert sum(one.taken_over for one in after_all)
    assert likened
