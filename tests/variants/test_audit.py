"""An audit finds what it is for: near-duplicates, slips that fit, sizes at an edge, weak items."""

from dataclasses import replace

import numpy as np
import pytest

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.formula.evaluate import evaluate as evaluate_formula
from gripcourse.policy.bands import band
from gripcourse.policy.model import Policy
from gripcourse.slips.candidates import candidates_of
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, to_si
from gripcourse.text.units import factor
from gripcourse.variants.answers import solve_groups
from gripcourse.variants.audit import VariantAudit, audit
from gripcourse.variants.draw import draw
from gripcourse.variants.fair import Steps, near_steps, steps_ratio
from gripcourse.variants.model import Variant
from gripcourse.variants.screening import sifter
from gripcourse.variants.slip_distance import near_slips, too_near
from gripcourse.variants.space import Space, load_spaces

SCHEMES = {"wedge_roller", "screw", "vacuum_cups", "slot_lever"}


@pytest.fixture(scope="module")
def spaces(course: Course) -> tuple[Space, ...]:
    return tuple(one for one in load_spaces(course) if one.scheme in SCHEMES)


@pytest.fixture(scope="module")
def sound(course: Course, policy: Policy, spaces: tuple[Space, ...]) -> tuple[Variant, ...]:
    """A table that keeps all rules."""
    return draw(course, spaces, 12, 3, sifter(policy, len(course.sections))).variants


@pytest.fixture(scope="module")
def raw(course: Course, spaces: tuple[Space, ...]) -> tuple[Variant, ...]:
    """A table that was drawn without any rule."""
    return draw(course, spaces, 40, 3).variants


@pytest.fixture(scope="module")
def raw_audit(
    course: Course, policy: Policy, spaces: tuple[Space, ...], raw: tuple[Variant, ...]
) -> VariantAudit:
    return audit(course, policy, raw, spaces)


def test_a_table_in_which_a_quantity_never_comes_out_is_audited(
    course: Course, policy: Policy, sound: tuple[Variant, ...]
) -> None:
    """Nothing rubs: the force that would have to hold by friction has no value in any variant."""
    rubbing = [one for one in sound if "friction" in one.given][:1]
    still = [replace(one, given={**one.given, "friction": 0.0}) for one in rubbing]
    found = audit(course, policy, (*still, *(replace(one, id="twin") for one in still)))
    assert still
    assert all(one.broken for one in found.variants if "friction" in one.variant.given)


def planted(course: Course, sound: tuple[Variant, ...]) -> tuple[Variant, ...]:
    """The table with a near-duplicate of its first variant: the least important number differs."""
    first = sound[0]
    plan = make_plan(course, first.scheme, first.options)
    least = min(plan.givens, key=lambda one: (len(needing(plan, one.id)), one.id)).id
    changed = {**first.given, least: 1.1 * first.given[least]}
    return (*sound, replace(first, id="planted", given=changed))


def needing(plan: Plan, wanted: str) -> set[str]:
    """Everything that is computed from a quantity, directly or not."""
    found = {wanted}
    for name in plan.quantities:
        if found.intersection(plan.inputs[name]):
            found.add(name)
    return found


@pytest.mark.usefixtures("few_slips_counted")
def test_a_planted_near_duplicate_is_found(
    course: Course, policy: Policy, spaces: tuple[Space, ...], sound: tuple[Variant, ...]
) -> None:
    found = audit(course, policy, planted(course, sound), spaces)
    above = {one.variant.id for one in found.variants if one.above}
    assert above == {sound[0].id, "planted"}
    assert not found.passed
    (worst, *_) = found.pairs
    assert {worst.own, worst.other} == {0, len(sound)}
    assert worst.share > 0.5
    assert worst.given == pytest.approx(1 - 1 / len(sound[0].given))
    assert "lifting_load" in worst.equal


