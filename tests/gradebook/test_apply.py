"""A person's mark enters every later report; when the automatic part changes, it is flagged."""

import tempfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TypeAlias

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gripcourse.gradebook.apply import as_it_stands, with_marks
from gripcourse.gradebook.model import Attempt, GradebookEntry, Mark
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.grading.model import Finding, Flag, FlagCode, Outcome, Report
from gripcourse.text.words import message

MakeReport = Callable[..., Report]
MakeMark = Callable[..., Mark]
MakeAttempts = Callable[..., Sequence[Attempt]]
Enter = Callable[..., GradebookEntry]


@pytest.fixture
def enter(report: MakeReport, attempts: MakeAttempts, mark: MakeMark) -> Enter:
    """Make a mark that was entered against some report, the usual one if none is named."""

    def make(
        quantity: str = "drawing",
        credit: float | None = 0.5,
        *,
        against: Report | None = None,
        number: int = 1,
        **changes: object,
    ) -> GradebookEntry:
        (attempt,) = attempts(against or report())
        return GradebookEntry(
            mark(quantity, credit, number=number, **changes), replace(attempt, number=1)
        )

    return make


def item(report: Report, quantity: str) -> Finding:
    return next(one for one in report.findings if one.quantity == quantity)


def codes(report: Report) -> list[str]:
    return [flag.code for flag in report.flags]


class TestTheReport:
    def test_a_mark_gives_its_share_of_the_points_and_closes_the_item(
        self, report: MakeReport, enter: Enter
    ) -> None:
        before = report()
        after = with_marks(before, [enter(credit=0.75, comment="Масштаб?")])
        drawing = item(after, "drawing")
        assert (drawing.outcome, drawing.points, drawing.is_open) == (Outcome.MANUAL, 7.5, False)
        assert drawing.decision is not None
        assert drawing.decision.comment == "Масштаб?"
        assert after.score == before.score + 7.5
        assert after.max_score == before.max_score + 10
        assert after.open_points == before.open_points - 10

    def test_an_item_without_a_mark_stays_open_and_counts_nowhere(self, report: MakeReport) -> None:
        assert with_marks(report(), []) == report()
        assert item(report(), "drawing").is_open

    def test_a_zero_is_a_mark_and_not_an_open_item(self, report: MakeReport, enter: Enter) -> None:
        after = with_marks(report(), [enter(credit=0.0)])
        assert not item(after, "drawing").is_open
        assert after.max_score == report().max_score + 10

    def test_points_follow_the_policy_of_the_day(self, report: MakeReport, enter: Enter) -> None:
        """The mark keeps the share; a drawing that is worth more now earns more."""
        now = report(drawing=(Outcome.MANUAL, 0.0, 20.0))
        assert item(with_marks(now, [enter(credit=0.75)]), "drawing").points == 15

    def test_a_report_that_was_not_judged_comes_back_as_it_is(
        self, report: MakeReport, enter: Enter
    ) -> None:
        rejected = replace(report(), judged=False, findings=(), score=0.0, max_score=0.0)
        assert with_marks(rejected, [enter()]) is rejected


class TestDecisions:
    def test_what_we_could_not_judge_is_decided_and_its_flag_goes(
        self, report: MakeReport, enter: Enter
    ) -> None:
        assert codes(report()) == [FlagCode.NOT_JUDGED]
        after = with_marks(report(), [enter("stroke", 1.0, comment="верно")])
        stroke = item(after, "stroke")
        assert stroke.points == 1
        assert stroke.decision is not None
        assert stroke.decision.automatic is Outcome.NOT_JUDGED
        assert codes(after) == []

    def test_the_flag_names_what_is_left_to_judge(self, report: MakeReport, enter: Enter) -> None:
        two = report(rod=(Outcome.NOT_JUDGED, 0.0, 1.0))
        after = with_marks(two, [enter("stroke", 1.0, against=two)])
        assert codes(after) == [FlagCode.NOT_JUDGED]
        assert "rod" in str(after.flags[0].message)
        assert "stroke" not in str(after.flags[0].message)

    def test_an_overruled_result_keeps_what_the_program_had_found(
        self, report: MakeReport, enter: Enter
    ) -> None:
        after = with_marks(report(), [enter("bore", 0.5, comment="другой каталог")])
        bore = item(after, "bore")
        assert (bore.outcome, bore.points) == (Outcome.MANUAL, 1.0)
        assert bore.decision is not None
        assert bore.decision.automatic is Outcome.WRONG
        assert after.max_score == report().max_score

    def test_a_withdrawn_decision_lets_the_automatic_result_count_again(
        self, report: MakeReport, enter: Enter
    ) -> None:
        history = [enter("bore", 0.5), enter("bore", None, number=2)]
        assert with_marks(report(), history) == report()

    def test_other_flags_stay(self, report: MakeReport, enter: Enter) -> None:
        odd = Flag(FlagCode.SIGNATURE, message("The file is empty: it has no bytes."))
        before = replace(report(), flags=(odd, *report().flags))
        assert with_marks(before, [enter()]).flags == before.flags


