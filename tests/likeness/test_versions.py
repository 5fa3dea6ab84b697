"""Whoever was issued to twice has two sheets: both may be copied, and both are his own."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import pytest
from numpy.typing import NDArray

from gripcourse.course.model import Course
from gripcourse.likeness.cells import SparseTable
from gripcourse.likeness.evidence import find_evidence
from gripcourse.likeness.issued import IssuedValues, issued_values
from gripcourse.likeness.matches import SoughtNumbers, met
from gripcourse.likeness.model import ComparedWork, Evidence, NumberKind
from gripcourse.likeness.persons import RepeatedValues, persons_of
from gripcourse.likeness.typed_numbers import Typed, TypedNumbers
from gripcourse.policy.model import LikenessRule
from gripcourse.variants.model import Variant

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from .conftest import Room, School

Floats = NDArray[np.float64]

RULE = LikenessRule(1e3, 3, 3)
ANY = LikenessRule(1e-12, 1, 0)
TABLE = np.random.default_rng(3).lognormal([7, 4, 2, 3, 1, 5], 0.6, (40, 6))
CORRECTED = np.where(np.arange(6) < 3, TABLE[1], TABLE[1] * [1, 1, 1, 1.3, 0.7, 1.2])
REPLACED = 1  # which of the owner's rows
STUDENTS = tuple(f"s{number:02d}" for number in range(len(TABLE)))


def issued_of(table: Floats, owners: Sequence[str]) -> IssuedValues:
    columns = table.shape[1]
    return IssuedValues(
        owners=tuple(owners),
        quantities=tuple(f"q{column}" for column in range(columns)),
        values=[SparseTable.of_table(part) for part in (table[:25], table[25:])],
        kind=np.zeros(len(table), np.intp),
        families=np.arange(columns)[None, :],
        discrete=np.zeros(columns, bool),
    )


ONCE = issued_of(TABLE, STUDENTS)
# Student s01 has the second row of the table now, and had other numbers in three places before.
TWICE = issued_of(np.vstack((TABLE, CORRECTED)), (*STUDENTS, "s01"))


def work(student: str, values: Floats, own: Floats, version: int = 0) -> ComparedWork:
    """What somebody typed with four figures: his own numbers explain some of it."""
    typed = [float(f"{one:.3e}") for one in values]
    half = [10.0 ** (np.floor(np.log10(one)) - 3) / 2 for one in typed]
    explained = np.isclose(values, own, rtol=1e-3)
    numbers = (
        Typed(f"q{column}", *one, None)
        for column, one in enumerate(zip(typed, half, explained.tolist(), strict=True))
    )
    return ComparedWork(student, TypedNumbers.of(numbers), "", version)


@pytest.mark.parametrize("sheet", [TABLE[1], CORRECTED], ids=["new", "replaced"])
@pytest.mark.parametrize("handed_in", [None, 0, REPLACED])
def test_whoever_copies_any_version_is_told_with_its_owner(
    sheet: Floats, handed_in: int | None
) -> None:
    own = (TABLE[1], CORRECTED)
    works = [work("s07", sheet, TABLE[7])]
    if handed_in is not None:
        works.append(work("s01", own[handed_in], own[handed_in], handed_in))
    taken = [
        one for one in find_evidence(works, TWICE, RULE) if one.kind is NumberKind.OTHER_VARIANT
    ]
    assert [one.students for one in taken] == [("s07", "s01")]


@pytest.mark.parametrize("version", [0, REPLACED])
@pytest.mark.parametrize("mixed", [(), (3,), (4, 5), (3, 4, 5)])
def test_nobody_is_told_for_numbers_of_his_own_other_version(
    version: int, mixed: tuple[int, ...]
) -> None:
    own, other = ((TABLE[1], CORRECTED), (CORRECTED, TABLE[1]))[version]
    typed = np.where(np.isin(np.arange(6), mixed), other, own)
    neighbour = np.vstack((TABLE, CORRECTED))
    neighbour[2] = np.where(np.arange(6) < 5, other, 1.4 * other)  # one number apart from it
    near = issued_of(neighbour, TWICE.owners)
    for issued in (TWICE, near):
        assert find_evidence([work("s01", typed, own, version)], issued, ANY) == ()


def test_two_works_of_one_student_on_two_versions_are_not_compared() -> None:
    wrong = np.array([777.0, 33.3, 5.55, 9.99, 44.4, 123.0])
    works = [work("s01", wrong, TABLE[1]), work("s01", wrong, CORRECTED, REPLACED)]
    assert find_evidence(works, TWICE, RULE) == ()


def test_two_works_of_one_student_make_a_mistake_no_commoner() -> None:
    wrong = np.array([777.0, 33.3, 5.55, 9.99, 44.4, 123.0])
    copy, first = work("s07", wrong, TABLE[7]), work("s01", wrong, CORRECTED, REPLACED)
    for others in ([first], [first, work("s01", wrong, TABLE[1])]):
        found = find_evidence([copy, *others], TWICE, RULE)
        assert ("s07", "s01") in {one.students for one in found}


def test_a_mistake_is_measured_by_the_version_that_the_work_was_made_for() -> None:
    """Two who err by the same factor where they have the same right numbers prove little."""
    wrong = CORRECTED * [2.0, 3.0, 0.5, 1.7, 4.0, 0.3]
    twin = issued_of(np.vstack((TABLE[:7], CORRECTED[None], TABLE[8:], CORRECTED)), TWICE.owners)

    def odds(version: int) -> float:
        works = [work("s01", wrong, CORRECTED, version), work("s07", wrong, CORRECTED)]
        found = find_evidence(works, twin, ANY)
        return max(one.odds for one in found if one.kind is NumberKind.SAME_ANSWERS)

    assert odds(REPLACED) < 1e-3 * odds(0)


def test_what_both_versions_have_is_had_by_one_person() -> None:
    """The three numbers that stayed say as much as if there had been one version."""
    copied = np.where(np.arange(6) < 3, TABLE[1], TABLE[7])

    def odds(issued: IssuedValues) -> float:
        [found] = find_evidence([work("s07", copied, TABLE[7])], issued, ANY)
        assert found.students == ("s07", "s01")
        return found.odds

    # One row more was compared with, and the numbers spread a little otherwise.
    assert odds(TWICE) == pytest.approx(odds(ONCE) * 39 / 40, rel=0.1)
    strangers = issued_of(np.vstack((TABLE, CORRECTED)), (*STUDENTS, "s40"))
    assert odds_of_any(copied, strangers) < 0.1 * odds(TWICE)


def odds_of_any(copied: Floats, issued: IssuedValues) -> float:
    found = find_evidence([work("s07", copied, TABLE[7])], issued, ANY)
    return max(one.odds for one in found)


def test_persons_with_the_same_number_are_counted_and_not_their_rows() -> None:
    rng = np.random.default_rng(11)
    owners = [f"s{number}" for number in rng.integers(30, size=90)]
    table = np.round(rng.lognormal(2, 0.4, (90, 4)), 1)
    table[rng.random(table.shape) < 0.3] = np.nan
    column, value = rng.integers(4, size=200), np.round(rng.lognormal(2, 0.4, 200), 1)
    sought = SoughtNumbers(column, value, rng.choice([0.05, 0.15, 0.4], 200))
    tables = [SparseTable.of_table(part) for part in (table[:40], table[40:])]

    def portions() -> "Iterator[SoughtNumbers]":
        return iter((sought.some(np.arange(200) < 70), sought.some(np.arange(200) >= 70)))

    counted = met(portions, tables, RepeatedValues.of(tables, persons_of(owners)))
    persons = [
        {
            owner
            for owner, row in zip(owners, table, strict=True)
            if low <= row[place] <= high  # never of a number that is not there
        }
        for place, low, high in zip(column, value - sought.reach, value + sought.reach, strict=True)
    ]
    assert np.concatenate(counted.same).tolist() == [len(one) for one in persons]
    assert counted.all.tolist() == [
        len({owner for owner, one in zip(owners, numbers, strict=True) if np.isfinite(one)})
        for numbers in table.T
    ]


def test_where_everybody_has_one_version_there_is_nothing_to_count_once() -> None:
    assert RepeatedValues.of(ONCE.values, persons_of(STUDENTS)) is None


@dataclass(frozen=True, slots=True)
class Reissued:
    """Two hundred students, of whom every third was issued to twice.

    Attributes:
        issued: of all versions.
        first, last: the same students, as they would hand in their first or last version.
        twice: those who have two; half of them a corrected one, half another variant.
    """

    issued: IssuedValues
    first: "School"
    last: "School"
    twice: frozenset[str]

    @classmethod
    def of(
        cls,
        course: Course,
        variants: Sequence[Variant],
        school_of: "Callable[[Sequence[tuple[str, Variant]]], School]",
    ) -> "Reissued":
        last = {f"s{number:03d}": one for number, one in enumerate(variants[:200])}
        before = {
            student: corrected(one) if number % 2 else variants[200 + number // 2]
            for number, (student, one) in enumerate(list(last.items())[::3])
        }
        issued = issued_values(course, [*last.items(), *before.items()])
        first, now = (school_of(list(owned.items())) for owned in ({**last, **before}, last))
        return cls(issued, first, now, frozenset(before))

    def works(self, seed: int) -> list[ComparedWork]:
        """What honest ones hand in: who was issued to twice, one version, the other, or both."""
        rng = np.random.default_rng(seed)
        old, new = (
            {
                student: (room, row)
                for room in school.rooms
                for student, row in zip(room.students, room.honest(rng), strict=True)
            }
            for school in (self.first, self.last)
        )
        works = list[ComparedWork]()
        for student in sorted(new):
            (room, typed), (before, typed_before) = new[student], old[student]
            does = rng.integers(3) if student in self.twice else 1
            if does == 0:
                works.append(handed_in(before, student, typed_before, REPLACED))
                continue
            both = does == 2 and before.answered == room.answered
            some = rng.random(len(typed)) < 0.5
            mixed = np.where(some, typed_before, typed) if both else typed
            works.append(handed_in(room, student, mixed, 0))
        return works


def handed_in(room: "Room", student: str, typed: Floats, version: int) -> ComparedWork:
    """The work of one student of a room."""
    place = room.students.index(student)
    given = {name: one[[place]] for name, one in room.given.items()}
    alone = replace(room, students=(student,), given=given)
    [one] = alone.works(typed[None])
    return replace(one, version=version)


def corrected(variant: Variant) -> Variant:
    """The same variant with another mass or load: what was printed first was wrong."""
    name = "mass" if "mass" in variant.given else next(iter(variant.given))
    return replace(variant, given={**variant.given, name: round(1.37 * variant.given[name], 2)})


@pytest.fixture(scope="module")
def reissued(
    course: Course,
    variants: tuple[Variant, ...],
    school_of_all: "Callable[[Sequence[tuple[str, Variant]]], School]",
) -> Reissued:
    return Reissued.of(course, variants, school_of_all)


@pytest.mark.parametrize("seed", [1])
def test_of_honest_students_a_third_of_whom_have_two_versions_nobody_is_told(
    reissued: Reissued, seed: int
) -> None:
    works = reissued.works(seed)
    assert (len(works), len(reissued.twice)) == (200, 67)
    assert {one.version for one in works} == {0, REPLACED}
    assert sum(not one.explained for work in works for one in work.numbers) > 700
    assert find_evidence(works, reissued.issued, LikenessRule(1.0, 3, 3)) == ()


def test_copies_of_replaced_sheets_are_told_in_a_cohort(reissued: Reissued) -> None:
    """Every twentieth copies the right numbers of a sheet whose owner handed in the new one."""
    works = {one.student: one for one in reissued.works(2)}
    once = [student for student in works if student not in reissued.twice][::13]
    rooms = {student: room for room in reissued.first.rooms for student in room.students}
    sources: dict[str, str] = {}
    for student in once:
        room = rooms[student]
        near = (one for one in room.students if one in reissued.twice)
        source = next(
            (one for one in near if works[one].version == 0 and one not in sources.values()), None
        )
        if source is not None:
            right, _ = room.values(room.given)
            sources[student] = source
            works[student] = handed_in(room, student, right[room.students.index(source)], 0)
    found = find_evidence(list(works.values()), reissued.issued, RULE)
    assert len(sources) >= 5
    assert {one.students[:2] for one in found if taken(one)} == set(sources.items())


def taken(one: Evidence) -> bool:
    return one.kind is NumberKind.OTHER_VARIANT
