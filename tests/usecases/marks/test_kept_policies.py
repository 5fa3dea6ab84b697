"""The policy that works were graded by is kept, so that what changed in it can be named."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from io import BytesIO
from pathlib import Path
from shutil import copytree
from typing import TYPE_CHECKING
from zipfile import ZipFile

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.gradebook.journal import Signed
from gripcourse.gradebook.policy_changes import PolicyLine
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.history import history
from gripcourse.usecases.marks.regrade import Regrading, apply_regrade, regrade, undo_regrade
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

NOW = datetime(2026, 12, 2, 9, tzinfo=UTC)
POLICY = Path("grader") / "policy.toml"
HALF = PolicyLine("grader/policy.toml", "credit.carried", "1.0", "0.5")


@dataclass
class Department:
    """A course of one student's work, whose head changes the policy."""

    context: GradingContext
    work: Path
    hours: int = 0

    @property
    def root(self) -> Path:
        return self.context.course.root

    @property
    def folder(self) -> Path:
        return self.root / "private" / "policies"

    @property
    def kept(self) -> list[Path]:
        return sorted(self.folder.iterdir())

    @property
    def place(self) -> str:
        return str(self.root / "own.sqlite")

    def grade(self) -> None:
        keep([Graded(grade_file(self.work, self.context), "")], self.context, self.place, NOW)

    def write(self, old: str, new: str) -> None:
        text = (self.root / POLICY).read_text(encoding="utf-8")
        assert text.count(old) == 1
        (self.root / POLICY).write_text(text.replace(old, new), encoding="utf-8")

    def carried(self, credit: float) -> None:
        """Let what follows from own numbers be worth something else."""
        before = self.context.policy.carried_credit
        self.write(f"carried = {before} ", f"carried = {credit} ")
        policy = replace(self.context.policy, carried_credit=credit)
        self.context = replace(self.context, policy=policy)

    def regrade(self) -> Regrading:
        return regrade([self.work], self.context, self.place, 0, NOW)

    def signed(self) -> Signed:
        self.hours += 1
        return Signed("Петров", NOW + timedelta(hours=self.hours), "so")

    def told(self) -> Iterable[str]:
        return (str(one.what) for one in history(self.place, "s02", root=self.root))


@pytest.fixture
def department(issued: "Classroom", tmp_path: Path) -> Department:
    root = tmp_path / "course"
    copytree(issued.course.root / "grader", root / "grader")
    (root / "variants").mkdir()
    (root / "private").mkdir()
    context = replace(issued.context, course=replace(issued.course, root=root))
    work = issued.hand_in("s02", forget_one_jaw, tmp_path / "s02.xlsx")
    made = Department(context, work)
    made.grade()
    return made


def test_a_regrade_names_the_lines_that_changed_since_each_policy(department: Department) -> None:
    assert department.regrade().policies == ()
    department.carried(0.5)
    found = department.regrade()
    assert [(one.works, one.lines) for one in found.policies] == [(1, (HALF,))]
    assert len(department.kept) == 1  # nothing is kept of what was only looked at
    apply_regrade(found, department.place, department.signed())
    department.write("relative = 0.01", "relative = 0.010  # one percent")
    assert [one.lines for one in department.regrade().policies] == [()]


def test_a_history_names_them_since_what_stood(department: Department) -> None:
    for credit in (0.5, 0.25):
        department.carried(credit)
        apply_regrade(department.regrade(), department.place, department.signed())
        undo_regrade(department.place, department.signed())
    named = [one.partition("policy: ")[2] for one in department.told() if "Attempt" in one]
    line = "grader/policy.toml: credit.carried 1.0 → "
    assert named == ["", f"{line}0.5", f"{line}0.25"]


@pytest.mark.parametrize("damage", [b"", b"PK"])
def test_a_damaged_one_counts_as_not_kept(department: Department, damage: bytes) -> None:
    department.carried(0.5)
    for path in department.kept:
        path.write_bytes(damage)
    found = department.regrade()
    assert [one.lines for one in found.policies] == [None]
    assert len(found.to_apply) == 1


def test_where_none_can_be_kept_works_are_graded_all_the_same(department: Department) -> None:
    for path in department.kept:
        path.unlink()
    department.folder.rmdir()
    department.folder.write_bytes(b"")
    department.carried(0.5)
    department.grade()
    department.carried(0.25)
    assert [one.lines for one in department.regrade().policies] == [None]


def _cut(content: bytes) -> bytes:
    return content[:-30]


def _of_another_method(content: bytes) -> bytes:
    """A bit of the first file's method of packing is another, in the list at the end."""
    place = content.rindex(b"PK\x01\x02") + 10
    return content[:place] + bytes([content[place] ^ 64]) + content[place + 1 :]


def _of_another_policy(_: bytes) -> bytes:
    stream = BytesIO()
    with ZipFile(stream, "w") as archive:
        archive.writestr("grader/policy.toml", "[credit]\ncarried = 0.125\n")
    return stream.getvalue()


@pytest.mark.parametrize(
    "damaged", [_cut, _of_another_method, _of_another_policy, lambda _: b"", lambda _: b"PK"]
)
def test_a_damaged_one_is_kept_again_while_it_is_todays(
    department: Department, damaged: Callable[[bytes], bytes]
) -> None:
    (path,) = department.kept
    whole = path.read_bytes()
    path.write_bytes(damaged(whole))
    department.grade()
    assert path.read_bytes() == whole
    department.carried(0.5)
    assert [one.lines for one in department.regrade().policies] == [(HALF,)]


def test_a_whole_one_is_not_written_again(department: Department) -> None:
    (path,) = department.kept
    before = path.stat()
    department.grade()
    after = path.stat()
    assert (after.st_ino, after.st_mtime_ns) == (before.st_ino, before.st_mtime_ns)
