"""Drawing what students do."""

from collections import Counter
from dataclasses import replace

import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.simulation.behaviour import draw_behaviours, hand_of
from gripcourse.simulation.cohort import make_classroom
from gripcourse.simulation.model import Conduct, Mix
from gripcourse.simulation.student import Classroom


def test_the_same_seed_makes_the_same_cohort(course: Course, policy: Policy, mix: Mix) -> None:
    one = make_classroom(course, policy, mix, 8, 3)
    again = make_classroom(course, policy, mix, 8, 3)
    other = make_classroom(course, policy, mix, 8, 4)
    assert one.behaviours == again.behaviours
    assert one.context.register == again.context.register
    assert one.behaviours != other.behaviours


def test_all_schemes_and_languages_take_part(room: Classroom, course: Course, mix: Mix) -> None:
    entries = room.context.register.values()
    assert {one.variant.scheme for one in entries} == set(course.schemes)
    assert {one.student.language for one in entries} == set(mix.language)


def test_students_do_things_as_often_as_the_mix_says(room: Classroom, mix: Mix) -> None:
    entries = list(room.context.register.values()) * 10
    numbered = [
        replace(one, student=replace(one.student, id=f"s{number}"))
        for number, one in enumerate(entries)
    ]
    found = Counter(one.conduct for one in draw_behaviours(numbered, mix, 1).values())
    total = sum(mix.conduct.values())
    for conduct, weight in mix.conduct.items():
        assert found[conduct] / len(numbered) == pytest.approx(weight / total, abs=0.03)


def test_one_copies_from_a_neighbour_with_the_same_scheme(room: Classroom) -> None:
    register = room.context.register
    copiers = {name: one for name, one in room.behaviours.items() if one.conduct.copies}
    assert copiers
    for name, one in copiers.items():
        assert register[name].variant.scheme == register[one.neighbour].variant.scheme
        assert not room.behaviours[one.neighbour].conduct.copies


def test_who_finds_nobody_to_copy_from_works_honestly(
    course: Course, policy: Policy, mix: Mix
) -> None:
    copying = replace(mix, conduct={Conduct.COPIED_WORKBOOK: 1.0})
    room = make_classroom(course, policy, copying, 3, 1)
    assert {one.conduct for one in room.behaviours.values()} == {Conduct.HONEST}


def test_who_writes_all_that_the_calculator_shows_writes_ten_figures(room: Classroom) -> None:
    hands = [hand_of(one) for one in room.behaviours.values() if one.rounding == "full"]
    assert hands
    assert {int(hand.figures) for hand in hands} == {10}
