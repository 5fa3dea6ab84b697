"""Cohorts made with numpy: honest students with rounding, slips and errors, and some who copy.

No workbook is written: answers are arrays, and what explains them is found as the grader does, by
comparing with the reference and with each formula at the student's own numbers.
"""

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import pytest
from numpy.typing import NDArray

from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.likeness.issued import IssuedValues, issued_values
from gripcourse.likeness.model import ComparedWork
from gripcourse.likeness.typed_numbers import Typed, TypedNumbers
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import evaluate
from gripcourse.text.units import factor
from gripcourse.variants.cases import Cases
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Variant
from gripcourse.variants.space import load_spaces

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

TOLERANCE = 0.01
FIGURES = (3, 3, 4, 5)  # that students round to
SKILLS = (0.0, 0.02, 0.05, 0.15, 0.4)  # share of their answers that go wrong
FACTORS = (2, 0.5, 10, 0.1, 9.81, 1.5, 3.1416, 4, 0.25, 1000)  # of usual errors
COMMON_ERROR = 1.37  # a wrong method that a third of the cohort shares
USUAL = ("grip_force", "drive_force", "lifting_load", "bore_required")
MISREAD = 0.25  # share of the students who calculate with somebody else's mass, friction, …


@dataclass(frozen=True, slots=True, repr=False)
class Room:
    """Students with the same kind of variant: answers and what was issued, in declared units.

    Attributes:
        students: ids, one for each row.
        answered: ids, one for each column of `answers`.
        given: by id, one number for each student.
    """

    plan: Plan
    students: tuple[str, ...]
    answered: tuple[str, ...]
    given: Mapping[str, Floats]

    def values(self, known: Mapping[str, Floats]) -> tuple[Floats, Floats]:
        """Evaluate: what counts downstream, and what each formula gives."""
        units = {name: factor(self.plan.quantities[name].unit) for name in self.plan.quantities}
        done = evaluate(self.plan, {name: one * units[name] for name, one in known.items()})

        def stacked(values: Mapping[str, Floats]) -> Floats:
            rows = len(self.students)
            return np.stack(
                [np.broadcast_to(values[name] / units[name], rows) for name in self.answered], 1
            )

        return stacked(done.values), stacked(done.computed)

    def honest(self, rng: np.random.Generator) -> Floats:
        """What students type who make errors, but no use of each other."""
        rows = len(self.students)
        used = {name: one.copy() for name, one in self.given.items()}
        for row in np.flatnonzero(rng.random(rows) < MISREAD):
            name = rng.choice(list(used))
            used[name][row] = self.given[name][rng.integers(rows)]
        right, _ = self.values(used)
        computed = np.array([self.plan.quantities[q].kind is Kind.FORMULA for q in self.answered])
        wrong = rng.random(right.shape) < rng.choice(SKILLS, (rows, 1))
        error = np.where(
            rng.random(right.shape) < 0.5,
            rng.choice(FACTORS, right.shape),
            np.exp(rng.normal(0, 0.7, right.shape)),
        )
        error = np.where(wrong & computed, error, 1.0)
        shared = np.isin(self.answered, USUAL) & (rng.random((rows, 1)) < 1 / 3)
        error = np.where(shared, error * COMMON_ERROR, error)
        known = {
            name: np.where(error[:, column] != 1, right[:, column] * error[:, column], np.nan)
            for column, name in enumerate(self.answered)
        }
        found, _ = self.values(used | known)
        typed = np.where(computed, rounded(found, rng.choice(FIGURES, (rows, 1))), found)
        return np.where(rng.random(typed.shape) < 0.03, np.nan, typed)

    def works(self, typed: Floats) -> list[ComparedWork]:
        """Submissions with what explains each answer."""
        reference, _ = self.values(self.given)
        own = {name: typed[:, column] for column, name in enumerate(self.answered)}
        _, expected = self.values({**self.given, **own})
        explained = near(typed, reference) | near(typed, expected)
        half = half_unit(typed)
        kinds = [self.plan.quantities[name].kind for name in self.answered]
        return [
            ComparedWork(
                student,
                TypedNumbers.of(
                    Typed(name, typed[row, column], half[row, column], told, "")
                    for column, name in enumerate(self.answered)
                    if np.isfinite(typed[row, column]) and kinds[column] is not Kind.VERDICT
                    for told in (bool(explained[row, column]),)
                ),
                "",
            )
            for row, student in enumerate(self.students)
        ]


