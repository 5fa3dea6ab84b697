"""Declared free bodies: every fault at its key, claims tried with numbers."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.errors import CourseError
from gripcourse.proofs.equilibrium.check import load_mechanisms
from gripcourse.proofs.equilibrium.read import FOLDER
from gripcourse.proofs.equilibrium.trials import prove_equilibrium
from gripcourse.proofs.model import ProofResult, Verdict
from gripcourse.proofs.samples import SampleSource

RACK = """
schemes = ["rack_parallelogram"]
bodies = ["arm"]

[position]
at_max = { rise = "(diameter_max - diameter_min)/2" }
at_min = { rise = "0*diameter_min" }

[let]
reach = "sqrt(arm_length**2 - rise**2)"

[point]
O = { x = "0", y = "0" }
A = { x = "reach", y = "rise" }
M = { x = "0", y = "pitch_radius" }
S = { kind = "circles", around = ["O", "A"], radii = ["pitch_radius", "arm_length"], side = "left" }

[joint]
pivot = { kind = "pin", between = ["arm", "ground"], at = "O" }
teeth = { kind = "force", between = ["arm", "ground"], at = "M", direction = "0" }

[load]
grip = { on = "arm", at = "A", force = "grip_force", direction = "pi/2" }

[[claim]]
quantity = "force_ratio_at_max*grip_force"
is = "2*teeth_force"
at = "at_max"

[[claim]]
quantity = "tooth_force"
is = "teeth_force"
largest = true

