"""A number that stands in two cells may have been written into the wrong one."""

import math
from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING

from gripcourse.course.quantity import Kind
from gripcourse.submission.model import Answer

if TYPE_CHECKING:
    from conftest import Case

FAR = 0.1


def test_the_number_of_the_next_cell_gets_no_name_and_says_whose_it_is(
    hydraulic: "Case", typed: Callable[[str, float, int], Answer]
) -> None:
    answered = [one for one in hydraulic.plan.answered if one.kind is Kind.FORMULA]
    said = 0
    for one, other in list(pairwise(answered))[::4]:
        number = hydraulic.reference[other.id]
        if abs(number - hydraulic.reference[one.id]) < 0.1 * abs(number):
            continue
        pair = {name: typed(name, number, 4) for name in (one.id, other.id)}
        finding = hydraulic.findings({**hydraulic.answers, **pair})[one.id]
        if finding.outcome.traits.mistake and finding.slip is None:
            said += other.title.of("en") in " ".join(map(str, finding.remarks))
    assert said


def test_the_number_of_the_other_end_is_named_beside_the_cell_that_it_stands_in(
    table: "tuple[Case, ...]", typed: Callable[[str, float, int], Answer]
) -> None:
    """The smaller ratio is both: taken for the larger, or written into its cell."""
    case, smaller = next(
        (one, min(ends, key=lambda name: one.reference[name]))
        for one in table
        if (ends := one.plan.inputs.get("force_ratio", ()))
        and set(ends) == {"force_ratio_at_max", "force_ratio_at_min"}
        and abs(one.reference[ends[0]] / one.reference[ends[1]] - 1) > FAR
    )
    number = case.reference[smaller]
    written = {name: typed(name, number, 4) for name in ("force_ratio", smaller)}
    answers = {**case.following(force_ratio=number), **written}
    finding = case.findings(answers)["force_ratio"]
    assert str(finding.slip) == "best_position"
    assert "Or the number of another cell" in str(finding.message)
    assert case.lost(answers) == {"force_ratio"}


def test_a_verdict_after_a_number_in_the_wrong_cell_is_judged_by_the_number_that_was_meant(
    hydraulic: "Case", typed: Callable[[str, float, int], Answer]
) -> None:
    quantities, values = hydraulic.plan.quantities, hydraulic.reference
    other = next(
        name
        for name in hydraulic.answers
        if quantities[name].kind is Kind.FORMULA
        and values[name] > 2 * values["bearing_stress_allowed"]
    )
    written = {name: typed(name, values[other], 4) for name in ("bearing_stress", other)}
    assert values["bearing_ok"] == 1
    assert hydraulic.lost({**hydraulic.answers, **written}) == {"bearing_stress"}


def test_the_size_of_the_line_above_may_have_been_copied(
    table: "tuple[Case, ...]", typed: Callable[[str, float, int], Answer]
) -> None:
    """The verdict is then that of the number which was meant, not of a size among stresses."""
    tried = 0
    for case in table:
        order = [one.id for one in case.plan.answered]
        if "bearing_ok" not in case.answers or case.reference["bearing_ok"] > 0:
            continue
        above = order[order.index("bearing_stress") - 1]
        size = case.reference[above]
        if above != "pin_diameter_first" or size > case.reference["bearing_stress_allowed"]:
            continue
        tried += 1
        written = {"bearing_stress": typed("bearing_stress", size, len(f"{size:g}"))}
        assert case.lost({**case.answers, **written}) == {"bearing_stress"}
    assert tried


def test_two_numbers_in_each_others_cells_cost_once(
    table: "tuple[Case, ...]", typed: Callable[[str, float, int], Answer]
) -> None:
    ends = ("force_ratio_at_max", "force_ratio_at_min")
    case = next(
        one
        for one in table
        if set(ends) <= one.answers.keys()
        and abs(one.reference[ends[0]] / one.reference[ends[1]] - 1) > FAR
    )
    exchanged = {
        name: typed(name, case.reference[other], 4)
        for name, other in zip(ends, ends[::-1], strict=True)
    }
    findings = case.findings({**case.answers, **exchanged})
    assert case.lost({**case.answers, **exchanged}) == {ends[0]}
    assert "are exchanged" in str(findings[ends[0]].message)
    assert findings[ends[1]].roots == (ends[0],)


