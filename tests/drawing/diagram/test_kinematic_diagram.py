"""Kinematic diagrams of issued variants: right in place, legible, and in one's language."""

import math
import xml.etree.ElementTree as ET
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from io import BytesIO
from itertools import combinations

import numpy as np
import pytest
import shapely
from ezdxf import recover

from gripcourse.course.diagram_words import VOCABULARY
from gripcourse.course.model import Course
from gripcourse.drawing.diagram.kinematic_diagram import KinematicDiagram, kinematic_diagram
from gripcourse.drawing.diagram.layout import HIGHEST, SYMBOLS, WIDEST, DiagramLayout, lay_out
from gripcourse.drawing.diagram.letters import Written, covered_lengths, strokes_of
from gripcourse.drawing.diagram.marks import Fill, Point, RingMark, chain
from gripcourse.solver.motion import coordinates, drive_at
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate, to_si
from gripcourse.text.words import LANGUAGES, Texts
from support.issued_table import issued_table

LANGUAGE = "ru"
OTHERS = ("en", "uk")  # by turns, a scheme in one of them
NEAR = 1e-6  # mm of paper
OFF_ITS_LINE = 0.2  # mm of paper: chords of a circle have their mean not quite in its middle
SEEN_UNDER_A_LETTER = 0.1  # mm of line that touches a symbol
HOSTILE = '<b>&"_"<i>'


@dataclass(frozen=True, slots=True)
class Drawn:
    """A variant's plan and given values, and its diagram in Russian."""

    name: str
    plan: Plan
    given: Mapping[str, float]
    layout: DiagramLayout


DiagramIn = Callable[[Drawn, str], tuple[DiagramLayout, KinematicDiagram]]


@pytest.fixture(scope="module")
def drawn(course: Course) -> tuple[Drawn, ...]:
    """Of each scheme the first and the last variant of the course's table."""
    by_scheme = defaultdict(list)
    for variant in issued_table(course):
        by_scheme[variant.scheme].append(variant)
    found = []
    for variant in (one for own in by_scheme.values() for one in own[:: max(len(own) - 1, 1)]):
        plan = make_plan(course, variant.scheme, variant.options)
        layout = lay_out(plan, variant.given, LANGUAGE)
        assert layout is not None, f"{variant.scheme} {variant.id} has no diagram"
        found.append(Drawn(f"{variant.scheme} {variant.id}", plan, variant.given, layout))
    return tuple(found)


@pytest.fixture(scope="module")
def diagram_in() -> Iterator[DiagramIn]:
    """Draw the diagram of a variant in a language, once; with the layout that it is drawn from."""
    layouts: list[DiagramLayout] = []

    def kept(
        plan: Plan, values: Mapping[str, float], language: str, widest: float
    ) -> DiagramLayout | None:
        layout = lay_out(plan, values, language, widest)
        layouts.extend([] if layout is None else [layout])
        return layout

    made: dict[tuple[str, str], tuple[DiagramLayout, KinematicDiagram]] = {}

    def draw(one: Drawn, language: str) -> tuple[DiagramLayout, KinematicDiagram]:
        if (one.name, language) not in made:
            diagram = kinematic_diagram(one.plan, one.given, language)
            assert diagram is not None
            made[one.name, language] = layouts[-1], diagram
        return made[one.name, language]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("gripcourse.drawing.diagram.kinematic_diagram.lay_out", kept)
        yield draw


@pytest.fixture(scope="module")
def one_of_each(drawn: tuple[Drawn, ...]) -> tuple[Drawn, ...]:
    """The first variant of each scheme."""
    return tuple({one.plan.scheme.id: one for one in reversed(drawn)}.values())


def joints(plan: Plan, kinds: set[str]) -> set[str]:
    """Return the joints of the kinematics that elements of these kinds stand at."""
    diagram, motion = plan.scheme.diagram, plan.scheme.kinematics
    if diagram is None or motion is None:
        return set()
    return {
        element.points["at"][0]
        for element in diagram.elements
        if element.kind in kinds and element.is_drawn(plan.options) and element.mirror != "only"
    } & motion.points.keys()