[[condition]]
that = "pivot_force >= grip_force"
"""

Write = Callable[[str], Course]


@pytest.fixture
def with_mechanism(course: Course, tmp_path: Path) -> Write:
    """Return the reference course with one mechanism and nothing else."""

    def write(text: str) -> Course:
        (tmp_path / "variants" / FOLDER).mkdir(parents=True, exist_ok=True)
        (tmp_path / "variants" / FOLDER / "one.toml").write_text(text, encoding="utf-8")
        return replace(course, root=tmp_path)

    return write


def proved(course: Course) -> ProofResult:
    """Try the only mechanism of a course with the worked example."""
    [mechanism] = load_mechanisms(course)
    return prove_equilibrium(mechanism, SampleSource(course, (), 1, 1), None)


def test_a_course_without_mechanisms_declares_none(course: Course, tmp_path: Path) -> None:
    assert load_mechanisms(replace(course, root=tmp_path)) == ()


def test_what_is_in_equilibrium_holds(with_mechanism: Write) -> None:
    result = proved(with_mechanism(RACK))
    assert (result.verdict, result.compared) == (Verdict.HOLDS, 3)


@pytest.mark.parametrize(
    ("old", "new", "key", "said"),
    [
        ('"2*teeth', '"3*teeth', "claim[1].quantity", "1.5 to 1.5 times as much"),
        ('"teeth_force"', '"2*teeth_force"', "claim[2].quantity", "in worked example"),
        (">= grip_force", "<= grip_force", "condition[1].that", "does not hold in 2 of 2"),
        (
            'kind = "force", between = ["arm", "ground"], at = "M", direction = "0"',
            'kind = "contact", between = ["arm", "ground"], at = "M", direction = "pi"',
            "joint.teeth",
            "The contact teeth pulls",
        ),
        (
            'at = "M", direction = "0" }',
            'at = "O", direction = "0" }',
            "joint",
            "it leaves open: pivot_x, teeth_force",
        ),
    ],
)
def test_what_is_not_in_equilibrium_is_told_with_key_and_size(
    with_mechanism: Write, old: str, new: str, key: str, said: str
) -> None:
    text = RACK.replace(old, new)
    assert text != RACK
    if "contact" in new:
        text = text.replace("teeth_force", "teeth_normal")
    result = proved(with_mechanism(text))
    assert result.verdict is Verdict.FAILS
    told = {one.key: str(one.what) for one in result.problems}
    assert said in told[key]
    assert {one.file for one in result.problems} == {"variants/equilibrium/one.toml"}


def test_without_numbers_a_mechanism_stays_open(with_mechanism: Write) -> None:
    text = RACK.replace("bodies", 'options = { grip_model = "prism_along" }\nbodies')
    result = proved(with_mechanism(text))
    assert result.verdict is Verdict.OPEN
    assert result.note is not None


@pytest.mark.parametrize(
    ("old", "new", "key", "what"),
    [
        ('["rack_parallelogram"]', '["rack"]', "schemes", "'rack' is not known"),
        ("bodies =", "bodis =", "bodis", "means nothing here"),
        ('on = "arm"', 'on = "lever"', "load.grip.on", "'lever' is not known"),
        ('["arm", "ground"], at = "O"', '["arm", "floor"], at = "O"', "joint.pivot.between",
         "'floor' is not known"),
        ('["arm", "ground"], at = "O"', '["arm", "arm"], at = "O"', "joint.pivot.between",
         "connects two bodies"),
        ('["arm", "ground"], at = "O"', '"arm", at = "O"', "joint.pivot.between", "wrong type"),
        ('kind = "pin"', 'kind = "pinn"', "joint.pivot.kind", "'pinn' is not known"),
        ('kind = "pin"', 'kind = "weld"', "joint", "5 unknown reactions|4 unknown reactions"),
        ('kind = "pin", between = ["arm", "ground"], at = "O"',
         'kind = "couple", between = ["arm", "ground"]', "joint", "nothing holds the bodies"),
        ('at = "M", direction', 'at = "N", direction', "joint.teeth.at", "'N' is not known"),
        ('direction = "0" }', 'direction = "0", along = "0" }', "joint.teeth.along",
         "means nothing here"),
        ('direction = "0" }', 'direction = "arm_length" }', "joint.teeth.direction",
         "does not measure"),
        ('force = "grip_force"', 'force = "gear_torque"', "load.grip.force", "does not measure"),
        ('force = "grip_force"', 'moment = "gear_torque", force = "grip_force"', "load.grip",
         "a force or a moment"),
        ('force = "grip_force", direction = "pi/2"', 'force = "grip_force"',
         "load.grip.direction", "missing"),
        ('x = "reach", y = "rise"', 'x = "reach", y = "S_y"', "point.A", "follows from itself"),
        ('x = "reach", y = "rise"', 'x = "grip_force", y = "rise"', "point.A.x",
         "does not measure"),
        ('around = ["O", "A"]', 'around = ["O", "B"]', "point.S.around", "'B' is not known"),
        ('side = "left"', 'side = "above"', "point.S.side", "'above' is not known"),
        ("at_min = {", "at_middle = {", "position.at_middle", "'at_middle' is not known"),
        ("at_min = { rise", "at_min = { height", "position.at_min", "do not give the same names"),
        ("2*teeth_force", "2*tooth_farce", "claim[1].is", "'tooth_farce' is not known"),
        ("2*teeth_force", "2*teeth_force*arm_length", "claim[1].is", "different things"),
        ("2*teeth_force", "2*teeth_force +", "claim[1].is", "missing or too much"),
        (">= grip_force", "+ grip_force", "condition[1].that", "must be a comparison"),
        ("largest = true", 'largest = true\nat = "at_min"', "claim[2].at", "has no position"),
        ("teeth = {", "tooth = {", "joint", "'tooth_force' is a quantity"),
        ("[[claim]]", '[relation]\nsum = { of = { teeth = "1" }, gives = "0" }\n[[claim]]',
         "relation.sum.of.teeth", "no unknown reaction 'teeth'"),
    ],
)  # fmt: skip
def test_a_fault_of_a_mechanism_is_told_with_its_key(
    with_mechanism: Write, old: str, new: str, key: str, what: str
) -> None:
    text = RACK.replace(old, new, 1)
    assert text != RACK
    with pytest.raises(CourseError) as raised:
        load_mechanisms(with_mechanism(text))
    told = [(one.key, str(one.what)) for one in raised.value.problems]
    assert any(
        key == where and any(part in said for part in what.split("|")) for where, said in told
    ), told
    assert all(str(one.remedy) for one in raised.value.problems)


def test_a_mechanism_without_a_claim_proves_nothing(with_mechanism: Write) -> None:
    with pytest.raises(CourseError, match="Nothing is claimed"):
        load_mechanisms(with_mechanism(RACK[: RACK.index("[[claim]]")]))
