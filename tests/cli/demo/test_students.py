"""Scripted students do what their names say."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.cli.demo.chosen import early_mistake, measured, smaller_sizes
from gripcourse.cli.demo.students import (
    STORIES,
    blank,
    correct,
    early_slip,
    fill_workbooks,
    printed,
    rounded_down,
    text_and_units,
    three_figures,
)
from gripcourse.course.quantity import Kind
from gripcourse.simulation.write import fill
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Reading, Submission
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook

if TYPE_CHECKING:
    from gripcourse.cli.demo.students import Behaviour, Typed
    from support.classroom import Classroom


def typed_by(issued: "Classroom", behaviour: "Behaviour") -> "Typed":
    typed = behaviour(issued.plan("s01"), issued.register["s01"])
    assert typed is not None
    return typed


def reference(issued: "Classroom") -> dict[str, float]:
    return solve_variant(issued.plan("s01"), issued.register["s01"].variant.given)


def read(issued: "Classroom", file: Path) -> Submission:
    raw = read_workbook(file)
    assert isinstance(raw, RawWorkbook)
    return interpret(raw, issued.plan("s01").quantities.values())


def test_every_story_but_the_blank_one_answers_everything(issued: "Classroom") -> None:
    asked = {one.id for one in issued.plan("s01").answered}
    for story, behaviour in STORIES.items():
        expected = set() if behaviour is blank else asked
        assert set(typed_by(issued, behaviour)) == expected, story


def test_the_correct_student_types_the_reference(issued: "Classroom") -> None:
    right = reference(issued)
    for one in issued.plan("s01").answered:
        value = typed_by(issued, correct)[one.id]
        expected = ("да" if right[one.id] else "нет") if one.kind is Kind.VERDICT else right[one.id]
        assert value == expected


def test_three_figures_are_three_figures_of_numbers_computed_on(issued: "Classroom") -> None:
    typed = typed_by(issued, three_figures)
    for one in issued.plan("s01").answered:
        if one.kind is Kind.FORMULA:
            assert typed[one.id] == float(f"{typed[one.id]:.3g}")


def test_the_early_slip_is_the_first_that_the_course_declares(issued: "Classroom") -> None:
    plan, given = issued.plan("s01"), issued.register["s01"].variant.given
    mistake = early_mistake(plan, given)
    assert mistake is not None
    name, value = mistake
    asked = [one.id for one in plan.answered]
    before = [one for one in plan.answered[: asked.index(name)] if one.kind is Kind.FORMULA]
    assert plan.quantities[name].slips
    right, typed = reference(issued), typed_by(issued, early_slip)
    assert typed[name] == pytest.approx(value)
    assert value != pytest.approx(right[name], rel=0.05)
    assert all(typed[one.id] == right[one.id] for one in before if name not in one.uses)


def test_where_nothing_is_anticipated_the_first_result_is_doubled(issued: "Classroom") -> None:
    plan, given = issued.plan("s01"), issued.register["s01"].variant.given
    plain = {name: replace(one, slips=()) for name, one in plan.quantities.items()}
    bare = replace(plan, quantities=plain, answered=tuple(plain[o.id] for o in plan.answered))
    mistake = early_mistake(bare, given)
    assert mistake is not None
    name, value = mistake
    assert value == pytest.approx(2 * reference(issued)[name])


def test_rounding_down_takes_the_next_smaller_sizes(issued: "Classroom") -> None:
    right, typed = reference(issued), typed_by(issued, rounded_down)
    plan, given = issued.plan("s01"), issued.register["s01"].variant.given
    sizes = smaller_sizes(plan, given, 2)
    assert len(sizes) == 2
    for name in sizes:
        assert plan.quantities[name].choice is not None
        assert typed[name] < right[name]


def test_who_computes_as_printed_differs_where_the_source_errs(issued: "Classroom") -> None:
    right, typed = reference(issued), typed_by(issued, printed)
    assert typed["jaw_travel"] == right["jaw_travel"]
    assert typed["lifting_load"] != pytest.approx(right["lifting_load"])


def test_who_types_text_types_units_too_and_twice_no_number(
    issued: "Classroom", tmp_path: Path
) -> None:
    file = issued.hand_in("s01", text_and_units, tmp_path / "a.xlsx")
    answers = read(issued, file).answers
    unreadable = {name for name, one in answers.items() if one.reading is Reading.UNREADABLE}
    assert unreadable == {one.id for one in measured(issued.plan("s01"))[:2]}
    force = answers["drive_force"]
    assert force.unit == "kN"
    assert force.value == pytest.approx(reference(issued)["drive_force"], rel=1e-4)


def test_answers_are_typed_into_the_named_cells_and_nothing_else_changes(
    issued: "Classroom", tmp_path: Path
) -> None:
    target = tmp_path / "folder" / "a.xlsx"
    fill(issued.workbook("s01"), {"grip_force": 3900.0}, target)
    before, after = read(issued, issued.workbook("s01")), read(issued, target)
    assert after.answers["grip_force"].value == 3900
    assert after.givens == before.givens
    assert after.identity == before.identity
    others = {one.reading for name, one in after.answers.items() if name != "grip_force"}
    assert others == {Reading.BLANK}


def test_the_first_students_play_a_story_each_and_one_copies(
    issued: "Classroom", tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "gripcourse.cli.demo.students.STORIES", {"correct": correct, "blank": blank}
    )
    workbooks = {name: issued.workbook(name) for name in issued.register}
    stories = fill_workbooks(issued.course, issued.register, workbooks, tmp_path)
    assert stories == {"s01": "correct", "s02": "blank", "s03": "copied"}
    assert {path.name for path in tmp_path.iterdir()} == {"s01.xlsx", "s02.xlsx", "s03.xlsx"}
    assert read(issued, tmp_path / "s03.xlsx").identity.student == "s01"
