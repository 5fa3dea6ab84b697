"""Judged reports, as a batch of works that came out of a platform's zip."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from gripcourse.exports.make_report_result import grades_result
from gripcourse.exports.platforms.works import GradedWork, works_of
from gripcourse.exports.report_result import GradesResult
from gripcourse.grading.model import Report
from gripcourse.text.words import Words
from gripcourse.variants.model import Student
from support.reports import perfect, values, variant, wrong

__all__ = ["perfect", "values", "variant", "wrong"]

WORDS = Words("ru")
STUDENTS = {
    "s17": Student("s17", "Иванова Ольга", "РТ-41", "ivanova@uni.ua", "", ""),
    "s18": Student("s18", "О'Ковальчук Іван", "РТ-41", "kovalchuk@uni.ua", "", ""),
    "s19": Student("s19", "=Петров Пётр", "РТ-41", "petrov@uni.ua", "", ""),
}
Graded = Callable[..., GradesResult]


@pytest.fixture
def graded(perfect: Report) -> Graded:
    """Make the results of a batch: for each file, whose it is and what the report says else."""

    def make(files: dict[str, str], **changes: object) -> GradesResult:
        made = [
            replace(perfect, file=file, student=student, name=STUDENTS[student].name, **changes)
            for file, student in files.items()
        ]
        return grades_result(made, WORDS)

    return make


@pytest.fixture
def works(graded: Graded) -> Callable[..., tuple[GradedWork, ...]]:
    """Make works that count."""

    def make(files: dict[str, str]) -> tuple[GradedWork, ...]:
        return works_of(graded(files), STUDENTS)[0]

    return make
