"""What a person with two ids was told stands, whichever of them it was told to."""

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.errors import NextStep, UsageError
from gripcourse.gradebook.journal import published_works
from gripcourse.grading.model import FlagCode
from gripcourse.policy.time_rules import AttemptRule, Counts, LateRule
from gripcourse.usecases.marks.batch_wish import BatchWish
from gripcourse.usecases.marks.handed_in import HandingTime
from gripcourse.usecases.marks.mark import existing_gradebook
from gripcourse.usecases.marks.opening import as_wished, register_of
from gripcourse.usecases.marks.regrade import undo_regrade
from support.office import DRAWING, Office, two_works

if TYPE_CHECKING:
    from support.classroom import Classroom


@pytest.fixture(scope="module")
def works(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return two_works(issued, tmp_path_factory.mktemp("inbox"))


def stricter(office: Office) -> None:
    """Let a policy hold from now on that gives the second work less."""
    office.policy = replace(office.context.policy, carried_credit=0.5)


def told(office: Office) -> set[str]:
    """Who was told of a work, as ids stand now."""
    joins = register_of(office.root).joins
    return {one for one, _ in published_works(existing_gradebook(office.place, joins))}


def test_what_was_published_under_the_second_id_changes_by_a_regrade_alone(
    office: Office, works: dict[str, Path]
) -> None:
    (alone,) = office.grade(works["s03"])
    office.publish()
    note = office.join().notes[-1]
    assert str(note) == "1 published result of s03 is that of s01 now: only a regrade changes it."
    stricter(office)
    (report,) = office.grade(works["s03"])
    assert (report.student, report.score) == ("s01", alone.score)
    assert FlagCode.REGRADE_WAITS in {one.code for one in report.flags}
    found = office.regrade(works["s03"])
    (change,) = found.changes
    assert (change.work.student, change.published) == ("s01", True)
    with pytest.raises(UsageError) as refused:
        office.apply(found)
    assert refused.value.problems[0].step is NextStep.ALLOW_LOWER
    assert office.grade(works["s03"])[0].score == alone.score
    (lower,) = office.apply(found, allow_lower=True)
    assert (lower.student, lower.kept_as) == ("s01", "s03")
    (now,) = office.grade(works["s03"])
    assert (now.score or 0.0) < (alone.score or 0.0)
    undo_regrade(office.place, office.signed())
    assert office.grade(works["s03"])[0].score == alone.score


def test_what_a_person_was_told_of_a_regrade_is_not_taken_back_silently_after_the_joining(
    office: Office, works: dict[str, Path]
) -> None:
    """The person was told the better result under the second id."""
    stricter(office)
    office.grade(works["s03"])
    office.policy = None
    office.apply(office.regrade(works["s03"]))
    office.publish()
    office.join()
    joins = register_of(office.root).joins
    with pytest.raises(UsageError, match="published to s01, who would get"):
        undo_regrade(office.place, office.signed(), joins)
    assert undo_regrade(office.place, office.signed(), joins, allow_lower=True).undoes == 1


def test_taken_back_it_is_the_publication_of_the_second_id_again(
    office: Office, works: dict[str, Path]
) -> None:
    rows = [one.key for one in office.grade_and_keep(works["s03"])]
    office.publish()
    office.join()
    assert told(office) == {"s01"}
    # Whatever is done about the work meanwhile goes with it.
    stricter(office)
    office.apply(office.regrade(works["s03"]), allow_lower=True)
    office.mark("s01", 0.5)
    office.publish("s01")
    notes = [str(one) for one in office.join(undo=True).notes]
    assert "1 published result is that of s03 again." in notes
    assert told(office) == {"s03"}
    assert office.credit("s03") == 0.5
    kept = existing_gradebook(office.place).attempts()
    assert [one.key for one in kept] == [*rows, ("s03", 2)]


def test_nothing_is_kept_twice_where_a_published_work_is_graded_again(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s03"])
    office.publish()
    before = existing_gradebook(office.place).attempts()
    office.join()
    office.grade(works["s03"])
    assert existing_gradebook(office.place).attempts() == before
    assert office.publish() == ()


def test_a_work_on_the_second_sheet_that_came_later_goes_with_the_sheet(
    office: Office, works: dict[str, Path]
) -> None:
    office.join()
    (report,) = office.grade(works["s03"])
    office.publish("s03")
    assert (report.student, told(office)) == ("s01", {"s01"})
    office.join(undo=True)
    assert told(office) == {"s03"}


def test_of_the_same_bytes_under_both_ids_the_result_told_last_stands(
    office: Office, works: dict[str, Path]
) -> None:
    (first,) = office.grade(works["s03"])
    office.publish()
    stricter(office)
    office.grade(works["s03"], whose="s01")
    office.join()
    # Of s01 nobody was told it: what is in hand stands, though the other was found later.
    assert office.grade(works["s03"])[0].score == first.score
    office.join(undo=True)
    office.publish("s01")
    office.join()
    (last,) = office.grade(works["s03"])
    assert (last.score or 0.0) < (first.score or 0.0)
    assert last.student == "s01"


def test_results_that_differ_under_both_ids_are_said(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s01"])
    office.grade(works["s03"])
    office.publish("s03")
    assert not office.join().told_twice
    office.join(undo=True)
    office.publish("s01")
    done = office.join()
    assert done.told_twice
    assert str(done.notes[-1]).startswith("s01 was told different results: s01 ")


def test_works_of_both_ids_are_counted_together(office: Office, works: dict[str, Path]) -> None:
    office.grade(works["s01"])
    office.grade(works["s03"])
    office.join()
    for rule, counting in (
        (AttemptRule(Counts.LAST, 0), "s03"),
        (AttemptRule(Counts.FIRST, 0), "s01"),
        (AttemptRule(Counts.BEST, 0), "s01"),
        (AttemptRule(Counts.LAST, 1), "s01"),
    ):
        office.policy = replace(office.context.policy, attempts=rule)
        reports = office.grade(works["s01"], works["s03"])
        timings = [one.timing for one in reports]
        assert [(one.number, one.of) for one in timings if one] == [(1, 2), (2, 2)]
        counts = [
            name for name, one in zip(("s01", "s03"), timings, strict=True) if one and one.counts
        ]
        assert counts == [counting]
    # One alone is the same attempt.
    (alone,) = office.grade(works["s03"])
    assert alone.timing is not None
    assert (alone.timing.number, alone.timing.of) == (2, 2)


def test_the_history_tells_under_which_id_it_was_found_and_told(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s01"])
    office.grade(works["s03"])
    office.publish()
    office.join()
    events = office.told("s01")
    assert sum("Points published to the student" in one for one in events) == 2
    assert sum(one.endswith("(attempt 2). (As s03.)") for one in events) == 1
    found = [one for one in events if one.endswith("(As s03.)") and "s03.xlsx" in one]
    assert [one.split(",")[0] for one in found] == ["Attempt 2"]
    # Of the other id it tells what is kept under it.
    assert sum("(attempt 1)." in one for one in office.told("s03")) == 1


def late(office: Office, **days: int) -> dict[str, HandingTime]:
    """Say how many days after the deadline files came, which is the first of December."""
    rule = LateRule(per_day=0.1, most=0.5, grace=0.0, zone="UTC")
    office.policy = replace(office.context.policy, late=rule)
    at = datetime(2026, 12, 1, 12, tzinfo=UTC)
    return {name: HandingTime(at + timedelta(days=one), said=True) for name, one in days.items()}


def days_late(office: Office, file: Path) -> int:
    (report,) = office.grade(file)
    assert report.timing is not None
    return report.timing.days_late


def test_a_time_that_was_said_under_the_second_id_is_that_of_the_work(
    office: Office, works: dict[str, Path]
) -> None:
    file = works["s03"]
    office.grade(file, times={str(file): late(office, said=2)["said"]})
    office.join()
    assert days_late(office, file) == 2
    # And it may be said again.
    office.grade(file, times={str(file): late(office, said=1)["said"]})
    assert days_late(office, file) == 1
    office.join(undo=True)
    assert days_late(office, file) == 1


@pytest.mark.parametrize("published", [False, True])
def test_of_two_times_of_one_file_the_earlier_counts_until_a_person_says_it(
    office: Office, works: dict[str, Path], *, published: bool
) -> None:
    file, said = works["s03"], late(office, earlier=1, later=3)
    office.grade(file, times={str(file): said["earlier"]})
    office.grade(file, times={str(file): said["later"]}, whose="s01")
    if published:
        office.publish()
    office.join()
    (report,) = office.grade(file)
    assert report.timing is not None
    assert report.timing.days_late == 1
    (flag,) = (one for one in report.flags if one.code is FlagCode.TIME_DOUBTFUL)
    assert "s03" in str(flag.message)
    for times in ({str(file): said["later"]}, {}):
        (report,) = office.grade(file, times=times)
        assert report.timing is not None
        assert report.timing.days_late == 3
        assert FlagCode.TIME_DOUBTFUL not in {one.code for one in report.flags}


def test_a_row_of_deadlines_for_either_id_is_the_persons(
    office: Office, works: dict[str, Path]
) -> None:
    table = office.root / "variants" / "deadlines.csv"
    table.write_text("student,deadline\ns03,2026-12-05\ns01,2026-12-03\n", encoding="utf-8")
    late(office)
    office.grade(works["s03"])
    office.join()
    # A row for nobody would be refused.
    as_wished(BatchWish(), [works["s03"]], office.context, office.place, 0)
    (report,) = office.grade(works["s03"])
    assert report.timing is not None
    assert report.timing.deadline is not None
    assert report.timing.deadline.date().isoformat() == "2026-12-05"
    office.join(undo=True)
    (report,) = office.grade(works["s01"])
    assert report.timing is not None
    assert report.timing.deadline is not None
    assert report.timing.deadline.date().isoformat() == "2026-12-03"


def test_a_mark_is_entered_against_the_work_under_whatever_id_that_is_kept(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s03"])
    office.mark("s03", 1.0)
    office.join()
    assert office.mark("s01", 1.0) == 0
    assert office.mark("s01", 0.5) == 1
    assert office.credit("s01") == 0.5
    assert office.mark("s01", None, "Не тот чертёж") == 1
    assert (office.credit("s01"), office.waits()) == (None, {("s01", False)})
    kept = existing_gradebook(office.place).entries()
    assert {(one.mark.student, one.mark.quantity) for one in kept} == {("s03", DRAWING)}
    assert [one.mark.credit for one in kept] == [1.0, 0.5, None]


def counting(office: Office) -> list[str]:
    """What joining, or taking it back, says of the works that count."""
    return [str(one) for one in office.join().notes if "counts from now on" in str(one)]


def test_that_another_work_counts_is_said_when_two_are_joined_and_are_two_again(
    office: Office, works: dict[str, Path]
) -> None:
    """Of both works the later one counts, of which the person has less than before."""
    (first,), (second,) = office.grade(works["s01"]), office.grade(works["s03"])
    of_first = f"s01.xlsx {first.score:.4g} / {first.max_score:.4g}"
    of_second = f"s03.xlsx {second.score:.4g} / {second.max_score:.4g}"
    (said,) = counting(office)
    assert f"Before: s01 {of_first}; s03 {of_second}. Now: s01 {of_second}." in said
    notes = [str(one) for one in office.join(undo=True).notes]
    assert f"Before: s01 {of_second}. Now: s01 {of_first}; s03 {of_second}." in notes[-1]


def test_nothing_is_said_of_a_work_that_only_changes_hands(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s03"])
    assert counting(office) == []


def test_ids_are_joined_though_the_policy_cannot_be_used(
    office: Office, works: dict[str, Path]
) -> None:
    office.grade(works["s01"], works["s03"])
    (office.root / "grader" / "policy.toml").write_text("[credit]\ncarried = 7\n")
    assert counting(office) == []
    assert register_of(office.root).joins
