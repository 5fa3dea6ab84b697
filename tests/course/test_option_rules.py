"""Rules among options: which choices go together, and what is wrong with a rule."""

from collections.abc import Callable, Mapping
from dataclasses import replace

import pytest

from gripcourse.course.check_options import check_option_names, check_option_rules
from gripcourse.course.model import Course, Scheme
from gripcourse.course.option_rule import OptionRule
from gripcourse.course.option_sets import option_sets
from gripcourse.text.words import Texts

Choices = Mapping[str, tuple[str, ...]]
NOTE = Texts({"en": "so", "ru": "так", "uk": "так"})
FRICTION: Choices = {"grip_model": ("friction",)}


@pytest.fixture
def ruled(course: Course) -> Callable[..., tuple[Course, Scheme]]:
    """Give the screw gripper one more rule among its options."""

    def change(
        when: Choices, requires: Choices, same: tuple[str, ...] = ()
    ) -> tuple[Course, Scheme]:
        rule = OptionRule(when, requires, same, NOTE, "scheme.toml", "option_rule[1]")
        scheme = replace(course.schemes["screw"], own_rules=(rule,))
        return replace(course, schemes={"screw": scheme}), scheme

    return change


def test_a_rule_counts_where_all_its_choices_are_made() -> None:
    when = {"drive": ("a", "b"), "jaw": ("c",)}
    rule = OptionRule(when, {"mount": ("d",)}, (), NOTE, "", "")
    assert rule.counts({"drive": "b", "jaw": "c"})
    assert not rule.counts({"drive": "b"})
    assert rule.broken_by({"drive": "b", "jaw": "c", "mount": "e"}) == "mount"
    assert not rule.broken_by({"drive": "b", "jaw": "c", "mount": "d"})
    assert not rule.broken_by({"drive": "b", "jaw": "c"}), "a choice that is not made yet"


def test_four_points_of_contact_are_combined_with_prisms_alone(course: Course) -> None:
    for options in option_sets(course.schemes["screw"]):
        if options["grip_model"] in {"contact", "contact_exact", "prism_along", "prism_across"}:
            assert options["jaw_shape"] == "prism"


def test_a_rule_of_a_shared_option_passes_over_schemes_without_the_other_option(
    course: Course,
) -> None:
    shapes = {options["jaw_shape"] for options in option_sets(course.schemes["worm_sector"])}
    assert {"flat", "prism"} <= shapes
    assert not course.schemes["worm_sector"].rules


@pytest.mark.parametrize(
    ("when", "requires", "what"),
    [
        ({"grip": ("friction",)}, {"jaw_shape": ("prism",)}, "There is no option 'grip'."),
        (FRICTION, {"jaw_shape": ("prisms",)}, "There is no choice 'prisms'."),
    ],
)
def test_an_unknown_name_is_told_with_file_key_and_remedy(
    ruled: Callable[..., tuple[Course, Scheme]], when: Choices, requires: Choices, what: str
) -> None:
    changed, _scheme = ruled(when, requires)
    (problem,) = check_option_names(changed, changed)
    assert (problem.file, str(problem.what)) == ("scheme.toml", what)
    assert str(problem.key).startswith("option_rule[1].")
    assert str(problem.remedy)


def test_rules_that_leave_no_combination_are_told(
    course: Course, ruled: Callable[..., tuple[Course, Scheme]]
) -> None:
    (models,) = (one.choices for one in course.schemes["screw"].options if one.id == "grip_model")
    when = {"grip_model": tuple(one.id for one in models)}
    course, scheme = ruled(when, {"mounting": ()})
    (problem,) = check_option_rules(course, scheme)
    assert "leave no combination" in str(problem.what)


def test_a_choice_that_nothing_goes_with_is_told(
    ruled: Callable[..., tuple[Course, Scheme]],
) -> None:
    course, scheme = ruled({"jaw_shape": ("flat",)}, {"mounting": ()})
    (problem,) = check_option_rules(course, scheme)
    assert "'flat' of 'jaw_shape'" in str(problem.what)
    assert "option_rule[1]" in str(problem.remedy)


def test_givens_that_are_one_must_be_given_and_alike(
    ruled: Callable[..., tuple[Course, Scheme]],
) -> None:
    course, scheme = ruled(FRICTION, {}, ("mass", "acceleration", "weight"))
    what = [str(one.what) for one in check_option_rules(course, scheme)]
    assert "No such quantity is given where the rule counts: 'weight'." in what
    assert any("unlike units: kg, m/s**2" in one for one in what)