class TestLookAgain:
    def test_nothing_has_changed(self, report: MakeReport, enter: Enter) -> None:
        after = with_marks(replace(report(), file="moved/s01.xlsx"), [enter()])
        assert FlagCode.MARK_OUTDATED not in codes(after)

    @pytest.mark.parametrize("change", ["file", "result of the item"])
    def test_a_change_of_what_the_mark_rests_on_is_flagged_and_the_mark_still_counts(
        self, report: MakeReport, enter: Enter, change: str
    ) -> None:
        now = {
            "file": report(digest="b" * 64),
            "result of the item": report(drawing=(Outcome.NOT_JUDGED, 0.0, 10.0)),
        }[change]
        after = with_marks(now, [enter(credit=0.75)])
        assert codes(after) == [FlagCode.NOT_JUDGED, FlagCode.MARK_OUTDATED]
        assert "drawing" in str(after.flags[1].message)
        drawing = item(after, "drawing")
        assert drawing.points == 7.5
        assert drawing.decision is not None
        assert drawing.decision.outdated

    @pytest.mark.parametrize(
        "change",
        [
            {"bore": (Outcome.CORRECT, 2.0, 2.0)},
            {"bore": (Outcome.WRONG, 0.0, 3.0)},
            {"drawing": (Outcome.MANUAL, 0.0, 20.0)},
        ],
        ids=["result of another item", "points of another item", "points of the item"],
    )
    def test_what_a_mark_does_not_rest_on_outdates_nothing(
        self, report: MakeReport, enter: Enter, change: dict[str, tuple[Outcome, float, float]]
    ) -> None:
        after = with_marks(report(**change), [enter(credit=0.75)])
        assert codes(after) == [FlagCode.NOT_JUDGED]
        drawing = item(after, "drawing")
        assert drawing.points == 0.75 * drawing.max_points

    def test_only_the_overruled_item_is_named_when_a_tolerance_changes(
        self, report: MakeReport, enter: Enter
    ) -> None:
        now = report(bore=(Outcome.CORRECT, 2.0, 2.0))
        after = with_marks(now, [enter(), enter("bore", 0.5, comment="другой каталог")])
        (flag,) = [one for one in after.flags if one.code is FlagCode.MARK_OUTDATED]
        assert "bore" in str(flag.message)
        assert "drawing" not in str(flag.message)

    def test_a_mark_against_the_new_state_takes_the_flag_away(
        self, report: MakeReport, enter: Enter
    ) -> None:
        now = report(digest="b" * 64)
        again = [enter(credit=0.75), enter(credit=0.75, number=2, against=now)]
        assert FlagCode.MARK_OUTDATED not in codes(with_marks(now, again))

    def test_a_work_that_was_there_when_the_mark_was_given_brings_nothing_new(
        self, report: MakeReport, enter: Enter
    ) -> None:
        """Marks are entered against the last work, also where an earlier one counts."""
        earlier, entered = report(digest="b" * 64), enter(credit=0.75)
        seen = replace(entered, attempt=replace(entered.attempt, number=2))
        assert FlagCode.MARK_OUTDATED not in codes(with_marks(earlier, [seen], since=("s01", 1)))
        assert FlagCode.MARK_OUTDATED in codes(with_marks(earlier, [seen], since=("s01", 3)))
        of_another_id = replace(seen, attempt=replace(seen.attempt, kept_as="s09"))
        assert FlagCode.MARK_OUTDATED in codes(
            with_marks(earlier, [of_another_id], since=("s01", 1))
        )

    def test_of_an_earlier_work_too_another_result_of_the_item_is_flagged(
        self, report: MakeReport, enter: Enter
    ) -> None:
        earlier = report(digest="b" * 64, bore=(Outcome.CORRECT, 2.0, 2.0))
        overruled = enter("bore", 0.5, comment="другой каталог")
        seen = replace(overruled, attempt=replace(overruled.attempt, number=2))
        assert FlagCode.MARK_OUTDATED in codes(with_marks(earlier, [seen], since=("s01", 1)))

    def test_a_mark_of_an_item_that_is_gone_is_not_forgotten_silently(
        self, report: MakeReport, enter: Enter
    ) -> None:
        whole = report()
        without = replace(
            whole, findings=tuple(one for one in whole.findings if one.quantity != "drawing")
        )
        after = with_marks(without, [enter()])
        assert FlagCode.MARK_OUTDATED in codes(after)
        assert "no longer asks for drawing" in " ".join(str(one.message) for one in after.flags)


