"""Declared proofs: read with every fault at its key, tried with numbers."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.errors import CourseError
from gripcourse.proofs.check_declared import load_declared_proofs
from gripcourse.proofs.declared import FILE, DeclaredProofs
from gripcourse.proofs.declared_trials import prove_declared
from gripcourse.proofs.model import Verdict
from gripcourse.proofs.samples import SampleSource

IDENTITY = """
[[proof]]
id = "friction"
kind = "identity"
schemes = ["rack_parallelogram"]
options = { grip_model = "friction" }
set = { dynamic_factor = 1.2 }
let = { weight = "mass*(gravity + acceleration)" }
left = "2*friction*grip_force"
right = "dynamic_factor*weight"
"""
WORK = """
[[proof]]
id = "work"
kind = "virtual_work"
schemes = ["rack_parallelogram"]
ratio = "force_ratio_at_max"
parameter = "angle"
unit = "deg"
at = "arm_angle_at_max"
input = "pitch_radius*angle"
output = "2*arm_length*sin(angle)"
"""
TRAVEL = """
[[proof]]
id = "travel"
kind = "travel"
schemes = ["rack_parallelogram"]
quantity = "jaw_travel"
coordinate = "jaw_pin_y"
start = "open"
end = "at_min"
"""
INEQUALITY = """
[[proof]]
id = "closed"
kind = "inequality"
schemes = ["rack_parallelogram"]
condition = "jaw_travel >= release_travel"
"""

Write = Callable[[str, str], Course]


def test_a_course_without_proofs_declares_none(course: Course, tmp_path: Path) -> None:
    assert load_declared_proofs(replace(course, root=tmp_path)) == DeclaredProofs()


@pytest.mark.parametrize("text", [IDENTITY, WORK, TRAVEL, INEQUALITY])
def test_what_is_right_holds_at_the_worked_example(with_file: Write, text: str) -> None:
    course = with_file(FILE, text)
    [proof] = load_declared_proofs(course).proofs
    result = prove_declared(proof, SampleSource(course, (), 1, 1), None)
    assert (result.verdict, result.compared) == (Verdict.HOLDS, 1)


@pytest.mark.parametrize(
    ("text", "old", "new"),
    [
        (IDENTITY, '"2*friction', '"7*friction'),
        (WORK, '"2*arm_length', '"3*arm_length'),
        (TRAVEL, 'end = "at_min"', 'end = "at_max"'),
        (INEQUALITY, ">=", "<"),
    ],
)
def test_what_is_wrong_fails_with_a_scheme_and_a_variant(
    with_file: Write, text: str, old: str, new: str
) -> None:
    assert old in text
    course = with_file(FILE, text.replace(old, new))
    [proof] = load_declared_proofs(course).proofs
    result = prove_declared(proof, SampleSource(course, (), 1, 1), None)
    assert result.verdict is Verdict.FAILS
    [problem] = result.problems
    assert (problem.file, problem.key) == ("variants/proofs.toml", "proof[1]")
    assert "rack_parallelogram" in str(problem.what)
    assert "worked example" in str(problem.what)


def test_without_numbers_a_proof_stays_open(with_file: Write) -> None:
    course = with_file(FILE, IDENTITY.replace('"friction" }', '"prism_along" }'))
    [proof] = load_declared_proofs(course).proofs
    result = prove_declared(proof, SampleSource(course, (), 1, 1), None)
    assert result.verdict is Verdict.OPEN
    assert result.note is not None


@pytest.mark.parametrize(
    ("text", "old", "new", "key", "what"),
    [
        (IDENTITY, '"identity"', '"identidy"', "kind", "no kind of proof 'identidy'"),
        (IDENTITY, '["rack_parallelogram"]', '["rack"]', "schemes", "no scheme 'rack'"),
        (IDENTITY, "2*friction*", "2*friction+*", "left", "missing or too much"),
        (IDENTITY, "2*friction*", "2*frictoin*", "left", "'frictoin' is not known"),
        (IDENTITY, "grip_model", "grip_modle", "options", "has these options"),
        (IDENTITY, "2*friction*", "friction/", "right", "measure different things"),
        (IDENTITY, "dynamic_factor = 1.2", "factor_k = 1.2", "set.factor_k", "not known"),
        (IDENTITY, "left =", "lift =", "lift", "means nothing here"),
        (WORK, 'unit = "deg"', 'unit = "dge"', "unit", "'dge' is not known"),
        (WORK, 'at = "arm_angle_at_max"', 'at = "arm_length"', "at", "what the parameter does"),
        (TRAVEL, "jaw_pin_y", "jaw_y", "coordinate", "no 'jaw_y'"),
        (TRAVEL, '"open"', '"opened"', "start", "no 'opened'"),
        (INEQUALITY, ">= release_travel", "+ release_travel", "condition", "must be a comparison"),
    ],
)
def test_a_fault_of_a_proof_is_told_with_its_key(
    with_file: Write, text: str, old: str, new: str, key: str, what: str
) -> None:
    assert old in text
    with pytest.raises(CourseError) as raised:
        load_declared_proofs(with_file(FILE, text.replace(old, new)))
    found = {str(one.key): str(one.what) for one in raised.value.problems}
    assert what in found[f"proof[1].{key}"]
    assert {one.file for one in raised.value.problems} == {"variants/proofs.toml"}
    assert all(str(one.remedy) for one in raised.value.problems)


def test_an_operator_that_nothing_shows_must_exist(with_file: Write) -> None:
    text = '[[unshown]]\nquantity = "mss"\noperator = "%"\nreason = "none"\n'
    with pytest.raises(CourseError) as raised:
        load_declared_proofs(with_file(FILE, text))
    assert [one.key for one in raised.value.problems] == [
        "unshown[1].quantity",
        "unshown[1].operator",
    ]
