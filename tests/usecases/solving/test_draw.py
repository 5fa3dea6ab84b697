from dataclasses import replace
from pathlib import Path

import pytest
from ezdxf import recover

from gripcourse.course.model import Course
from gripcourse.drawing.paper.text import read_text
from gripcourse.errors import UsageError
from gripcourse.text.words import Words
from gripcourse.usecases.solving.draw import write_general_view
from gripcourse.usecases.solving.solve import SolvedVariant, solve_from_table
from support.issued_table import issued_table


@pytest.fixture(scope="module")
def solved(course: Course) -> SolvedVariant:
    table = issued_table(course)
    return solve_from_table(course, table, "002", None)


def test_a_general_view_is_written_for_cad_programs_and_for_browsers(
    solved: SolvedVariant, tmp_path: Path
) -> None:
    written = write_general_view(solved, tmp_path, "Somebody", Words("en"))
    assert [path.name for path in written] == ["002-general-view.dxf", "002-general-view.svg"]
    document, audit = recover.readfile(written[0])
    assert not audit.errors
    assert "Somebody" in [read_text(one) for one in document.modelspace().query("TEXT")]
    assert ">Somebody<" in written[1].read_text(encoding="utf-8")


def test_a_scheme_without_a_general_view_says_so(solved: SolvedVariant, tmp_path: Path) -> None:
    bare = replace(solved.plan, scheme=replace(solved.plan.scheme, view=None))
    with pytest.raises(UsageError, match="declares no general view"):
        write_general_view(replace(solved, plan=bare), tmp_path, "", Words("en"))
