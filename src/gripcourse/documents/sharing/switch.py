"""Puts what is shared between documents in the place of WeasyPrint's own functions, and back."""

import hashlib
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from threading import RLock
from typing import Any, Final

# The files of WeasyPrint that were read for this, and their digest in version 70.0.
_SOURCES: Final = (
    "__init__.py",
    "css/__init__.py",
    "css/computed_values.py",
    "draw/text.py",
    "layout/percent.py",
    "pdf/fonts.py",
    "pdf/stream.py",
    "text/fonts.py",
    "text/line_break.py",
)
_DIGEST: Final = "d95fa19a0d72def64fd55fa01ca5decf0afb020a806323e5e3f45576f1a32b99"
_IN_PLACE: Final = RLock()


@dataclass(frozen=True, slots=True)
class _Name:
    """A name in a module that means a function of WeasyPrint, and what it means while we share."""

    module: Any
    name: str
    own: Callable[..., Any]
    shared: Callable[..., Any]


@contextmanager
def shared_between_documents(fonts: object) -> Iterator[None]:
    """Let WeasyPrint share what it works out, where it is a version that is known.

    Other threads wait: what is kept is changed by one document at a time, which costs nothing where
    threads take turns anyway.

    Args:
        fonts: the configuration of fonts that all documents share; others share nothing.
    """
    with _IN_PLACE:
        names = _names(fonts) if is_known() else ()
        try:
            for one in names:
                setattr(one.module, one.name, one.shared)
            yield
        finally:
            for one in names:
                setattr(one.module, one.name, one.own)


@lru_cache(maxsize=1)
def is_known() -> bool:
    """Tell whether the installed WeasyPrint is the one whose source was read for this."""
    return digest_of_sources() == _DIGEST


def digest_of_sources() -> str:
    """Return the digest of those files of WeasyPrint; empty where one is missing."""
    spec = find_spec("weasyprint")
    if spec is None or spec.origin is None:
        return ""
    folder = Path(spec.origin).parent
    try:
        read = b"\0".join((folder / source).read_bytes() for source in _SOURCES)
    except OSError:
        return ""
    return hashlib.sha256(read).hexdigest()


@lru_cache(maxsize=1)
def _names(fonts: object) -> tuple[_Name, ...]:
    """Find all names of the functions that are replaced: each module has those that it imported."""
    from weasyprint import css  # noqa: PLC0415 (450 ms)
    from weasyprint.draw import text as drawn  # noqa: PLC0415
    from weasyprint.layout import percent  # noqa: PLC0415
    from weasyprint.text import line_break  # noqa: PLC0415

    from gripcourse.documents.sharing.drawings import SharedDrawings  # noqa: PLC0415
    from gripcourse.documents.sharing.lines import SharedLines  # noqa: PLC0415
    from gripcourse.documents.sharing.sizes import SharedSizes  # noqa: PLC0415
    from gripcourse.documents.sharing.styles import SharedStyles  # noqa: PLC0415

    lines, drawings = SharedLines(fonts), SharedDrawings()
    sizes, styles = SharedSizes(fonts), SharedStyles(fonts)
    instead: tuple[tuple[Callable[..., Any], Callable[..., Any]], ...] = (
        (css.StyleFor, styles.style_for),
        (line_break.split_first_line, lines.split_first_line),
        (drawn.draw_first_line, drawings.draw_first_line),
        (percent.resolve_percentages, sizes.resolve_percentages),
        (line_break.strut, sizes.strut),
    )
    modules = [module for name, module in sys.modules.items() if name.split(".")[0] == "weasyprint"]
    return tuple(
        _Name(module, name, own, shared)
        for own, shared in instead
        for module in modules
        for name, value in vars(module).items()
        if value is own
    )
