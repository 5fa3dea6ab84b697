"""What workers work out of a report as a whole holds for just that report."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import ModuleType

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Graded, with_reports
from gripcourse.batch.run import grade_files
from gripcourse.exports.report_json import json_around
from gripcourse.grading.folded import digest_of_report

Inbox = Callable[..., list[Path]]


@pytest.fixture
def graded(context: GradingContext, fake: ModuleType, inbox: Inbox) -> Sequence[Graded]:
    line_of = partial(json_around, language="uk", scales=context.policy.scales)
    files = inbox(s01="good", s02="die", s03="good")
    return grade_files(files, context, 1, grade_one=fake.obey, line_of=line_of)


def test_it_is_what_would_be_worked_out_here(
    context: GradingContext, graded: Sequence[Graded]
) -> None:
    stated = [one.stated for one in graded]
    assert stated[1] is None  # its worker died
    for one, said in zip(graded, stated, strict=True):
        if said is not None:
            assert said.line == json_around(one.report, "uk", context.policy.scales)
            assert said.digest == digest_of_report(one.report) == one.digest


def test_it_does_not_hold_for_what_a_report_became_since(graded: Sequence[Graded]) -> None:
    other = replace(graded[0].report, score=0.125)
    since = with_reports(graded, [(0, other)])
    assert since[0].stated is None
    assert since[0].digest == digest_of_report(other) != graded[0].digest
    assert since[2].stated == graded[2].stated
