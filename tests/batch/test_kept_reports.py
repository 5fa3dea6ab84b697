"""What a batch is compared with is solved once for all runs into a folder."""

from pathlib import Path

import numpy as np

from gripcourse.batch.kept_reports import KeptReports
from gripcourse.likeness.cells import SparseTable
from gripcourse.likeness.issued import IssuedValues


def values(owner: str) -> IssuedValues:
    table = SparseTable.of_table(np.array([[1.0, np.nan, 3.0]]))
    kind, families = np.zeros(1, np.intp), np.arange(3).reshape(1, 3)
    return IssuedValues((owner,), ("a", "b", "c"), table, kind, families, np.zeros(3, np.bool_))


def test_right_values_are_solved_once_for_the_same_versions(tmp_path: Path) -> None:
    solved: list[str] = []

    def find_for(owner: str) -> IssuedValues:
        solved.append(owner)
        return values(owner)

    def asked(about: str, owner: str) -> IssuedValues:
        # Every run opens the folder anew.
        return KeptReports(tmp_path / "kept", {}).issued_values(about, lambda: find_for(owner))

    first, again = asked("version 1", "s01"), asked("version 1", "s01")
    assert solved == ["s01"]
    assert (again.owners, again.quantities) == (first.owners, first.quantities)
    assert np.array_equal(
        again.values.dense([0, 1, 2]), first.values.dense([0, 1, 2]), equal_nan=True
    )
    assert asked("version 2", "s02").owners == ("s02",)
    assert solved == ["s01", "s02"]


def test_where_nothing_can_be_kept_they_are_solved_all_the_same(tmp_path: Path) -> None:
    (tmp_path / "kept").write_text("a file where a folder should be")
    kept = KeptReports(tmp_path / "kept", {})
    assert kept.issued_values("version 1", lambda: values("s01")).owners == ("s01",)
