"""A variant for which no size of a series will do is not handed out."""

from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.errors import TableError
from gripcourse.variants.table import read_table

SPRINGS = Path(__file__).parents[1] / "support" / "spring_course"
TABLE = """variant,scheme,wire,force,stress_assumed,index
A1,spring,bright,100,800,6
A2,spring,zinc,600,5000,6
"""


def test_its_author_is_told_the_variant_the_choice_and_the_last_size(tmp_path: Path) -> None:
    """At 600 N a wire of 2.5 mm bears 1837 MPa; 594 are allowed where it is galvanised."""
    path = tmp_path / "table.csv"
    path.write_text(TABLE, encoding="utf-8")
    with pytest.raises(TableError) as refused:
        read_table(path, load_course(SPRINGS))
    [problem] = refused.value.problems
    assert str(problem.key) == "row 3, variant A2"
    assert str(problem.what) == (
        "accepted wire (wire): no size of wire.diameter from 1.6 mm up to the last one, 2.5 mm, "
        "satisfies stress <= stress_allowed."
    )
    assert str(problem.remedy) == "Change the numbers that it comes from."
