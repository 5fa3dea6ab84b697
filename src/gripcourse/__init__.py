"""Course assignments: issue variants, check answers, grade and report.

`import gripcourse as gc` costs nothing until something of `gripcourse.api` is asked for.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gripcourse.api import *  # noqa: F403 (its `__all__` says what)

__version__ = "0.1.0"


def __getattr__(name: str) -> object:
    # A module of this package is asked for in the same way while it is imported.
    if not name.startswith("_"):
        library = import_module("gripcourse.api")
        if name in library.__all__:
            found: object = getattr(library, name)
            return found
    said = f"module {__name__!r} has no attribute {name!r}"
    raise AttributeError(said)


def __dir__() -> list[str]:
    return sorted([*globals(), *import_module("gripcourse.api").__all__])
