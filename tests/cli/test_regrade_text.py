"""What is printed of a regrade names students and quantities as people do, beside their ids."""

from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.cli.demo.students import correct
from gripcourse.cli.regrade_text import regrade_text
from gripcourse.text.words import Words
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.regrade import Regrading, regrade
from support.classroom import forget_one_jaw

if TYPE_CHECKING:
    from support.classroom import Classroom

NOW = datetime(2026, 12, 2, 9, tzinfo=UTC)


@pytest.fixture
def stricter(issued: "Classroom", tmp_path: Path) -> tuple[Regrading, GradingContext]:
    """A stricter regrade of one of two works."""
    files = [
        issued.hand_in("s01", correct, tmp_path / "s01.xlsx"),
        issued.hand_in("s02", forget_one_jaw, tmp_path / "s02.xlsx"),
    ]
    context, place = issued.context, str(tmp_path / "gradebook.sqlite")
    keep([Graded(grade_file(one, context), "") for one in files], context, place, NOW)
    stricter = replace(context, policy=replace(context.policy, carried_credit=0.5))
    return regrade(files[1:], stricter, place, 0, NOW), stricter


def test_works_and_quantities_are_called_by_name_and_title(
    stricter: tuple[Regrading, GradingContext], issued: "Classroom"
) -> None:
    found, context = stricter
    name = {one: entry.student.name for one, entry in context.register.items()}
    item = found.to_apply[0].items[0].quantity
    for language in ("en", "uk"):
        said = regrade_text(found, None, context, Words(language))
        title = issued.plan("s02").quantities[item].title.of(language)
        assert f"{name['s02']} (s02), {title} ({item}): " in said
        assert f" {name['s01']} (s01): s01.xlsx." in said
