"""Cohorts as folders: the workbooks say what the truth says, and grading them is no other thing."""

from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.errors import UsageError
from gripcourse.policy.model import Policy
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.confusion import evaluate
from gripcourse.simulation.in_memory import judge_in_memory
from gripcourse.simulation.model import Conduct, Mix
from gripcourse.simulation.on_disk import (
    grade_cohort,
    register_of,
    submission_path,
    truth_path,
    write_cohort,
)
from gripcourse.simulation.record import read_truth, write_truth
from gripcourse.simulation.student import Classroom
from gripcourse.solver.plan import make_plan
from gripcourse.submission.interpret import interpret
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook

COUNT = 14


@pytest.fixture(scope="module")
def small(course: Course, policy: Policy, mix: Mix) -> Classroom:
    """A small cohort that does everything, honest work too."""
    conducts = dict.fromkeys(Conduct, 1.0) | {Conduct.HONEST: 3.0}
    return make_classroom(
        course, policy, replace(mix, conduct=conducts), COUNT, 2, "rack_parallelogram"
    )


@pytest.fixture(scope="module")
def folder(small: Classroom, tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("cohort")
    write_cohort(small, out, 0)
    return out


def test_the_workbooks_hold_what_the_truth_says(folder: Path, small: Classroom) -> None:
    for work in read_truth(truth_path(folder)):
        variant = small.context.register[work.owner].variant
        plan = make_plan(small.context.course, variant.scheme, variant.options)
        raw = read_workbook(submission_path(folder, work.student))
        assert isinstance(raw, RawWorkbook)
        assert raw.identity.student == work.owner
        answers = interpret(raw, plan.quantities.values()).answers
        for action in work.actions:
            found = answers[action.quantity].value
            assert found == (
                None if action.value is None else pytest.approx(action.value, rel=1e-9)
            )


def test_grading_the_folder_says_what_judging_in_memory_says(
    folder: Path, small: Classroom, course: Course, policy: Policy
) -> None:
    on_disk = evaluate(grade_cohort(folder, course, policy, 0, lambda: None), small.mix)
    in_memory = evaluate(judge_in_memory(small, 1), small.mix)
    assert on_disk.table == in_memory.table
    assert on_disk.rates == in_memory.rates


def test_the_truth_is_read_as_it_was_written(folder: Path, tmp_path: Path) -> None:
    works = read_truth(truth_path(folder))
    write_truth(tmp_path / "again.jsonl", works)
    assert read_truth(tmp_path / "again.jsonl") == works
    assert len(works) == COUNT


def test_the_register_tells_nothing_of_the_truth(folder: Path) -> None:
    text = register_of(folder).read_text(encoding="utf-8")
    assert not any(f'"{conduct}"' in text for conduct in Conduct)


def test_a_damaged_truth_is_named(tmp_path: Path) -> None:
    (tmp_path / "truth.jsonl").write_text('{"format": 1}\n', encoding="utf-8")
    with pytest.raises(UsageError, match="damaged"):
        read_truth(tmp_path / "truth.jsonl")
    with pytest.raises(UsageError, match="no such file"):
        read_truth(tmp_path / "none.jsonl")
