"""What a worker has to import while it does its first job."""

import sys
from collections.abc import Callable
from typing import Any


def first_imports(item: Any, work: tuple[Callable[[Any, Any], Any], Any]) -> set[str]:  # noqa: ANN401 (of any job)
    """Do a job, and return the packages that it had to import, without the standard library's."""
    known = _packages()
    do, shared = work
    do(item, shared)
    return _packages() - known


def _packages() -> set[str]:
    return {one.partition(".")[0] for one in sys.modules} - sys.stdlib_module_names
