"""The series and tables that a student needs at hand."""

from decimal import Decimal

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.solver.needed_tables import needed_tables, tables_by_taker
from gripcourse.solver.plan import make_plan


def test_every_choice_finds_its_series_and_its_further_ones(course: Course) -> None:
    for scheme in course.schemes.values():
        assert scheme.example is not None
        plan = make_plan(course, scheme.id, scheme.example.options)
        found = tables_by_taker(needed_tables(plan))
        for quantity in plan.answered:
            if quantity.choice is not None:
                series = {
                    one.partition(".")[0] for one in (quantity.choice.column, *quantity.choice.also)
                }
                assert series <= {one.catalogue.id for one in found[quantity.id]}
            elif quantity.kind is Kind.PICK:
                assert found[quantity.id]


def test_sizes_are_those_of_the_file_to_the_last_digit(course: Course) -> None:
    plan = make_plan(course, "electromagnet", course.schemes["electromagnet"].example.options)  # type: ignore[union-attr]
    wire = next(one for one in needed_tables(plan) if one.catalogue.id == "winding_wire")
    lines = (course.root / wire.catalogue.file).read_text(encoding="utf-8").splitlines()
    declared = [Decimal(line) for line in lines if line[:1].isdigit()]
    assert [Decimal(repr(size)) for (size,) in wire.rows] == declared


def test_series_come_before_tables_and_numbers_follow_each_other(course: Course) -> None:
    plan = make_plan(course, "electromagnet", course.schemes["electromagnet"].example.options)  # type: ignore[union-attr]
    tables = needed_tables(plan)
    assert [one.number for one in tables] == list(range(1, len(tables) + 1))
    assert sorted(tables, key=lambda one: not one.is_series) == list(tables)
