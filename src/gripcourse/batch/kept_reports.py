"""What single files came to, kept as it comes: a batch that was stopped goes on where it was."""

import hashlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeAlias, TypeVar

from gripcourse.grading.known_by import KnownBy
from gripcourse.grading.model import Flag, Report
from gripcourse.likeness.cells import SparseTable
from gripcourse.likeness.issued import KeptTable
from gripcourse.machine.content import Readable, digest_of_content, shown_name
from gripcourse.machine.kept import read_value, write_value
from gripcourse.machine.kept_records import Find, RecordsFile, kept_records, new_records

_COMPARED = "compared.kept"
_ISSUED = "issued-{number}.kept"
_Found = TypeVar("_Found")

FlagsOf: TypeAlias = Mapping[str, tuple[Flag, ...]]
"""Flags by student."""


@dataclass(frozen=True, slots=True)
class KeptReports:
    """Reports of single files, before they are compared with each other.

    Attributes:
        folder: of these reports alone, named after all that a report is made from but its file.
        whose: by file, the student who handed it in, where a person says so.
        answered: by file and by the digest of what it held before, whose it was then.
        said: the same, as a person said.
        written: the file of what this run keeps, once there is anything.
    """

    folder: Path
    whose: Mapping[str, str]
    answered: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    said: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    written: list[RecordsFile] = field(default_factory=list)

    def of(self, files: Sequence[Readable]) -> Iterator[tuple[int, Report]]:
        """Yield what is known of files, with their places: the same bytes under the same name."""
        if not self.folder.is_dir():
            return
        with kept_records(self.folder) as find:
            for number, file in enumerate(files):
                report = self._known(file, find)
                if report is not None:
                    yield number, report

    def keep(self, file: Readable, report: Report) -> None:
        """Keep the report of a file under the digest of the bytes that it was made from.

        Raises:
            OSError: it cannot be written.
        """
        if not self.written:
            self.written.append(new_records(self.folder))
        name = shown_name(file)
        said = self._said(name, report.digest)
        if said is None and report.known_by is KnownBy.PERSON:
            said = self._answer(name, report.digest)
        self.written[0].add(_key(name, report.digest, said), report)

    def flags_of(self, digests: Iterable[str], find: Callable[[], FlagsOf]) -> FlagsOf:
        """Return the flags that comparing reports comes to; the last comparison is kept.

        Args:
            digests: of all that is compared, as it is before it.
            find: compares them, where an earlier run did not compare just these.
        """
        return self._last(_COMPARED, digests, find)

    def issued_values(self, about: str) -> KeptTable:
        """Return what returns the right values of what was issued; the last ones are kept.

        Args:
            about: of which versions they are and by which declarations, beside those of students
                who were issued to once.
        """

        def table(number: int, solve: Callable[[], SparseTable]) -> SparseTable:
            return self._last(_ISSUED.format(number=number), (about,), solve)

        return table

    def _last(self, name: str, about: Iterable[str], find: Callable[[], _Found]) -> _Found:
        """Return what was found last, if it was about just the same; else it is found, and kept."""
        key, path = _digest_of(about), self.folder / name
        kept = read_value(path)
        if isinstance(kept, _Last) and kept.key == key:
            known: _Found = kept.found
            return known
        found = find()
        # What was found is used all the same.
        with suppress(OSError):
            write_value(path, _Last(key, found))
        return found

    def _known(self, file: Readable, find: Find) -> Report | None:
        digest, name = digest_of_content(file), shown_name(file)
        if not digest:
            return None
        said = self._said(name, digest)
        found = find(_key(name, digest, said))
        answer = self._answer(name, digest) if said is None else None
        if answer is not None and not (isinstance(found, Report) and found.judged):
            found = find(_key(name, digest, answer))  # else it is graded with the answer
        return found if isinstance(found, Report) and found.digest == digest else None

    def _said(self, name: str, digest: str) -> str | None:
        """Return by what a word for whose a file is, of now or before, is kept; None for none."""
        before = self.said.get(name, {}).get(digest)
        return self.whose.get(name) or (None if before is None else f"said: {before}")

    def _answer(self, name: str, digest: str) -> str | None:
        """Return by what an earlier word for whose a file is is kept; None where there is none."""
        student = self.answered.get(name, {}).get(digest)
        return f"before: {student}" if student else None


def _key(name: str, digest: str, said: str | None) -> bytes:
    return hashlib.sha256(repr((name, digest, said)).encode()).digest()


def _digest_of(lines: Iterable[str]) -> str:
    digest = hashlib.sha256()
    for line in lines:
        digest.update(f"{line}\n".encode())
    return digest.hexdigest()


@dataclass(frozen=True, slots=True)
class _Last:
    """What was found last, and a digest of what it is about."""

    key: str
    found: Any
