"""Spaces are read into lists of tidy values, and every mistake in them is told."""

import json
import tomllib
from collections.abc import Callable
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.errors import CourseError
from gripcourse.variants.cases import SpaceCase
from gripcourse.variants.ranges import Follower
from gripcourse.variants.space import Space, load_spaces

Change = Callable[[str, str], Course]


def case_of(space: Space, fluid: str) -> SpaceCase:
    return next(case for case in space.cases if case.options["fluid"] == fluid)


def problems_of(course: Course) -> dict[str, str]:
    with pytest.raises(CourseError) as caught:
        load_spaces(course)
    return {problem.key: f"{problem.what} {problem.remedy}" for problem in caught.value.problems}


def test_a_step_gives_decimals_that_a_person_would_write(small_course: Course) -> None:
    (space,) = load_spaces(small_course)
    assert case_of(space, "oil").given["friction"] == (0.1, 0.15, 0.2, 0.25, 0.3)


def test_every_combination_of_options_is_a_case_with_its_own_givens(small_course: Course) -> None:
    (space,) = load_spaces(small_course)
    assert [case.options for case in space.cases] == [{"fluid": "oil"}, {"fluid": "air"}]
    assert "noise" in case_of(space, "air").given
    assert "noise" not in case_of(space, "oil").given


def test_a_range_can_depend_on_an_option(small_course: Course) -> None:
    (space,) = load_spaces(small_course)
    assert case_of(space, "oil").given["pressure"] == (6.3, 10.0, 16.0)
    assert case_of(space, "air").given["pressure"] == (0.4, 0.5)


def test_a_column_of_a_catalogue_is_read_in_the_declared_unit(small_course: Course) -> None:
    (space,) = load_spaces(small_course)
    assert case_of(space, "oil").given["arm"] == (40.0, 63.0, 100.0)


def test_a_quantity_can_follow_another(small_course: Course) -> None:
    (space,) = load_spaces(small_course)
    follower = case_of(space, "oil").followers["form_factor"]
    assert follower == Follower("teeth", {17.0: 4.26, 20.0: 4.08, 25.0: 3.9})


def test_a_course_without_spaces_has_none(small_course: Course, small_with: Change) -> None:
    course = small_with("", "")
    (course.root / "variants" / "spaces" / "press.toml").unlink()
    assert load_spaces(course) == ()
    assert len(load_spaces(small_course)) == 1


def ranges_beside_givens(course: Course) -> None:
    """Move every range of the scheme's file to the givens; the file is no more."""
    space = course.root / "variants" / "spaces" / "press.toml"
    given = tomllib.loads(space.read_text(encoding="utf-8"))["given"]
    space.unlink()
    for path in (course.root / "variants").rglob("*.toml"):
        text = path.read_text(encoding="utf-8")
        for name, table in given.items():
            heading = f"[quantity.{name}]\n"
            text = text.replace(heading, f"{heading}range = {inline(table)}\n")
        path.write_text(text, encoding="utf-8")


def inline(value: object) -> str:
    """Write a value as TOML on one line."""
    match value:
        case dict():
            return "{ " + ", ".join(f"{key} = {inline(one)}" for key, one in value.items()) + " }"
        case list():
            return "[" + ", ".join(inline(one) for one in value) + "]"
        case _:
            return json.dumps(value)


def test_a_range_beside_its_given_needs_no_space(small_course: Course, small_with: Change) -> None:
    course = small_with("", "")
    ranges_beside_givens(course)
    (space,), (usual,) = load_spaces(load_course(course.root)), load_spaces(small_course)
    assert [case.given for case in space.cases] == [case.given for case in usual.cases]
    assert [case.followers for case in space.cases] == [case.followers for case in usual.cases]


def test_a_space_replaces_a_range_beside_its_given(small_with: Change) -> None:
    course = small_with("", "")
    ranges_beside_givens(course)
    own = 'scheme = "press"\n[given.friction]\nvalues = [0.2]\n'
    (course.root / "variants" / "spaces" / "press.toml").write_text(own, encoding="utf-8")
    (space,) = load_spaces(load_course(course.root))
    assert case_of(space, "oil").given["friction"] == (0.2,)


def test_a_second_file_for_a_scheme_is_refused(small_with: Change) -> None:
    course = small_with("", "")
    folder = course.root / "variants" / "spaces"
    (folder / "second.toml").write_bytes((folder / "press.toml").read_bytes())
    assert "already has variants/spaces/press.toml" in problems_of(course)["scheme"]


