"""A slip or a printed erratum that gives the right number is useless: nobody would be told."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import evaluate
from gripcourse.policy.bands import band, within
from gripcourse.policy.model import Policy
from gripcourse.proofs.prove import Subject
from gripcourse.proofs.samples import Trial
from gripcourse.proofs.wrong_methods import prove_wrong_methods
from gripcourse.solver.sizes import entry
from gripcourse.text.units import factor
from support.each import each

if TYPE_CHECKING:
    from conftest import Composition, Reference
    from gripcourse.solver.plan import Plan

# Where the numbers of the guide's example hide a wrong method; variants must show it.
SAME_IN_THE_EXAMPLE: Mapping[str, Mapping[str, str]] = {
    "rack_parallelogram": {
        "drive_force: efficiency_multiplied": "the guide's example leaves the efficiency out",
        "drive_force: efficiency_left_out": "the guide's example leaves the efficiency out",
        "force_gain: losses_left_out": "the guide's example leaves the efficiency out",
        "drive_force: reserve_counted": "the guide's example has no reserve",
        "bore_required: reserve_counted": "the guide's example has no reserve",
        "pin_diameter_first: E13": "the right force asks for 11.03 mm, whose nearest size is 12",
        "lifting_load: E16": "the example is computed with the printed gravity",
        "reduced_modulus: mean_of_both": "jaw and object of the guide's example have one modulus",
    },
}
# Errata that few variants can show. No variant is refused for an erratum: a course may accept it.
SELDOM_DIFFERENT: Mapping[str, str] = {
    "arm_shift_at_max: E17": "tangent and cotangent of half of a right angle are one",
    "arm_shift_at_min: E17": "tangent and cotangent of half of a right angle are one",
    "radius_ratio: E2": "the printed ratio is right where the jaw has the smaller radius",
    "finger_opening_right: E22": "friction cancels where the faces stand square to the load",
    "finger_opening_left: E22": "friction cancels where the faces stand square to the load",
}
USUAL = 0.75  # share of the variants in which a wrong method must show


@dataclass(frozen=True, slots=True)
class Wrong:
    """A wrong value of a quantity, by the name of its slip or erratum; declared unit."""

    name: str
    quantity: Quantity
    value: float
    right: float


def wrong_values(plan: "Plan", reference: "Reference") -> Iterator[Wrong]:
    """Compute every wrong method at the right inputs."""
    for one in plan.answered:
        size = factor(one.unit)
        right = float(reference.values[one.id]) / size
        named = [(slip.id, slip.formula) for slip in one.slips]
        named += [
            (printed.erratum, printed.formula) for printed in one.as_printed if printed.formula
        ]
        for name, formula in named:
            value = evaluate(formula, one.unit, reference.values, plan.columns)
            yield Wrong(f"{one.id}: {name}", one, float(value) / size, right)
        for printed in one.as_printed:
            if printed.rounding is None or one.choice is None or one.formula is None:
                continue
            required = evaluate(one.formula, one.unit, reference.values, plan.columns)
            value = entry(plan, one.choice, printed.rounding, required)
            yield Wrong(f"{one.id}: {printed.erratum}", one, float(value) / size, right)


def is_seen(wrong: Wrong, policy: Policy) -> bool:
    """Tell whether a wrong value lies outside the band round the right one."""
    return not within(wrong.value, wrong.right, band(wrong.quantity, wrong.right, policy))


def test_every_wrong_method_shows_and_is_named(
    subject: Subject, trials: dict[str, tuple[Trial, ...]]
) -> None:
    every = tuple(one for own in trials.values() for one in own)
    results = tuple(prove_wrong_methods(subject.source, subject.policy, every))
    left = {one.key for result in results for one in result.problems}
    assert left == set()
    assert sum(one.compared for one in results) > 200


def test_a_wrong_method_shows_in_the_guides_example(
    of_the_guide: "Composition", policy: Policy
) -> None:
    found = wrong_values(of_the_guide.plan, of_the_guide.example)
    hidden = {wrong.name for wrong in found if not is_seen(wrong, policy)}
    assert hidden == SAME_IN_THE_EXAMPLE.get(of_the_guide.plan.scheme.id, {}).keys()


@each("compositions", "composition")
def test_a_wrong_method_shows_in_most_variants(composition: "Composition", policy: Policy) -> None:
    variants = [one for one in composition.references if one.name != "worked example"]
    seen: dict[str, int] = {}
    for reference in variants:
        for wrong in wrong_values(composition.plan, reference):
            rounded = wrong.quantity.kind is Kind.CHOICE  # often the same entry of the series
            shows = is_seen(wrong, policy) or rounded
            seen[wrong.name] = seen.get(wrong.name, 0) + shows
    declared = {
        f"{one.id}: {slip.id}"
        for one in composition.plan.answered
        for slip in one.slips
        if slip.seldom
    }
    seldom = {name for name, count in seen.items() if count < USUAL * len(variants)}
    assert seldom - SELDOM_DIFFERENT.keys() - declared == set()


@each("compositions", "composition")
def test_two_wrong_methods_of_a_quantity_give_two_values(
    composition: "Composition", policy: Policy
) -> None:
    """Else the hint of the one would be given for the other."""
    doubled: dict[tuple[str, str], int] = {}
    for reference in composition.references:
        found = list(wrong_values(composition.plan, reference))
        for index, one in enumerate(found):
            for other in found[index + 1 :]:
                if one.quantity.id == other.quantity.id:
                    key = (one.name, other.name)
                    same = within(one.value, other.value, band(one.quantity, other.value, policy))
                    doubled[key] = doubled.get(key, 0) + same
    always = {key for key, count in doubled.items() if count == len(composition.references)}
    # One example may hide what variants show.
    assert always == set() or len(composition.references) == 1
