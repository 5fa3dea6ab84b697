"""Which files of a batch are looked at; every other one is named with the reason.

A name tells what a file is, and where it says that it is no workbook, so does its content.
A zip that is named itself is looked into, as a learning platform hands it out. One inside a folder
or inside another zip may be a student's own bundle: it is named and a person unpacks it.
"""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path, PurePath
from typing import Final

from gripcourse.errors import Problem, UsageError
from gripcourse.machine.archive import Unusable, damaged_zip, is_bundle, members_of
from gripcourse.machine.content import PackedFile, Readable, pure_path, shown_name
from gripcourse.machine.shelf import Shelved
from gripcourse.machine.spreadsheet.by_content import is_workbook
from gripcourse.text.shown import first_of
from gripcourse.text.words import Message, message
from gripcourse.usecases.grading.versions import EARLIER

# What people hand in as a workbook: the reader says what is wrong with those that are none.
WORKBOOKS: Final = frozenset({".xlsx", ".xlsm", ".xls", ".xlsb", ".ods", ".csv", ".numbers"})
_ZIP: Final = ".zip"
_ARCHIVES: Final = frozenset({_ZIP, ".rar", ".7z", ".tar", ".gz", ".tgz", ".bz2", ".xz"})
_TEXTS: Final = frozenset({".docx", ".doc", ".odt", ".rtf", ".pages", ".txt", ".html", ".htm"})
_NAMED: Final = 5  # that a refusal of a whole folder names


class WhyNot(StrEnum):
    """Why a file was not looked at; the value stands in JSON and in tables."""

    ARCHIVE = "archive"
    TEXT_DOCUMENT = "text_document"
    NO_EXTENSION = "no_extension"
    LOCK_FILE = "lock_file"
    HIDDEN = "hidden"
    HIDDEN_WORKBOOK = "hidden_workbook"
    LINK = "link"
    CLOSED = "closed"
    NO_FILE = Unusable.NO_FILE
    UNSAFE_PATH = Unusable.UNSAFE_PATH
    ENCRYPTED = Unusable.ENCRYPTED
    METHOD = Unusable.METHOD
    TOO_LARGE = Unusable.TOO_LARGE
    OTHER = "other"


REASONS: Final[Mapping[WhyNot, Message]] = {
    WhyNot.ARCHIVE: message("An archive; unpack it, there may be a workbook in it."),
    WhyNot.TEXT_DOCUMENT: message("A text document, not a workbook."),
    WhyNot.NO_EXTENSION: message(
        "Its name has no extension, and its content is that of no .xlsx workbook; ask what it is."
    ),
    WhyNot.LOCK_FILE: message(
        "The lock file of an open workbook; the workbook itself may not have been handed in."
    ),
    WhyNot.HIDDEN: message("A hidden file of some program."),
    WhyNot.HIDDEN_WORKBOOK: message(
        "A workbook in a hidden file; if it was handed in, take the full stop off its name."
    ),
    WhyNot.LINK: message(
        "A link to another place, where anything may lie; put the file itself here."
    ),
    WhyNot.CLOSED: message(
        "A folder that may not be looked into; allow it, there may be works in it."
    ),
    WhyNot.NO_FILE: message("No file that can be read: a broken link or a device."),
    WhyNot.UNSAFE_PATH: message(
        "Its name in the archive leads out of it; nobody packs so by chance."
    ),
    WhyNot.ENCRYPTED: message("It is protected by a password inside the archive."),
    WhyNot.METHOD: message(
        "It is packed in a way that is not read; unpack the archive and name the folder."
    ),
    WhyNot.TOO_LARGE: message("It is larger than any workbook that is looked at."),
    WhyNot.OTHER: message("Not a workbook, for example a drawing."),
}
"""What each means, for a person."""

_MAY_BE_WORK: Final = frozenset(WhyNot) - {
    WhyNot.LOCK_FILE,
    WhyNot.HIDDEN,
    WhyNot.NO_FILE,
    WhyNot.OTHER,
}

# A workbook may be called like one of these.
_MAY_BE_CALLED_SO: Final = frozenset(
    {WhyNot.ARCHIVE, WhyNot.TEXT_DOCUMENT, WhyNot.NO_EXTENSION, WhyNot.OTHER}
)


@dataclass(frozen=True, slots=True)
class PassedOver:
    """A file that was found and not looked at."""

    file: str
    why: WhyNot

    @property
    def needs_person(self) -> bool:
        """Whether a student may have meant it as the work."""
        return self.why in _MAY_BE_WORK


