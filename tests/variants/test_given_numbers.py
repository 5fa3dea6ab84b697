"""Given numbers that share their names are as good as a `dict` of them."""

import copy
import json
import pickle

import pytest

from gripcourse.variants.given_numbers import GivenNumbers, SharedNames

PLAIN = {"mass": 2.5, "length": 0.1, "speed": 1e-9}


@pytest.fixture
def given() -> GivenNumbers:
    return SharedNames().numbers(PLAIN.items())


def test_they_are_read_as_a_dict_is(given: GivenNumbers) -> None:
    assert given == PLAIN
    assert [given] == [PLAIN]
    assert list(given.items()) == list(PLAIN.items())
    assert (repr(given), json.dumps(dict(given))) == (repr(PLAIN), json.dumps(PLAIN))
    assert ("mass" in given, "force" in given, given.get("force")) == (True, False, None)
    with pytest.raises(KeyError):
        given["force"]


def test_other_numbers_are_others(given: GivenNumbers) -> None:
    assert given != {**PLAIN, "mass": 2.6}
    assert given != {"mass": 2.5}


def test_they_come_to_another_process_as_they_are(given: GivenNumbers) -> None:
    there = copy.deepcopy(given)  # by the way that pickle takes, too
    assert (there, list(there)) == (PLAIN, list(PLAIN))


def test_names_are_held_once() -> None:
    shared = SharedNames()
    one, other = (shared.numbers([("mass", mass), ("length", 1.0)]) for mass in (1.0, 2.0))
    assert (one["mass"], other["mass"]) == (1.0, 2.0)
    assert len(pickle.dumps([one] * 1 + [other])) < 2 * len(pickle.dumps([one]))
