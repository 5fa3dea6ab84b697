"""Jobs of a kind wait for the same worker, and nobody is idle while another has any left."""

from gripcourse.machine.jobs.lanes import JobsLeft

ANIMALS = ("cat", "dog", "cow", "cat", "?", "dog", "cow", "cat")


def kind_of(item: str) -> str | None:
    return None if item == "?" else item


def test_those_of_a_kind_are_taken_one_after_the_other_and_unknown_ones_last() -> None:
    waiting = JobsLeft.of(ANIMALS, range(8), kind_of)
    taken = [waiting.take(0) for _ in range(8)]
    assert [item for _, item in taken] == ["cat", "cat", "cat", "dog", "dog", "cow", "cow", "?"]
    assert [number for number, _ in taken] == [0, 3, 7, 1, 5, 2, 6, 4]
    assert not waiting


def test_without_kinds_they_are_taken_as_they_come() -> None:
    waiting = JobsLeft.of(ANIMALS, [2, 5, 6])
    assert [waiting.take(0)[0] for _ in range(3)] == [2, 5, 6]


def test_each_lane_has_its_own_and_an_empty_one_helps_the_longest_from_its_end() -> None:
    waiting = JobsLeft.of(ANIMALS, range(8), kind_of, lanes=2)
    first = [waiting.take(0)[1] for _ in range(4)]
    assert first == ["cat", "cat", "cat", "dog"]
    assert waiting.take(1)[1] == "dog"
    assert waiting.take(0)[1] == "?"
    assert sorted(waiting.left()) == [2, 6]
    assert [waiting.take(lane)[1] for lane in (0, 1)] == ["cow", "cow"]
    assert len(waiting) == 0
