"""Points, shares, days and amounts as a reader sees them."""

import pytest

from gripcourse.text.amounts import counted_points, points_up_to
from gripcourse.text.words import Words


@pytest.mark.parametrize(
    ("language", "value", "plain", "limit"),
    [
        ("en", 1.0, "1 point", "up to 1 point"),
        ("en", 9.05, "9.05 points", "up to 9.05 points"),
        ("ru", 1.0, "1 балл", "до 1 балла"),
        ("ru", 3.0, "3 балла", "до 3 баллов"),
        ("ru", 25.0, "25 баллов", "до 25 баллов"),
        ("ru", 9.05, "9,05 балла", "до 9,05 балла"),
        ("uk", 25.0, "25 балів", "до 25 балів"),
        ("uk", 9.05, "9,05 бала", "до 9,05 бала"),
    ],
)
def test_points_are_declined_and_never_broken(
    language: str, value: float, plain: str, limit: str
) -> None:
    words = Words(language)
    written = counted_points(value, words), points_up_to(value, words)
    assert [one.replace("\u00a0", " ") for one in written] == [plain, limit]
    assert not any(" " in one for one in written)