def expected_places(one: Drawn, name: str) -> Iterator[Point]:
    """Yield where a joint is on the sheet, by the solver: at both ends of the range."""
    motion, diagram = one.plan.scheme.kinematics, one.plan.scheme.diagram
    assert motion is not None
    assert diagram is not None
    values = evaluate(one.plan, to_si(one.plan, one.given)).values
    for position in ("at_min", "at_max"):
        where = coordinates(motion, values, drive_at(motion, values, position))
        along, across = (float(where[one_]) * 1000 * one.layout.scale
                         for one_ in motion.points[name])  # fmt: skip
        if diagram.axis == "y":
            along, across = across, along
        yield one.layout.origin[0] + along, one.layout.origin[1] + across


def is_near(point: Point, places: list[Point]) -> bool:
    return any(math.dist(point, place) < NEAR for place in places)


def test_every_scheme_has_a_diagram(course: Course, one_of_each: tuple[Drawn, ...]) -> None:
    assert {one.plan.scheme.id for one in one_of_each} == set(course.schemes)


def test_every_word_of_the_vocabulary_is_drawn_and_used(course: Course) -> None:
    assert set(SYMBOLS) == set(VOCABULARY)
    used = {
        element.kind
        for scheme in course.schemes.values()
        if scheme.diagram is not None
        for element in scheme.diagram.elements
    }
    assert used == set(VOCABULARY)


def test_joints_stand_where_the_solver_puts_them(drawn: tuple[Drawn, ...]) -> None:
    faults, tried = [], 0
    for one in drawn:
        rings = [mark.centre for mark in one.layout.marks if isinstance(mark, RingMark)]
        for name in joints(one.plan, {"pivot", "fixed_pivot", "roller"}):
            tried += 1
            faults += [f"{one.name} {name}" for place in expected_places(one, name)
                       if not is_near(place, rings)]  # fmt: skip
    assert tried > len(drawn)
    assert faults == []


def test_pins_in_slots_stand_where_the_solver_puts_them(drawn: tuple[Drawn, ...]) -> None:
    faults, tried = [], 0
    for one in drawn:
        middles = [
            tuple(np.mean(mark.points, axis=0)) for mark in one.layout.marks
            if isinstance(mark, Fill)
        ]  # fmt: skip
        for name in joints(one.plan, {"pin"}):
            tried += 1
            held = next(expected_places(one, name))
            if not is_near(held, middles):
                faults.append(f"{one.name} {name}")
    assert tried
    assert faults == []


def test_the_other_jaw_is_drawn_too(drawn: tuple[Drawn, ...]) -> None:
    for one in drawn:
        middle = one.layout.origin[1]
        rings = [mark.centre for mark in one.layout.marks if isinstance(mark, RingMark)]
        for name in joints(one.plan, {"fixed_pivot"}):
            x, y = next(expected_places(one, name))
            assert is_near((x, 2 * middle - y), rings), one.name


def test_every_symbol_is_one_of_the_declarations(
    one_of_each: tuple[Drawn, ...], diagram_in: DiagramIn
) -> None:
    """Every scheme in Russian, and in one of the other languages."""
    for number, one in enumerate(one_of_each):
        for language in (LANGUAGE, OTHERS[number % 2]):
            layout = one.layout if language == LANGUAGE else diagram_in(one, language)[0]
            declared = {quantity.symbol.of(language) for quantity in one.plan.quantities.values()}
            written = {letter.symbol for letter in layout.written if letter.is_quantity}
            assert written
            assert written <= declared, f"{one.name} {language}: {written - declared}"


