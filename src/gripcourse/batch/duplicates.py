"""Files of one batch that belong together: several of one student, one of several students."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from gripcourse.grading.model import Flag, FlagCode, Report
from gripcourse.text.words import message


def mark_doubles(reports: Sequence[Report]) -> tuple[Report, ...]:
    """Flag several files of one student, and equal bytes from several students."""
    by_student: dict[str, list[Report]] = defaultdict(list)
    by_digest: dict[str, list[Report]] = defaultdict(list)
    for report in reports:
        if report.student:
            by_student[report.student].append(report)
        if report.student and report.digest:
            by_digest[report.digest].append(report)
    return tuple(
        replace(report, flags=(*report.flags, *_flags(report, by_student, by_digest)))
        for report in reports
    )


def _flags(
    report: Report,
    by_student: Mapping[str, Sequence[Report]],
    by_digest: Mapping[str, Sequence[Report]],
) -> Iterator[Flag]:
    files = [one.file for one in by_student.get(report.student, ()) if one is not report]
    if files:
        yield Flag(
            FlagCode.SEVERAL_FILES,
            message("The student handed in more files: {files}.", files=", ".join(files)),
        )
    others = (one.student for one in by_digest.get(report.digest, ()))
    students = dict.fromkeys(one for one in others if one != report.student)
    if students:
        yield Flag(
            FlagCode.SAME_BYTES,
            message("The same file came from: {students}.", students=", ".join(students)),
        )
