"""Thousands of spoiled copies of a workbook: nothing is raised, and no answer is invented."""

import pytest

from hostile.fuzz import failures, once_failed
from hostile.mutations import mutated
from hostile.provenance import invented
from hostile.reading import as_student
from hostile.small_workbook import PARTS, SHEET, archive, quantities

RUNS = 3_000
FEWEST_READ = 0.3  # of them: who refuses everything proves nothing


def test_no_mutation_fails_and_none_gives_an_answer_that_is_not_there() -> None:
    assert not dict(failures(range(RUNS)))


def test_what_once_failed_does_not_fail_again() -> None:
    assert not dict(failures(once_failed()))


def test_a_number_tells_the_whole_file() -> None:
    assert mutated(7) == mutated(7) != mutated(8)


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
