"""The files that a course is made of at one moment, and which of them concern one of its schemes.

A scheme is judged from its own folder, from the parts that it and its options name, from the
catalogues that any of these names, and from what all schemes share. Nothing else of the course is
shown to who judges it: see `alone`.
"""

import hashlib
import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from gripcourse.course.compose import all_part_ids
from gripcourse.course.implied_series import is_implied
from gripcourse.course.model import Course, Scheme
from gripcourse.machine.enclosed import read_within_bounds
from gripcourse.machine.kept import digest_of
from gripcourse.machine.resources import REQUIRED_FOLDERS, VARIANTS

SCHEMES: Final = f"{VARIANTS}/schemes/"
PARTS: Final = f"{VARIANTS}/sections/"
CATALOGUES: Final = f"{VARIANTS}/catalogues/"
SPACES: Final = f"{VARIANTS}/spaces/"
_WORDS: Final = re.compile(rb"\w+")
_ESCAPE: Final = re.compile(rb"\\[uUx]")  # a name may be written with such, too


@dataclass(frozen=True, slots=True)
class SourceFile:
    """A file as it was when it was read.

    Attributes:
        digest: of its content.
        changed: when anything of it changed last, of the clock of the disk in nanoseconds.
        named: the ids of catalogues and schemes that occur in it.
    """

    digest: str
    changed: int
    named: frozenset[str]


@dataclass(frozen=True, slots=True)
class SourceFiles:
    """All files of a course, by their names below its folder; two are equal where nothing changed.

    Attributes:
        files: by name.
    """

    files: Mapping[str, SourceFile]

    def shared(self, left_out: Collection[str] = ()) -> list[str]:
        """Return the names of the files that belong to no scheme more than to another.

        Args:
            left_out: files, and folders with a slash at their end, that are not looked into.
        """
        return [
            name
            for name in self.files
            if not (_is_of_few(name) or name.startswith(tuple(left_out)))
        ]

    def of_scheme(
        self, scheme: Scheme, shared: Collection[str], left_out: Collection[str] = ()
    ) -> list[str]:
        """Return the names of the files that a scheme is judged from, with those that all share."""
        parts = {f"{PARTS}{part}.toml" for part in all_part_ids(scheme)}
        own = f"{SCHEMES}{scheme.id}/"
        found = [*shared, *(one for one in self.files if one in parts or one.startswith(own))]
        found += [] if SPACES in left_out else self.spaces_of(scheme.id)
        named = {id_ for one in found for id_ in self.files[one].named}
        return [*found, *(one for one in self.catalogues() if Path(one).stem in named)]

    def spaces_of(self, scheme: str) -> list[str]:
        """Return the names of the files that may say what variants of a scheme are drawn from."""
        spaces = (one for one in self.files if one.startswith(SPACES))
        return [one for one in spaces if scheme in self.files[one].named]

    def are_spaces_named(self, schemes: Collection[str]) -> bool:
        """Tell whether each file of spaces names a scheme, so that none is passed over."""
        spaces = (one for one in self.files if one.startswith(SPACES))
        return all(not self.files[one].named.isdisjoint(schemes) for one in spaces)

    def digest(self, names: Iterable[str], *more: str) -> str:
        """Digest some of the files, the program and what else a judgement depends on."""
        told = (f"{name}\0{self.files[name].digest}" for name in sorted(set(names)))
        whole = "\0\0".join([_program(), *more, *told])
        return hashlib.sha256(whole.encode()).hexdigest()

    def alone(self, course: Course, schemes: Iterable[Scheme], files: Collection[str]) -> Course:
        """Return a course as if it had some schemes only, with what these are judged from.

        Args:
            course: as it was read from these files.
            schemes: some of its schemes.
            files: see `of_scheme`.
        """
        kept = {one.id: one for one in schemes}
        parts, listed = {part for one in kept.values() for part in all_part_ids(one)}, set(files)
        return replace(
            course,
            schemes=kept,
            parts={name: part for name, part in course.parts.items() if name in parts},
            catalogues={
                name: one
                for name, one in course.catalogues.items()
                if f"{CATALOGUES}{name}.csv" in listed or is_implied(one)
            },
        )

    def are_unchanged(self, root: Path) -> bool:
        """Tell whether a course still consists of these files, and nothing of them has changed."""
        found = _contents(root)
        return found is not None and {
            name: (changed, hashlib.sha256(data).hexdigest())
            for name, (changed, data) in found.items()
        } == {name: (one.changed, one.digest) for name, one in self.files.items()}

    def catalogues(self) -> Iterator[str]:
        """Yield the names of the files of all catalogues."""
        return (name for name in self.files if _is_in(name, CATALOGUES, ".csv"))


def source_files(root: Path) -> SourceFiles | None:
    """Read all files of a course; None: some cannot be read, or a folder is a link.

    Args:
        root: of the course.
    """
    read = _contents(root)
    if read is None:
        return None
    ids = {Path(name).stem for name in read if _is_in(name, CATALOGUES, ".csv")}
    ids |= {name.removeprefix(SCHEMES).split("/")[0] for name in read if name.startswith(SCHEMES)}
    known = _Known.of(ids)
    return SourceFiles(
        {
            name: SourceFile(hashlib.sha256(data).hexdigest(), changed, known.in_text(data))
            for name, (changed, data) in read.items()
        }
    )


def _contents(root: Path) -> dict[str, tuple[int, bytes]] | None:
    """Return by name when each file of a course changed last, and its content; None as above."""
    try:
        below = [path for one in REQUIRED_FOLDERS for path in (root / one).rglob("*")]
        if any(path.is_symlink() and path.is_dir() for path in below):
            return None
        paths = {path.relative_to(root).as_posix(): path for path in below if path.is_file()}
        return {
            name: (path.stat().st_ctime_ns, read_within_bounds(path))
            for name, path in paths.items()
        }
    except OSError:
        return None


@dataclass(frozen=True, slots=True)
class _Known:
    """The names that are looked for in files: those that are one word, and the others.

    Attributes:
        words, others: by how they are written.
    """

    words: Mapping[bytes, str]
    others: Mapping[bytes, str]

    @staticmethod
    def of(ids: Iterable[str]) -> "_Known":
        known = {os.fsencode(one): one for one in ids}
        words = {written: one for written, one in known.items() if _WORDS.fullmatch(written)}
        others = {written: one for written, one in known.items() if written not in words}
        return _Known(words, others)

    def in_text(self, data: bytes) -> frozenset[str]:
        """Return which may be meant in a text: those that occur, all where some are escaped."""
        if _ESCAPE.search(data):
            return frozenset((*self.words.values(), *self.others.values()))
        words = self.words.keys() & set(_WORDS.findall(data))
        others = (one for written, one in self.others.items() if written in data)
        return frozenset((*(self.words[one] for one in words), *others))


def _is_of_few(name: str) -> bool:
    """Tell whether a file is of one scheme, or of those alone that name it."""
    return (
        name.startswith((SCHEMES, SPACES))
        or _is_in(name, PARTS, ".toml")
        or _is_in(name, CATALOGUES, ".csv")
    )


def _is_in(name: str, folder: str, suffix: str) -> bool:
    return name.startswith(folder) and name.endswith(suffix) and "/" not in name[len(folder) :]


def _program() -> str:
    return digest_of(Path(), ())
