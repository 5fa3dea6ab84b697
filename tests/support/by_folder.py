"""Who runs what where several processes run the tests: whole folders, and dear ones first.

What the tests of a folder share is then made once and not in every process, and no process is left
with a long folder when the others have nothing to do. Where nothing is compiled yet, as in a fresh
clone, one process reads the tests before the others do: each would compile all of them.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from xdist.scheduler import LoadScopeScheduling
from xdist.workermanage import WorkerController

TESTS = Path(__file__).parents[1]
FRESH = "nothing is compiled"

# By the seconds of the processor that they took, longest first; the rest is short. A folder inside
# another that stands here is a piece of work of its own.
DEAR = (
    *("usecases", "contracts", "documents", "drawing", "cli", "variants", "web", "grading"),
    *("machine/jobs", "course", "simulation", "batch", "hostile", "cli/demo", "examples", "policy"),
    *("submission", "docs", "issuing", "gradebook", "slips", "machine", "solver"),
    *("test_wheel.py", "formula", "api"),
)


def folder_of(nodeid: str) -> str:
    """Return the piece of work of a test: the folder below `tests`, or a file that stands there."""
    _, room, *rest = nodeid.partition("::")[0].split("/")
    inner = "/".join([room, *rest[:1]])
    return inner if inner in DEAR else room


def dear_first(items: list[pytest.Item]) -> None:
    """Order tests by their folders; inside a folder they stay in their order."""
    ranks = {name: rank for rank, name in enumerate(DEAR)}
    items.sort(key=lambda item: ranks.get(folder_of(item.nodeid), len(DEAR)))


class ByFolder(LoadScopeScheduling):
    """Gives each process one folder after the other, in the order of the tests."""

    def __init__(self, config: pytest.Config, log: object = None) -> None:
        super().__init__(config, log)
        config.option.loadscopereorder = False

    def _split_scope(self, nodeid: str) -> str:
        return folder_of(nodeid)


def is_shared(config: pytest.Config) -> bool:
    """Tell whether this process is one of several that run the tests."""
    return hasattr(config, "workerinput")


def tell_whether_fresh(node: WorkerController) -> None:
    """Tell a process that is about to start whether the tests were ever read here."""
    compiled = TESTS.glob("*/__pycache__/test_*.pyc")
    node.workerinput[FRESH] = sys.platform != "win32" and not any(compiled)


@contextmanager
def one_before_the_others(config: pytest.Config) -> Iterator[None]:
    """Let the other processes wait for the first, where all would do the same."""
    if not (is_shared(config) and config.workerinput[FRESH]):
        yield
        return
    import fcntl  # noqa: PLC0415 (not everywhere)

    with Path(__file__).open("rb") as shared:
        try:
            fcntl.flock(shared, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            fcntl.flock(shared, fcntl.LOCK_SH)
        yield
