"""Whoever marks sees which work counts where it is another one than the last."""

from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.cli.demo.students import correct
from gripcourse.cli.grading_text import waiting_text
from gripcourse.policy.time_rules import AttemptRule, Counts
from gripcourse.text.words import Words
from gripcourse.usecases.marks.counting import counting_instead
from gripcourse.usecases.marks.handed_in import HandingTime
from gripcourse.usecases.marks.mark import what_waits
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom
    from support.office import Office

Listed = Callable[[Counts | None], str]


@pytest.fixture
def listed(issued: "Classroom", office: "Office", tmp_path: Path) -> Listed:
    """Show what waits for a person of a student whose first work was the better one."""
    files = (issued.hand_in("s01", correct, tmp_path / "first.xlsx"),
             issued.hand_in("s01", forget_one_jaw, tmp_path / "second.xlsx"))  # fmt: skip
    now = office.later()
    times = {str(one): HandingTime(now + timedelta(hours=number), said=True)
             for number, one in enumerate(files)}  # fmt: skip
    office.grade(*files, times=times)

    def show(counts: Counts | None) -> str:
        rule = None if counts is None else AttemptRule(counts, 0)
        context = office.context
        context = replace(context, policy=replace(context.policy, attempts=rule))
        waits = what_waits(office.place)
        instead = counting_instead(office.place, {one.student for one in waits}, context)
        return waiting_text(waits, instead, context, Words("en"))

    return show


def test_the_work_that_counts_is_named_beside_the_last_one(listed: Listed) -> None:
    said = listed(Counts.BEST)
    assert "second.xlsx" in said
    assert "attempt 1 counts: first.xlsx" in said


@pytest.mark.parametrize("counts", [Counts.LAST, None])
def test_where_the_last_one_counts_nothing_is_added(listed: Listed, counts: Counts | None) -> None:
    assert "counts:" not in listed(counts)
