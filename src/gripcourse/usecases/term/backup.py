"""A whole term in one file: course, key, register, gradebook, desk, and all that was handed in.

The file is a zip that any program opens. `manifest.json` names every other member with its size and
SHA-256; tables are text, so that a term moves from a file to PostgreSQL and back. The database is
read first and as one state; every file that it names was on the disk before, and is there still.
"""

import hashlib
import json
import sqlite3
import tempfile
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path, PurePosixPath
from typing import Final

from gripcourse.course.read import course_id
from gripcourse.errors import Problem, UsageError
from gripcourse.issuing.signature import key_path, read_keys
from gripcourse.issuing.store import read_register
from gripcourse.machine.database.copy import lines_of, our_tables, standing_still
from gripcourse.machine.database.home import address_path, exists, gradebook_path, home_of
from gripcourse.machine.database.migrate import NEWEST
from gripcourse.machine.database.opening import open_engine, refusals_named, without_password
from gripcourse.machine.enclosed import file_below, strange_files
from gripcourse.machine.files import expect_file, make_private, making
from gripcourse.machine.resources import COURSE_FOLDERS
from gripcourse.text.words import message

FORMAT: Final = 1
MANIFEST: Final = "manifest.json"
COURSE: Final = "course/"
TABLES: Final = "tables/"
LINES: Final = ".jsonl"
PRIVATE: Final = "private"
BESIDE: Final = (".gitignore", "README.md")
"""Files beside the folders of a course that belong to it."""

_PORTION: Final = 1 << 20
_EARLIEST: Final = (1980, 1, 1, 0, 0, 0)  # of a zip; when it was made stands in the manifest


@dataclass(frozen=True, slots=True)
class PackedPart:
    """What a backup says of one of its files: size in bytes, and SHA-256."""

    size: int
    sha256: str


@dataclass(frozen=True, slots=True)
class Manifest:
    """What a backup says of itself: of which course, its tables' revision, and its members."""

    course: str
    revision: str
    members: Mapping[str, PackedPart]


@dataclass(frozen=True, slots=True)
class BackedUp:
    """What a backup holds: of which course, how many files, and the digest of the whole."""

    course: str
    files: int
    sha256: str


def back_up(root: Path, out: Path, now: datetime) -> BackedUp:
    """Write a whole term into one file, which only its owner may read: it has the key in it.

    Students may hand in and instructors may grade meanwhile.

    Args:
        root: folder of the course.
        out: file to make; missing folders above it are made.
        now: when it is done.

    Raises:
        UsageError: there is such a file already, or the course has a file that leads elsewhere.
        GripcourseError: the course's main file, its key, its register or its database cannot be
            used.
        OSError: a file cannot be read or written.
    """
    if out.exists():
        what, remedy = message("This exists already."), message("Name another place.")
        raise UsageError([Problem(str(out), "", what, remedy)])
    expect_file(out)
    strange = strange_files(root, (*COURSE_FOLDERS, PRIVATE))
    if strange:
        raise UsageError(strange)
    # A term is kept also while somebody is amid a change that the course does not bear.
    course = course_id(root)
    # What cannot be restored is no backup: every signature is verified.
    read_keys(key_path(root))
    read_register(root, course)
    out.parent.mkdir(parents=True, exist_ok=True)
    with making(out) as temporary:
        make_private(temporary)
        with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as archive:
            members = {**_add_tables(archive, root), **_add_files(archive, root)}
            manifest = {
                "format": FORMAT,
                "course": course,
                "made_at": now.isoformat(),
                "revision": NEWEST,
                "members": {name: asdict(one) for name, one in sorted(members.items())},
            }
            text = json.dumps(manifest, ensure_ascii=False, indent=1)
            _add(archive, MANIFEST, [text.encode() + b"\n"])
        with temporary.open("rb") as written:
            digest = hashlib.file_digest(written, "sha256").hexdigest()
    return BackedUp(course, len(members), digest)


def _add_tables(archive: zipfile.ZipFile, root: Path) -> dict[str, PackedPart]:
    place = home_of(root)
    if not exists(place):
        return {}
    engine = open_engine(place)
    with refusals_named(without_password(engine.url)), standing_still(engine) as connection:
        return {
            name: _add(archive, name, lines_of(connection, table))
            for table in our_tables(connection)
            for name in (f"{TABLES}{table.name}{LINES}",)
        }


def _add_files(archive: zipfile.ZipFile, root: Path) -> dict[str, PackedPart]:
    return {
        name: _add(archive, name, _content(root / path))
        for path in _files_of(root)
        for name in (f"{COURSE}{path}",)
    }


def is_sound(inside: PurePosixPath) -> bool:
    """Tell whether a path, relative to a term's folder, is one of a term and leads nowhere else."""
    if str(inside) in BESIDE:
        return True
    folder, *below = inside.parts
    if folder not in {*COURSE_FOLDERS, PRIVATE} or not below or is_database(inside):
        return False
    try:
        for name in below:
            file_below(Path(), name)
    except ValueError:
        return False
    return True


def is_database(inside: PurePosixPath) -> bool:
    """Tell whether a file is the database, a copy of it, or the line that names another."""
    address, database = address_path(Path()), gradebook_path(Path())
    return str(inside) == str(address) or str(inside).startswith(str(database))


def _files_of(root: Path) -> Iterator[PurePosixPath]:
    """Yield the files of a term, relative to its folder; the database is none of them."""
    for folder in (*COURSE_FOLDERS, PRIVATE):
        for path in sorted((root / folder).rglob("*")):
            inside = PurePosixPath(path.relative_to(root).as_posix())
            # Hidden ones are what a killed program left half-written.
            hidden = any(one.startswith(".") for one in inside.parts)
            if hidden or is_database(inside) or not path.is_file():
                continue
            if not is_sound(inside):
                what = message("No other system can have a file of this name.")
                raise UsageError([Problem(str(inside), "", what, message("Give it another name."))])
            yield inside
    yield from (PurePosixPath(name) for name in BESIDE if (root / name).is_file())


def _content(path: Path) -> Iterator[bytes]:
    if path.suffix == ".sqlite":
        yield _standing(path)
        return
    with path.open("rb") as stream:
        while portion := stream.read(_PORTION):
            yield portion


def _standing(path: Path) -> bytes:
    """Return one state of a small database that others may be writing to."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / path.name
        source = f"{path.absolute().as_uri()}?mode=ro"
        try:
            with (
                closing(sqlite3.connect(source, uri=True)) as old,
                closing(sqlite3.connect(copy)) as new,
            ):
                old.backup(new)
        except sqlite3.Error as fault:
            raise OSError(None, str(fault), str(path)) from fault
        return copy.read_bytes()


def _add(archive: zipfile.ZipFile, name: str, portions: Iterable[bytes]) -> PackedPart:
    digest, size = hashlib.sha256(), 0
    info = zipfile.ZipInfo(name, _EARLIEST)
    info.compress_type = zipfile.ZIP_DEFLATED
    info.external_attr = 0o600 << 16
    with archive.open(info, "w", force_zip64=True) as stream:
        for portion in portions:
            stream.write(portion)
            digest.update(portion)
            size += len(portion)
    return PackedPart(size, digest.hexdigest())
