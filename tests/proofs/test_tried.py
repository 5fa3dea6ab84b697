"""How many of the numbers that were tried are wrong, in the form that goes with the number."""

import pytest

from gripcourse.proofs.tried import in_comparisons, in_sets
from gripcourse.text.words import Words


@pytest.mark.parametrize(
    ("language", "wrong", "count", "sets", "comparisons"),
    [
        ("en", 1, 1, "in 1 of 1 set of numbers", "in 1 of 1 comparison"),
        ("en", 2, 21, "in 2 of 21 sets of numbers", "in 2 of 21 comparisons"),
        ("ru", 1, 1, "в 1 из 1 набора чисел", "в 1 из 1 сравнения"),
        ("ru", 3, 12, "в 3 из 12 наборов чисел", "в 3 из 12 сравнений"),
        ("uk", 1, 21, "у 1 із 21 набору чисел", "у 1 із 21 порівняння"),
        ("uk", 2, 3, "у 2 із 3 наборів чисел", "у 2 із 3 порівнянь"),
    ],
)
def test_a_share_of_what_was_tried_has_the_form_of_its_number(
    language: str, wrong: int, count: int, sets: str, comparisons: str
) -> None:
    words = Words(language)
    assert words.say(in_sets(wrong, count)) == sets
    assert words.say(in_comparisons(wrong, count)) == comparisons
