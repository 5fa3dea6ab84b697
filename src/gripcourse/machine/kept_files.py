"""Files of a course as they were, kept in its private folder under their fingerprint.

What was kept once is never changed: another content has another fingerprint. It is compared
whenever it is looked at, so that what was damaged counts as not kept, and is kept again while the
course still has those files.
"""

import io
import lzma
import tempfile
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Final, TypeAlias

from gripcourse.machine.files import make_private_folder, write_bytes

_EARLIEST: Final = (1980, 1, 1, 0, 0, 0)  # of a zip: when it was made says nothing
_DAMAGE: Final = (
    *(zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, OSError),
    *(NotImplementedError, RuntimeError, ValueError),  # a bit of the wrong flag, or of the method
)

DigestOf: TypeAlias = Callable[[Path], str]
"""Computes the fingerprint of files as they lie in a folder."""


def keep_files(root: Path, kind: str, fingerprint_of: DigestOf, paths: Iterable[Path]) -> str:
    """Keep files of a course as they are now, unless this was done before and they are whole.

    Args:
        root: folder of the course.
        kind: of what they are; a folder of that name in the course's private one has them.
        fingerprint_of: computes by what they are known.
        paths: of the files, below the folder of the course.

    Returns:
        Their fingerprint.

    Raises:
        OSError: a file cannot be read or written.
    """
    fingerprint = fingerprint_of(root)
    with kept_files(root, kind, fingerprint, fingerprint_of) as folder:
        if folder is not None:
            return fingerprint
    kept = _path(root, kind, fingerprint)
    make_private_folder(kept.parent)
    write_bytes(kept, _packed(root, paths), private=True)
    return fingerprint


@contextmanager
def kept_files(
    root: Path, kind: str, fingerprint: str, fingerprint_of: DigestOf
) -> Iterator[Path | None]:
    """Give a folder with the files as they lay in that of the course; it goes on leaving.

    Args:
        root: folder of the course.
        kind: see `keep_files`.
        fingerprint: that they were kept under.
        fingerprint_of: computes it, so that nothing is given that has another one by now.

    Yields:
        The folder; None where they were not kept, or are damaged.

    Raises:
        OSError: a file cannot be read or written.
    """
    kept = _path(root, kind, fingerprint)
    if not kept.is_file():
        yield None
        return
    packed = io.BytesIO(kept.read_bytes())
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        whole = _is_readable(packed)
        if whole:
            with zipfile.ZipFile(packed) as archive:
                archive.extractall(folder)
        yield folder if whole and fingerprint_of(folder) == fingerprint else None


def _is_readable(packed: io.BytesIO) -> bool:
    """Tell whether each file can be unpacked; it is in the memory, so that no disk is to blame."""
    try:
        with zipfile.ZipFile(packed) as archive:
            return all(archive.read(one) is not None for one in archive.infolist())
    except _DAMAGE:
        return False


def _path(root: Path, kind: str, fingerprint: str) -> Path:
    return root / "private" / kind / f"{fingerprint}.zip"


def _packed(root: Path, paths: Iterable[Path]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for path in paths:
            info = zipfile.ZipInfo(path.relative_to(root).as_posix(), _EARLIEST)
            archive.writestr(info, path.read_bytes(), zipfile.ZIP_DEFLATED)
    return stream.getvalue()
