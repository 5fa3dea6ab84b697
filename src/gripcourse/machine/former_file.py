"""Keeping the file whose place another one takes: a person may have filled it in."""

import filecmp
import shutil
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import TypeVar

_Made = TypeVar("_Made")


def keeping_former(path: Path, make: Callable[[], _Made]) -> tuple[_Made, Path | None]:
    """Make a file; where another one has its name, keep that one beside it.

    Args:
        path: the file to make or to replace.
        make: makes it, whole or not at all.

    Returns:
        What `make` returns, and what the former file is called now; None where there was none, or
        the same.

    Raises:
        OSError: the former file cannot be kept, and nothing was made; or what `make` raises.
    """
    if not path.is_file():
        return make(), None
    # With the same ending, so that the same program opens it.
    names = (path.with_stem(f"{path.stem}.before-{number}") for number in count(1))
    kept = next(one for one in names if not one.exists())
    try:
        shutil.copy2(path, kept)
    except OSError:
        kept.unlink(missing_ok=True)
        raise
    try:
        made = make()
    finally:
        # Whatever happened: only what still stands in its place is removed here.
        is_same = filecmp.cmp(path, kept, shallow=False)
        if is_same:
            kept.unlink()
    return made, None if is_same else kept
