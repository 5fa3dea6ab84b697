"""A term from its backup: verified wholly, written beside, and put in place in one step.

A backup may be damaged, and may be somebody's trap: every member is written under a name that we
have looked at, to the size that was declared, and compared with its digest; then every signature of
the register is verified. Whatever fails leaves nothing.
"""

import hashlib
import json
import secrets
import shutil
import zipfile
import zlib
from contextlib import suppress
from pathlib import Path, PurePosixPath
from typing import Final

from sqlalchemy import Connection

from gripcourse.errors import Problem, UsageError
from gripcourse.issuing.register import verified
from gripcourse.issuing.rows import read_rows
from gripcourse.issuing.signature import key_path, read_keys
from gripcourse.machine.database.copy import add_lines, holds_anything, our_tables
from gripcourse.machine.database.home import address_path, gradebook_path
from gripcourse.machine.database.migrate import NEWEST, REVISIONS, bring_up, revision_of
from gripcourse.machine.database.opening import (
    engine_of,
    refusals_named,
    without_password,
    writing,
)
from gripcourse.machine.files import make_private, make_private_folder, write_text
from gripcourse.text.words import Message, message
from gripcourse.usecases.term.backup import (
    COURSE,
    FORMAT,
    LINES,
    MANIFEST,
    TABLES,
    Manifest,
    PackedPart,
    is_sound,
)

_LARGEST_MANIFEST: Final = 64_000_000  # bytes; half a million members
_PORTION: Final = 1 << 20
_TOKEN_BYTES: Final = 4
_DAMAGE: Final = (
    zipfile.BadZipFile,
    zlib.error,
    EOFError,
    NotImplementedError,
    RuntimeError,
    ValueError,
    TypeError,
    KeyError,
    AttributeError,
)
_NOTHING: Final = message("Nothing was written. Take another copy of the backup.")


def restore(backup: Path, root: Path, place: str | None = None) -> Manifest:
    """Put a term back: its folder, and its database in a file or where a URL says.

    Args:
        backup: the file that `back_up` made.
        root: folder to make; it may be there if it is empty.
        place: URL of an empty database; None for the course's own file.

    Returns:
        What was restored.

    Raises:
        UsageError: there is something already, or the backup is damaged, strange or of a later
            program; nothing was changed.
        RegisterError: an entry of the register does not fit the key; nothing was changed.
        GradebookError: the database cannot be used; nothing was changed.
        OSError: a file cannot be read or written.
    """
    if root.exists() and (not root.is_dir() or any(root.iterdir())):
        what = message("There is something already.")
        raise _refusal(root, what, message("Name a new folder; nothing is ever overwritten."))
    root.parent.mkdir(parents=True, exist_ok=True)
    beside = root.with_name(f".{root.name}.{secrets.token_hex(_TOKEN_BYTES)}")
    make_private_folder(beside)
    tables = beside / "tables"
    try:
        manifest = _unpack(backup, beside / "course", tables)
        _put_in_place(backup, manifest, beside, root, place)
    finally:
        shutil.rmtree(beside, ignore_errors=True)
    return manifest


def _unpack(backup: Path, course: Path, tables: Path) -> Manifest:
    """Write the members below two folders, each compared with its digest."""
    name = MANIFEST
    try:
        with zipfile.ZipFile(backup) as archive:
            manifest = _manifest(backup, archive)
            names = sorted(one.filename for one in archive.infolist())
            if names != sorted([MANIFEST, *manifest.members]):
                raise ValueError(names)
            # Before anything is written.
            targets: dict[str, Path] = {}
            for name in manifest.members:
                targets[name] = _target(name, course, tables)
            _expect_room(course.parent, manifest)
            make_private_folder(course / "private")
            make_private_folder(tables)
            for name, member in manifest.members.items():
                _write_member(archive, name, member, targets[name])
    except _DAMAGE as fault:
        what = message("The backup is damaged, or is none: {member}.", member=name)
        raise _refusal(backup, what, _NOTHING) from fault
    return manifest


