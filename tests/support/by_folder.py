"""Who runs what where several processes run the tests: whole folders, and dear ones first.

What the tests of a folder share is then made once and not in every process, and no process is left
with a long folder when the others have nothing to do.
"""

import pytest
from xdist.scheduler import LoadScopeScheduling

# By the seconds of the processor that they took, longest first; the rest is short.
DEAR = (
    *("usecases", "contracts", "documents", "drawing", "cli", "variants", "web", "grading"),
    *("jobs", "course", "simulation", "batch", "hostile", "demo", "examples", "policy"),
    *("submission", "docs", "issuing", "gradebook", "slips", "machine", "solver"),
    *("test_wheel.py", "formula", "api"),
)


def folder_of(nodeid: str) -> str:
    """Return the piece of work of a test: the folder below `tests`, or a file that stands there."""
    return nodeid.partition("::")[0].split("/")[1]


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
