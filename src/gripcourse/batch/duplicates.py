"""Files of one batch that belong together: several of one student, one of several students."""

from array import array
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from typing import Final, TypeAlias

import numpy as np

from gripcourse.batch.graded import Changes
from gripcourse.grading.model import Flag, FlagCode, Report
from gripcourse.text.words import message

_Numbered: TypeAlias = tuple[int, Report]
_Groups: TypeAlias = Mapping[str, Sequence[_Numbered]]
_NAMED: Final = 5


def doubles(reports: Sequence[Report]) -> Changes:
    """Flag several files of one student, and equal bytes from several students."""
    said = [array("q"), array("q")]
    for report in reports:
        said[0].append(hash(report.student))
        said[1].append(hash(report.digest))
    # Of a large batch nearly all are alone: only what may belong together is looked at.
    together = sorted({number for hashes in said for number in _repeated(hashes)})
    found = [(number, reports[number]) for number in together]
    by_student, by_digest = _grouped(found)
    for number, report in found:
        flags = tuple(_flags(number, report, by_student, by_digest))
        if flags:
            yield number, with_flags(report, flags)


def _repeated(hashes: "array[int]") -> Iterator[int]:
    """Yield the places of what is there more than once."""
    _, kind, count = np.unique(
        np.frombuffer(hashes, np.int64), return_inverse=True, return_counts=True
    )
    yield from np.flatnonzero(count[kind] > 1).tolist()


def _grouped(found: Iterable[_Numbered]) -> tuple[_Groups, _Groups]:
    """Group files by their students, and those of students by their bytes."""
    by_student: dict[str, list[_Numbered]] = defaultdict(list)
    by_digest: dict[str, list[_Numbered]] = defaultdict(list)
    for one in found:
        if one[1].student:
            by_student[one[1].student].append(one)
            if one[1].digest:
                by_digest[one[1].digest].append(one)
    return by_student, by_digest


def with_flags(report: Report, flags: Iterable[Flag]) -> Report:
    """Return a report with more flags; itself where there are none, of which a batch has many."""
    more = tuple(flags)
    return replace(report, flags=(*report.flags, *more)) if more else report


def _flags(number: int, report: Report, by_student: _Groups, by_digest: _Groups) -> Iterator[Flag]:
    mine = by_student.get(report.student, ())
    files = [one.file for place, one in mine if place != number]
    if files:
        yield Flag(
            FlagCode.SEVERAL_FILES,
            message("The student handed in more files: {files}.", files=_some(files)),
        )
    same = [one for _, one in by_digest.get(report.digest, ())]
    alike = [one for one in same if one.student != report.student]
    students = dict.fromkeys(one.student for one in alike)
    if not students:
        return
    if not _is_anothers(report) and all(map(_is_anothers, alike)):
        yield Flag(
            FlagCode.COPIED_FROM,
            message(
                "This student's own workbook was handed in by {students} too: the question goes to "
                "them, not to the owner.",
                students=_some(students),
            ),
            tuple(students),
        )
        return
    yield Flag(
        FlagCode.SAME_BYTES,
        message("The same file came from: {students}.", students=_some(students)),
        tuple(students),
    )


def _some(names: Collection[str]) -> str:
    """Name the first ones: of a hundred files that belong together each would name all others."""
    more = len(names) - _NAMED
    said = ", ".join(islice(names, _NAMED))
    return said if more <= 0 else f"{said}, … (+{more})"


def _is_anothers(report: Report) -> bool:
    """Tell whether a workbook was issued to another than the student who handed it in."""
    return any(flag.code is FlagCode.ISSUED_TO_OTHER for flag in report.flags)
