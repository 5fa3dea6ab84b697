"""How often somebody may do something does not depend on how many others try."""

from gripcourse.access.desk.model import Allowance
from gripcourse.web.rates import MOST_KEPT, Counter

RATE = Allowance(2, 600)


def used_up(counter: Counter, who: str, now: float) -> None:
    assert [counter.allows(RATE, who, now) for _ in range(3)] == [True, True, False]


def test_who_used_up_an_allowance_waits_until_its_time_is_over() -> None:
    counter = Counter()
    used_up(counter, "s01", 0)
    assert not counter.allows(RATE, "s01", 599)
    assert counter.allows(RATE, "s02", 599)
    assert counter.allows(RATE, "s01", 600)


def test_a_flood_of_names_gives_nobody_a_new_allowance() -> None:
    counter = Counter()
    used_up(counter, "s01", 0)
    for number in range(3 * MOST_KEPT):
        assert counter.allows(RATE, f"flood {number}", 1)
        if number % (MOST_KEPT // 2) == 0:  # who is refused and goes on is not forgotten
            assert not counter.allows(RATE, "s01", 2)
    assert not counter.allows(RATE, "s01", 3)


def test_a_flood_at_one_door_is_not_counted_at_another() -> None:
    counter, other = Counter(), Allowance(5, 600)
    used_up(counter, "s01", 0)
    for number in range(2 * MOST_KEPT):
        counter.allows(other, f"flood {number}", 1)
    assert not counter.allows(RATE, "s01", 2)


def test_who_has_not_come_for_the_longest_time_is_forgotten_first() -> None:
    counter = Counter()
    used_up(counter, "first", 0)
    used_up(counter, "second", 0)
    for number in range(MOST_KEPT - 1):
        counter.allows(RATE, f"flood {number}", 1)
    assert not counter.allows(RATE, "second", 2)
    assert counter.allows(RATE, "first", 2)