@pytest.mark.usefixtures("few_slips_counted")
def test_without_it_nothing_is_to_be_looked_at(
    course: Course, policy: Policy, spaces: tuple[Space, ...], sound: tuple[Variant, ...]
) -> None:
    found = audit(course, policy, sound, spaces)
    assert found.passed
    assert not found.apart.beyond
    assert found.pairs  # the nearest there are
    assert all(one.share <= policy.variants.shared_points for one in found.pairs)


@pytest.mark.usefixtures("few_slips_counted")
def test_an_identical_variant_shares_everything(
    course: Course, policy: Policy, sound: tuple[Variant, ...]
) -> None:
    found = audit(course, policy, (*sound, replace(sound[0], id="twin")))
    (worst, *_) = found.pairs
    beside = (worst.share, worst.sizes, worst.verdicts, worst.given, worst.followed)
    assert beside == pytest.approx((1.0,) * 5)
    assert worst.sections == pytest.approx((1.0,) * len(worst.sections))


@pytest.mark.usefixtures("few_slips_counted")
def test_a_single_variant_has_nobody_to_share_with(
    course: Course, policy: Policy, sound: tuple[Variant, ...]
) -> None:
    found = audit(course, policy, sound[:1])
    assert found.passed
    assert found.apart.pairs == 0
    assert found.variants[0].nearest is None


@pytest.mark.usefixtures("few_slips_counted")
def test_a_variant_outside_its_space_is_named(
    course: Course, policy: Policy, spaces: tuple[Space, ...], sound: tuple[Variant, ...]
) -> None:
    row = next(place for place, one in enumerate(sound) if one.scheme == "screw")
    near = {**sound[row].given, "diameter_max": 1.2 * sound[row].given["diameter_min"]}
    changed = (*sound[:row], replace(sound[row], given=near), *sound[row + 1 :])
    found = audit(course, policy, changed, spaces)
    said = [str(one) for one in found.variants[row].broken]
    assert any(one.startswith("not so: the largest object is enough larger") for one in said)
    assert not audit(course, policy, changed).variants[row].broken  # without spaces it is no rule


def test_a_refused_slip_lies_within_the_demanded_bands_and_the_others_do_not(
    course: Course, policy: Policy, raw: tuple[Variant, ...], raw_audit: VariantAudit
) -> None:
    """Against the scalar functions: every declared slip of every variant."""
    assert any(one.slips for one in raw_audit.variants)
    for variant, checked in zip(raw[:30], raw_audit.variants, strict=False):
        plan = make_plan(course, variant.scheme, variant.options)
        values = evaluate(plan, to_si(plan, variant.given)).values
        for quantity in plan.answered:
            if quantity.kind is Kind.CHOICE:
                continue
            size = factor(quantity.unit)
            right = float(values[quantity.id]) / size
            reach = policy.variants.slip_bands * band(quantity, right, policy)
            for slip in quantity.slips:
                wrong = evaluate_formula(slip.formula, quantity.unit, values, plan.columns) / size
                near = abs(float(wrong) - right) < reach
                assert ((quantity.id, slip.id) in checked.slips) == (near and not slip.seldom)


def test_no_right_answer_of_a_sound_table_is_what_a_declared_slip_gives(
    course: Course, policy: Policy, sound: tuple[Variant, ...]
) -> None:
    for group in solve_groups(course, sound):
        assert too_near(group, policy) == {}


def test_slips_of_every_kind_are_counted(
    course: Course, policy: Policy, sound: tuple[Variant, ...], raw_audit: VariantAudit
) -> None:
    kinds = {one.kind for one in raw_audit.slips}
    assert "declared" in kinds
    assert kinds - {"declared"} <= {str(kind) for kind in policy.slips.kinds}
    (group, *_) = solve_groups(course, sound[:1])
    named = {(one.quantity, one.slip) for one in near_slips(group, policy)}
    assert named == {
        (quantity.id, str(one.id))
        for quantity in group.family.plan(0).answered
        for one in candidates_of(group.family.plan(0), quantity.id, policy.slips)
    }


