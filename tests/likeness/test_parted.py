"""A cohort is compared in tables; what is found does not hang on how many there are."""

from typing import TYPE_CHECKING

import pytest

from gripcourse.likeness.cells import SparseTable
from gripcourse.likeness.evidence import find_evidence
from gripcourse.likeness.issued import IssuedValues
from gripcourse.likeness.model import NumberKind
from gripcourse.policy.model import LikenessRule

if TYPE_CHECKING:
    from .conftest import School

RULE = LikenessRule(1000.0, 3, 3)


def parted(issued: IssuedValues, count: int) -> list[SparseTable]:
    """The tables of issued values, with so many owners in each."""
    [whole] = issued.values
    table = whole.dense(range(whole.columns))
    return [SparseTable.of_table(table[at : at + count]) for at in range(0, whole.rows, count)]


@pytest.mark.parametrize("count", [37, 100])
def test_evidence_is_the_same_in_small_tables(
    school: "School", count: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    works, _ = school.copying(5, 0.8, 0.3, moved=0.005)
    issued = school.issued
    small = IssuedValues(
        issued.owners,
        issued.quantities,
        parted(issued, count),
        issued.kind,
        issued.families,
        issued.discrete,
    )
    whole = find_evidence(works, issued, RULE)
    monkeypatch.setattr("gripcourse.likeness.pool._TOGETHER", count)
    assert find_evidence(works, small, RULE) == whole
    assert {one.kind for one in whole} >= {NumberKind.SAME_ANSWERS, NumberKind.OTHER_VARIANT}
