"""Where the declarations of a scheme come from, and when a variant has them."""

from gripcourse.course.compose import direct_inputs
from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention
from gripcourse.documents.reference.occurrence import conditions_of, content_of

SCHEME = "rack_parallelogram"


def test_a_part_that_every_choice_brings_is_always_there(course: Course) -> None:
    assert conditions_of(course.schemes[SCHEME], "cylinder") == ()
    assert conditions_of(course.schemes[SCHEME], "pin") == ()


def test_a_part_of_one_choice_says_which(course: Course) -> None:
    [condition] = conditions_of(course.schemes[SCHEME], "hydraulic_series")
    assert condition.option.id == "drive"
    assert [choice.id for choice in condition.choices] == ["hydraulic"]


def test_declarations_that_exclude_each_other_have_places_of_their_own(course: Course) -> None:
    bores = content_of(course, course.schemes[SCHEME]).by_id["bore"]
    assert [one.anchor for one in bores][:2] == ["bore", "bore.pneumatic_series"]
    assert len({one.part for one in bores}) == len(bores)


def test_a_formula_means_the_declarations_of_its_own_part(course: Course) -> None:
    content = content_of(course, course.schemes[SCHEME])
    rods = content.by_id["rod"]
    assert [content.meant("bore", rod) for rod in rods] == [
        (bore,) for bore in content.by_id["bore"]
    ]


def test_a_formula_of_another_part_means_all_that_may_stand_beside_it(course: Course) -> None:
    content = content_of(course, course.schemes[SCHEME])
    [actual] = content.by_id["drive_force_actual"]
    assert content.meant("bore", actual) == content.by_id["bore"]
    between = next(one for one in content.by_id["pair_force_near"] if "between" in one.part)
    # A wide pair excludes that the centre of gravity lies between two pairs.
    assert {one.part for one in content.by_id["pair_spacing"]} > {"object_pairs"}
    assert [one.part for one in content.meant("pair_spacing", between)] == ["object_pairs"]


def test_a_schemes_change_of_a_part_is_shown(course: Course) -> None:
    [changed] = content_of(course, course.schemes[SCHEME]).by_id["force_ratio"]
    assert changed.changed
    assert changed.part == "drive_force"
    assert changed.quantity.as_printed


def test_inputs_stand_before_what_needs_them(course: Course) -> None:
    """But for options that exclude each other, whose formulas may run in a circle together."""
    content = content_of(course, course.schemes["screw"])
    place = {one.quantity.id: number for number, one in enumerate(content.occurrences)}
    late = [
        (one.quantity.id, name)
        for one in content.occurrences
        for name in direct_inputs(one.quantity, Convention.CORRECTED)
        if len(content.by_id[name]) == 1 and place[name] > place[one.quantity.id]
    ]
    assert late == []
