"""What a diagram shows of a drive is what its declarations compute: it pushes, or it pulls."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache

import pytest

from gripcourse.course.diagram import Element
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Convention
from gripcourse.drawing.diagram.contacts import contact
from gripcourse.drawing.diagram.drives import cylinder, floating_cylinder
from gripcourse.drawing.diagram.marks import Path
from gripcourse.drawing.diagram.places import PlacedElement, Stop, shape_of, stops_of
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, to_si
from gripcourse.variants.model import Variant

DRAWN = 12
SEEN = 0.02  # mm of paper: an arc is drawn as a chain of chords
SOONEST = 0.1  # mm of paper that a rod travels at least
DRIVES = {"cylinder": cylinder, "floating_cylinder": floating_cylinder}


@dataclass(frozen=True, slots=True)
class Case:
    """A variant of a scheme with one of its drives.

    Attributes:
        name: for messages.
        plan: with the options of the variant.
        stops: where the joints are.
        pulls: whether the declarations take the rod's section from the piston; None: no cylinder.
    """

    name: str
    plan: Plan
    stops: dict[str, Stop]
    pulls: bool | None

    def shapes(
        self, kinds: set[str], quantity: str = ""
    ) -> Iterator[tuple[PlacedElement, PlacedElement]]:
        """Yield each drawn element of these kinds, on the largest object and on the smallest."""
        diagram = self.plan.scheme.diagram
        assert diagram is not None
        for element in diagram.elements:
            is_meant = element.kind in kinds and quantity in {"", element.quantity}
            if is_meant and element.is_drawn(self.plan.options):
                yield self.shape(element, "at_max"), self.shape(element, "at_min")

    def shape(self, element: Element, position: str) -> PlacedElement:
        """Return an element at a position, a millimetre of paper for one of the gripper."""
        return shape_of(element, self.plan, self.stops, position, 1.0, "en")


@pytest.fixture(scope="module")
def cases_of(
    course: Course, drawn_of: Callable[[str, int], tuple[Variant, ...]]
) -> Callable[[str], tuple[Case, ...]]:
    """Make the cases of a scheme, once."""
    return cache(lambda scheme_id: drives_of(course, course.schemes[scheme_id], drawn_of))


@pytest.fixture
def cases(scheme_id: str, cases_of: Callable[[str], tuple[Case, ...]]) -> tuple[Case, ...]:
    """Drawn variants of a scheme, one at least for each drive; none where nothing moves."""
    return cases_of(scheme_id)


def drives_of(
    course: Course, scheme: Scheme, drawn_of: Callable[[str, int], tuple[Variant, ...]]
) -> tuple[Case, ...]:
    """Draw variants of a scheme, and let them have each of its drives."""
    if scheme.kinematics is None:
        return ()
    drawn = drawn_of(scheme.id, DRAWN)
    found = [case(course, one, dict(one.options)) for one in drawn]
    for option in scheme.options:
        for choice in option.choices if option.id == "drive" else ():
            of_choice = (case(course, one, {**one.options, "drive": choice.id}) for one in drawn)
            found.append(next(one for one in of_choice if one is not None))
    return tuple(one for one in found if one is not None)


def case(course: Course, variant: Variant, options: dict[str, str]) -> Case | None:
    """Solve a variant with other options; None where it lacks numbers for them."""
    plan = make_plan(course, variant.scheme, options, Convention.CORRECTED)
    given = {name: one for name, one in variant.given.items() if name in plan.quantities}
    values = evaluate(plan, to_si(plan, given)).values
    diagram = plan.scheme.diagram
    assert diagram is not None
    pulls = None
    if "piston_area" in values:
        area, bore = float(values["piston_area"]), float(values["bore"])
        if not math.isfinite(area):
            return None
        pulls = area < math.pi * bore**2 / 4 * (1 - 1e-9)
    name = f"{variant.scheme} {variant.id} {options}"
    return Case(name, plan, stops_of(plan, diagram, given), pulls)


def out_of_the_cylinder(open_: PlacedElement, closed: PlacedElement) -> float:
    """Return how far the rod comes out of the drawn body while the jaws close."""
    if closed.element.kind == "floating_cylinder":
        ends = (one.through for one in (open_, closed))
        before, after = (math.dist(one[0], one[-1]) for one in ends)
        return after - before
    body = next(mark for mark in cylinder(closed) if isinstance(mark, Path) and mark.closed)
    middle = tuple(sum(one) / len(body.points) for one in zip(*body.points, strict=True))
    return math.dist(closed.at, middle) - math.dist(open_.at, middle)


def test_the_rod_leaves_a_pushing_cylinder_and_enters_a_pulling_one(
    cases: tuple[Case, ...],
) -> None:
    faults = []
    for one in cases:
        cylinders = list(one.shapes(set(DRIVES)))
        if len(cylinders) != (one.pulls is not None):
            faults.append(f"{one.name}: {len(cylinders)} cylinders")
        for open_, closed in cylinders:
            if (closed.element.words["rod"] == "pulls") is not one.pulls:
                faults.append(f"{one.name}: the pressure is drawn on the wrong side")
            out = out_of_the_cylinder(open_, closed)
            if abs(out) < SOONEST or (out < 0) is not one.pulls:
                faults.append(f"{one.name}: the rod moves {out} mm, pulls: {one.pulls}")
    assert faults == []


def test_the_force_of_the_drive_points_where_the_rod_goes(cases: tuple[Case, ...]) -> None:
    faults = []
    for one in cases:
        arrows = list(one.shapes({"force"}, "drive_force"))
        if len(arrows) != ("drive_force" in one.plan.quantities):
            faults.append(f"{one.name}: {len(arrows)} arrows")
        for open_, closed in arrows:
            turn = closed.angles["turn"]
            moved = [after - before for before, after in zip(open_.at, closed.at, strict=True)]
            if moved[0] * math.cos(turn) + moved[1] * math.sin(turn) <= 0:
                faults.append(f"{one.name}: the rod moves by {moved}, the force points to {turn}")
    assert faults == []


def test_every_jaw_touches_the_object_and_never_cuts_it(cases: tuple[Case, ...]) -> None:
    faults = []
    for one in cases:
        jaws = list(one.shapes({"contact", "vee"}))
        if len(jaws) != 1:
            faults.append(f"{one.name}: {len(jaws)} kinds of jaws")
        for shape in (found for pair in jaws for found in pair if found.element.kind == "contact"):
            centre = shape.points["holds"][0]
            radius = math.dist(shape.at, centre)
            outlines = [mark for mark in contact(shape) if isinstance(mark, Path) and mark.closed]
            for outline in outlines:
                gap = distance(outline, centre) - radius
                if abs(gap) > SEEN:
                    faults.append(f"{one.name}: {gap} mm from the object of {radius} mm")
    assert faults == []


def distance(outline: Path, point: tuple[float, float]) -> float:
    """Return the distance of a point from a closed outline, negative inside it."""
    corners = outline.points
    sides = zip(corners, (*corners[1:], corners[0]), strict=True)
    return min(from_side(a, b, point) for a, b in sides)


def from_side(a: tuple[float, float], b: tuple[float, float], point: tuple[float, float]) -> float:
    along = (b[0] - a[0], b[1] - a[1])
    square = along[0] ** 2 + along[1] ** 2
    share = ((point[0] - a[0]) * along[0] + (point[1] - a[1]) * along[1]) / square
    share = min(max(share, 0.0), 1.0)
    return math.dist(point, (a[0] + share * along[0], a[1] + share * along[1]))
