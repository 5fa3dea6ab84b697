"""Files of one batch that belong together: several of one student, one of several students."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
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
    return tuple(with_flags(one, _flags(one, by_student, by_digest)) for one in reports)


def with_flags(report: Report, flags: Iterable[Flag]) -> Report:
    """Return a report with more flags; itself where there are none, of which a batch has many."""
    more = tuple(flags)
    return replace(report, flags=(*report.flags, *more)) if more else report


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
    if not students:
        return
    alike = [one for one in by_digest.get(report.digest, ()) if one.student != report.student]
    if not _is_anothers(report) and all(map(_is_anothers, alike)):
        yield Flag(
            FlagCode.COPIED_FROM,
            message(
                "This student's own workbook was handed in by {students} too: the question goes to "
                "them, not to the owner.",
                students=", ".join(students),
            ),
            tuple(students),
        )
        return
    yield Flag(
        FlagCode.SAME_BYTES,
        message("The same file came from: {students}.", students=", ".join(students)),
        tuple(students),
    )


def _is_anothers(report: Report) -> bool:
    """Tell whether a workbook was issued to another than the student who handed it in."""
    return any(flag.code is FlagCode.ISSUED_TO_OTHER for flag in report.flags)