@dataclass(frozen=True, slots=True, repr=False)
class School:
    """A cohort that can be simulated again and again."""

    issued: IssuedValues
    rooms: tuple[Room, ...]

    def honest(self, seed: int) -> list[ComparedWork]:
        rng = np.random.default_rng(seed)
        return [work for room in self.rooms for work in room.works(room.honest(rng))]

    def copying(
        self, seed: int, share: float, of_them: float, moved: float = 0.0
    ) -> tuple[list[ComparedWork], dict[str, str]]:
        """Let some students replace a share of their answers by a neighbour's.

        Args:
            seed: of the cohort.
            share: of the answers that are copied.
            of_them: share of the students who copy.
            moved: relative; how far each copied number is moved at most.

        Returns:
            The submissions, and whom each copier copied from.
        """
        rng = np.random.default_rng(seed)
        works: list[ComparedWork] = []
        sources: dict[str, str] = {}
        for room in self.rooms:
            typed = room.honest(rng)
            copies = rng.random(len(typed)) < of_them
            honest = np.flatnonzero(~copies)
            for row in np.flatnonzero(copies) if honest.size else ():
                source = rng.choice(honest)
                taken = (rng.random(typed.shape[1]) < share) & np.isfinite(typed[source])
                theirs = typed[source]
                if moved:
                    away = theirs * (1 + rng.uniform(-moved, moved, theirs.shape))
                    exact = [room.plan.quantities[name].exact for name in room.answered]
                    theirs = np.where(exact, theirs, rounded(away, np.full(theirs.shape, 4)))
                typed[row] = np.where(taken, theirs, typed[row])
                sources[room.students[row]] = room.students[source]
            works += room.works(typed)
        return works, sources


def rounded(values: Floats, figures: NDArray[np.int64]) -> Floats:
    with np.errstate(divide="ignore", invalid="ignore"):
        places = 10.0 ** (figures - 1 - np.floor(np.log10(np.abs(values))))
        digits = np.round(values * places) / places
    return np.where(values == 0, 0.0, digits)


def half_unit(values: Floats) -> Floats:
    """Half a unit of the last digit of the shortest decimal number."""
    exponents = [len(f"{abs(one):.15g}".partition(".")[2]) for one in values.ravel()]
    return (0.5 * 10.0 ** -np.array(exponents, dtype=float)).reshape(values.shape)


def near(values: Floats, expected: Floats) -> Flags:
    return np.abs(values - expected) <= TOLERANCE * np.abs(expected)


@pytest.fixture(scope="session")
def variants(course: Course) -> tuple[Variant, ...]:
    """Three hundred variants, of every scheme with one choice of its options."""
    spaces = [replace(space, cases=Cases.of([space.cases[0]])) for space in load_spaces(course)]
    return tuple(draw(course, spaces, 300, 20261121).variants)


def school_of(course: Course, owned: Sequence[tuple[str, Variant]]) -> School:
    """Put students with the same kind of variant into one room."""
    kinds: dict[tuple[str, frozenset[tuple[str, str]]], list[tuple[str, Variant]]]
    kinds = defaultdict(list)
    for student, one in owned:
        kinds[one.scheme, frozenset(one.options.items())].append((student, one))
    rooms = []
    for members in kinds.values():
        plan = make_plan(course, members[0][1].scheme, members[0][1].options)
        given = {
            quantity.id: np.array([one.given[quantity.id] for _, one in members])
            for quantity in plan.givens
        }
        answered = tuple(one.id for one in plan.answered)
        rooms.append(Room(plan, tuple(student for student, _ in members), answered, given))
    return School(issued_values(course, owned), tuple(rooms))


@pytest.fixture(scope="session")
def school_of_all(course: Course) -> Callable[[Sequence[tuple[str, Variant]]], School]:
    """Make a school of students with their variants."""
    return partial(school_of, course)


@pytest.fixture(scope="session")
def school(course: Course, variants: Sequence[Variant]) -> School:
    return school_of(course, [(f"s{number:03d}", one) for number, one in enumerate(variants)])


@pytest.fixture(scope="session")
def near_school(course: Course) -> School:
    """Ninety students of one worked example, each with another mass and nothing else."""
    scheme = course.schemes["rack_parallelogram"]
    assert scheme.example is not None
    plan = make_plan(course, scheme.id, scheme.example.options)
    given = {one.id: float(scheme.example.given[one.id]) for one in plan.givens}
    spread = np.exp(np.random.default_rng(1).uniform(-0.35, 0.35, 90))
    masses = np.round(given["mass"] * spread, 2).tolist()
    issued = [
        Variant(f"{number}", scheme.id, dict(plan.options), {**given, "mass": one})
        for number, one in enumerate(masses)
    ]
    return school_of(course, [(f"s{one.id:0>3}", one) for one in issued])
