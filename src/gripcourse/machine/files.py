"""Writing files so that a reader never sees half of one.

Everything is written under a temporary name beside its target and then renamed over it, which the
operating system does in one step. What was there before stays until the new file is whole.
"""

import errno
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

_TOKEN_BYTES = 4
_PUBLIC = 0o666  # narrowed by the user's umask, as for any new file
_PRIVATE = 0o600
_PRIVATE_FOLDER = 0o700
_NEW = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)


def write_bytes(path: Path, data: bytes, *, private: bool = False, lasting: bool = True) -> None:
    """Write a file in one step, with the folders above it where they are missing.

    Args:
        path: the file to make or to replace.
        data: its whole content.
        private: whether only its owner may read it, for example the key of the signatures.
        lasting: whether to wait until the disk has it, so that a machine that loses its power has
            the one or the other whole.

    Raises:
        OSError: the folder cannot be written; the old file is untouched.
    """
    with replacing(path) as temporary:
        handle = os.open(temporary, _NEW, _PRIVATE if private else _PUBLIC)
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            if lasting:
                stream.flush()
                os.fsync(stream.fileno())


def write_text(path: Path, text: str, *, private: bool = False) -> None:
    """Write text as UTF-8 in one step; line ends stay as they are in `text`.

    Args:
        path: the file to make or to replace.
        text: its whole content.
        private: whether only its owner may read it.

    Raises:
        OSError: the folder cannot be written; the old file is untouched.
    """
    write_bytes(path, text.encode(), private=private)


def write_together(texts: Mapping[Path, Iterable[str | bytes]]) -> None:
    """Write files as UTF-8 that belong together; none takes its place before all are whole.

    Args:
        texts: by file, the pieces of its text, or what these are as UTF-8, asked for one after the
            other; only its owner may read it.

    Raises:
        OSError: one of them cannot be written; what was there before is untouched.
    """
    with ExitStack() as stack:
        for path, pieces in texts.items():
            temporary = stack.enter_context(replacing(path))
            make_private(temporary)
            with temporary.open("wb") as stream:
                stream.writelines(
                    piece if isinstance(piece, bytes) else piece.encode() for piece in pieces
                )
                stream.flush()
                os.fsync(stream.fileno())


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give a name to write to; on leaving without an error the file takes the place of `path`.

    The name is beside the target and has its suffix, because some writers judge by the suffix. On
    an error the unfinished file is removed and the old one stays.

    Args:
        path: the file to make or to replace; missing folders above it are made.

    Yields:
        The temporary path; nothing exists there yet.

    Raises:
        OSError: the folder cannot be made or the file cannot be renamed.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = _temporary(path)
    try:
        with _failing_as(path, temporary):
            yield temporary
            temporary.replace(path)
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)


@contextmanager
def making(path: Path) -> Iterator[Path]:
    """Give a name to write to; on leaving it becomes `path`, unless somebody made that meanwhile.

    Who is later keeps what is there: two programs that make the same file at once end up with one.

    Args:
        path: the file to make; the folder above it is there.

    Yields:
        The temporary path; nothing exists there yet.

    Raises:
        OSError: the file cannot be made.
    """
    temporary = _temporary(path)
    try:
        with _failing_as(path, temporary):
            yield temporary
            _link(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


@contextmanager
def _failing_as(path: Path, temporary: Path) -> Iterator[None]:
    """Give errors the name of the file that somebody asked for."""
    try:
        yield
    except OSError as error:
        # Nobody knows the temporary name, and what fails while it is written has no name at all.
        if error.filename in (None, str(temporary), temporary):
            error.filename, error.filename2 = str(path), None
        raise


def _link(temporary: Path, path: Path) -> None:
    """Give a finished file its name, unless that is taken."""
    try:
        path.hardlink_to(temporary)
    except FileExistsError:
        return
    except OSError:
        # A file system without links, such as that of a memory stick.
        if not path.exists():
            temporary.rename(path)


def expect_file(path: Path) -> None:
    """Refuse a file that could not be written, before anybody computes what it shall hold.

    Nothing is made. Whether the disk has room for it shows later.

    Args:
        path: the file to make or to replace; folders above it may be missing.

    Raises:
        OSError: a folder lies there, or the folder that it would lie in cannot be written.
    """
    if path.is_dir():
        raise _refusal(errno.EISDIR, path)
    expect_folder(path.parent)


def expect_folder(path: Path) -> None:
    """Refuse a folder into which nothing could be written; see `expect_file`.

    Args:
        path: the folder; it may be missing.

    Raises:
        OSError: it is a file or below one, or cannot be written.
    """
    existing = next((one for one in (path, *path.parents) if _exists(one)), path)
    if not existing.is_dir():
        raise _refusal(errno.ENOTDIR, existing)
    if not os.access(existing, os.W_OK | os.X_OK):
        raise _refusal(errno.EACCES, existing)


def _exists(path: Path) -> bool:
    """Tell whether something lies at a path. A name that is too long for any is an error."""
    try:
        path.stat()
    except (FileNotFoundError, NotADirectoryError):
        return False
    return True


def _refusal(number: int, path: Path) -> OSError:
    return OSError(number, os.strerror(number), str(path))


def make_private(path: Path) -> None:
    """Make an empty file that only its owner may read.

    Raises:
        OSError: there is one already, or the folder cannot be written.
    """
    os.close(os.open(path, _NEW, _PRIVATE))


def make_private_folder(path: Path) -> None:
    """Make a folder that only its owner may open; one that is there stays as it is.

    Raises:
        OSError: it cannot be made, or is a file.
    """
    path.mkdir(mode=_PRIVATE_FOLDER, parents=True, exist_ok=True)


def _temporary(path: Path) -> Path:
    if not path.name:  # this folder, or the root
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(path))
    return path.with_name(f".{path.stem}.{os.urandom(_TOKEN_BYTES).hex()}{path.suffix}")


def discard_all_unfinished(folder: Path) -> None:
    """Remove what a process that was killed left of its writing into a folder of ours.

    Args:
        folder: nobody else may be writing into it, see `writing_into`; it need not be there.

    Raises:
        OSError: a file cannot be removed.
    """
    unfinished = re.compile(rf"\..+\.[0-9a-f]{{{2 * _TOKEN_BYTES}}}(\.[^.]+)?")
    if folder.is_dir():
        for one in folder.iterdir():
            if unfinished.fullmatch(one.name):
                one.unlink(missing_ok=True)


def discard_unfinished(path: Path) -> None:
    """Remove what a process that was killed left of its writing of `path`.

    Args:
        path: the file that was to be made; it stays as it is, and nobody else may be writing it
            (see `writing_into`).

    Raises:
        OSError: a file cannot be removed.
    """
    token = f"[0-9a-f]{{{2 * _TOKEN_BYTES}}}"
    unfinished = re.compile(rf"\.{re.escape(path.stem)}\.{token}{re.escape(path.suffix)}")
    if path.parent.is_dir():
        for one in path.parent.iterdir():
            if unfinished.fullmatch(one.name):
                one.unlink(missing_ok=True)