def test_two_entries_of_a_table_in_each_others_cells_cost_once(table: "tuple[Case, ...]") -> None:
    """The bolt circle and the outer diameter of a flange, D_1 and D_2."""
    cells = ("flange_bolt_circle", "flange_diameter")
    case = next(one for one in table if set(cells) <= one.answers.keys())
    one, other = (case.reference[name] for name in cells)
    answers = {**case.answers, cells[0]: other, cells[1]: one}
    lost = case.lost(answers)
    assert len(lost) == 1
    assert lost < set(cells)
    assert "exchanged" in str(case.findings(answers)[lost.pop()].message)


def test_two_cells_one_below_the_other_cost_once_whatever_their_units(
    hydraulic: "Case", typed: Callable[[str, float, int], Answer]
) -> None:
    """Newtons in the cell of millimetres, and the other way round; cells far apart cost each."""
    case = hydraulic.without_errata
    cells = [one for one in case.plan.answered if one.id in case.answers]
    pairs = [
        (one, other)
        for one, other in pairwise(cells)
        if one.section == other.section
        and one.unit != other.unit
        and {one.kind, other.kind} == {Kind.FORMULA}
        and not math.isclose(case.reference[one.id], case.reference[other.id], rel_tol=0.1)
    ]
    assert len(pairs) > 3
    far = (pairs[0][0], next(one for one, _ in pairs[2:] if one.unit != pairs[0][0].unit))
    for one, other in (*pairs, far):
        written = {
            here.id: typed(here.id, case.reference[there.id], 4)
            for here, there in ((one, other), (other, one))
        }
        lost = case.lost({**case.answers, **written})
        assert lost == ({one.id} if (one, other) != far else {one.id, other.id}), (one.id, other.id)


def test_after_a_mistake_two_cells_are_exchanged_by_ones_own_numbers(
    table: "tuple[Case, ...]", typed: Callable[[str, float, int], Answer]
) -> None:
    """What one of them should be is computed with the number that stands in the other's cell."""
    tried = 0
    for case in table:
        quantities = case.plan.quantities
        for one, other in pairwise(case.plan.answered):
            if one.id not in case.plan.inputs[other.id] or one.section != other.section:
                continue
            if {one.kind, other.kind} != {Kind.FORMULA}:
                continue
            before = [
                name for name in case.plan.inputs[one.id] if quantities[name].kind is Kind.FORMULA
            ]
            if not before:
                continue
            wrong = case.following(**{before[0]: 1.37 * case.reference[before[0]]})
            near = wrong[one.id] / wrong[other.id]
            moved = wrong[other.id] / case.reference[other.id]
            if abs(near - 1) < FAR or abs(moved - 1) < FAR or quantities[one.id].integer:
                continue
            written = {
                one.id: typed(one.id, wrong[other.id], 4),
                other.id: typed(other.id, wrong[one.id], 4),
            }
            findings = case.findings({**wrong, **written})
            assert "are exchanged" in str(findings[one.id].message), (case.label, one.id)
            assert findings[other.id].points == findings[other.id].max_points
            tried += 1
            break
        if tried > 2:
            return
    assert tried


def test_what_follows_from_exchanged_numbers_as_they_were_meant_is_no_mistake(
    flat_belt: "Case",
) -> None:
    """After a wrong torque; the shaft is computed with the torque that stands in the next cell."""
    first, second = "torque_large", "driven_speed"
    later = flat_belt.following(torque_small=1.31 * flat_belt.reference["torque_small"])
    answers = {**later, first: later[second], second: later[first]}
    lost = flat_belt.lost(answers)
    assert "torque_small" in lost
    assert len(lost) == 2, lost
    said = [str(one.message) for one in flat_belt.findings(answers).values()]
    assert any("are exchanged" in one for one in said)


def test_a_number_of_a_table_that_stands_far_away_too_is_the_same_by_chance(
    hydraulic: "Case", typed: Callable[[str, float, int], Answer]
) -> None:
    """Of short numbers there are many: a bolt circle of 18 mm was not meant as a travel of 18."""
    order = [one.id for one in hydraulic.plan.answered]
    picks = [one.id for one in hydraulic.plan.answered if one.kind is Kind.PICK]
    far = [one for one in picks if order.index(one) - order.index("jaw_travel") > 1]
    assert far
    for name in far:
        number = 2 * hydraulic.reference[name]
        pair = {one: typed(one, number, 2) for one in (name, "jaw_travel")}
        finding = hydraulic.findings({**hydraulic.answers, **pair})[name]
        assert finding.outcome.traits.mistake
        assert "nother cell" not in f"{finding.message} {' '.join(map(str, finding.remarks))}"
