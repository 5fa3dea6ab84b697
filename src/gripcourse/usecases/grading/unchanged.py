"""What an earlier run into the same folder found out and printed, and whether it still holds.

Nothing is compared by its time. A report of a file is kept under a digest of all that it is made
from; beside a document stands a digest of all that it says. Whatever changes, the digest is another
one and what was kept is not found.
"""

import hashlib
import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import date
from itertools import chain
from pathlib import Path
from typing import Final

from gripcourse.batch.context import GradingContext
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.grading.folded import digest_of_report
from gripcourse.grading.model import Report
from gripcourse.machine.files import make_private_folder, write_text
from gripcourse.machine.office import office_identity
from gripcourse.usecases.grading.lines_before import LinesBefore
from gripcourse.usecases.grading.versions import EARLIER, digest_of_texts, versions_of

_PRINTED: Final = "printed"


@dataclass(frozen=True, slots=True)
class TakenOver:
    """How many results of files, and how many students' reports, are those of an earlier run."""

    results: int = 0
    reports: int = 0


@dataclass(frozen=True, slots=True)
class PrintedBefore:
    """What the documents of a folder were made from.

    Attributes:
        folder: of the notes, one for each document.
        made_with: digest of all that every document is made with.
    """

    folder: Path
    made_with: str

    def stands(self, path: Path, made_from: str) -> bool:
        """Tell whether a document is there, untouched, and was made from just this."""
        try:
            before, content, _ = _read_note(self._note(path))
            # The file is long: it is read where nothing else speaks against it.
            return before == self._before(made_from) and content == _content_of(path)
        except (OSError, UnicodeDecodeError):
            return False

    def note(self, path: Path, made_from: str, points: str = "") -> None:
        """Note what a document was made from, after it was written.

        Args:
            path: of the document.
            made_from: digest of what it is made from.
            points: digest of those it tells; empty where it is no student's report.

        Raises:
            OSError: the document cannot be read, or the note cannot be written.
        """
        noted = f"{self._before(made_from)}\n{_content_of(path)}\n{points}"
        write_text(self._note(path), noted, private=True)

    def lines_of(self, path: Path) -> LinesBefore:
        """Return the lines of a table that an earlier run wrote."""
        return LinesBefore(self.folder / f"{path.name}.lines", self.made_with)

    def _note(self, path: Path) -> Path:
        return _note_in(self.folder, path)

    def _before(self, made_from: str) -> str:
        return digest_of_texts([self.made_with, made_from])


def points_noted(path: Path) -> str:
    """Return the digest of the points that a student's report tells.

    Empty where nobody noted it, or the report was written by others since.
    """
    try:
        _, content, points = _read_note(_note_in(path.parent.parent / EARLIER / _PRINTED, path))
        return points if points and content == _content_of(path) else ""
    except (OSError, UnicodeDecodeError):
        return ""


def _note_in(folder: Path, path: Path) -> Path:
    return folder / f"{path.name}.sha256"


def _read_note(path: Path) -> tuple[str, str, str]:
    """Return what a document was made from, its content and its points; each may be empty."""
    lines = [*path.read_text(encoding="utf-8").split("\n"), "", ""]
    return lines[0], lines[1], lines[2]


def _content_of(path: Path) -> str:
    # The table of a large batch takes more room than all of its reports: piece by piece.
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


@dataclass(frozen=True, slots=True)
class Earlier:
    """What an earlier run left, where this one leaves its own for the next."""

    reports: KeptReports
    printed: PrintedBefore


def told_of(reports: Iterable[Report | str]) -> str:
    """Return a digest of all that reports say, and of what else a document says."""
    return digest_of_texts(
        digest_of_report(one) if isinstance(one, Report) else one for one in reports
    )


def open_earlier(
    out: Path,
    context: GradingContext,
    versions: str,
    *,
    workers: int,
    day: date | None = None,
    afresh: bool = False,
) -> Earlier | None:
    """Open what an earlier run left among its results; what no longer holds is removed.

    Args:
        out: folder of the results.
        context: the course and its policy as they were loaded from its folder, and the register.
        versions: of the course, taken before it was loaded.
        workers: how many processes grade; without any, fewer kinds of files can be read.
        day: that documents must bear; None where any day will do on which they were printed.
        afresh: whether all of it is to be forgotten.

    Returns:
        What is there; None where the course changed while it was loaded, and nobody can tell what
        the results are made from.

    Raises:
        OSError: the folder cannot be written.
    """
    folder = out / EARLIER
    if afresh:
        shutil.rmtree(folder, ignore_errors=True)
    if versions_of(context.course.root) != versions:
        return None
    make_private_folder(folder)
    pattern = context.pattern and context.pattern.written
    judged_by = context.either_version, sorted(context.either_for), sorted(context.declared)
    former = sorted(context.former.items())
    office = (office_identity(context.office), context.recalculate) if workers else None
    decides = (versions, *map(repr, (judged_by, pattern, office, former)))
    # One person after the other: all of them in one text are larger than anything else here.
    people = (
        repr((name, issued[name]))
        for issued in (context.register, context.earlier)
        for name in sorted(issued)
    )
    results = folder / digest_of_texts(chain(decides, people))
    for old in folder.iterdir():
        if old not in {results, folder / _PRINTED}:
            shutil.rmtree(old, ignore_errors=True)
    made_with = digest_of_texts([versions, repr(day)])
    reports = KeptReports(results, context.whose, context.answered, context.said)
    return Earlier(reports, PrintedBefore(folder / _PRINTED, made_with))
