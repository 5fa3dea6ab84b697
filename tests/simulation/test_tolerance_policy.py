"""Tolerances written into a policy: a line each, nothing else touched."""

import tomllib
from pathlib import Path

import pytest

from gripcourse.course.quantity import Tolerance
from gripcourse.errors import UsageError
from gripcourse.simulation.tolerance_policy import apply_tolerances, with_tolerances

PLAIN = """\
# The head of course wrote this.
[tolerance]   # the default
relative = 0.01

[credit]
carried = 1.0             # a remark
"""
OWN = """\
[quantity_tolerance]      # by hand
bore_required = { relative = 0.02 }  # agreed in the department

grip_force = { relative = 0.03 }

[credit]
carried = 1.0
"""


def test_everything_that_was_written_stays() -> None:
    after = with_tolerances(PLAIN, {"grip_force": Tolerance(0.002, 0.0)})
    assert after.startswith(PLAIN)
    assert tomllib.loads(after)["quantity_tolerance"] == {"grip_force": {"relative": 0.002}}


def test_a_line_that_is_there_is_changed_and_keeps_its_remark() -> None:
    after = with_tolerances(OWN, {"bore_required": Tolerance(0.005, 0.05)})
    line = "bore_required = { relative = 0.005, absolute = 0.05 }  # agreed in the department"
    assert line in after.splitlines()
    assert after.replace(line, OWN.splitlines()[1]) == OWN


def test_a_new_line_goes_to_the_end_of_the_table() -> None:
    after = with_tolerances(OWN, {"pin_force": Tolerance(0.001, 0.0)})
    lines = after.splitlines()
    assert lines[lines.index("grip_force = { relative = 0.03 }") + 1].startswith("pin_force =")
    assert tomllib.loads(after)["credit"] == {"carried": 1.0}


def test_writing_again_changes_nothing() -> None:
    wanted = {"b": Tolerance(0.002, 0.0), "a": Tolerance(0.005, 0.1)}
    once = with_tolerances(PLAIN, wanted)
    assert with_tolerances(once, wanted) == once
    assert with_tolerances(once, {}) == once


def test_a_policy_that_is_written_otherwise_is_left_alone(tmp_path: Path) -> None:
    policy = tmp_path / "policy.toml"
    text = PLAIN + "\n[quantity_tolerance.grip_force]\nrelative = 0.02\n"
    policy.write_text(text, encoding="utf-8")
    with pytest.raises(UsageError, match="line by line"):
        apply_tolerances(policy, "grader/policy.toml", {"grip_force": Tolerance(0.002, 0.0)})
    assert policy.read_text(encoding="utf-8") == text


def test_a_policy_with_another_quantity_in_a_table_of_its_own_is_changed(tmp_path: Path) -> None:
    policy = tmp_path / "policy.toml"
    text = PLAIN + "\n[quantity_tolerance.grip_force]\nrelative = 0.02\n"
    policy.write_text(text, encoding="utf-8")
    apply_tolerances(policy, "grader/policy.toml", {"pin_force": Tolerance(0.002, 0.0)})
    written = tomllib.loads(policy.read_text(encoding="utf-8"))["quantity_tolerance"]
    assert written == {"grip_force": {"relative": 0.02}, "pin_force": {"relative": 0.002}}
