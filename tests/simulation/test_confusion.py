"""The measuring itself: planted judgements come out as they were planted."""

from collections.abc import Iterable
from dataclasses import replace

import pytest

from gripcourse.grading.model import Finding, Flag, Outcome
from gripcourse.simulation.confusion import JudgedWork, Said, evaluate
from gripcourse.simulation.misses import HEADS, misses_csv
from gripcourse.simulation.model import Action, ActionKind, Conduct, Mix
from gripcourse.slips.model import SlipId
from gripcourse.text.words import message


def _slip(written: str) -> SlipId | None:
    return SlipId.parse(written) if written else None


def action(quantity: str, done: ActionKind, slip: str = "", twins: tuple[str, ...] = ()) -> Action:
    kind = slip.partition(":")[0]
    made, others = _slip(slip), tuple(SlipId.parse(one) for one in twins)
    return Action(quantity, done, made, kind, others, value=2.0, right=1.0, typed=2.0)


@pytest.fixture
def planted(judged: tuple[JudgedWork, ...]) -> "Plant":
    honest = next(
        one
        for one in judged
        if one.work.behaviour.conduct is Conduct.HONEST and one.report.findings
    )
    return Plant(honest)


class Plant:
    """Makes students of whom it is known what they did and what was said of it."""

    def __init__(self, pattern: JudgedWork) -> None:
        self.pattern = pattern

    def student(
        self,
        name: str,
        conduct: Conduct,
        answers: Iterable[tuple[Action, Outcome, str, tuple[str, ...]]],
        flags: tuple[str, ...] = (),
        neighbour: str = "",
    ) -> JudgedWork:
        listed = list(answers)
        behaviour = replace(self.pattern.work.behaviour, conduct=conduct, neighbour=neighbour)
        work = replace(
            self.pattern.work,
            student=name,
            owner=neighbour if conduct is Conduct.COPIED_WORKBOOK else name,
            behaviour=behaviour,
            actions=tuple(one[0] for one in listed),
        )
        findings = tuple(self.finding(one.quantity, *said) for one, *said in listed)
        report = replace(
            self.pattern.report,
            student=name,
            findings=findings,
            flags=tuple(Flag(code, message("Look here.")) for code in flags),
        )
        return JudgedWork(work, report)

    def finding(self, quantity: str, outcome: Outcome, slip: str, tied: tuple[str, ...]) -> Finding:
        return replace(
            self.pattern.report.findings[0],
            quantity=quantity,
            outcome=outcome,
            slip=_slip(slip),
            tied=tuple(SlipId.parse(one) for one in tied),
        )


def test_planted_judgements_are_counted_where_they_belong(planted: Plant, mix: Mix) -> None:
    slip = action("b", ActionKind.SLIP, "unit:kN", twins=("power_of_ten:0.001",))
    said = [
        (action("a", ActionKind.RIGHT), Outcome.CORRECT, "", ()),
        (slip, Outcome.SLIP, "unit:kN", ()),
        (replace(slip, quantity="c"), Outcome.SLIP, "power_of_ten:0.001", ()),
        (replace(slip, quantity="d"), Outcome.SLIP, "sign:whole", ("unit:kN",)),
        (replace(slip, quantity="e"), Outcome.SLIP, "sign:whole", ()),
        (replace(slip, quantity="f"), Outcome.CARRIED, "", ()),
        (replace(slip, quantity="g"), Outcome.WRONG, "", ()),
        (action("h", ActionKind.FOLLOWS), Outcome.CARRIED, "", ()),
        (action("i", ActionKind.FOLLOWS), Outcome.WRONG, "", ()),
    ]
    honest = [(action("a", ActionKind.RIGHT), Outcome.WRONG, "", ())]
    found = evaluate(
        [
            planted.student("one", Conduct.SLIP, said),
            planted.student("two", Conduct.HONEST, honest),
        ],
        mix,
    )
    assert found.table[ActionKind.SLIP, Said.NAMED] == 2
    assert found.table[ActionKind.SLIP, Said.TIED] == 1
    assert found.table[ActionKind.SLIP, Said.MISNAMED] == 1
    counted = {name: (rate.hits, rate.total) for name, rate in found.rates.items()}
    assert counted["honest_refused"] == (1, 1)
    assert counted["other_refused"] == (0, 1)
    assert counted["slip_accepted"] == (1, 6)
    assert counted["slip_named"] == (3, 6)
    assert counted["slip_misnamed"] == (1, 6)
    assert counted["follows_refused"] == (1, 2)
    assert set(found.missed) == {"honest_refused", "slip_accepted", "slip_named", "slip_misnamed"}
    assert sorted(one.action.quantity for one in found.misses) == ["a", "e", "f", "g", "i"]


