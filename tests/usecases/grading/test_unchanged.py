"""Grading again does only what is new, and whatever a report is made from makes it be made anew."""

import dataclasses
import importlib
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime
from hashlib import sha256
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, Final
from zoneinfo import ZoneInfo

import pytest

from gripcourse.cli.demo.students import correct
from gripcourse.course.model import Course
from gripcourse.gradebook.enter import Draft
from gripcourse.gradebook.store import open_gradebook
from gripcourse.gradebook.timing import Waiver
from gripcourse.grading.model import Decision, Flag, FlagCode, Outcome, Report, Timing
from gripcourse.grading.path_pattern import path_pattern
from gripcourse.machine.spreadsheet.preflight import LARGEST_FILE
from gripcourse.policy.load import load_policy
from gripcourse.text.words import message
from gripcourse.usecases.grading.as_before import Beginning, GradingAsked, SaidAtEnd, beginning
from gripcourse.usecases.grading.collect import collect
from gripcourse.usecases.grading.grade import GradingOutcome, grade, is_settled, write_results
from gripcourse.usecases.grading.unchanged import TakenOver, open_earlier, told_of
from gripcourse.usecases.grading.versions import EARLIER
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.handed_in import handed_in_times
from gripcourse.usecases.marks.mark import enter_mark
from gripcourse.usecases.marks.opening import grading_of
from gripcourse.usecases.marks.waive import waive
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

GRADED_ON: Final = date(2026, 12, 2)
NOW: Final = datetime(2026, 12, 9, 9, tzinfo=UTC)
LATER: Final = datetime(2026, 12, 10, 9, tzinfo=UTC)
WORKS: Final = Path("works")
SAID: Final = SaidAtEnd("belts", "two works", "", needs_person=False)
HERE = Path(__file__).parent
# Two hundred files, which each test would copy and each grading would look at.
NOT_LOADED_AGAIN = ("schemes", "sections", "equilibrium", "options", "drawing", "spaces")
LATE = """
[late]
per_day = 0.1
zone = "Europe/Kyiv"
"""


@dataclass
class Desk:
    """A course with two works, in the folder that the process works in; pages cost nothing."""

    course: Course
    fake: ModuleType

    def grade(
        self,
        *,
        out: str = "out",
        day: date | None = None,
        afresh: bool = False,
        now: datetime = NOW,
        **changes: object,
    ) -> GradingOutcome:
        context = replace(grading_of(self.course, load_policy(self.course)), **changes)  # type: ignore[arg-type]
        folder = Path(out)
        begun = self.begun(out)
        versions = begun.versions
        earlier = open_earlier(folder, context, versions, workers=0, day=day, afresh=afresh)
        files = collect([WORKS]).files
        graded = grade(files, context, 0, lambda _: None, earlier)
        times = handed_in_times((), files, ZoneInfo("Europe/Kyiv"))
        graded = keep(graded, context, self.gradebook, now, times)
        outcome = write_results(
            graded,
            context,
            folder,
            day or GRADED_ON,
            0,
            lambda _: None,
            lay_out=self.fake.page,
            earlier=earlier,
        )
        if is_settled(graded, context, folder, 0):
            begun.keep(SAID, [one.report.digest for one in graded], now)
        return outcome

    def begun(self, out: str = "out", *options: object) -> Beginning:
        """Return how everything stands."""
        found = collect([WORKS])
        return beginning(GradingAsked(self.course.root, self.gradebook, Path(out), found, options))

    @property
    def gradebook(self) -> str:
        return str(self.course.root / "private" / "gradebook.sqlite")

    def add(self, file: str, text: str) -> None:
        path = self.course.root / file
        path.parent.mkdir(parents=True, exist_ok=True)
        with path.open("a", encoding="utf-8") as stream:
            stream.write(text)


def made(out: str) -> Mapping[str, bytes]:
    """Return all results of a folder, by name."""
    found = {str(one.relative_to(out)): one for one in Path(out).rglob("*") if one.is_file()}
    return {name: one.read_bytes() for name, one in found.items() if EARLIER not in one.parts}


