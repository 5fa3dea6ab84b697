"""What was computed once and is kept on disk for the next process, under the digest of its sources.

A kept value cannot lie: its name is a digest of everything that it was computed from, the program
and the versions of its libraries included. What cannot be read, was damaged or belongs to somebody
else counts as not kept.
"""

import hashlib
import io
import os
import pickle
import stat
import sys
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import fields, is_dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Final

from gripcourse.machine.enclosed import read_within_bounds
from gripcourse.machine.files import write_bytes
from gripcourse.machine.process_wide import few_collections

_MOST: Final = 32  # kept values; the ones unused for longest go
_PROGRAM: Final = Path(__file__).parents[1]
_COUNTS: Final = ("py", "csv", "toml", "po")  # its files that decide over what is found


def digest_of(root: Path, files: Iterable[Path]) -> str:
    """Return the digest of files, of their names below a folder, and of this program.

    Raises:
        OSError: a file cannot be read, or is larger than any of a course.
    """
    found = hashlib.sha256(_program_digest())
    for path in sorted(files):
        content = read_within_bounds(path)
        # The letters of a name may be those of another system.
        found.update(os.fsencode(path.relative_to(root).as_posix()))
        found.update(f"\0{len(content)}\0".encode())
        found.update(content)
    return found.hexdigest()


def read_kept(digest: str) -> Any:  # noqa: ANN401 (whatever was kept)
    """Return what was kept under a digest, None where nothing is."""
    path = _path(digest)
    value = None if path is None else read_value(path)
    if path is not None and value is not None:
        with suppress(OSError):
            os.utime(path)
    return value


def read_value(path: Path) -> Any:  # noqa: ANN401 (whatever was kept)
    """Return what `write_value` wrote; None where it is not there, damaged, or not this user's."""
    try:
        if not hasattr(os, "getuid") or not is_mine(path):
            return None
        with few_collections():
            return pickle.loads(path.read_bytes())  # noqa: S301 (written by this user's own process)
    except Exception:  # noqa: BLE001 (a damaged file fails in any way; the value is computed again)
        return None


def write_value(path: Path, value: object) -> None:
    """Write a value for the next process, in a folder that only this user may open.

    Raises:
        OSError: it cannot be written.
    """
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    written = io.BytesIO()
    _Pickler(written).dump(value)
    # What a machine loses with its power counts as not kept.
    write_bytes(path, written.getvalue(), private=True, lasting=False)


class _Pickler(pickle.Pickler):
    """Writes a plain value as its class and its fields; the library wants this as a method.

    A course has twenty thousand of them, and each asks for the fields of its class otherwise: two
    fifths of the time that unpacking a course takes.
    """

    def reducer_override(self, value: object) -> Any:  # noqa: ANN401 (as the library has it)
        """Return how a value is made again."""
        names = _field_names(type(value))  # type: ignore[arg-type] # a class has a hash
        if names is None:
            return NotImplemented
        return type(value), tuple([getattr(value, name) for name in names])


@lru_cache(maxsize=1024)
def _field_names(kind: type) -> tuple[str, ...] | None:
    """Return the fields that make a value of a class; None where more than these makes it."""
    if not is_dataclass(kind) or "__slots__" not in vars(kind) or hasattr(kind, "__post_init__"):
        return None
    state = getattr(vars(kind).get("__getstate__"), "__module__", "dataclasses")
    if state != "dataclasses" or kind.__reduce__ is not object.__reduce__:
        return None
    listed = fields(kind)
    is_plain = all(one.init and not one.kw_only for one in listed)
    return tuple(one.name for one in listed) if is_plain else None


def keep(digest: str, value: object) -> None:
    """Keep a value; where that is not possible, nothing happens."""
    path = _path(digest)
    with suppress(OSError):
        if path is not None:
            write_value(path, value)
            kept = sorted(path.parent.glob("*.kept"), key=lambda one: one.stat().st_mtime)
            for old in kept[:-_MOST]:
                old.unlink(missing_ok=True)


@lru_cache(maxsize=1)
def _program_digest() -> bytes:
    """Digest all that a kept value was made by: this program, the interpreter, the libraries."""
    found = hashlib.sha256("\0".join([sys.version, *_libraries()]).encode())
    for path in sorted(path for kind in _COUNTS for path in _PROGRAM.rglob(f"*.{kind}")):
        content = path.read_bytes()
        found.update(f"\0{path.relative_to(_PROGRAM).as_posix()}\0{len(content)}\0".encode())
        found.update(content)
    return found.digest()


def _libraries() -> list[str]:
    """Name the packages that are installed, with their versions: others may find something else."""
    return sorted(one.name for place in sys.path for one in Path(place).glob("*.dist-info"))


def _path(digest: str) -> Path | None:
    """Return the place of a kept value, None where a machine has none that is private."""
    if not hasattr(os, "getuid"):
        return None
    base = os.environ.get("XDG_CACHE_HOME") or ""
    home = os.environ.get("HOME") or ""
    if not Path(base).is_absolute():
        base = str(Path(home) / ".cache") if Path(home).is_absolute() else ""
    return Path(base) / "gripcourse" / f"{digest}.kept" if base else None


def is_mine(path: Path) -> bool:
    """Tell whether nobody but this user can have written a file."""
    own = os.getuid()
    for one in (path, path.parent):
        found = one.lstat()
        others = found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
        if found.st_uid != own or others or stat.S_ISLNK(found.st_mode):
            return False
    return True
