"""What an appendix prints finds room on its page, and tells every size."""

from dataclasses import replace

import numpy as np

from gripcourse.course.model import Course
from gripcourse.documents.appendix import (
    Appendix,
    AppendixFormula,
    AppendixTable,
    QuotedWork,
    appendix_of,
)
from gripcourse.documents.assignment_sheet import STYLES
from gripcourse.documents.pdf import template_environment
from gripcourse.formula import typeset
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.words import Words
from support.laid_out import TEMPLATES, boxes, pages_of

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


def test_many_formulas_go_round_the_only_small_table(course: Course) -> None:
    """Under it they would leave most of its lines empty; the tables after them have the width."""
    example = course.schemes["prism_lever"].example
    assert example is not None
    appendix = appendix_of(make_plan(course, "prism_lever", example.options), Words("ru"))
    (small,) = (one for one in appendix.tables if not one.wide)
    assert (appendix.around, appendix.beside) == (small.number, 0)
    macro = template_environment(TEMPLATES, "ru").get_template("parts/appendix.html.j2").module
    printed = f'<main class="appendix">{macro.printed(appendix)}</main>'  # type: ignore[attr-defined]
    (page,) = pages_of(printed, STYLES)
    tables = [one for one in boxes(page, "div") if "tabled" in one.element.get("class", "")]
    at = appendix.tables.index(small)
    formulas = [one for one in boxes(page, "span") if "quoted" in one.element.get("class", "")]
    assert formulas[0].position_y < tables[at].position_y + tables[at].height
    assert formulas[0].position_x > tables[at].position_x + tables[at].width
    assert len({one.position_x for one in tables}) == 1
    bottom = max(one.position_y + one.height for one in formulas)
    assert all(one.position_y >= bottom for one in tables[at + 1 :])


def test_few_formulas_stand_beside_a_small_table_and_many_follow_several(plan: Plan) -> None:
    appendix = appendix_of(plan, Words("en"))
    small = replace(appendix.series[0], number=1, wide=False)
    formula = AppendixFormula(typeset.symbol_box("x"), ())
    two, three = (QuotedWork(1, "work", (formula,) * count) for count in (2, 3))
    both = (small, replace(small, number=2))
    found = [
        replace(appendix, tables=tables, works=(works,))
        for works in (two, three)
        for tables in ((), (small,), both)
    ]
    assert [(one.beside, one.around) for one in found] == [
        (0, 0), (1, 0), (2, 0), (0, 0), (0, 1), (0, 0),
    ]  # fmt: skip
