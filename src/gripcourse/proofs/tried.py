"""In how many of the numbers that were tried something is wrong, as part of a sentence."""

from gripcourse.text.words import Message, counted


def in_sets(wrong: int, count: int) -> Message:
    """Say in how many sets of numbers something is wrong: a phrase with its preposition."""
    return counted(
        "in {wrong} of {count} set of numbers",
        "in {wrong} of {count} sets of numbers",
        count,
        wrong=wrong,
    )


def in_comparisons(wrong: int, count: int) -> Message:
    """Say in how many comparisons something is wrong: a phrase with its preposition."""
    return counted(
        "in {wrong} of {count} comparison",
        "in {wrong} of {count} comparisons",
        count,
        wrong=wrong,
    )
