"""What is one and the same for nearly everybody is named; how sizes spread is told."""

from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.text.words import LANGUAGES, Texts
from gripcourse.variants.answers import solve_groups
from gripcourse.variants.audit import VariantAudit, audit
from gripcourse.variants.draw import draw
from gripcourse.variants.fair import VerdictShare
from gripcourse.variants.model import Variant
from gripcourse.variants.monotony import EndShare, ends_of, sizes_of, taken_of
from gripcourse.variants.space import load_spaces

SCHEMES = ("screw", "slot_lever")
BECAUSE = Texts(dict.fromkeys(LANGUAGES, "the pivot carries less"))


@pytest.fixture(scope="module")
def some(course: Course) -> tuple[Variant, ...]:
    spaces = [one for one in load_spaces(course) if one.scheme in SCHEMES]
    return draw(course, spaces, 40, 3).variants


@pytest.fixture(scope="module")
def found(course: Course, policy: Policy, some: tuple[Variant, ...]) -> VariantAudit:
    return audit(course, policy, some)


def test_five_fifty_and_ninety_five_percent_of_a_size_are_told_in_its_unit(
    course: Course, some: tuple[Variant, ...]
) -> None:
    groups = solve_groups(course, some)
    (one,) = (
        one for one in sizes_of(groups) if (one.scheme, one.quantity) == ("screw", "pin_diameter")
    )
    (group,) = (group for group in groups if group.family.scheme == "screw")
    sizes = group.values["pin_diameter"] * 1000
    assert one.unit == "mm"
    assert one.is_picked
    for told, percent in ((one.low, 5), (one.median, 50), (one.high, 95)):
        occurring = sizes[np.isclose(sizes, told)]
        assert len(occurring), "no size of the series"
        assert (sizes <= occurring.max()).mean() >= percent / 100
        assert (sizes < occurring.min()).mean() < percent / 100
    common = np.isclose(sizes, one.commonest).mean()
    assert one.share == pytest.approx(common)
    assert all(np.isclose(sizes, other).mean() <= common for other in sizes)


def test_a_size_that_most_variants_share_is_named(found: VariantAudit) -> None:
    limit = found.rules.same_size
    common = {
        (one.scheme, one.quantity): one
        for one in found.sizes
        if one.is_picked and one.share > limit and one.variants >= 4
    }
    same = {(one.scheme, one.quantity): one for one in found.same_sizes}
    assert same.items() <= common.items()
    for (scheme, _), one in common.items() - same.items():
        assert any((scheme, name) in common for name in one.rests_on)
    none = replace(found, rules=replace(found.rules, same_size=1.0))
    assert none.same_sizes == ()


def test_an_end_of_the_range_that_always_governs_is_named(
    course: Course, found: VariantAudit, some: tuple[Variant, ...]
) -> None:
    groups = solve_groups(course, some)
    ends = {(one.scheme, one.quantity): one for one in ends_of(groups)}
    force = ends["slot_lever", "force_ratio"]
    assert {force.first, force.second} == {"force_ratio_at_max", "force_ratio_at_min"}
    (group,) = (group for group in groups if group.family.scheme == "slot_lever")
    greater = group.values[force.first] > group.values[force.second]
    assert force.share == pytest.approx(greater.mean())
    assert (force in found.same_ends) == (force.same > found.rules.same_end)


@pytest.mark.parametrize("places", [-4, 0, 4])
def test_ends_that_differ_in_the_last_places_are_alike(
    course: Course, some: tuple[Variant, ...], places: int
) -> None:
    (group,) = (one for one in solve_groups(course, some) if one.family.scheme == "slot_lever")
    largest = group.values["force_ratio_at_max"]
    moved = largest + places * np.spacing(largest)
    group = replace(group, values={**group.values, "force_ratio_at_min": moved})
    (force,) = (one for one in taken_of(group) if one.member.quantity.id == "force_ratio")
    assert set(force.share) == {0.5}


def test_the_reason_of_a_quantity_stands_with_each_pair_that_its_formula_compares(
    course: Course, some: tuple[Variant, ...]
) -> None:
    groups = solve_groups(course, some)
    ends = ends_of(groups)
    told = {(one.scheme, one.quantity, one.first, one.second): one for one in ends}
    assert len(told) == len(ends)
    shares: dict[tuple[str, str, str, str], list[np.ndarray]] = {}
    for group in groups:
        for taken in taken_of(group):
            declared = taken.member.quantity
            pair = (group.family.scheme, declared.id, taken.first, taken.second)
            assert told[pair].because == declared.one_end
            shares.setdefault(pair, []).append(taken.share)
    for pair, found in shares.items():
        assert told[pair].share == pytest.approx(np.nanmean(np.concatenate(found)))
    assert any(one.because is not None for one in ends)
    assert any(one.because is None for one in ends)


def test_a_reason_excuses_only_the_pairs_that_it_is_declared_for(found: VariantAudit) -> None:
    excused = EndShare("press", "force", "at_max", "at_min", 50, 1.0, BECAUSE)
    broken = replace(excused, first="open", second="at_max", share=0.98)
    silent = replace(excused, quantity="torque", because=None)
    told = replace(found, ends=(excused, broken, silent))
    assert told.told_ends == (excused,)
    assert told.same_ends == (broken, silent)


def test_a_verdict_that_is_rarely_or_mostly_no_is_named(found: VariantAudit) -> None:
    counts = {"rare": 9, "even": 5, "mostly": 1}
    verdicts = [
        VerdictShare(id_, "screw", 10, 1.0, yes, must_hold=False) for id_, yes in counts.items()
    ]
    verdicts.append(VerdictShare("asked", "screw", 10, 1.0, 10, must_hold=True))
    named = [one.quantity for one in replace(found, verdicts=tuple(verdicts)).lopsided_verdicts]
    assert named == ["rare", "mostly"]


@pytest.mark.parametrize(
    ("share", "because", "is_named", "is_told"),
    [
        (0.9, None, True, False),
        (0.55, None, False, False),
        (1.0, BECAUSE, False, True),
        (0.0, BECAUSE, False, True),
        (0.98, BECAUSE, True, False),  # it was said that this cannot be
    ],
)
def test_an_end_that_is_declared_to_govern_always_is_told_and_checked(
    found: VariantAudit,
    share: float,
    because: Texts | None,
    *,
    is_named: bool,
    is_told: bool,
) -> None:
    end = EndShare("press", "force", "at_max", "at_min", 50, share, because)
    told = replace(found, ends=(end,))
    assert bool(told.same_ends) == is_named
    assert bool(told.told_ends) == is_told