@pytest.mark.parametrize(
    ("old", "new", "key", "said"),
    [
        ('scheme = "press"', 'scheme = "pres"', "scheme", "no scheme 'pres'. Did you mean 'press'"),
        ("low = 10\n", "low = 90\n", "given.mass", "upside down"),
        ("step = 2.5", "step = 3", "given.mass.step", "Write high = 79"),
        ("step = 2.5", "step = 0.0001", "given.mass.step", "coarser"),
        ("step = 2.5", "", "given.mass", "four ways"),
        ("step = 2.5", 'step = "2"', "given.mass.step", "number"),
        ("low = 10\n", "low = -10\n", "given.mass", "outside the bounds"),
        ("[given.mass]", "[given.mas]", "given.mas", "Did you mean 'mass'"),
        ("[given.mass]", "[given.mas]", "given.mass", "no range"),
        ("[17, 20, 25]", "[]", "given.teeth.values", "list of numbers"),
        ("[17, 20, 25]", "[17, 20.5, 25]", "given.teeth", "whole numbers only"),
        ("[17, 20, 25]", "[17, 20, 25, 30]", "given.form_factor.pairs", "teeth = 30"),
        ("[17, 4.26], ", "[17], ", "given.form_factor.pairs", "pairs of numbers"),
        ('follows = "teeth"', 'follows = "tooth"', "given.form_factor.follows", "'teeth'"),
        ("bore.bore", "bore.size", "given.arm.catalogue", "Did you mean 'bore.bore'"),
        ("low = 40\n", "low = 400\n", "given.arm", "nothing between"),
        ('choice = "air"', 'choice = "water"', "given.pressure.when[1].choice", "no 'water'"),
        ("angle <= 60", "angel <= 60", "constraint[1].formula", "Did you mean 'angle'"),
        ("angle <= 60", "angle", "constraint[1].formula", "not a condition"),
        ("angle <= 60", "angle <= (60", "constraint[1].formula", "bracket"),
        ("angle <= 60", "force <= mass", "constraint[1].formula", "like with like"),
        ('{ angle = "deg" }', '{ angle = "dge" }', "constraint[1].evaluated_in.angle", "'dge'"),
        ('evaluated_in = { angle = "deg" }', "", "constraint[1].formula", "or in SI"),
        ("angle <= 60", "angle >= 100", "constraint[1].formula", "angle 0 … 90 deg"),
        ("angle <= 60", "angle + angle < 0", "constraint[1].formula", "or loosen"),
        ("[[constraint]]", "[[constraints]]", "constraints", "Did you mean 'constraint'"),
    ],
)
def test_a_mistake_is_told_with_its_place_and_its_remedy(
    small_with: Change, old: str, new: str, key: str, said: str
) -> None:
    found = problems_of(small_with(old, new))
    assert said in found.get(key, ""), found


def test_all_mistakes_are_told_at_once(small_with: Change, tmp_path: Path) -> None:
    course = small_with("low = 10\n", "low = 90\n")
    space = tmp_path / "course" / "variants" / "spaces" / "press.toml"
    space.write_text(
        space.read_text(encoding="utf-8").replace("angle <= 60", "angle"), encoding="utf-8"
    )
    assert set(problems_of(course)) == {"given.mass", "constraint[1].formula"}


def test_the_spaces_of_the_reference_course_are_sound(reference_course: Course) -> None:
    spaces = load_spaces(reference_course)
    assert {space.scheme for space in spaces} == set(reference_course.schemes)


def test_givens_that_a_rule_makes_one_number_are_drawn_alike(reference_course: Course) -> None:
    ruled = {
        scheme.id: rule
        for scheme in reference_course.schemes.values()
        for rule in scheme.rules
        if rule.same
    }
    assert ruled
    for space in load_spaces(reference_course):
        if space.scheme not in ruled:
            continue
        rule = ruled[space.scheme]
        options = next(one for one in space.cases.combinations if rule.counts(one))
        case = space.cases.with_options(options)
        assert case is not None
        led = [case.followers[one] for one in rule.same if one in case.followers]
        (leader,) = {one.leader for one in led}
        assert len(led) == len(rule.same) - 1
        assert leader in rule.same
        assert all(one == number for follower in led for number, one in follower.values.items())


def test_spaces_are_read_anew_only_where_their_files_changed(
    small_with: Callable[[str, str], Course],
) -> None:
    course = small_with("scheme", "scheme")
    found = load_spaces(course)
    assert load_spaces(course) is found
    file = course.root / "variants" / "spaces" / "press.toml"
    file.write_text(f"weight = 3\n{file.read_text(encoding='utf-8')}", encoding="utf-8")
    assert [one.weight for one in load_spaces(course)] == [3.0]