@pytest.fixture(scope="module")
def fake() -> Iterator[ModuleType]:
    """Pages that say all that they are made from."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(HERE))
        found = importlib.import_module("fake_documents")
        patch.setattr("gripcourse.usecases.grading.cohort_print.cohort_pdf", found.cohort_page)
        yield found


def grade_once(issued: "Classroom", fake: ModuleType, base: Path, *left_out: str) -> None:
    """Grade two works in a folder of their own, with a course that lacks some of its files."""
    ignored = shutil.ignore_patterns(*left_out)
    shutil.copytree(issued.course.root, base / "course", ignore=ignored)
    issued.hand_in("s01", correct, base / WORKS / "s01.xlsx")
    issued.hand_in("s02", forget_one_jaw, base / WORKS / "s02.xlsx")
    for one in (base / WORKS).iterdir():
        os.utime(one, (NOW.timestamp(), NOW.timestamp()))
    desk = Desk(replace(issued.course, root=Path("course")), fake)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(base)
        desk.add("grader/policy.toml", LATE)
        assert desk.grade().taken_over == TakenOver(0, 0)


@pytest.fixture(scope="module")
def graded_once(
    issued: "Classroom", fake: ModuleType, tmp_path_factory: pytest.TempPathFactory
) -> Path:
    base = tmp_path_factory.mktemp("desk")
    grade_once(issued, fake, base, *NOT_LOADED_AGAIN)
    return base


@pytest.fixture
def desk(
    graded_once: Path,
    issued: "Classroom",
    fake: ModuleType,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> Desk:
    """What was graded once; the course is not loaded anew, whatever happens to its files."""
    base = tmp_path / "desk"
    shutil.copytree(graded_once, base)
    monkeypatch.chdir(base)
    return Desk(replace(issued.course, root=Path("course")), fake)


@pytest.fixture
def whole_desk(
    issued: "Classroom", fake: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Desk:
    """What was graded once with a course that another process can load."""
    grade_once(issued, fake, tmp_path)
    monkeypatch.chdir(tmp_path)
    return Desk(replace(issued.course, root=Path("course")), fake)


def register_with(desk: Desk, student: str, **changes: object) -> dict[str, Any]:
    register = grading_of(desk.course, load_policy(desk.course)).register
    entry = register[student]
    told = replace(entry.student, **changes)  # type: ignore[arg-type]
    changed = replace(entry, student=told)
    return {"register": {**register, student: changed}}


def mark(desk: Desk) -> None:
    context = grading_of(desk.course, load_policy(desk.course))
    draft = Draft("s01", "grip_force", {}, credit=0.5, comment="see me", override=True)
    enter_mark(draft, context, desk.gradebook, "Петров", NOW)


def waived(desk: Desk) -> None:
    context = grading_of(desk.course, load_policy(desk.course))
    waiver = Waiver("s01", 0, None, withdrawn=False, person="Петров", done_at=NOW, why="болезнь")
    waive(waiver, desk.gradebook, context.register)


NOTHING = TakenOver(0, 0)
# What is changed, how, and how many results and reports may be taken over after it.
CHANGES: Final[Mapping[str, tuple[Callable[..., Any], TakenOver]]] = {
    "nothing": (lambda _: None, TakenOver(2, 2)),
    "a file of the course": (lambda d: d.add("variants/course.toml", "\n#\n"), NOTHING),
    "a catalogue": (lambda d: d.add("variants/catalogues/one.csv", "d\n1\n"), NOTHING),
    "the policy": (lambda d: d.add("grader/policy.toml", "grace = 500\n"), NOTHING),
    "the slips": (lambda d: d.add("grader/slips.toml", "\n#\n"), NOTHING),
    "a rubric": (lambda d: d.add("grader/rubric/general_view.toml", "\n#\n"), NOTHING),
    "a template": (lambda d: d.add("templates/student.html.j2", "more"), NOTHING),
    "a style": (lambda d: d.add("templates/style/page.css", "p {}"), NOTHING),
    "the name on the register": (lambda d: register_with(d, "s01", name="А"), TakenOver(0, 1)),
    "the language": (lambda d: register_with(d, "s01", language="en"), TakenOver(0, 1)),
    "another's entry": (lambda d: register_with(d, "s03", name="А"), TakenOver(0, 2)),
    "the deadline": (
        lambda d: d.add("variants/deadlines.csv", "group,student,deadline\n,s01,2026-12-08\n"),
        TakenOver(2, 1),
    ),
    "a waiver": (waived, TakenOver(2, 1)),
    "a mark": (mark, TakenOver(2, 1)),
    "a person's word": (lambda _: {"whose": {"works/s01.xlsx": "s01"}}, TakenOver(1, 1)),
    "a pattern": (lambda _: {"pattern": path_pattern("{id}*.xlsx", ["s01", "s02"])}, None),
    "either version": (lambda _: {"either_version": True}, TakenOver(0, 2)),
    "either version, as before": (lambda _: {"either_for": frozenset({"0" * 64})}, TakenOver(0, 2)),
    "LibreOffice": (lambda _: {"office": "none"}, TakenOver(2, 2)),
    "the day": (lambda _: {"day": date(2026, 12, 3)}, TakenOver(2, 0)),
    "asked for": (lambda _: {"afresh": True}, NOTHING),
    "a report that is gone": (lambda _: Path("out/reports/s01.pdf").unlink(), TakenOver(2, 1)),
    "a report that was touched": (
        lambda _: Path("out/reports/s02.pdf").write_bytes(b"%PDF-"),
        TakenOver(2, 1),
    ),
}


@pytest.mark.parametrize("change", CHANGES)
def test_what_changes_is_made_anew_and_nothing_stale_is_left(desk: Desk, change: str) -> None:
    do, expected = CHANGES[change]
    found = do(desk)
    options = found if isinstance(found, dict) else {}
    as_before = (SAID, None) if change == "nothing" else (None, None)
    assert (desk.begun().said_before(), desk.begun("anew").said_before()) == as_before or options
    taken_over = desk.grade(**options).taken_over
    assert expected is None or taken_over == expected
    desk.grade(**{**options, "out": "anew"})
    assert made("out") == made("anew")


def test_of_a_changed_work_only_its_own_is_made_anew(desk: Desk, issued: "Classroom") -> None:
    issued.hand_in("s01", forget_one_jaw, WORKS / "s01.xlsx")
    assert desk.grade().taken_over == TakenOver(1, 1)
    desk.grade(out="anew")
    assert made("out") == made("anew")


def test_evidence_that_a_new_work_brings_makes_the_report_anew_that_it_concerns(
    desk: Desk, issued: "Classroom", monkeypatch: pytest.MonkeyPatch
) -> None:
    issued.hand_in("s03", correct, WORKS / "s03.xlsx")
    said = Flag(FlagCode.SAME_ANSWERS, message("as in the work of s03"))
    monkeypatch.setattr("gripcourse.batch.copies.flags_by_student", lambda *_: {"s01": (said,)})
    assert desk.grade().taken_over == TakenOver(2, 1)
    assert b"as in the work of s03" in Path("out/reports/s01.pdf").read_bytes()
    desk.grade(out="anew")
    assert made("out") == made("anew")


@pytest.mark.parametrize(
    "part",
    [
        "gripcourse.machine.kept._program_digest",
        "gripcourse.usecases.grading.versions._libraries",
        "gripcourse.usecases.grading.versions.catalogue_file",
    ],
)
def test_another_program_library_or_translation_makes_all_anew(
    desk: Desk, monkeypatch: pytest.MonkeyPatch, part: str
) -> None:
    other = Path("other.po")
    other.write_text("", encoding="utf-8")
    values = {"_program_digest": b"other", "_libraries": ["other"], "catalogue_file": other}
    monkeypatch.setattr(part, lambda *_: values[part.rpartition(".")[2]])
    assert desk.grade().taken_over == NOTHING


def file_changed(_: Desk) -> None:
    path = WORKS / "s01.xlsx"
    path.write_bytes(path.read_bytes() + b"more")
    os.utime(path, (NOW.timestamp(), NOW.timestamp()))


def row_added(desk: Desk) -> None:
    columns = "course, student, number, name, study_group, email, language, fixed_variant"
    with closing(sqlite3.connect(desk.gradebook)) as book, book:
        book.execute(
            f"INSERT INTO register_person ({columns})"  # noqa: S608 (ours)
            f" SELECT {columns.replace('number', 'number + 1')} FROM register_person LIMIT 1"
        )


AROUND: Final[Mapping[str, Callable[[Desk], object]]] = {
    "a work": file_changed,
    "the time of a work": lambda _: os.utime(WORKS / "s01.xlsx"),
    "one more file": lambda _: (WORKS / "s03.xlsx").write_bytes(b""),
    "one more file that is not looked at": lambda _: (WORKS / "s03.zip").write_bytes(b""),
    "a work that is gone": lambda _: (WORKS / "s01.xlsx").unlink(),
    "a table": lambda _: Path("out/grades.csv").write_text("", encoding="utf-8"),
    "a report of somebody else": lambda _: Path("out/reports/s09.pdf").write_bytes(b"%PDF-"),
    "the register": row_added,
    "the key": lambda _: Path("course/private/key").write_text("0" * 64, encoding="utf-8"),
    "what was said": lambda _: Path("out", EARLIER, "said.json").write_text("{}", encoding="utf-8"),
}


@pytest.mark.parametrize("change", AROUND)
def test_nothing_is_said_again_once_anything_has_changed(desk: Desk, change: str) -> None:
    assert desk.begun().said_before() == SAID
    assert desk.begun("out", "another option").said_before() is None
    AROUND[change](desk)
    assert desk.begun().said_before() is None


def test_what_somebody_else_decides_meanwhile_is_not_passed_over_next_time(desk: Desk) -> None:
    begun, digests = desk.begun(), [sha256(one.read_bytes()) for one in sorted(WORKS.iterdir())]
    mark(desk)
    begun.keep(SAID, [one.hexdigest() for one in digests], datetime.now(UTC))
    assert desk.begun().said_before() is None
    desk.begun().keep(SAID, [one.hexdigest() for one in digests], datetime.now(UTC))
    assert desk.begun().said_before() == SAID


def test_files_that_were_refused_for_their_content_are_not_looked_at_again(desk: Desk) -> None:
    (WORKS / "s03.xlsx").write_bytes(b"%PDF-1.7 a scan")
    (WORKS / "s04.xlsx").write_bytes(b"")
    (WORKS / "s05.xls").write_bytes(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(9))
    first = desk.grade(now=LATER)
    assert [one.refusal for one in first.reports] == ["", "", "pdf", "empty", "xls"]
    assert desk.begun().said_before() == SAID
    assert desk.grade().taken_over.results == 5
    (WORKS / "s04.xlsx").write_bytes(b"%PDF-1.7 another")
    assert desk.begun().said_before() is None
    assert desk.grade().taken_over.results == 4
    desk.grade(out="anew")
    assert made("out") == made("anew")


def test_a_file_larger_than_any_workbook_is_refused_unread_and_remembered(
    desk: Desk, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = WORKS / "s03.xlsx"
    path.touch()
    os.truncate(path, LARGEST_FILE + 1)
    monkeypatch.setattr(Path, "read_bytes", fail_for(path, Path.read_bytes))
    assert desk.grade(now=LATER).reports[2].refusal == "too_large"
    assert desk.begun().said_before() == SAID
    assert desk.grade().taken_over == TakenOver(3, 3)


def fail_for(path: Path, read: Callable[[Path], bytes]) -> Callable[[Path], bytes]:
    """Read every file but one, which must not be read as a whole."""

    def read_or_fail(one: Path) -> bytes:
        assert one != path
        return read(one)

    return read_or_fail


def test_a_file_that_this_machine_could_not_read_is_looked_at_again(
    desk: Desk, monkeypatch: pytest.MonkeyPatch
) -> None:
    def without_room(*_: object) -> None:
        raise MemoryError

    (WORKS / "s03.xlsx").write_bytes((WORKS / "s02.xlsx").read_bytes())
    with monkeypatch.context() as patch:
        patch.setattr("gripcourse.submission.read.read_checked", without_room)
        refusals = [one.refusal for one in desk.grade(now=LATER).reports]
        assert refusals == ["", "", "too_costly"]
    assert desk.begun().said_before() is None
    assert [one.refusal for one in desk.grade().reports] == ["", "", ""]


@pytest.mark.parametrize(
    ("damaged", "left"),
    [
        (lambda kept: kept[:-9], 1),  # as by a process that was killed while it wrote the last one
        (lambda kept: kept[:200] + b"?" + kept[201:], 1),
        (lambda kept: kept[:9], 0),
    ],
    ids=["end", "middle", "beginning"],
)
def test_a_damaged_result_is_found_out_again(
    desk: Desk, damaged: Callable[[bytes], bytes], left: int
) -> None:
    for one in Path("out", EARLIER).rglob("*.kept"):
        one.write_bytes(damaged(one.read_bytes()))
    assert desk.grade().taken_over == TakenOver(left, 2)


def test_a_course_that_changed_while_it_was_loaded_leaves_nothing(desk: Desk) -> None:
    context = grading_of(desk.course, load_policy(desk.course))
    assert open_earlier(Path("out"), context, "before", workers=0) is None


def test_every_part_of_a_report_is_told(desk: Desk) -> None:
    report = desk.grade().reports[1]
    said = message("word")
    decision = Decision(Outcome.WRONG, 1.0, {}, "", NOW, "", outdated=False)
    timing = Timing(1, 1, True, None, None, 0, 0.0, "")
    finding = replace(report.findings[0], decision=decision)
    whole = replace(report, findings=(finding,), timing=timing, remarks=(said,))
    parts: list[tuple[Any, Callable[[Any], Report]]] = [
        (whole, lambda one: one),
        (timing, lambda one: replace(whole, timing=one)),
        (said, lambda one: replace(whole, remarks=(one,))),
        (finding, lambda one: replace(whole, findings=(one,))),
        (decision, lambda one: replace(whole, findings=(replace(finding, decision=one),))),
    ]
    for part, put in parts:
        for field in dataclasses.fields(part):
            changed = put(replace(part, **{field.name: "another"}))
            assert told_of((changed,)) != told_of((whole,)), field


def grade_to_the_end() -> None:
    """Do what the program that is killed does."""
    importlib.import_module("grade_aloud").main()


def test_a_run_that_is_killed_again_and_again_ends_as_one_that_is_not(whole_desk: Desk) -> None:
    whole = made("out")
    kept = open_gradebook(whole_desk.gradebook).attempts()
    shutil.rmtree("out")
    for moment in ("graded", "reported"):
        call = [sys.executable, str(HERE / "grade_aloud.py")]
        running = subprocess.Popen(  # noqa: S603 (ours)
            call, stdout=subprocess.PIPE, text=True, start_new_session=True
        )
        assert running.stdout is not None
        lines = []
        for line in running.stdout:
            lines.append(line.strip())
            if line.strip() == moment:
                os.killpg(running.pid, signal.SIGKILL)
                break
        running.stdout.close()
        assert running.wait() == -signal.SIGKILL, lines
    grade_to_the_end()
    assert made("out") == whole
    assert open_gradebook("course/private/trial.sqlite").attempts() == kept
