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

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.batch.one_file import judge_read
from gripcourse.batch.run import grade_files
from gripcourse.course.load import load_course
from gripcourse.gradebook.journal import Signed
from gripcourse.gradebook.model import Attempt, Mark
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.gradebook.works import latest_judged
from gripcourse.grading.model import FlagCode, Report
from gripcourse.machine.content import NamedBytes, Readable, content_of, shown_name
from gripcourse.policy.load import load_policy
from gripcourse.policy.time_rules import AttemptRule, Counts
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
from gripcourse.usecases.marks.regrade import publish

BELTS: Final = Path(__file__).parents[2] / "examples" / "belt_drive"
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
def room() -> Room:
    """Everybody has a work of their own, and one with the numbers that another typed.

    The works are of the second course, which is judged in a third of the time.
    """
    course = load_course(BELTS)
    policy = load_policy(course)
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


RULES: Final = (None, *(AttemptRule(counts, 0) for counts in Counts))


@pytest.fixture(scope="module")
def graded_steps(room: Room) -> list[tuple[Graded, ...]]:
    """What each step comes to by itself, the last one twice: which attempt counts is said later."""
    handed = list(steps(room, random.Random(5)))  # noqa: S311
    return [room.grade(files, None) for files in (*handed, handed[-1])]


@pytest.mark.parametrize("rule", RULES, ids=str)
def test_results_that_are_not_read_again_change_nothing(
    room: Room,
    graded_steps: list[tuple[Graded, ...]],
    tmp_path: Path,
    rule: AttemptRule | None,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of two gradebooks the results of one are always read; some are marked, some were told."""
    context = replace(room.context, policy=replace(room.context.policy, attempts=rule))
    ruled = replace(room, context=context)
    books = [tmp_path / name for name in ("unread.sqlite", "read.sqlite")]
    for number, graded in enumerate(graded_steps):
        made = []
        for place in books:
            with monkeypatch.context() as patch:
                if place == books[1]:
                    patch.setattr(Gradebook, "unread_attempts", Gradebook.attempts)
                made.append(tables(graded, ruled, tmp_path / f"{place.stem} {number}", place))
            mark_and_tell(str(place))
        assert made[0] == made[1]
    kept = [open_gradebook(str(place)).attempts() for place in books]
    assert kept[0] == kept[1]
    assert b"mark_outdated" in made[0][0]


def mark_and_tell(place: str) -> None:
    """Mark an item of one student, and tell another the results."""
    book = open_gradebook(place)
    marked, told = sorted({one.student for one in book.attempts()})[:2]
    last = latest_judged(book.standing({marked}))[marked]
    draft = Mark(marked, next(iter(last.by_quantity)), 0, last.number, 0.5, {}, "Петров", NOW, "so")
    book.add_marks([draft])
    publish(place, [told], Signed("Петров", NOW))


def test_a_batch_that_is_kept_already_reads_no_results(
    room: Room, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    graded = room.grade(next(steps(room, random.Random(1))), None)  # noqa: S311
    place = str(tmp_path / "gradebook.sqlite")
    first = keep(graded, room.context, place, NOW)

    def read(*_: object) -> tuple[Attempt, ...]:
        raise AssertionError

    monkeypatch.setattr("gripcourse.gradebook.store.read_attempts", read)
    monkeypatch.setattr("gripcourse.gradebook.store.read_results", read)
    assert keep(graded, room.context, place, NOW) == first