class TestAPublishedWork:
    def test_it_is_as_it_was_told_and_what_would_change_is_named(
        self, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        (told,) = attempts(report())
        now = report(bore=(Outcome.CORRECT, 2.0, 2.0))
        after = as_it_stands(now, told)
        assert (item(after, "bore").outcome, item(after, "bore").points) == (Outcome.WRONG, 0.0)
        assert after.score == report().score
        assert codes(after) == [FlagCode.NOT_JUDGED, FlagCode.REGRADE_WAITS]
        assert "bore" in str(after.flags[-1].message)

    def test_it_is_left_alone_where_both_say_the_same(
        self, report: MakeReport, attempts: MakeAttempts
    ) -> None:
        (told,) = attempts(report())
        assert as_it_stands(report(), told) == report()


def test_the_order_in_which_marks_are_read_does_not_matter(
    report: MakeReport, enter: Enter
) -> None:
    history = [enter(credit=0.25), enter(credit=1.0, number=2), enter(credit=0.5, number=3)]
    assert with_marks(report(), history) == with_marks(report(), history[::-1])
    assert item(with_marks(report(), history), "drawing").points == 5


Step: TypeAlias = tuple[str, float | None] | tuple[str, Outcome]
CREDITS = st.one_of(st.none(), st.sampled_from([0.0, 0.25, 0.5, 1.0]))
MARKS = st.tuples(st.sampled_from(["drawing", "stroke", "bore"]), CREDITS)
GRADINGS = st.tuples(
    st.sampled_from(["a", "b"]), st.sampled_from([Outcome.CORRECT, Outcome.WRONG, Outcome.BLANK])
)


@given(steps=st.lists(st.one_of(MARKS, GRADINGS), max_size=8))
@settings(max_examples=20)
def test_no_sequence_of_marks_and_gradings_loses_a_mark_and_the_latest_counts(
    report: MakeReport, mark: MakeMark, attempts: MakeAttempts, steps: list[Step]
) -> None:
    with tempfile.TemporaryDirectory() as folder:
        book = open_gradebook(str(Path(folder) / "gradebook.sqlite"))
        follow(steps, book, report, mark, attempts)


def follow(
    steps: list[Step],
    book: Gradebook,
    report: MakeReport,
    mark: MakeMark,
    attempts: MakeAttempts,
) -> None:
    """Take the steps on a real gradebook and on plain lists beside it, and compare."""
    current = report()
    book.add_attempts(attempts(current))
    entered: list[tuple[str, float | None]] = []
    latest: dict[str, float | None] = {}
    for name, what in steps:
        if isinstance(what, Outcome):
            current = report(digest=name * 64, bore=(what, 2.0 * (what is Outcome.CORRECT), 2.0))
            book.add_attempts(attempts(current))
        else:
            last = book.attempts()[-1].number
            book.add_marks([mark(name, what, attempt=last, comment=str(len(entered)))])
            entered.append((name, what))
            latest[name] = what
        entries = book.entries()
        assert len(entries) == len(entered)
        assert sorted((one.mark.quantity, int(one.mark.comment)) for one in entries) == sorted(
            (name, number) for number, (name, _) in enumerate(entered)
        )
        marked = with_marks(current, entries)
        for finding, automatic in zip(marked.findings, current.findings, strict=True):
            credit = latest.get(finding.quantity)
            if credit is None:
                assert finding == automatic
            else:
                assert finding.points == credit * finding.max_points
                assert not finding.is_open
        closed = [one for one in marked.findings if not one.is_open]
        assert marked.score == sum(one.points for one in closed)
        assert marked.max_score + marked.open_points == sum(
            one.max_points for one in marked.findings
        )
