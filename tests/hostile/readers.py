"""Whatever reads what a stranger made, by name: each takes any bytes and reads or refuses them.

A reader answers with something, or raises one of our own errors, which say what is wrong. Nothing
else may come of any bytes. Who paints drawings is kept in a worker and may raise what it likes: of
it only time and memory count.
"""

import functools
import json
import sys
import tempfile
import zipfile
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from gripcourse.api.results import CheckResult, SolutionResult, VariantsResult
from gripcourse.course.check import check_course
from gripcourse.course.model import Course
from gripcourse.course.read import read_course
from gripcourse.errors import GripcourseError
from gripcourse.exports.platforms.canvas import fill_gradebook
from gripcourse.exports.platforms.moodle_worksheet import fill_worksheet, read_worksheet
from gripcourse.exports.report_result import GradesResult
from gripcourse.grading.path_pattern import path_pattern
from gripcourse.grading.platforms import platform_part
from gripcourse.issuing.roster import read_roster
from gripcourse.machine.archive import (
    UnreadableMemberError,
    is_bundle,
    members_of,
    read_member,
)
from gripcourse.machine.content import NamedBytes
from gripcourse.policy.load import read_policy
from gripcourse.submission.raw import RawCell, RawWorkbook
from gripcourse.submission.understand import cell_text, understand
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import empty_course
from gripcourse.usecases.grading.collect import why_not
from gripcourse.web.pictures import picture_of
from gripcourse.web.rest.bodies import usable
from gripcourse.web.rest.wishes import (
    MarkWish,
    PublishingReason,
    RegradeWish,
    RegradingWish,
    UndoingWish,
)

if __name__ == "__main__":  # as a program it does not know where the tests are
    sys.path.insert(0, str(Path(__file__).parents[1]))

from hostile.changes import Form
from hostile.provenance import invented
from hostile.reading import as_student, as_table, faults_of
from hostile.samples import (
    GRADEBOOK,
    TYPED,
    WORKSHEET,
    drawn,
    grades,
    solution,
    works_of_many,
)
from hostile.small_workbook import PARTS, archive, quantities

ROOT: Final = Path(__file__).parents[2]
FAILED: Final = Path(__file__).parent / "once_failed"
"""Files that once failed, in folders called like their readers."""


class NotAsItShouldBeError(AssertionError):
    """A reader came to what it must not come to."""


@dataclass(frozen=True, slots=True)
class Reader:
    """Who reads files of one kind.

    Attributes:
        sound: files that are read.
        read: reads one; what it returns is never nothing.
        form: of the files, which tells how they are changed.
    """

    sound: tuple[bytes, ...]
    read: Callable[[bytes], object]
    form: Form = Form.PLAIN


@functools.cache
def _folder() -> Path:
    """Return a folder of this process, for who reads nothing but files."""
    keeper = tempfile.TemporaryDirectory(prefix="hostile-")
    _KEEPERS.append(keeper)
    return Path(keeper.name)


_KEEPERS: Final[list[tempfile.TemporaryDirectory[str]]] = []


def _workbook(data: bytes) -> object:
    read = as_student(data, quantities())
    wrong = faults_of(read)
    if isinstance(read.raw, RawWorkbook):
        wrong += invented(data, read.raw)
    as_table(data, None)
    if wrong:
        raise NotAsItShouldBeError("; ".join(wrong))
    return read


def _answers(data: bytes) -> object:
    """Understand a text as each kind of answer; its first line is the cell's number format."""
    number_format, _, text = data.decode("utf-8", "replace").partition("\n")
    for quantity in quantities():
        for value in (text, _number(text)):
            cell = RawCell(value, number_format, error=False, formula="", cell="a!A1")
            understood = understand(quantity, cell)
            for language in ("en", "ru", "uk"):
                for said in getattr(understood, "remarks", ()):
                    Words(language).say(said)
            cell_text(cell)
    return text or "nothing"


def _number(text: str) -> float:
    with suppress(ValueError):
        return float(text)
    return float(len(text))


def _roster(data: bytes) -> object:
    return read_roster(NamedBytes("roster.csv", data))


def _roster_workbook(data: bytes) -> object:
    # What opens it in a worker has limits of its own; here it is the reader alone that is tried.
    return as_table(data, None) or "an empty table"


def _worksheet(data: bytes) -> object:
    return fill_worksheet(read_worksheet(NamedBytes("work.csv", data)), (), lambda _: "").content