def test_a_size_is_at_an_edge_exactly_when_it_changes_with_its_answer(
    course: Course, raw: tuple[Variant, ...]
) -> None:
    seen = set()
    for group in solve_groups(course, raw):
        near = near_steps(group, 0.1)
        for place in range(len(group.rows)):
            size, answer = "pin_diameter_first", "pin_diameter_required"
            required = group.values[answer][place] if size in near else 0
            if not np.nan_to_num(required):
                continue
            sizes = group.family.plan(place).columns["pin.diameter"].sizes
            chosen = [sizes[np.searchsorted(sizes, required * scale)] for scale in (0.9, 1.1)]
            own = group.values[size][place]
            assert near[size][place] == any(abs(one - own) > 0.2 * own for one in chosen)
            seen.add(bool(near[size][place]))
    assert seen == {True, False}


def test_a_size_that_rests_on_sizes_alone_is_never_at_an_edge(
    course: Course, raw: tuple[Variant, ...]
) -> None:
    for group in solve_groups(course, raw):
        near = near_steps(group, 0.05)
        if "rod" in near:
            rods = [one for one in group.family.members if one.quantity.id == "rod"]
            assert {one.inputs for one in rods} == {("bore",)}
            assert not near["rod"].any()


def test_a_quantity_that_hardly_differs_is_named_as_weak(raw_audit: VariantAudit) -> None:
    weak = {(one.scheme, one.quantity) for one in raw_audit.weak_items}
    limit = raw_audit.rules.weak_item
    assert weak == {(one.scheme, one.quantity) for one in raw_audit.spreads if one.equal > limit}
    assert weak
    assert ("screw", "grip_force") not in weak
    for one in raw_audit.spreads:
        assert one.lowest <= one.median <= one.highest


def test_a_verdict_with_one_answer_is_weak_and_one_with_both_is_not(
    raw_audit: VariantAudit,
) -> None:
    assert all(one.yes == one.variants for one in raw_audit.verdicts if one.must_hold)
    first = raw_audit.verdicts[0]
    for yes, is_weak in ((first.variants, True), (0, True), (first.variants - 1, False)):
        one = replace(raw_audit, verdicts=(replace(first, yes=yes),))
        assert (first.quantity in one.weak_verdicts) is is_weak


def test_steps_are_counted_for_each_scheme_and_its_options(raw_audit: VariantAudit) -> None:
    assert sum(one.variants for one in raw_audit.steps) == len(raw_audit.variants)
    assert {one.composition.scheme for one in raw_audit.steps} == SCHEMES
    for one in raw_audit.steps:
        assert one.total == one.computed + one.decided + one.read
        assert 1 < one.chain < one.total
    assert raw_audit.ratio == steps_ratio(raw_audit.steps) > 1


def test_a_much_longer_assignment_is_to_be_looked_at(raw_audit: VariantAudit) -> None:
    short = Steps(Composition("a", ()), 1, 10, 5, 5, 8)
    long = replace(short, computed=45)
    assert steps_ratio([short, long]) == pytest.approx(55 / 20)
    assert not replace(raw_audit, ratio=2.75).alike_steps
    assert replace(raw_audit, ratio=2.5).alike_steps


def test_every_variant_is_told_whose_answers_bring_most(raw_audit: VariantAudit) -> None:
    for row, one in enumerate(raw_audit.variants):
        assert one.nearest is not None
        assert one.nearest.own == row != one.nearest.other
        assert one.nearest.share == pytest.approx(raw_audit.apart.whole.share[row])
        assert one.nearest.followed >= one.nearest.share - 1e-9


def test_what_counts_for_no_limit_is_told_beside(raw_audit: VariantAudit) -> None:
    beside = raw_audit.beside
    assert 0 < beside.computed < beside.sizes < beside.verdicts < 1
    pairs, size = raw_audit.apart.pairs, len(raw_audit.variants)
    assert pairs == size * (size - 1)
    histogram = raw_audit.apart.whole.histogram
    mean = (histogram * np.arange(len(histogram))).sum() / pairs / 100
    assert beside.computed == pytest.approx(mean, abs=0.01)
