"""A file that only its name ties to a student counts for nothing beside the student's own."""

from dataclasses import replace

import pytest

from gripcourse.batch.context import GradingContext
from gripcourse.batch.doubts import in_doubt
from gripcourse.grading.model import Flag, FlagCode, KnownBy, Report
from gripcourse.grading.unjudged import unjudged
from gripcourse.text.words import message


@pytest.fixture
def report(context: GradingContext) -> Report:
    odd = Flag(FlagCode.SIGNATURE, message("Odd."))
    made = unjudged("", odd, context.register["s02"], "d")
    return replace(made, judged=True, score=1.0, max_score=2.0)


def known(report: Report, file: str, known_by: KnownBy) -> Report:
    return replace(report, file=file, known_by=known_by)


def test_a_forged_file_is_nobody_s_beside_the_signed_one(report: Report) -> None:
    own = known(report, "answers.xlsx", KnownBy.SIGNATURE)
    [(place, forged)] = in_doubt([known(report, "s02.xlsx", KnownBy.FILE_NAME), own])
    assert place == 0
    assert (forged.student, forged.judged, forged.score) == ("", False, 0.0)
    assert [flag.code for flag in forged.flags] == ["who_handed_in"]
    assert "answers.xlsx" in str(forged.flags[0].message)


@pytest.mark.parametrize("known_by", [KnownBy.PERSON, KnownBy.PLATFORM, KnownBy.SIGNATURE])
def test_what_is_surely_the_student_s_stays(report: Report, known_by: KnownBy) -> None:
    reports = (known(report, "a.xlsx", KnownBy.SIGNATURE), known(report, "b.xlsx", known_by))
    assert not list(in_doubt(reports))


def test_a_name_counts_where_it_is_all_that_there_is(report: Report) -> None:
    reports = (known(report, "s02.xlsx", KnownBy.FILE_NAME),)
    assert not list(in_doubt(reports))