@dataclass(frozen=True, slots=True)
class Collected:
    """The files of a batch: those to grade, and all others that were found."""

    files: Sequence[Readable]
    passed_over: tuple[PassedOver, ...]


def collect(paths: Iterable[Path]) -> Collected:
    """Find the workbooks under files, folders and zips, sorted inside a folder or a zip.

    A file that is named itself is graded whatever it is called, but for a zip: one that is neither
    works nor a workbook is a download that broke off, and nobody's work.

    Raises:
        UsageError: for a path that does not exist, a damaged zip, or a batch without any workbook.
    """
    paths = tuple(paths)
    files: dict[Readable, None] = {}
    passed_over: dict[Readable, PassedOver] = {}
    problems: list[Problem] = []
    for path in paths:
        is_zip = is_bundle(path)
        if path.is_dir() or is_zip:
            for one, why in _packed(path) if is_zip else _inside(path):
                if why is None:
                    files[one] = None
                else:
                    passed_over[one] = PassedOver(shown_name(one), why)
        elif path.is_file() and path.suffix.lower() == _ZIP and not is_workbook(path):
            problems.append(damaged_zip(path))
        elif path.is_file():
            files[path] = None
        else:
            problems.append(_problem(path, message("There is no such file or folder.")))
    left = tuple(one for path, one in passed_over.items() if path not in files)
    if not files and not problems:
        problems = [_problem(path, _no_workbook(left)) for path in paths]
    if problems:
        raise UsageError(problems)
    return Collected(Shelved(files), left)


def why_not(file: Readable) -> WhyNot | None:
    """Tell why a file is not looked at; None where it is: by its name, or by its content."""
    why = _by_name(pure_path(file))
    if why is WhyNot.HIDDEN:
        return WhyNot.HIDDEN_WORKBOOK if is_workbook(file) else why
    return None if why in _MAY_BE_CALLED_SO and is_workbook(file) else why


def _by_name(path: PurePath) -> WhyNot | None:
    name, suffix = path.name, path.suffix.lower()
    if name.startswith(("~$", ".~lock.")):
        return WhyNot.LOCK_FILE
    if name.startswith("."):
        return WhyNot.HIDDEN
    if suffix in WORKBOOKS:
        return None
    if suffix in _ARCHIVES:
        return WhyNot.ARCHIVE
    if suffix in _TEXTS:
        return WhyNot.TEXT_DOCUMENT
    return WhyNot.OTHER if suffix else WhyNot.NO_EXTENSION


def _packed(archive: Path) -> Iterator[tuple[Readable, WhyNot | None]]:
    for one in members_of(archive):
        file = PackedFile(archive, one.place, one.name)
        yield file, why_not(file) if one.unusable is None else WhyNot(one.unusable.value)


def _inside(folder: Path) -> Iterator[tuple[Readable, WhyNot | None]]:
    closed: list[Path] = []
    found: list[Path] = []
    for place, folders, files in os.walk(
        folder, onerror=lambda fault: closed.append(Path(str(fault.filename)))
    ):
        if not os.access(place, os.X_OK):  # its names may be read, nothing else
            closed.append(Path(place))
            folders.clear()
            continue
        found += (Path(place, name) for name in (*folders, *files))
    for path in sorted({*found, *closed}):
        # What we keep of an earlier run is nobody's work, wherever the results were put.
        if EARLIER in path.parts:
            continue
        # Whoever made the folder may have laid a link to any file of ours, or of another student's.
        if path.is_symlink() and path != folder:
            yield path, WhyNot.LINK
        elif path in closed:
            yield path, WhyNot.CLOSED
        elif not path.is_dir():
            yield path, why_not(path) if path.is_file() else WhyNot.NO_FILE


def _no_workbook(found: tuple[PassedOver, ...]) -> Message:
    if not found:
        return message("There is no workbook in it.")
    said = message(
        "There is no workbook in it, only {count} other files: {names}.",
        count=len(found),
        names=first_of([PurePath(one.file).name for one in found], _NAMED),
    )
    reasons = {one.why for one in found}
    if len(reasons) > 1:
        return said
    return message("{what} {more}", what=said, more=REASONS[reasons.pop()])


def _problem(path: Path, what: Message) -> Problem:
    return Problem(
        str(path), "", what, message("Name a workbook, or a folder or a zip with workbooks.")
    )
