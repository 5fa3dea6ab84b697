"""What an appendix prints finds room on its page, and tells every size."""

from dataclasses import replace

import numpy as np

from gripcourse.course.model import Course
from gripcourse.documents.appendix import Appendix, AppendixTable, appendix_of
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.words import Words

PAGE = 125  # characters of the print of a table that a page has room for


def with_rows(plan: Plan, catalogue: str, sizes: np.ndarray) -> Appendix:
    """Return the appendix of a plan, one of whose catalogues has these sizes in all columns."""
    course = plan.course
    changed = replace(
        course.catalogues[catalogue],
        columns=dict.fromkeys(course.catalogues[catalogue].columns, sizes),
    )
    catalogues = {**course.catalogues, catalogue: changed}
    return appendix_of(replace(plan, course=replace(course, catalogues=catalogues)), Words("en"))


def table_of(tables: tuple[AppendixTable, ...], plan: Plan, catalogue: str) -> AppendixTable:
    title = plan.course.catalogues[catalogue].title
    assert title is not None
    return next(one for one in tables if one.title == title.of("en"))


def test_of_all_whole_numbers_only_the_ends_are_printed(plan: Plan) -> None:
    appendix = with_rows(plan, "pin", np.arange(5, 401) * 1e-3)
    assert table_of(appendix.series, plan, "pin").sizes == ("5", "6", "7", "…", "400")


def test_a_run_ends_where_the_step_changes(plan: Plan) -> None:
    sizes = np.array([1, 1.5, *range(2, 60), 70, 80]) * 1e-3
    appendix = with_rows(plan, "pin", sizes)
    printed = table_of(appendix.series, plan, "pin").sizes
    assert printed == ("1", "1.5", "2", "3", "4", "5", "…", "59", "70", "80")


def test_a_usual_series_is_printed_size_by_size(plan: Plan) -> None:
    catalogue = plan.course.catalogues["pin"]
    printed = table_of(appendix_of(plan, Words("en")).series, plan, "pin").sizes
    assert len(printed) == len(catalogue.columns["diameter"])
    assert "…" not in printed


def test_a_table_that_is_wider_than_the_page_goes_on_below(course: Course) -> None:
    example = course.schemes["worm_sector"].example
    assert example is not None
    plan = make_plan(course, "worm_sector", example.options)
    usual = next(one for one in appendix_of(plan, Words("en")).tables if one.strips)
    assert len(usual.strips) == 1
    (name,) = (
        id_
        for id_, one in course.catalogues.items()
        if one.title and one.title.of("en") == usual.title
    )
    wide = table_of(with_rows(plan, name, np.arange(1, 61) + 0.125).tables, plan, name)
    assert [row for strip in wide.strips for row in strip] == list(wide.rows)
    assert len(wide.strips) > 1
    for strip in wide.strips:
        assert sum(1 + max(map(len, row)) for row in strip) <= PAGE
