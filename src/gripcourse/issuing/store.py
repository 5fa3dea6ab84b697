"""The register in its database: read with every signature, extended by one program at a time.

Who issues reads and adds in one transaction, begun with the right to write. A program that issues
at the same time waits, or is refused by the primary key and tries again with what is there then. So
no entry is lost and no variant given twice.
"""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import chain, islice
from pathlib import Path
from typing import TypeAlias

from sqlalchemy import Connection, Engine

from gripcourse.errors import GradebookError, Problem, RegisterError
from gripcourse.issuing.allotment import Extended
from gripcourse.issuing.register import Register, verified
from gripcourse.issuing.register_file import old_register_path, read_register_file
from gripcourse.issuing.rows import (
    RowOfTable,
    add_rows,
    fetch_former_names,
    fetch_rows,
    other_courses,
    read_rows,
    register_of_rows,
    stream_entries,
)
from gripcourse.issuing.shelved import ShelvedRegister, shelved
from gripcourse.issuing.signature import key_path, read_keys
from gripcourse.issuing.withdrawal import Withdrawal
from gripcourse.issuing.withdrawal_rows import fetch_withdrawals
from gripcourse.machine.database.home import exists, gradebook_path, home_of
from gripcourse.machine.database.opening import (
    another_was_faster,
    open_engine,
    refusals_named,
    without_password,
    writing,
)
from gripcourse.text.words import message

_Kept: TypeAlias = tuple[Sequence[RowOfTable], tuple[Withdrawal, ...]]

# Each refusal means that somebody else got through, so a few tries per rival are enough.
_TRIES = 50


def read_register(root: Path, course_id: str) -> Register:
    """Read the register of a course; where nothing was issued yet, an empty one.

    The register of an earlier program is taken over first; its file stays as a copy.

    Args:
        root: folder of the course, with its key.
        course_id: of the course.

    Raises:
        RegisterError: an entry was changed or is damaged, the key is missing, or the register is
            of another course.
        GradebookError: the database cannot be used.
    """
    engine = _register_engine(root, course_id)
    if engine is None:
        return Register(course_id, ())
    with refusals_named(without_password(engine.url)), engine.connect() as connection:
        return _read(connection, engine, root, course_id)


def shelve_register(root: Path, course_id: str) -> ShelvedRegister:
    """Read the register of a course for who looks into one entry after the other.

    It takes little memory, however much was issued. Arguments and errors as for `read_register`.
    """
    engine = _register_engine(root, course_id)
    if engine is None:
        return ShelvedRegister(course_id, {}, {})
    place = without_password(engine.url)
    with refusals_named(place), engine.connect() as connection:
        entries = stream_entries(connection, course_id, place)
        first = tuple(islice(entries, 1))
        keys: tuple[bytes, ...] = ()
        if first:
            keys = read_keys(key_path(root))
        else:
            _refuse_other(connection, engine, root, course_id)
        withdrawals = fetch_withdrawals(connection, course_id)
        register = shelved(chain(first, entries), course_id, keys, place, withdrawals)
        return replace(register, former=fetch_former_names(connection, course_id))


def _register_engine(root: Path, course_id: str) -> Engine | None:
    """Open the database of a course, with what an earlier program kept; None where there is none.

    Errors as for `read_register`.
    """
    if old_register_path(root).is_file():
        _take_over(root, course_id)
    place = home_of(root)
    return open_engine(place) if exists(place) else None


@dataclass(slots=True, eq=False)
class VerifiedRegister:
    """The register for who asks all the time: verified again whenever anything of it changed.

    The rows are read each time and compared with those that were verified last, and so is the key;
    only the signatures of what is exactly the same are not computed again. Safe between threads.

    Attributes:
        root: folder of the course, with its key.
        course_id: of the course.
        engine: of the database.
    """

    root: Path
    course_id: str
    engine: Engine
    _last: tuple[_Kept, tuple[bytes, ...], Register] | None = field(default=None, init=False)

    def read(self) -> Register:
        """Return the register as it is now.

        Raises:
            RegisterError: an entry was changed or is damaged, or the key is missing.
            GradebookError: the database cannot be used.
        """
        place = without_password(self.engine.url)
        with refusals_named(place), self.engine.connect() as connection:
            rows = fetch_rows(connection, self.course_id)
            withdrawals = fetch_withdrawals(connection, self.course_id)
        if not rows:
            return read_register(self.root, self.course_id)
        keys, last = tuple(read_keys(key_path(self.root))), self._last
        kept = rows, withdrawals
        if last is not None and last[:2] == (kept, keys):
            return last[2]
        key, *former = keys
        register = register_of_rows(rows, self.course_id, place, withdrawals)
        self._last = (kept, keys, verified(register, key, place, former))
        return register