def _manifest(backup: Path, archive: zipfile.ZipFile) -> Manifest:
    with archive.open(MANIFEST) as stream:
        plain = json.loads(stream.read(_LARGEST_MANIFEST))
    if plain["format"] != FORMAT or plain["revision"] not in REVISIONS:
        what = message("A later version of the program made this backup.")
        raise _refusal(backup, what, message("Restore it with that version."))
    members = {
        str(name): PackedPart(int(one["size"]), str(one["sha256"]))
        for name, one in plain["members"].items()
    }
    return Manifest(str(plain["course"]), str(plain["revision"]), members)


def _target(name: str, course: Path, tables: Path) -> Path:
    """Return where a member goes.

    Raises:
        ValueError: it must not go anywhere.
    """
    inside = PurePosixPath(name.removeprefix(COURSE))
    if name == f"{COURSE}{inside}" and is_sound(inside):
        return course / inside
    table = name.removeprefix(TABLES).removesuffix(LINES)
    if name == f"{TABLES}{table}{LINES}" and table.isidentifier():
        return tables / table
    raise ValueError(name)


def _write_member(archive: zipfile.ZipFile, name: str, member: PackedPart, target: Path) -> None:
    """Write a member.

    Raises:
        ValueError: it is not what the manifest says.
    """
    digest, left = hashlib.sha256(), member.size
    if name.startswith((f"{COURSE}private/", TABLES)):
        make_private_folder(target.parent)
        make_private(target)
    else:
        target.parent.mkdir(parents=True, exist_ok=True)
    with archive.open(name) as stream, target.open("wb") as file:
        while portion := stream.read(min(_PORTION, left + 1)):
            left -= len(portion)
            if left < 0:
                raise ValueError(name)
            file.write(portion)
            digest.update(portion)
    if left or digest.hexdigest() != member.sha256:
        raise ValueError(name)


def _expect_room(folder: Path, manifest: Manifest) -> None:
    needed = sum(one.size for one in manifest.members.values())
    if needed > shutil.disk_usage(folder).free:
        what = message("The disk has no room for {size} bytes.", size=needed)
        raise _refusal(folder, what, message("Name a folder on another disk."))


def _put_in_place(
    backup: Path, manifest: Manifest, beside: Path, root: Path, place: str | None
) -> None:
    """Fill the database and let the folder appear: both, or neither."""
    course, own = beside / "course", gradebook_path(beside / "course")
    if place is None:
        make_private(own)
    else:
        write_text(address_path(course), f"{place}\n", private=True)
    engine = engine_of(str(own) if place is None else place)
    named = str(root) if place is None else without_password(engine.url)
    moved = False
    try:
        with refusals_named(named), writing(engine) as connection:
            _fill(connection, backup, manifest, beside, named)
            if place is not None:
                course.rename(root)
                moved = True
        if place is None:
            course.rename(root)
    except BaseException:
        if moved:
            # The database kept nothing, so this must not stay either.
            with suppress(OSError):
                shutil.rmtree(root)
        raise


def _fill(
    connection: Connection, backup: Path, manifest: Manifest, beside: Path, named: str
) -> None:
    """Make the tables as they were, fill them, and bring them up; then verify the register."""
    found = revision_of(connection)
    if holds_anything(connection) or found not in {None, manifest.revision}:
        what = message("There is something already.")
        remedy = message("Name an empty database; nothing is ever overwritten.")
        raise _refusal(named, what, remedy)
    if found is None:
        bring_up(connection, None, manifest.revision)
    ours = {table.name: table for table in our_tables(connection)}
    written = {path.name: path for path in (beside / "tables").iterdir()}
    name = ""
    try:
        if not set(written) <= set(ours):
            raise ValueError(sorted(set(written) - set(ours)))
        for name in (name for name in ours if name in written):
            with written[name].open("rb") as lines:
                add_lines(connection, ours[name], lines)
    except _DAMAGE as fault:
        what = message("The backup is damaged, or is none: {member}.", member=name)
        raise _refusal(backup, what, _NOTHING) from fault
    if manifest.revision != NEWEST:
        bring_up(connection, manifest.revision)
    register = read_rows(connection, manifest.course, str(backup))
    key, *former = read_keys(key_path(beside / "course"))
    verified(register, key, str(backup), former)


def _refusal(place: Path | str, what: Message, remedy: Message) -> UsageError:
    return UsageError([Problem(str(place), "", what, remedy)])
