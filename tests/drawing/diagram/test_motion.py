"""The mechanism as it moves: what a diagram draws holds together at every position."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations

import pytest
import shapely

from gripcourse.course.model import Course
from gripcourse.drawing.diagram.layout import SYMBOLS
from gripcourse.drawing.diagram.marks import Mark, Mask, Path, chain, mirrored, polar
from gripcourse.drawing.diagram.places import MILLIMETRES, PlacedElement, shape_of, stops_of
from gripcourse.solver.plan import make_plan
from gripcourse.variants.model import Variant
from support.issued_table import issued_table

EACH = 2  # variants of a scheme
SIZE = 80.0  # mm of paper that the mechanism takes
ATTACHED = 0.3  # mm of a link that is seen to end in its jaw
TOUCHES = 0.15  # mm: what is drawn in lines of half a millimetre touches
SHARES = (0.01, 0.25, 0.5, 0.75, 0.99)  # of a guide's length, where something must be in it
SOLID = frozenset({"object", "plate", "contact", "vee", "nut"})
STRAIGHT = frozenset({"link", "screw", "slider", "motor"})


@dataclass(frozen=True, slots=True)
class Standing:
    """A variant at one position of its drive.

    Attributes:
        name: of scheme, variant and position.
        solids: bodies with the kind of their element, those of the other side too.
        links: lines of all links and shafts.
        guides: middle lines of the guides.
    """

    name: str
    solids: tuple[tuple[str, shapely.Geometry], ...]
    links: shapely.Geometry
    guides: tuple[shapely.LineString, ...]


@pytest.fixture(scope="module")
def standing(course: Course) -> tuple[Standing, ...]:
    """Issued variants of every scheme at every position that their kinematics names."""
    table = issued_table(course)
    of_scheme: dict[str, list[Variant]] = {}
    for variant in table:
        of_scheme.setdefault(variant.scheme, []).append(variant)
    few = [one for variants in of_scheme.values() for one in variants[:EACH]]
    return tuple(one for variant in few for one in positions(course, variant))


def positions(course: Course, variant: Variant) -> Iterator[Standing]:
    plan = make_plan(course, variant.scheme, variant.options)
    diagram = plan.scheme.diagram
    assert diagram is not None
    stops = stops_of(plan, diagram, variant.given)
    reach = [abs(one) for stop in stops.values() for point in stop.points.values() for one in point]
    scale = SIZE / MILLIMETRES / max(reach)
    kinds = SOLID | STRAIGHT | {"guide"}
    drawn = [one for one in diagram.elements if one.kind in kinds and one.is_drawn(plan.options)]
    for position in stops:
        shapes = [shape_of(one, plan, stops, position, scale, "ru") for one in drawn]
        solids = [
            (one.element.kind, solid(marks))
            for one in shapes
            if one.element.kind in SOLID
            for marks in on_sides(one)
        ]
        links = [
            shapely.LineString(chain(mark))
            for one in shapes
            if one.element.kind in STRAIGHT
            for marks in on_sides(one)
            for mark in marks
            if isinstance(mark, Path)
        ]
        yield Standing(
            f"{variant.scheme} {variant.id} {position}",
            tuple(solids),
            shapely.MultiLineString(links),
            tuple(middle_line(one) for one in shapes if one.element.kind == "guide"),
        )


def on_sides(shape: PlacedElement) -> Iterator[Sequence[Mark]]:
    marks = list(SYMBOLS[shape.element.kind](shape))
    if shape.element.mirror != "only":
        yield marks
    if shape.element.mirror != "none":
        yield [mirrored(mark) for mark in marks]


def solid(marks: Sequence[Mark]) -> shapely.Geometry:
    """Return the region of a body: what hides others, else what its first line encloses."""
    hides = [shapely.Polygon(mark.points) for mark in marks if isinstance(mark, Mask)]
    return shapely.union_all(hides or [shapely.Polygon(chain(marks[0]))]).buffer(0)


def middle_line(guide: PlacedElement) -> shapely.LineString:
    half, turn = guide.numbers["long"] / 2, guide.angles["turn"]
    return shapely.LineString([polar(guide.at, side * half, turn) for side in (-1, 1)])


def test_every_jaw_is_attached_to_its_link(standing: tuple[Standing, ...]) -> None:
    jaws = [(one, body) for one in standing for kind, body in one.solids if kind == "contact"]
    assert jaws
    assert [one.name for one, body in jaws if one.links.intersection(body).length < ATTACHED] == []


def test_sliders_stay_in_their_guides(standing: tuple[Standing, ...]) -> None:
    guides = [(one, guide) for one in standing for guide in one.guides]
    assert guides
    assert [
        one.name
        for one, guide in guides
        for share in SHARES
        if one.links.distance(guide.interpolate(share, normalized=True)) > TOUCHES
    ] == []


def test_no_body_goes_through_another(standing: tuple[Standing, ...]) -> None:
    assert [
        f"{one.name}: {first[0]}, {second[0]}"
        for one in standing
        for first, second in combinations(one.solids, 2)
        if not first[1].intersection(second[1]).buffer(-TOUCHES).is_empty
    ] == []
