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
from gripcourse.gradebook.policy_changes import PolicyLine
from gripcourse.gradebook.regrade import ChangedPart
from gripcourse.text.words import Words
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.kept_policies import PolicyChange
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


def test_what_changed_in_the_policy_is_said_once_and_of_much_the_rest_is_counted(
    stricter: tuple[Regrading, GradingContext],
) -> None:
    found, context = stricter
    text = f"{'a' * 80}, from 1 to "
    lines = [PolicyLine("p.toml", f"key_{number}", "1", "2") for number in range(12)]
    lines[0] = PolicyLine("p.toml", "title", f'"{text}2"', f'"{text}3"')
    lines[1] = PolicyLine("p.toml", "late.per_day", None, "0.1")
    one = PolicyChange("abcdef0" + "9" * 57, 3, tuple(lines))
    said = regrade_text(replace(found, policies=(one,)), None, context, Words("uk"))
    heading, title, added, *_ = said.splitlines()
    assert heading == "Правила оцінювання abcdef0 (робіт: 3) відтоді змінилися:"
    assert title == '  p.toml: title …aaa, from 1 to 2" → …aaa, from 1 to 3"'
    assert added == "  p.toml: late.per_day: додано 0.1"
    assert said.splitlines()[10:12] == ["  p.toml: key_9 1 → 2", "  і ще 2"]
    kinds = replace(one, works=1, lines=()), replace(one, lines=None)
    by_policy = (replace(each, versions=(ChangedPart.POLICY,)) for each in found.changes)
    found = replace(found, policies=kinds, changes=tuple(by_policy))
    first, *others = regrade_text(found, None, context, Words("en")).splitlines()
    assert first.endswith("of 1 work has changed since in comments, layout or order alone.")
    assert "abcdef0" not in "".join(others)
    own = found.to_apply[0].work.attempt.fingerprints.policy
    assert f"the policy {own[:7]}" in "".join(others)