def _gradebook(data: bytes) -> object:
    return fill_gradebook(NamedBytes("grades.csv", data), (), "").content


def _works(data: bytes) -> object:
    """Read every member that may be read; no two of them have one name."""
    path = _folder() / "works.zip"
    path.write_bytes(data)
    is_bundle(path)
    members = [one for one in members_of(path) if one.unusable is None]
    if len({one.name for one in members}) != len(members):
        raise NotAsItShouldBeError([one.name for one in members])
    pattern = path_pattern("{name}/{id}*.xlsx", ("s01", "12"))
    for one in members:
        platform_part(one.name)
        pattern.part_of(one.name)
        why_not(Path(one.name))
        with suppress(UnreadableMemberError):
            read_member(path, one.place)
    return path


@functools.cache
def _sound_course() -> Path:
    root = _folder() / "course"
    empty_course(root, bytes(32), Words("en"))
    return root


def _course(data: bytes) -> object:
    """Read and check a course of which one file is replaced; the first line names it."""
    name, _, text = data.partition(b"\n")
    root, asked = _sound_course(), name.decode("utf-8", "replace")
    if asked not in DECLARED:
        return asked or "no file"
    path = root / asked
    before = path.read_bytes()
    path.write_bytes(text)
    try:
        course, problems = read_course(root)
        if isinstance(course, Course):
            problems = [*problems, *check_course(course), *read_policy(course)[1]]
    finally:
        path.write_bytes(before)
    for language in ("en", "ru", "uk"):
        for one in problems:
            Words(language).say(one.what)
    return problems or "a sound course"


_RESULTS: Final = (SolutionResult, VariantsResult, CheckResult, GradesResult)
_WISHES: Final = (RegradeWish, PublishingReason, RegradingWish, UndoingWish, MarkWish)


def _results(data: bytes) -> object:
    """Read JSON as each of the results that programs may bring back."""
    plain = _json(data)
    for kind in _RESULTS:
        with suppress(GripcourseError):
            kind.from_dict(plain)
    return plain is None or True


def _bodies(data: bytes) -> object:
    """Read JSON as each of the wishes that programs send."""
    plain = _json(data)
    return [usable(kind, plain) for kind in _WISHES] if isinstance(plain, dict) else "no object"


def _json(data: bytes) -> dict[str, object]:
    try:
        plain = json.loads(data)
    except (ValueError, RecursionError):
        return {}
    return plain if isinstance(plain, dict) else {"schema": plain}


def _drawing(data: bytes) -> object:
    try:
        return picture_of(data, "drawing.dxf", 1)
    except Exception as fault:  # noqa: BLE001 (a worker answers that; see `web.pictures`)
        return fault


def _declared() -> tuple[str, ...]:
    root = _sound_course()
    found = (one.relative_to(root).as_posix() for one in root.rglob("*"))
    return tuple(sorted(one for one in found if one.endswith((".toml", ".csv"))))


DECLARED: Final = _declared()


READERS: Final[Mapping[str, Reader]] = {
    "workbook": Reader((archive(PARTS, zipfile.ZIP_STORED),), _workbook, Form.PACKED),
    "answers": Reader(tuple(one.encode() for one in TYPED), _answers, Form.HEADED),
    "roster": Reader(((ROOT / "variants" / "roster.csv").read_bytes(),), _roster),
    "roster_workbook": Reader((archive(PARTS, zipfile.ZIP_STORED),), _roster_workbook, Form.PACKED),
    "worksheet": Reader((WORKSHEET.encode(), WORKSHEET.encode("utf-16")), _worksheet),
    "gradebook": Reader((GRADEBOOK.encode("utf-8-sig"),), _gradebook),
    "works": Reader((works_of_many(),), _works, Form.PACKED),
    "course": Reader(
        tuple(f"{one}\n".encode() + (_sound_course() / one).read_bytes() for one in DECLARED),
        _course,
        Form.HEADED,
    ),
    "results": Reader((solution(), grades()), _results, Form.JSON),
    "bodies": Reader(
        (
            b'{"item": "force", "sentence": "why"}',
            b'{"seen": "x", "why": "y", "allow_lower": true}',
            b'{"seen": "x", "lines": {"a": 0.5}, "credit": null, "comment": "", "override": false}',
        ),
        _bodies,
        Form.JSON,
    ),
    "drawing": Reader((drawn(),), _drawing),
}


if __name__ == "__main__":  # what `make` asks
    sys.stdout.write("\n".join(READERS) + "\n")