@pytest.mark.parametrize(
    ("follows", "roots", "counted"),
    [
        ((1.0, 1.0), ("root",), ("slip_joined", "slip_accepted")),
        ((None, None), ("root",), ("slip_joined", "slip_accepted")),
        ((1.9, 2.1), ("root",), ("slip_accepted", "slip_joined")),
        ((1.0, 1.0), (), ("slip_accepted", "slip_joined")),
    ],
    ids=["another number", "no number", "follows from what was typed", "no root"],
)
def test_a_mistake_that_cost_with_another_one_is_not_taken_for_right(
    planted: Plant,
    mix: Mix,
    follows: tuple[float | None, float | None],
    roots: tuple[str, ...],
    counted: tuple[str, str],
) -> None:
    slip = action("b", ActionKind.SLIP, "unit:kN")  # 2.0 was typed
    one = planted.student("one", Conduct.TWO_SLIPS, [(slip, Outcome.CARRIED, "", ())])
    low, high = follows
    finding = replace(one.report.findings[0], low=low, high=high, band=0.01, roots=roots)
    rates = evaluate([replace(one, report=replace(one.report, findings=(finding,)))], mix).rates
    assert [(rates[name].hits, rates[name].total) for name in counted] == [(1, 1), (0, 1)]


def test_copies_are_flagged_by_what_says_that_they_are_copies(planted: Plant, mix: Mix) -> None:
    right = [(action("a", ActionKind.RIGHT), Outcome.CORRECT, "", ())]
    found = evaluate(
        [
            planted.student("source", Conduct.HONEST, right, ("same_bytes",)),
            planted.student("alone", Conduct.HONEST, right, ("signature",)),
            planted.student("quiet", Conduct.HONEST, right),
            planted.student("copier", Conduct.COPIED_WORKBOOK, right, ("same_bytes",), "source"),
            planted.student("missed", Conduct.COPIED_ANSWERS, right, ("signature",), "source"),
        ],
        mix,
    )
    counted = {name: (rate.hits, rate.total) for name, rate in found.rates.items()}
    assert counted["copy_flagged"] == (1, 2)
    assert counted["honest_flagged"] == (1, 2)
    assert counted["source_flagged"] == (1, 1)


def test_an_incident_is_a_failure_of_ours(planted: Plant, mix: Mix) -> None:
    whole = planted.student("one", Conduct.HONEST, [])
    found = evaluate([whole, replace(whole, incident="Traceback: it failed")], mix)
    assert (found.rates["incidents"].hits, found.rates["incidents"].total) == (1, 2)
    assert found.missed == ("incidents",)
    assert found.incidents == ("Traceback: it failed",)


def test_each_miss_is_a_row_with_its_numbers(judged: tuple[JudgedWork, ...], mix: Mix) -> None:
    found = evaluate(judged, mix)
    schemes = {one.work.student: one.report.scheme for one in judged}
    lines = misses_csv(found.misses, schemes).splitlines()
    assert lines[0] == ",".join(HEADS)
    assert len(lines) == 1 + len(found.misses)


def test_the_grader_refuses_no_honest_answer_and_accepts_no_slip(
    judged: tuple[JudgedWork, ...], mix: Mix
) -> None:
    found = evaluate(judged, mix)
    assert not found.incidents
    for name in ("honest_refused", "slip_accepted", "slip_misnamed", "honest_flagged"):
        assert found.rates[name].reached, name
        assert found.rates[name].total > 30
    assert found.rates["slip_named"].share > 0.85
