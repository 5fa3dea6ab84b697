"""What is given to a call of the library and is of no kind that it takes is said in a sentence."""

import io
import os
from collections.abc import Callable
from datetime import UTC, date, datetime
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any, Final

import numpy as np
import pandas as pd
import pytest

import gripcourse as gc
from gripcourse.api.choices import a_day

SCHEME: Final = "rack_parallelogram"
ROSTER: Final = b"student,name\ns01,Anna\n"
Call = Callable[[Any], object]

NO_FILES: Final = {
    "none": None,
    "number": 5,
    "table": pd.DataFrame({"student": ["s01"]}),
    "read_as_text": io.StringIO("student,name"),
    "pair_the_wrong_way_round": (b"PK", "s01.xlsx"),
    "pair_with_a_path": (Path("s01.xlsx"), b"PK"),
    "nameless_pair": ("", b"PK"),
    "three": ("s01.xlsx", b"PK", 1),
    "named_text": gc.NamedBytes("s01.xlsx", "PK"),  # type: ignore[arg-type]
}


@pytest.fixture(scope="module")
def reference() -> gc.Course:
    return gc.Course.load(language="en")


def refusal(call: Callable[[], object]) -> gc.Problem:
    with pytest.raises(gc.GripcourseError) as refused:
        call()
    (problem,) = refused.value.problems
    assert str(problem.what)
    assert str(problem.remedy)
    return problem


@pytest.mark.parametrize("given", NO_FILES.values(), ids=NO_FILES)
def test_what_is_no_file_is_an_error_of_the_library(reference: gc.Course, given: Any) -> None:  # noqa: ANN401 (of any kind)
    assert refusal(lambda: reference.check(given)).parameter == "workbook"
    assert refusal(lambda: reference.grade([given])).parameter == "workbook-1"
    assert refusal(lambda: reference.issue(given, "out")).parameter == "roster"


@pytest.mark.parametrize(
    "given",
    [
        bytearray(ROSTER),
        memoryview(ROSTER),
        io.BytesIO(ROSTER),
        ("roster.csv", bytearray(ROSTER)),
        ("roster.csv", io.BytesIO(ROSTER)),
    ],
    ids=["bytearray", "memoryview", "open", "named_bytearray", "named_open"],
)
def test_bytes_of_any_kind_are_a_content(reference: gc.Course, given: Any) -> None:  # noqa: ANN401 (of any kind)
    assert "answer workbook" in reference.check(given).refusal or reference.check(ROSTER).refusal
    (report,) = reference.grade([given]).reports
    assert report.judged is False


def test_an_open_file_keeps_its_name(reference: gc.Course, tmp_path: Path) -> None:
    path = tmp_path / "s07.xlsx"
    path.write_bytes(b"PK")
    with path.open("rb") as file:
        (report,) = reference.grade([file]).reports
    assert report.file.endswith("s07.xlsx")


def test_one_file_may_stand_alone(reference: gc.Course, tmp_path: Path) -> None:
    path = tmp_path / "s07.xlsx"
    path.write_bytes(b"PK")
    named = gc.NamedBytes("s07.xlsx", b"PK")
    with path.open("rb") as file:
        for alone in (path, str(path), b"PK", ("s07.xlsx", b"PK"), named, file):
            assert len(reference.grade(alone).reports) == 1
    with os.scandir(tmp_path) as found:
        assert len(reference.grade(list(found)).reports) == 1


@pytest.mark.parametrize("folder", [b"course", 5, ["course"]])
def test_what_is_no_folder_is_no_path(folder: Any) -> None:  # noqa: ANN401 (of any kind)
    assert "is none" in str(refusal(lambda: gc.Course.load(folder)).what)


CALLS: Final[dict[str, tuple[str, Call, object]]] = {
    "variant": ("variant", lambda course: course.solve(19), 19),
    "count": ("count", lambda course: course.draw_variants("3", 1), "3"),
    "half_a_count": ("count", lambda course: course.draw_variants(1.5, 1), 1.5),
    "truth_for_a_count": ("count", lambda course: course.draw_variants(True, 1), True),
    "seed": ("seed", lambda course: course.draw_variants(1, "a"), "a"),
    "option": ("options", lambda course: course.solve_scheme(SCHEME, options={"drive": 5}), 5),
    "deadline": ("deadline", lambda course: course.issue(ROSTER, "out", deadline="1.2.2026"), ""),
    "graded_on": ("graded_on", lambda course: course.grade([b"PK"], graded_on="today"), ""),
    "workers": ("workers", lambda course: course.grade([b"PK"], workers=-1), -1),
    "who": ("who", lambda course: course.check(b"PK", ledger="ledger.sqlite"), ""),
    "number": ("numbers", lambda course: gc.trace(course, [1843.0], table=course.main_table), ""),
}


@pytest.mark.parametrize(("parameter", "call", "value"), CALLS.values(), ids=CALLS)
def test_a_value_of_another_kind_is_said_of_its_parameter(
    reference: gc.Course, parameter: str, call: Call, value: object
) -> None:
    problem = refusal(lambda: call(reference))
    assert problem.parameter == parameter
    assert str(value) in str(problem.what)


@pytest.mark.parametrize(
    "given", [60, np.int64(60), np.float32(60), Decimal(60), Fraction(60), "60"]
)
def test_a_number_of_any_kind_is_a_number(reference: gc.Course, given: Any) -> None:  # noqa: ANN401 (of any kind)
    solved = reference.scheme_solution(SCHEME, given={"mass": given})
    by_id = solved.table().set_index("id")
    assert by_id.loc["mass", "value"] == 60


@pytest.mark.parametrize("given", [None, True, [1], 1j, 10**400, "sixty", "1\x1b[2J"])
def test_what_is_no_number_is_refused(reference: gc.Course, given: Any) -> None:  # noqa: ANN401 (of any kind)
    problem = refusal(lambda: reference.solve_scheme(SCHEME, given={"mass": given}))
    assert problem.parameter == "given"
    assert "is not a number" in str(problem.what)
    assert "\x1b" not in str(problem.what)


def test_the_day_of_a_moment_is_its_day() -> None:
    assert a_day("today", datetime(2026, 12, 1, 18, tzinfo=UTC)) == date(2026, 12, 1)


def test_a_course_is_shown_on_one_line(reference: gc.Course) -> None:
    assert repr(reference) == "Course(language='en')"


@pytest.mark.parametrize("score", [float("nan"), float("inf")])
def test_what_json_does_not_have_is_read_from_no_plain_form(
    reference: gc.Course, score: float
) -> None:
    plain = reference.grade([b"?"]).reports[0].to_dict() | {"score": score}
    assert "A number is wanted" in str(refusal(lambda: gc.read_result(plain)).what)


def test_one_text_is_one_number_and_not_its_digits(reference: gc.Course) -> None:
    one, listed = (
        gc.trace(reference, given, table=reference.main_table) for given in ("60", ["60"])
    )
    assert {match.text for origin in one.origins for match in origin.matches} == {"60"}
    assert one.origins == listed.origins
