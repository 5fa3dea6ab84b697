"""An office in which ids are joined: it grades, marks, publishes and regrades; time goes on."""

from collections.abc import Mapping
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Final

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.gradebook.enter import Draft
from gripcourse.gradebook.journal import Published, Signed
from gripcourse.gradebook.model import Attempt
from gripcourse.grading.model import Report
from gripcourse.issuing.withdrawal import Withdrawal
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.handed_in import HandingTime
from gripcourse.usecases.marks.history import history
from gripcourse.usecases.marks.mark import enter_mark, existing_gradebook, item_of, what_waits
from gripcourse.usecases.marks.opening import open_grading, register_of
from gripcourse.usecases.marks.regrade import Regrading, apply_regrade, publish, regrade
from gripcourse.usecases.marks.withdraw import Withdrawn, withdraw
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from gripcourse.policy.model import Policy
    from support.classroom import Classroom

NOW: Final = datetime(2026, 12, 2, 9, tzinfo=UTC)
DRAWING: Final = "general_view_drawing"
_NO_TIMES: Final[Mapping[str, HandingTime]] = MappingProxyType({})


def two_works(issued: "Classroom", folder: Path) -> dict[str, Path]:
    """Hand in a faultless work of s01, and one of s03 with an early slip."""
    return {
        "s01": issued.hand_in("s01", correct, folder / "s01.xlsx"),
        "s03": issued.hand_in("s03", forget_one_jaw, folder / "s03.xlsx"),
    }


class Office:
    """A course with three assignments handed out, its gradebook, and who marks; time goes on."""

    def __init__(self, root: Path, place: str) -> None:
        self.root, self.place, self.now = root, place, NOW
        self.policy: Policy | None = None  # of the course, unless it says otherwise

    @property
    def context(self) -> GradingContext:
        context = open_grading(self.root)
        return context if self.policy is None else replace(context, policy=self.policy)

    def later(self) -> datetime:
        self.now += timedelta(hours=1)
        return self.now

    def grade(
        self, *files: Path, times: Mapping[str, HandingTime] = _NO_TIMES, whose: str = ""
    ) -> list[Report]:
        """Grade files; `whose` says of all of them who handed them in."""
        context = self.context
        if whose:
            context = replace(context, whose=dict.fromkeys(map(str, files), whose))
        reports = [Graded(grade_file(one, context), "") for one in files]
        return [one.report for one in keep(reports, context, self.place, self.later(), times)]

    def grade_and_keep(self, *files: Path) -> tuple[Attempt, ...]:
        """Grade, and return what is kept since then."""
        self.grade(*files)
        return existing_gradebook(self.place).attempts()

    def publish(self, *students: str) -> tuple[Published, ...]:
        joins = register_of(self.root).joins
        return publish(self.place, students, self.signed(), joins)

    def regrade(self, *files: Path) -> Regrading:
        return regrade(files, self.context, self.place, 0, self.later())

    def apply(self, regrading: Regrading, *, allow_lower: bool = False) -> tuple[Attempt, ...]:
        return apply_regrade(regrading, self.place, self.signed(), allow_lower=allow_lower)

    def signed(self) -> Signed:
        return Signed("Петров", self.later(), "так решила кафедра")

    def mark(self, student: str, credit: float | None, comment: str = "") -> int:
        lines = {} if credit is None else dict.fromkeys(("sizes", "assembly", "standards"), credit)
        draft = Draft(student, DRAWING, lines, comment=comment, withdraw=credit is None)
        context = open_grading(self.root)
        return len(enter_mark(draft, context, self.place, "Петров", self.later()).items)

    def join(self, student: str = "s03", person: str = "s01", *, undo: bool = False) -> Withdrawn:
        same_as = "" if undo else person
        wanted = Withdrawal(student, same_as, undo, "Сменила фамилию", "Петров", self.later())
        return withdraw(wanted, self.root, self.place)

    def credit(self, student: str) -> float | None:
        """What the item is worth on the last work of a student, by what counts now."""
        found = item_of(self.place, student, DRAWING, register_of(self.root).joins)
        return None if found is None or found.marked is None else found.marked.mark.credit

    def told(self, student: str) -> list[str]:
        register = register_of(self.root)
        known, withdrawals = register.by_student(), register.withdrawals
        events = history(self.place, student, known, withdrawals=withdrawals)
        return [str(one.what) for one in events]

    def waits(self) -> set[tuple[str, bool]]:
        joins = register_of(self.root).joins
        return {
            (one.student, one.again)
            for one in what_waits(self.place, joins)
            if one.quantity == DRAWING
        }