def test_a_gripper_with_jaws_shows_its_forces(one_of_each: tuple[Drawn, ...]) -> None:
    for one in one_of_each:
        written = {letter.symbol for letter in one.layout.written}
        effort = {"drive_force", "drive_torque"} & one.plan.quantities.keys()
        if one.plan.scheme.kinematics is not None:
            assert one.plan.quantities["grip_force"].symbol.of("ru") in written, one.name
            assert written & {one.plan.quantities[name].symbol.of("ru") for name in effort}


def test_a_grip_force_runs_through_the_middle_of_the_object(drawn: tuple[Drawn, ...]) -> None:
    faults = []
    for one in drawn:
        written = {letter.symbol: letter for letter in one.layout.written}
        if one.plan.scheme.kinematics is None:
            continue
        force = written[one.plan.quantities["grip_force"].symbol.of(LANGUAGE)]
        rim = written[one.plan.quantities["diameter_min"].symbol.of(LANGUAGE)].names[0]
        middle = np.mean(rim[:-1], axis=0)
        arrows = [pair for pair in force.names if pair != force.leader]
        assert arrows, one.name
        faults += [one.name for tail, tip in arrows if away(middle, tail, tip) > OFF_ITS_LINE]
    assert faults == []


def away(point: np.ndarray, start: Point, end: Point) -> float:
    """Return how far a point is from the straight line through two others."""
    (x, y), (u, v) = np.subtract(end, start), np.subtract(point, start)
    return float(abs(x * v - y * u) / math.hypot(x, y))


def test_a_leader_leans(drawn: tuple[Drawn, ...]) -> None:
    faults = []
    for one in drawn:
        for letter in one.layout.written:
            if letter.leader and not letter.has_arrow:
                (x, y), (u, v) = letter.leader
                if min(abs(u - x), abs(v - y)) < 0.1 * math.dist((x, y), (u, v)):
                    faults.append(f"{one.name}: {letter.symbol}")
    assert faults == []


def test_no_symbol_covers_another(drawn: tuple[Drawn, ...]) -> None:
    faults = [
        f"{one.name}: {first.symbol} and {second.symbol}"
        for one in drawn
        for first, second in combinations(one.layout.written, 2)
        if first.box.overlaps(second.box)
    ]
    assert faults == []


def test_no_symbol_covers_a_line(drawn: tuple[Drawn, ...]) -> None:
    faults = []
    for one in drawn:
        rows = np.array([box_row(letter) for letter in one.layout.written])
        covered = covered_lengths(rows, strokes_of(one.layout.marks))
        faults += [
            f"{one.name}: {letter.symbol}"
            for letter, length in zip(one.layout.written, covered, strict=True)
            if length > SEEN_UNDER_A_LETTER
        ]
    assert faults == []


def test_a_symbol_is_nearest_to_what_it_names(drawn: tuple[Drawn, ...]) -> None:
    faults = []
    for one in drawn:
        things = [joined(letter) for letter in one.layout.written]
        for letter, own in zip(one.layout.written, things, strict=True):
            box = shapely.box(*box_row(letter))
            others = [thing for thing in things if thing is not own]
            if box.distance(own) >= min(map(box.distance, others)):
                faults.append(f"{one.name}: {letter.symbol}")
    assert faults == []


def box_row(letter: Written) -> tuple[float, float, float, float]:
    box = letter.box
    return box.left, box.bottom, box.right, box.top


def joined(letter: Written) -> shapely.Geometry:
    """Return what a letter names, its leader included."""
    return shapely.union_all(
        [shapely.LineString(one) if len(one) > 1 else shapely.Point(one) for one in letter.names]
    )


def test_everything_lies_on_the_sheet(drawn: tuple[Drawn, ...]) -> None:
    for one in drawn:
        assert one.layout.width <= WIDEST, one.name
        assert one.layout.height <= HIGHEST, one.name
        corners = [point for mark in one.layout.marks for point in chain(mark)]
        corners += [(letter.box.left, letter.box.bottom) for letter in one.layout.written]
        corners += [(letter.box.right, letter.box.top) for letter in one.layout.written]
        assert all(0 <= x <= one.layout.width for x, _ in corners), one.name
        assert all(0 <= y <= one.layout.height for _, y in corners), one.name


