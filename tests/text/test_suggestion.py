"""What is said of a name that nobody knows."""

from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Words


def test_a_name_near_a_known_one_is_suggested() -> None:
    assert Words("en").say(did_you_mean("pover", ["power", "speed"])) == "Did you mean 'power'?"


def test_a_long_list_of_names_says_that_it_goes_on() -> None:
    known = [f"{number:03d}" for number in range(1, 65)]
    said = Words("en").say(did_you_mean("abc", known))
    assert said.startswith("Known here: 001, 002, ")
    assert said.endswith(", 012, and 52 more.")


def test_a_short_list_of_names_is_whole() -> None:
    assert Words("en").say(did_you_mean("xyz", ["b", "a"])) == "Known here: a, b."
