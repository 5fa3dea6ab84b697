"""How large a file the system lets this process write."""

import errno
import os


def largest_file() -> int | None:
    """Return the most bytes that a file may get; None where nothing bounds it."""
    try:
        import resource  # noqa: PLC0415 (Windows has none)
    except ModuleNotFoundError:
        return None
    most, _ = resource.getrlimit(resource.RLIMIT_FSIZE)
    return None if most == resource.RLIM_INFINITY else most


def demand_file_of(size: int) -> None:
    """Refuse what would be cut: shared memory is a file too.

    Raises:
        OSError: the system does not allow a file of so many bytes.
    """
    most = largest_file()
    if most is not None and size > most:
        raise OSError(errno.EFBIG, os.strerror(errno.EFBIG))
