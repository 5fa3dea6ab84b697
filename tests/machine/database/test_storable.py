"""Texts that no database keeps are marked wherever they stand, in one row or in thousands."""

import pytest

from gripcourse.machine.database.storable import storable


@pytest.mark.parametrize(
    ("given", "kept"),
    [
        ([("a\0b", 1), ("c", 2.5)], [("a�b", 1), ("c", 2.5)]),
        ([("a", 1), ("\ud800", None)], [("a", 1), ("�", None)]),
        ([("Гайка", 1), ("c", True)], [("Гайка", 1), ("c", True)]),
        ([{"name": "a\0"}], [{"name": "a�"}]),
        (("a\0", "b"), ("a�", "b")),
        ([("a", ("b\0",))], [("a", ("b�",))]),
        ("a\0", "a�"),
        ([], []),
    ],
)
def test_a_mark_stands_for_what_cannot_be_kept(given: object, kept: object) -> None:
    assert storable(given) == kept


def test_rows_of_plain_texts_and_numbers_go_as_they_are() -> None:
    rows = [("s01", 1, 0.5, None), ("s02", 2, 1.0, None)]
    assert storable(rows) is rows
