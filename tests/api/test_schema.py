"""Results leave as plain values with a version, and come back the same."""

import json
from collections.abc import Iterator
from dataclasses import fields, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest

import gripcourse as gc
from gripcourse.api.schema import KINDS
from gripcourse.errors import UsageError
from gripcourse.exports.plain import json_schema
from gripcourse.exports.report_result import (
    CauseResult,
    FindingResult,
    FlagResult,
    GradesResult,
    ReportResult,
)
from gripcourse.grading.model import Against, Decision, Outcome
from gripcourse.usecases.authoring.schema import write_schemas

DECISION = Decision(
    automatic=Outcome.WRONG,
    credit=0.5,
    lines={"sizes": 1.0},
    marker="Петров",
    decided_at=datetime(2026, 12, 2, 9, tzinfo=UTC),
    comment="",
    outdated=False,
)
FINDING = FindingResult(
    quantity="grip_force",
    section="grip",
    outcome=Outcome.MANUAL,
    against=Against.OWN_INPUTS,
    given=3900.0,
    typed="3,9 кН",
    cell="Grip!C7",
    reference=None,
    expected=3850.6,
    band=38.5,
    points=1,
    max_points=2.0,
    slip="",
    tied=("one_jaw_only",),
    roots=(),
    message="Right.",
    remarks=("Well done.",),
    decision=DECISION,
)
REPORT = ReportResult(
    file="s01.xlsx",
    student="s01",
    name="Иванова Анна",
    variant="007",
    scheme="rack_parallelogram",
    options={"drive": "hydraulic"},
    judged=True,
    score=1.0,
    max_score=2.0,
    open_points=0.0,
    flags=(FlagResult("same_bytes", "The same file."),),
    remarks=(),
    causes=(CauseResult("grip_force", ("drive_force",), "It explains one."),),
    findings=(FINDING, replace(FINDING, decision=None)),
    digest="00",
)
GRADES = GradesResult((REPORT,), needs_person=True)


def through_json(plain: object) -> Any:  # noqa: ANN401
    return json.loads(json.dumps(plain, allow_nan=False))


@pytest.mark.parametrize("result", [REPORT, GRADES])
def test_a_result_comes_back_as_it_was(result: ReportResult | GradesResult) -> None:
    plain = through_json(result.to_dict())
    assert plain["schema"] == result.SCHEMA
    assert type(result).from_dict(plain) == result
    assert gc.read_result(plain) == result


def test_a_solution_comes_back_as_it_was(own: gc.Course) -> None:
    solution = own.scheme_solution("rack_parallelogram")
    assert gc.SolutionResult.from_dict(through_json(solution.to_dict())) == solution


@pytest.mark.parametrize("found", ["gripcourse/grades/2", "gripcourse/report/1", "other"])
def test_another_form_or_version_is_refused_with_a_sentence(found: str) -> None:
    with pytest.raises(UsageError) as caught:
        GradesResult.from_dict({**GRADES.to_dict(), "schema": found})
    (problem,) = caught.value.problems
    assert str(problem.what) == (
        f"This has the form '{found}'; this version of gripcourse reads 'gripcourse/grades/1'."
    )


@pytest.mark.parametrize("form", ["gripcourse/grades/2", "gripcourse/marks/1", ""])
def test_a_form_that_nobody_knows_is_refused(form: str) -> None:
    with pytest.raises(UsageError, match="schema"):
        gc.read_result({**GRADES.to_dict(), "schema": form})


@pytest.mark.parametrize("other", [None, 5, "text", [GRADES.to_dict()]])
def test_what_is_no_result_at_all_is_refused_alike(other: object) -> None:
    with pytest.raises(UsageError, match="schema"):
        gc.read_result(other)


def test_everything_that_cannot_be_used_is_told_at_once_with_its_place() -> None:
    plain = through_json(GRADES.to_dict())
    report = plain["reports"][0]
    del report["student"]
    report["score"] = "much"
    report["options"] = []
    report["judged"] = 1
    report["findings"][1]["outcome"] = "excellent"
    report["findings"][0]["decision"]["decided_at"] = "yesterday"
    report["flags"] = None
    with pytest.raises(UsageError) as caught:
        GradesResult.from_dict(plain)
    assert {str(problem.key) for problem in caught.value.problems} == {
        "reports[0].student",
        "reports[0].score",
        "reports[0].options",
        "reports[0].judged",
        "reports[0].findings[1].outcome",
        "reports[0].findings[0].decision.decided_at",
        "reports[0].flags",
    }


def test_a_key_that_a_later_version_added_is_left_aside() -> None:
    assert ReportResult.from_dict({**REPORT.to_dict(), "mood": "good"}) == REPORT


def test_a_key_that_was_added_later_may_be_missing() -> None:
    plain = REPORT.to_dict()
    del plain["digest"]
    assert ReportResult.from_dict(plain) == replace(REPORT, digest="")


def references(schema: object) -> Iterator[str]:
    if isinstance(schema, dict):
        if isinstance(schema.get("$ref"), str):
            yield schema["$ref"]
        for one in schema.values():
            yield from references(one)
    elif isinstance(schema, list):
        for one in schema:
            yield from references(one)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.SCHEMA)
def test_every_form_has_its_json_schema(kind: type[Any]) -> None:
    schema = through_json(json_schema(kind))
    assert schema["$id"] == kind.SCHEMA
    assert {one.removeprefix("#/$defs/") for one in references(schema)} == schema["$defs"].keys()
    for name, definition in schema["$defs"].items():
        assert set(definition["required"]) <= definition["properties"].keys()
        told = {key for key, one in definition["properties"].items() if "description" in one}
        assert told == definition["properties"].keys() - {"schema"}, name
    top = schema["$defs"][kind.__name__]["properties"]
    assert top["schema"] == {"const": kind.SCHEMA}
    assert top.keys() - {"schema"} == {one.name for one in fields(kind)}


def test_versions_are_unique() -> None:
    assert len(gc.schemas()) == len(KINDS)


def test_the_schemas_of_results_can_be_had_as_files(tmp_path: Path) -> None:
    written = write_schemas(tmp_path, gc.schemas())
    assert sum(one.parent.name == "results" for one in written) == len(KINDS)
    of_grades = json.loads((tmp_path / "results" / "grades.schema.json").read_text("utf-8"))
    assert of_grades == gc.schemas()["gripcourse/grades/1"]
