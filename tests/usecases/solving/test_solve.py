"""Solving by hand: values set, values refused, and what is written out."""

from dataclasses import replace
from pathlib import Path

import openpyxl
import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention
from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import Words
from gripcourse.usecases.solving.solve import (
    SolvedVariant,
    solve_from_table,
    solve_scheme,
    write_key,
)
from gripcourse.variants.model import Variant

SCHEME = "rack_parallelogram"


@pytest.fixture(scope="module")
def course() -> Course:
    """The reference course."""
    return load_course(Path(__file__).parents[3])


def solve(course: Course, *settings: str, convention: Convention | None = None) -> SolvedVariant:
    given = dict(one.split("=", 1) for one in settings)
    return solve_scheme(course, SCHEME, given, {}, convention)


def refused(course: Course, *settings: str) -> tuple[Problem, ...]:
    with pytest.raises(UsageError) as error:
        solve(course, *settings)
    return error.value.problems


def test_what_is_not_set_is_the_worked_examples(course: Course) -> None:
    # the guide, section 5: 3900 N with its 10 m/s²; method E16: 3851 N with the course's gravity
    assert solve(course).values["grip_force"] == pytest.approx(3900)
    assert solve(course, "gravity=9.81").values["grip_force"] == pytest.approx(3850.6, abs=0.05)
    assert solve(course).variant.given["mass"] == 60


@pytest.mark.parametrize("written", ["62.5", "62,5", " 62,5 ", "6,25e1"])
def test_a_decimal_comma_is_a_decimal_point(course: Course, written: str) -> None:
    assert solve(course, f"mass={written}").values["mass"] == 62.5


def test_a_value_can_be_assumed_instead_of_computed(course: Course) -> None:
    solved = solve(course, "grip_force=4000", "bore=80")
    assert solved.values["gear_torque"] == pytest.approx(600)
    assert solved.values["bore"] == 80
    assert solved.assumed == ("grip_force", "bore")


def test_options_and_conventions_can_be_chosen(course: Course) -> None:
    given = {"mass": 8, "supply_pressure": 0.5}
    solved = solve_scheme(course, SCHEME, given, {"drive": "pneumatic"}, Convention.AS_PRINTED)
    assert solved.plan.options["drive"] == "pneumatic"
    assert solved.plan.options["jaw_shape"] == "flat"  # as in the worked example
    assert solved.plan.convention is Convention.AS_PRINTED
    assert (solved.values["bore"], solved.values["rod"]) == (125, 32)  # ISO 15552 pairs them


def test_a_variant_of_a_table_is_solved_with_its_options(course: Course) -> None:
    example = course.schemes[SCHEME].example
    assert example is not None
    variant = Variant("007", SCHEME, example.options, example.given)
    solved = solve_from_table(course, [variant], "007", None)
    assert solved.variant == variant
    assert solved.values["bore"] == 63
    assert solve_from_table(course, [variant], "7", None) == solved
    other = replace(variant, id="07")
    for table, name in (([variant], "08"), ([variant, other], "7")):
        with pytest.raises(UsageError, match=f"The table has no variant '{name}'"):
            solve_from_table(course, table, name, None)


@pytest.mark.parametrize(
    ("setting", "place", "what", "remedy"),
    [
        ("mas=60", "mas", "The scheme has no quantity 'mas'.", "Did you mean 'mass'?"),
        ("mass=heavy", "mass", "'heavy' is not a number.", "Write a plain number in kg."),
        ("mass=", "mass", "'' is not a number.", "Write a plain number in kg."),
        ("mass=60 kg", "mass", "'60 kg' is not a number.", "Write a plain number in kg."),
        ("mass=nan", "mass", "'nan' is not a number.", "Write a plain number in kg."),
        (
            "mass=-5",
            "mass",
            "mass of the object = −5 kg is not possible.",
            "It lies from 0.001 to 5000.",
        ),
        (
            "friction=0",
            "friction",
            "friction coefficient between jaw and object = 0 is not possible.",
            "It lies from 0.01 to 1.5.",
        ),
        (
            "gear_teeth=17.5",
            "gear_teeth",
            "number of teeth of the full gear of the sector = 17.5 is not possible.",
            "Write a whole number.",
        ),
        (
            "general_view_drawing=1",
            "general_view_drawing",
            "The scheme has no quantity 'general_view_drawing'.",
            "Known here: ",
        ),
    ],
)
def test_what_cannot_be_used_is_refused_with_its_name(
    course: Course, setting: str, place: str, what: str, remedy: str
) -> None:
    [problem] = refused(course, setting)
    assert problem.key == place
    assert str(problem.what) == what
    assert str(problem.remedy).startswith(remedy)


def test_everything_wrong_is_told_at_once(course: Course) -> None:
    assert len(refused(course, "mas=1", "friction=x")) == 2
    assert {one.key for one in refused(course, "mass=-1", "friction=0")} == {"mass", "friction"}


def test_an_arm_shorter_than_the_travel_is_named_with_both(course: Course) -> None:
    [problem] = refused(course, "arm_length=80")
    assert problem.key == "arm_angle_open"
    assert str(problem.what) == (
        "arm angle with the jaws open has no value for jaw_travel = 90 mm; arm_length = 80 mm."
    )
    assert "outside the domain" in str(problem.remedy)


def test_a_refusal_is_written_in_the_readers_language(course: Course) -> None:
    [problem] = refused(course, "arm_length=80,5")
    said = problem.say(Words("ru"))
    assert "угол рычага при раскрытых губках" in said
    assert "arm_length = 80,5 мм" in said


def test_an_empty_catalogue_entry_is_named_at_its_cause(course: Course) -> None:
    [problem] = refused(course, "supply_pressure=0.1", "mass=200")
    assert problem.key == "bore_first"
    assert "bore_required = " in str(problem.what)


def test_unknown_schemes_and_options_are_refused(course: Course) -> None:
    with pytest.raises(UsageError, match="Did you mean 'rack_parallelogram'"):
        solve_scheme(course, "rack_paralelogram", {}, {}, None)
    with pytest.raises(UsageError, match="Did you mean 'hydraulic'"):
        solve_scheme(course, SCHEME, {}, {"drive": "hydralic"}, None)
    with pytest.raises(UsageError, match="has no option 'driv'"):
        solve_scheme(course, SCHEME, {}, {"driv": "hydraulic"}, None)


def test_a_changed_constant_stands_in_the_key(course: Course, tmp_path: Path) -> None:
    path = write_key(solve(course, "gravity=10"), tmp_path / "key.xlsx", Words("en"))
    book = openpyxl.load_workbook(path, data_only=True)
    sheet, _, address = book.defined_names["given.gravity"].attr_text.rpartition("!")
    assert book[sheet.strip("'")][address.replace("$", "")].value == 10


def test_a_key_of_assumed_results_is_refused(course: Course, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="The key computes grip_force itself"):
        write_key(solve(course, "grip_force=4000"), tmp_path / "key.xlsx", Words("en"))
    assert list(tmp_path.iterdir()) == []
