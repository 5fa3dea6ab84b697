"""Files of a course as they were, kept in its private folder under their fingerprint.

What was kept once is never written again: another content has another fingerprint. Whoever reads it
compares the fingerprint, so that what was damaged counts as not kept.
"""

import io
import tempfile
import zipfile
import zlib
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from gripcourse.machine.files import make_private_folder, write_bytes

_EARLIEST: Final = (1980, 1, 1, 0, 0, 0)  # of a zip: when it was made says nothing
_DAMAGE: Final = (zipfile.BadZipFile, zlib.error, EOFError)


def keep_files(root: Path, kind: str, fingerprint: str, paths: Iterable[Path]) -> None:
    """Keep files of a course, unless this was done before.

    Args:
        root: folder of the course.
        kind: of what they are; a folder of that name in the course's private one has them.
        fingerprint: of the files.
        paths: of the files, below the folder of the course.

    Raises:
        OSError: a file cannot be read or written.
    """
    kept = _path(root, kind, fingerprint)
    if not kept.is_file():
        make_private_folder(kept.parent)
        write_bytes(kept, _packed(root, paths), private=True)


@contextmanager
def kept_files(root: Path, kind: str, fingerprint: str) -> Iterator[Path | None]:
    """Give a folder with the files as they lay in that of the course; it goes on leaving.

    Args:
        root: folder of the course.
        kind: see `keep_files`.
        fingerprint: that they were kept under; whether they still have it is for the caller to see.

    Yields:
        The folder; None where they were not kept, or are damaged.

    Raises:
        OSError: a file cannot be read or written.
    """
    kept = _path(root, kind, fingerprint)
    if not kept.is_file():
        yield None
        return
    with tempfile.TemporaryDirectory() as name:
        yield Path(name) if _unpacked(kept, Path(name)) else None


def _unpacked(kept: Path, folder: Path) -> bool:
    try:
        with zipfile.ZipFile(kept) as archive:
            archive.extractall(folder)
    except _DAMAGE:
        return False
    return True


def _path(root: Path, kind: str, fingerprint: str) -> Path:
    return root / "private" / kind / f"{fingerprint}.zip"


def _packed(root: Path, paths: Iterable[Path]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for path in paths:
            info = zipfile.ZipInfo(path.relative_to(root).as_posix(), _EARLIEST)
            archive.writestr(info, path.read_bytes(), zipfile.ZIP_DEFLATED)
    return stream.getvalue()
