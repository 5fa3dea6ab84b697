"""Measuring the grader: cohorts written and graded, tolerances derived and written."""

import shutil
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.errors import UsageError
from gripcourse.policy.load import load_policy, policy_path, read_policy
from gripcourse.policy.model import Policy
from gripcourse.simulation.tolerance import ToleranceAudit
from gripcourse.usecases.authoring.validate import validated
from gripcourse.usecases.measuring.tolerance import (
    ToleranceSample,
    apply,
    audit,
    variants_of,
    write_audit,
)
from gripcourse.usecases.measuring.virtual import (
    MISSES,
    Cohort,
    evaluate_folder,
    evaluate_in_memory,
    simulate,
)

# Judged and validated in a third of the time that the reference course takes.
BELTS = Path(__file__).parents[3] / "examples" / "belt_drive"
COHORT = Cohort(count=2, seed=3, scheme="v_belt")


def nothing() -> None:
    """Nobody watches."""


@pytest.fixture(scope="module")
def belts() -> tuple[Course, Policy]:
    """A course whose works are judged in a moment, and its policy."""
    own = load_course(BELTS)
    return own, load_policy(own)


@pytest.fixture(scope="module")
def narrow(tmp_path_factory: pytest.TempPathFactory) -> tuple[Course, Policy, ToleranceAudit]:
    """An audit of issued variants under a policy that refuses honest answers, once."""
    own = load_course(Path(shutil.copytree(BELTS, tmp_path_factory.mktemp("narrow") / "course")))
    path = policy_path(own.root)
    text = path.read_text(encoding="utf-8").replace("relative = 0.01\n", "relative = 0.0001\n", 1)
    path.write_text(text, encoding="utf-8")
    policy = load_policy(own)
    table = own.root / "variants" / "tables" / "main.csv"
    variants = variants_of(own, ToleranceSample(table, count=0, seed=1))[:2]
    return own, policy, audit(own, policy, variants, 0, nothing)


def test_a_cohort_is_written_and_graded(belts: tuple[Course, Policy], tmp_path: Path) -> None:
    (course, policy), out = belts, tmp_path / "cohort"
    assert simulate(course, policy, COHORT, out, 0, nothing) == COHORT.count
    found = evaluate_folder(course, policy, out, 0, nothing)
    assert found.students == COHORT.count
    assert (out / MISSES).is_file()
    in_memory = evaluate_in_memory(course, policy, COHORT, tmp_path / "misses.csv", 0, nothing)
    assert in_memory.table == found.table
    assert (tmp_path / "misses.csv").read_text() == (out / MISSES).read_text()


def test_a_folder_in_use_is_left_alone(course: Course, policy: Policy, tmp_path: Path) -> None:
    (tmp_path / "work.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(UsageError, match="not empty"):
        simulate(course, policy, COHORT, tmp_path, 0, nothing)
    assert [one.name for one in tmp_path.iterdir()] == ["work.txt"]


def test_a_scheme_that_nobody_declared_is_named(
    course: Course, policy: Policy, tmp_path: Path
) -> None:
    unknown = replace(COHORT, scheme="rack_paralelogram")
    with pytest.raises(UsageError, match="rack_paralelogram"):
        simulate(course, policy, unknown, tmp_path / "cohort", 0, nothing)


def test_derived_tolerances_are_written_once_and_keep_what_was_there(
    narrow: tuple[Course, Policy, ToleranceAudit],
) -> None:
    own, policy, found = narrow
    before = policy_path(own.root).read_text(encoding="utf-8")
    assert found.refuses
    assert apply(found, own, policy) > 10
    after = policy_path(own.root).read_text(encoding="utf-8")
    assert after.startswith(before)
    assert read_policy(own)[1] == []
    written = tomllib.loads(after)["quantity_tolerance"]
    changed = {one.quantity.id: one.proposed.relative for one in found.quantities if one.changes}
    assert {name: one["relative"] for name, one in written.items()} == changed
    apply(found, own, policy)
    assert policy_path(own.root).read_text(encoding="utf-8") == after


def test_the_audit_is_written_as_a_row_for_each_quantity(
    narrow: tuple[Course, Policy, ToleranceAudit], tmp_path: Path
) -> None:
    found = narrow[2]
    write_audit(found, tmp_path / "audit.csv")
    head, *rows = (tmp_path / "audit.csv").read_text(encoding="utf-8").splitlines()
    assert head.startswith("quantity,unit,answers,refused")
    assert len(rows) == len(found.quantities)


def test_a_fault_of_the_mix_is_found_when_the_course_is_validated(
    tmp_path: Path,
) -> None:
    root = Path(shutil.copytree(BELTS, tmp_path / "course"))
    mix = root / "grader" / "virtual.toml"
    text = mix.read_text(encoding="utf-8").replace("honest = 45.0", "honets = 45.0")
    mix.write_text(text, encoding="utf-8")
    assert [one.key for one in validated(root).problems] == ["conduct.honets"]
    mix.unlink()
    assert validated(root).problems == []