def test_a_narrower_page_gets_a_smaller_diagram(one_of_each: tuple[Drawn, ...]) -> None:
    for one in one_of_each[::2]:
        smaller = lay_out(one.plan, one.given, "ru", 112.0)
        assert smaller is not None
        assert smaller.width <= 112.0, one.name
        assert smaller.scale <= one.layout.scale


def test_files_are_sound_and_the_same_each_time(
    one_of_each: tuple[Drawn, ...], diagram_in: DiagramIn
) -> None:
    for number, one in enumerate(one_of_each):
        language = OTHERS[number % 2]
        _, first = diagram_in(one, language)
        picture = ET.fromstring(first.svg())  # noqa: S314 - our own drawing
        assert picture.attrib["width"] == f"{round(first.width, 2):g}mm"
        document, audit = recover.read(BytesIO(first.dxf()))
        assert not audit.errors, one.name
        assert not audit.fixes, one.name
        assert len(document.modelspace()) > len(one.layout.written)
        if number % 4 == 0:
            again = kinematic_diagram(one.plan, one.given, language)
            assert again is not None
            assert (first.svg(), first.dxf()) == (again.svg(), again.dxf())


def test_the_title_says_what_the_symbols_stand_for(
    one_of_each: tuple[Drawn, ...], diagram_in: DiagramIn
) -> None:
    for number, one in enumerate(one_of_each):
        language = OTHERS[number % 2]
        _, diagram = diagram_in(one, language)
        assert one.plan.scheme.title.of(language) in diagram.title
        named = [
            quantity
            for quantity in one.plan.quantities.values()
            if f"{quantity.symbol.of(language)} — {quantity.title.of(language)}" in diagram.title
        ]
        assert len(named) == len(
            {letter.symbol for letter in one.layout.written if letter.is_quantity}
        )


def test_a_symbol_is_text_and_never_markup(plan: Plan, drawn: tuple[Drawn, ...]) -> None:
    one = next(one for one in drawn if one.plan.scheme.id == plan.scheme.id)
    force = replace(
        one.plan.quantities["grip_force"], symbol=Texts(dict.fromkeys(LANGUAGES, HOSTILE))
    )
    hostile = replace(one.plan, quantities={**one.plan.quantities, "grip_force": force})
    diagram = kinematic_diagram(hostile, one.given, "ru")
    assert diagram is not None
    picture = ET.fromstring(diagram.svg())  # noqa: S314 - our own drawing
    base, _, below = HOSTILE.partition("_")
    texts = {text.strip() for text in picture.itertext()}
    assert {base, below} <= texts
    assert not [tag for tag in picture.iter() if tag.tag.endswith(("}b", "}i"))]


def test_a_scheme_without_a_diagram_has_none(plan: Plan, drawn: tuple[Drawn, ...]) -> None:
    one = next(one for one in drawn if one.plan.scheme.id == plan.scheme.id)
    bare = replace(one.plan, scheme=replace(one.plan.scheme, diagram=None))
    assert kinematic_diagram(bare, one.given, "ru") is None


def test_joints_that_have_no_place_are_not_drawn(drawn: tuple[Drawn, ...]) -> None:
    one = next(one for one in drawn if one.plan.scheme.id == "rack_parallelogram")
    impossible = {**one.given, "arm_length": 1.0}  # shorter than the jaws must travel
    assert kinematic_diagram(one.plan, impossible, "ru") is None


def test_a_diagram_fills_its_place(drawn: tuple[Drawn, ...]) -> None:
    for one in drawn:
        share = max(one.layout.width / WIDEST, one.layout.height / HIGHEST)
        assert share > 0.8, one.name