def extend_register(root: Path, course_id: str, change: Callable[[Register], Extended]) -> Extended:
    """Add to the register of a course what a function of it adds; whole, or not at all.

    Args:
        root: folder of the course, with its key.
        course_id: of the course.
        change: makes a longer register of the one there is; it may be called several times.

    Raises:
        RegisterError: as for `read_register`.
        GradebookError: the database cannot be used; nothing was added.
        Exception: what `change` raises; nothing was added.
    """
    before = read_register(root, course_id)
    if not exists(home_of(root)):
        # What is refused makes no database.
        change(before)
    engine = open_engine(home_of(root))
    for _ in range(_TRIES):
        try:
            return _extend(engine, root, course_id, change)
        except GradebookError as fault:
            if not another_was_faster(fault):
                raise
    raise RegisterError(
        [
            Problem(
                without_password(engine.url),
                "",
                message("Others issue from this course all the time."),
                message("Nothing was written; try again in a minute."),
            )
        ]
    )


def _extend(
    engine: Engine, root: Path, course_id: str, change: Callable[[Register], Extended]
) -> Extended:
    place = without_password(engine.url)
    with refusals_named(place), writing(engine) as connection:
        before = _read(connection, engine, root, course_id)
        extended = change(before)
        add_rows(connection, before, extended.register)
    return extended


def _read(connection: Connection, engine: Engine, root: Path, course_id: str) -> Register:
    place = without_password(engine.url)
    register = read_rows(connection, course_id, place)
    if register.entries:
        key, *former = read_keys(key_path(root))
        return verified(register, key, place, former)
    _refuse_other(connection, engine, root, course_id)
    return register


def _refuse_other(connection: Connection, engine: Engine, root: Path, course_id: str) -> None:
    """Refuse a database without this course where that can only be a mistake.

    A course's own file holds one course; and a course that has such a file already would be issued
    a second time in a database that does not know it.
    """
    place, file = without_password(engine.url), gradebook_path(root)
    if place == str(file):
        others = other_courses(connection, course_id)
        if others:
            what = message(
                "The register is of the course '{found}', not of '{course}'.",
                found=", ".join(others),
                course=course_id,
            )
            remedy = message("Name the right course, or take its id back.")
            raise RegisterError([Problem(place, "", what, remedy)])
    elif file.is_file():
        what = message("Nothing was issued here from this course, which has a file of its own.")
        remedy = message(
            "Remove the line of {address} to use {file}, or move that file away to begin anew.",
            address="private/database",
            file=str(file),
        )
        raise RegisterError([Problem(place, "", what, remedy)])


def _take_over(root: Path, course_id: str) -> None:
    """Take over the register that an earlier program kept as a file, which stays as a copy."""
    path = old_register_path(root)
    key, *former = read_keys(key_path(root))
    old = verified(read_register_file(path, course_id), key, str(path), former)
    engine = open_engine(home_of(root))
    with refusals_named(without_password(engine.url)), writing(engine) as connection:
        before = read_rows(connection, course_id, without_password(engine.url))
        add_rows(connection, before, _joined(before, old, path))
    # Another program may have put it aside at the same time.
    with suppress(FileNotFoundError):
        path.rename(_free(path))


def _joined(before: Register, old: Register, path: Path) -> Register:
    """Return all entries of both; an entry of both must be the same."""
    known = before.by_student()
    differing = [
        entry.student.id
        for entry in old.entries
        if entry.student.id in known and known[entry.student.id].variant != entry.variant
    ]
    if differing:
        what = message(
            "The gradebook says of {students} that other numbers were issued than this file.",
            students=", ".join(differing),
        )
        remedy = message("Move the wrong one away; do not edit either by hand.")
        raise RegisterError([Problem(str(path), "", what, remedy)])
    fresh = (entry for entry in old.entries if entry.student.id not in known)
    return replace(before, entries=(*before.entries, *fresh))


def _free(path: Path) -> Path:
    """Return a name for the copy that nothing has yet."""
    copy, number = path.with_name(f"{path.name}.imported"), 1
    while copy.exists():
        number += 1
        copy = path.with_name(f"{path.name}.imported-{number}")
    return copy
