"""Thousands of spoiled copies of a workbook: nothing is raised, and no answer is invented."""

import pytest

from hostile import guided
from hostile.fuzz import failures, once_failed
from hostile.mutations import PECULIAR, descended, mutated
from hostile.provenance import invented
from hostile.reading import as_student
from hostile.small_workbook import PARTS, SHEET, archive, quantities

RUNS = 3_000
PECULIARITIES = 150
GUIDED = 60  # a seventieth of a second each
FEWEST_STEPS = 700  # of the reader; the sound workbook takes 600
FEWEST_READ = 0.3  # of them: who refuses everything proves nothing


def test_no_mutation_fails_and_none_gives_an_answer_that_is_not_there() -> None:
    assert not dict(failures([*range(RUNS), *range(PECULIAR, PECULIAR + PECULIARITIES)]))


def test_what_once_failed_does_not_fail_again() -> None:
    assert not dict(failures(once_failed()))


def test_who_follows_the_steps_of_the_reader_finds_nothing_either() -> None:
    tried = list(guided.explore(0, GUIDED))
    assert not [(line, wrong) for line, wrong, _ in tried if wrong]
    assert any(len(line) > 1 for line, _, _ in tried)
    assert tried[-1][2] > FEWEST_STEPS
    assert not [line for line in guided.once_failed() if guided.faults(descended(line))]


def test_a_number_tells_the_whole_file() -> None:
    assert mutated(7) == mutated(7) != mutated(8)
    assert descended((7, 8)) == descended((7, 8)) != descended((8, 7))


def test_many_mutations_can_still_be_read() -> None:
    read = sum(as_student(mutated(seed), quantities()).submission is not None for seed in range(99))
    assert read / 99 > FEWEST_READ


@pytest.mark.parametrize(
    ("before", "after"), [(b"22941.5", b"22941.6"), (b"$E$5", b"$E$6"), (b"1,5", b"1,6")]
)
def test_an_invented_answer_would_be_found(before: bytes, after: bytes) -> None:
    raw = as_student(archive(PARTS), quantities()).raw
    changed = {name: part.replace(before, after) for name, part in PARTS.items()}
    assert changed != dict(PARTS)
    assert invented(archive(changed), raw)  # type: ignore[arg-type]
    assert SHEET in changed
