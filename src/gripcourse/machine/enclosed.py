"""What a folder from somebody else may make us read and write: only what lies inside of it.

A course is often another person's. A link in it could show a file of this machine in a document or
in a message, a pipe could make us wait for ever, and an id could lead out of the folder that
something is written to.
"""

import errno
import os
import re
import stat
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Final

from gripcourse.errors import Problem
from gripcourse.text.words import Message, message

LONGEST_NAME: Final = 64
_LARGEST: Final = 32_000_000  # bytes; a thousand times what files of courses have

_UNSAFE: Final = re.compile(r'[/\\:*?"<>|\x00-\x1f\x7f]')
# Bytes of a name that are no UTF-8 come as these from the system.
_NO_TEXT: Final = re.compile("[\ud800-\udfff]")
# Names that Windows keeps for devices, whatever follows the dot: no file can be called so.
_DEVICE: Final = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)


def strange_files(root: Path, folders: Iterable[str]) -> list[Problem]:
    """Return what lies in the folders of a course that must not be read.

    Args:
        root: of the course; it may be a link itself.
        folders: names of folders below it; one that is missing is none.

    Returns:
        A problem for each link that leads out of the course, each pipe or device, each file that is
        too large, and each whose name is no text.
    """
    listed = tuple(folders)
    # What a link leads to must be looked at, too: a folder beside these is not.
    homes = tuple(Path(os.path.realpath(root)) / one for one in listed)
    below = map(Path, _names(root, listed))
    found = ((path, _wrong_name(path.name) or _wrong(path, homes)) for path in below)
    return [
        Problem(path.relative_to(root).as_posix(), "", *said)
        for path, said in found
        if said is not None
    ]


def read_within_bounds(path: Path) -> bytes:
    """Return the content of a file of a course that nobody has looked at before.

    Raises:
        OSError: it cannot be read, or is larger than a file of a course may be.
    """
    with path.open("rb") as stream:
        if os.fstat(stream.fileno()).st_size > _LARGEST:
            raise OSError(errno.EFBIG, os.strerror(errno.EFBIG), str(path))
        return stream.read()


def is_file_name(name: str) -> bool:
    """Tell whether a name stays in its folder on every system, as a part of a file's name too."""
    return len(name) <= LONGEST_NAME and _stays(name)


def file_below(folder: Path, name: str) -> Path:
    """Return the path of a file in a folder.

    Raises:
        ValueError: the name would lead out of the folder; whoever takes names from outside has
            looked at them before.
    """
    if not _stays(name):
        raise ValueError(f"{name!r} is no name of a file")
    return folder / name


def _stays(name: str) -> bool:
    return bool(
        name
        and not _UNSAFE.search(name)
        and not name.startswith((".", " "))
        and not name.endswith((".", " "))
        and not _DEVICE.fullmatch(name)
    )


def _names(root: Path, folders: Iterable[str]) -> Iterator[str]:
    """Yield everything below the folders, links too, but nothing behind a link."""
    for folder in folders:
        top = root / folder
        if top.is_symlink():
            yield str(top)
            continue
        for where, inside, files in os.walk(top):
            yield from (os.path.join(where, one) for one in (*inside, *files))  # noqa: PTH118 (thrice as fast, for hundreds of files at each start)


def _wrong_name(name: str) -> tuple[Message, Message] | None:
    if not _NO_TEXT.search(name):
        return None
    return (
        message("The name of this file is in the letters of another system."),
        message("Give it another name; archives of old Windows programs unpack so."),
    )


def _wrong(path: Path, homes: Sequence[Path]) -> tuple[Message, Message] | None:
    """Say what keeps a file from being read and how that is mended; None for nothing."""
    try:
        found = path.lstat()
        if stat.S_ISLNK(found.st_mode):
            target = Path(os.path.realpath(path))
            if not any(map(target.is_relative_to, homes)):
                return (
                    message("This is a link that leads out of the folder of the course."),
                    message("Put a copy of the file in its place, if you know what is in it."),
                )
            found = path.stat()
    except OSError:
        return None  # a link to nothing: whoever needs the file says that it is missing
    if stat.S_ISDIR(found.st_mode):
        return None
    if not stat.S_ISREG(found.st_mode):
        return (
            message("This is no file but a pipe or a device."),
            message("Remove it; a course consists of plain files."),
        )
    if found.st_size > _LARGEST:
        return (
            message(
                "The file has {size} MB; a file of a course has {most} at most.",
                size=found.st_size // 1_000_000,
                most=_LARGEST // 1_000_000,
            ),
            message("Remove it, or leave out what the course does not need."),
        )
    return None
