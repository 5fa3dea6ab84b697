"""Every erratum of the sources can be computed as printed, or there is nothing to compute in it."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from gripcourse.course.compose import reference_formula
from gripcourse.course.model import Course
from gripcourse.course.quantity import AsPrinted, Convention, Quantity
from gripcourse.solver.plan import make_plan
from gripcourse.solver.sizes import reference_rounding
from support.each import each

if TYPE_CHECKING:
    from conftest import Composition

# Errata that are no version of a quantity, and why.
NOTHING_TO_COMPUTE: Mapping[str, str] = {
    "E1": "a row of a table for jaws that nobody builds",
    "E7": "one letter for two ratios: the course has a name for each",
    "E8": "numbers of equations and an index",
    "E9": "the name of a steel",
    "E15": "the summary contradicts the calculation above it; nothing follows from it",
    "E18": "a sentence about a sign that the equations of the paper have right",
    "E19": "a sentence about arms that the equations contradict",
    "E20": "a sentence that holds for some angles only",
}


def declared(course: Course) -> Iterator[tuple[Quantity, AsPrinted]]:
    """Yield every printed version that some part or scheme declares."""
    for owner in (*course.parts.values(), *course.schemes.values()):
        for one in owner.quantities.values():
            yield from ((one, printed) for printed in one.as_printed)
    for scheme in course.schemes.values():
        for one in (one for part in scheme.changed for one in part.values()):
            yield from ((one, printed) for printed in one.as_printed)


def test_every_erratum_is_declared_or_has_nothing_to_compute(course: Course) -> None:
    computed = {printed.erratum for _, printed in declared(course)}
    assert computed.isdisjoint(NOTHING_TO_COMPUTE)
    assert computed | NOTHING_TO_COMPUTE.keys() == course.errata.keys()
    assert set(course.errata) == {f"E{number}" for number in range(1, len(course.errata) + 1)}


def test_a_printed_version_is_a_formula_or_a_rounding(course: Course) -> None:
    faults = [
        f"{one.file}: {one.id}: {printed.erratum}"
        for one, printed in declared(course)
        if (printed.formula is None) == (printed.rounding is None)
    ]
    assert faults == []


def test_the_guides_convention_takes_the_printed_version(course: Course) -> None:
    faults = [
        f"{one.id}: {printed.erratum}"
        for one, printed in declared(course)
        if printed.formula not in (None, reference_formula(one, Convention.AS_PRINTED))
        or printed.rounding not in (None, reference_rounding(one, Convention.AS_PRINTED))
    ]
    assert faults == []


def test_the_corrected_convention_takes_none(course: Course) -> None:
    faults = [
        f"{one.id}: {printed.erratum}"
        for one, printed in declared(course)
        if printed.formula is not None
        and printed.formula == reference_formula(one, Convention.CORRECTED)
    ]
    assert faults == []


@each("compositions", "composition")
def test_what_is_printed_differs_from_what_is_right(composition: "Composition") -> None:
    """In the plan of the guide's convention; that the numbers differ is tested with the slips."""
    plan = composition.plan
    guide = make_plan(plan.course, plan.scheme.id, plan.options, Convention.AS_PRINTED)
    changed = {
        name
        for name, one in plan.quantities.items()
        if guide.reference_formula(name) != plan.reference_formula(name)
        or reference_rounding(one, Convention.AS_PRINTED)
        is not reference_rounding(one, Convention.CORRECTED)
    }
    assert changed == {name for name, one in plan.quantities.items() if one.as_printed}
