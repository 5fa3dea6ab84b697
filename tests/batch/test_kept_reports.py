"""What a batch is compared with is solved once for all runs into a folder."""

from pathlib import Path

import numpy as np

from gripcourse.batch.kept_reports import KeptReports
from gripcourse.likeness.cells import SparseTable


def values(number: float) -> SparseTable:
    return SparseTable.of_table(np.array([[number, np.nan, 3.0]]))


def test_right_values_are_solved_once_for_the_same_versions(tmp_path: Path) -> None:
    solved: list[float] = []

    def asked(about: str, place: int, number: float) -> list[float]:
        def find() -> SparseTable:
            solved.append(number)
            return values(number)

        # Every run opens the folder anew.
        return KeptReports(tmp_path / "kept", {}).issued_values(about)(place, find).value.tolist()

    assert asked("version 1", 0, 1.0) == asked("version 1", 0, 1.0) == [1.0, 3.0]
    assert asked("version 1", 1, 2.0) == [2.0, 3.0]
    assert asked("version 1", 0, 1.0) == [1.0, 3.0]
    assert solved == [1.0, 2.0]
    assert asked("version 2", 0, 4.0) == [4.0, 3.0]
    assert solved == [1.0, 2.0, 4.0]


def test_where_nothing_can_be_kept_they_are_solved_all_the_same(tmp_path: Path) -> None:
    (tmp_path / "kept").write_text("a file where a folder should be")
    kept = KeptReports(tmp_path / "kept", {})
    assert kept.issued_values("version 1")(0, lambda: values(1.0)).value.tolist() == [1.0, 3.0]
