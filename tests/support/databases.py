"""Databases of either kind, for the statements that hold on both."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from support.postgres import Server, running


@pytest.fixture(name="postgresql", scope="session")
def postgresql_server() -> Iterator[Server]:
    """A server, started where the first test needs it: one for all folders of a process."""
    with running() as server:
        yield server


@pytest.fixture(name="place", params=["sqlite", "postgresql"])
def either_place(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[str]:
    """Where a database may be: a file that is not there yet, or an empty one on a server."""
    if request.param == "sqlite":
        yield str(tmp_path / "gradebook.sqlite")
        return
    server: Server = request.getfixturevalue("postgresql")
    with server.database() as made:
        yield made
