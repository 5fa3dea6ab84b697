"""Works that were kept under several ids of one person, as those of that person."""

from collections.abc import Mapping
from datetime import UTC, datetime, timedelta

from gripcourse.gradebook.joined_works import attempts_of_persons
from gripcourse.gradebook.model import Attempt, Fingerprints
from gripcourse.gradebook.numbering import new_attempts
from gripcourse.gradebook.works import works_of
from gripcourse.issuing.withdrawal import Join

MORNING = datetime(2026, 12, 2, 9, tzinfo=UTC)
JOINED = (Join("s03", "s01", MORNING + timedelta(hours=12)),)
NOBODY: Mapping[tuple[str, int], datetime] = {}


def at(hour: float) -> datetime:
    return MORNING + timedelta(hours=hour)


def attempt(
    student: str,
    number: int,
    hour: float,
    digest: str = "a",
    *,
    regrade: int | None = None,
    said: datetime | None = None,
) -> Attempt:
    return Attempt(
        student=student,
        number=number,
        variant="001",
        scheme="rack",
        file=f"{student}.xlsx",
        digest=digest,
        graded_at=at(hour),
        fingerprints=Fingerprints("", ""),
        judged=True,
        results=(),
        regrade=regrade,
        handed_in=said,
        handed_in_said=said is not None,
    )


def stands(
    *kept: Attempt, told: Mapping[tuple[str, int], datetime] = NOBODY
) -> list[tuple[str, int]]:
    """Which attempt stands for each work of s01."""
    found = works_of(attempts_of_persons(kept, JOINED, told))
    return [one.attempt.key for one in found["s01"]]


def test_works_stand_in_the_order_in_which_they_were_graded_under_any_id() -> None:
    kept = attempt("s01", 1, 2), attempt("s03", 1, 1, "b"), attempt("s03", 2, 3, "c")
    assert stands(*kept) == [("s03", 1), ("s01", 1), ("s03", 2)]


def test_a_clock_that_was_set_back_puts_no_attempt_of_an_id_before_an_earlier_one() -> None:
    kept = attempt("s01", 1, 2, "b"), attempt("s03", 1, 5), attempt("s03", 2, 1)
    assert stands(*kept) == [("s01", 1), ("s03", 2)]


def test_of_the_same_bytes_stands_what_was_found_last_where_nobody_was_told() -> None:
    assert stands(attempt("s01", 1, 1), attempt("s03", 1, 2)) == [("s03", 1)]
    assert stands(attempt("s01", 1, 2), attempt("s03", 1, 1)) == [("s01", 1)]


def test_of_the_same_bytes_stands_what_was_told_last() -> None:
    kept = attempt("s01", 1, 2), attempt("s03", 1, 1)
    assert stands(*kept, told={("s03", 1): at(3)}) == [("s03", 1)]
    assert stands(*kept, told={("s03", 1): at(3), ("s01", 1): at(4)}) == [("s01", 1)]
    assert stands(*kept, told={("s03", 1): at(4), ("s01", 1): at(3)}) == [("s03", 1)]


def test_a_regrade_after_that_stands_under_whatever_id_it_is_kept() -> None:
    kept = attempt("s01", 1, 2), attempt("s01", 2, 5, regrade=1), attempt("s03", 1, 1)
    assert stands(*kept, told={("s03", 1): at(3)}) == [("s01", 2)]
    assert stands(*kept, told={("s03", 1): at(6)}) == [("s03", 1)]


def test_three_ids_are_one_person_as_far_as_they_are_joined() -> None:
    kept = [attempt("s01", 1, 1, "a"), attempt("s02", 1, 2, "b"), attempt("s03", 1, 3, "c")]
    joins = Join("s03", "s02", at(12)), Join("s02", "s01", at(13))
    assert {one.student for one in attempts_of_persons(kept, joins, {})} == {"s01"}
    found = attempts_of_persons(kept, joins[:1], {})
    assert {(one.student, one.kept_as) for one in found} == {
        ("s01", ""),
        ("s02", ""),
        ("s02", "s03"),
    }


def test_a_number_is_the_next_one_of_the_id_under_which_the_work_is_kept() -> None:
    kept = attempt("s01", 1, 1, "b"), attempt("s01", 2, 2, "c"), attempt("s03", 1, 3)
    known = attempts_of_persons(kept, JOINED, {})
    again, new = attempt("s01", 0, 20, said=at(0)), attempt("s01", 0, 20, "d")
    assert [one.key for one in new_attempts((again, new), known, ())] == [("s03", 2), ("s01", 3)]


def test_of_two_times_that_were_said_the_earlier_counts_until_one_is_said_again() -> None:
    kept = attempt("s01", 1, 1, said=at(-1)), attempt("s03", 1, 2, said=at(-5))
    (work,) = works_of(attempts_of_persons(kept, JOINED, {}))["s01"]
    assert (work.handed_in, work.of_two) == (at(-5), True)
    decided = attempt("s01", 2, 20, said=at(-1))
    (work,) = works_of(attempts_of_persons((kept[0], decided, kept[1]), JOINED, {}))["s01"]
    assert (work.handed_in, work.of_two) == (at(-1), False)


def test_two_ids_that_say_the_same_time_leave_no_doubt() -> None:
    kept = attempt("s01", 1, 1, said=at(-1)), attempt("s03", 1, 2, said=at(-1))
    (work,) = works_of(attempts_of_persons(kept, JOINED, {}))["s01"]
    assert (work.handed_in, work.of_two) == (at(-1), False)
