"""A PostgreSQL server of the tests' own: Debian's programs, a socket in a folder, no network."""

import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import count
from pathlib import Path

from sqlalchemy import create_engine
from sqlalchemy.engine import URL
from sqlalchemy.pool import NullPool

from gripcourse.machine.database.opening import open_engine

_SETTINGS = (
    "listen_addresses=''",
    "max_connections=40",
    "shared_buffers=16MB",
    # What is lost with the machine is a test's.
    "fsync=off",
    "full_page_writes=off",
    "autovacuum=off",
)
_TEMPLATE = "empty"


@dataclass(frozen=True, slots=True)
class Server:
    """A server that was started here.

    Attributes:
        folder: with its data and its socket.
        programs: the folder of its programs.
        numbers: of the databases that were made.
    """

    folder: Path
    programs: Path
    numbers: Iterator[int] = field(default_factory=count)

    def url(self, database: str) -> str:
        """Return the place of a database, as it stands in `private/database`."""
        query = {"host": str(self.folder)}
        url = URL.create("postgresql+psycopg", "postgres", database=database, query=query)
        return url.render_as_string()

    @contextmanager
    def database(self, options: str = f"TEMPLATE {_TEMPLATE}") -> Iterator[str]:
        """Make a database for a while, by default one with empty tables; its place is given."""
        name = f"course_{next(self.numbers)}"
        self.do(f"CREATE DATABASE {name} {options}")
        yield self.url(name)
        self.do(f"DROP DATABASE {name} WITH (FORCE)")

    def do(self, statement: str) -> None:
        """Let the server do something, outside of any transaction."""
        engine = create_engine(self.url("postgres"), poolclass=NullPool)
        with engine.connect().execution_options(isolation_level="AUTOCOMMIT") as connection:
            connection.exec_driver_sql(statement)

    def start(self) -> None:
        """Start it, and wait until it answers."""
        options = " ".join(
            f"-c {one}" for one in (*_SETTINGS, f"unix_socket_directories={self.folder}")
        )
        self._control("start", "-o", options, "-l", str(self.folder / "log"))

    def stop(self) -> None:
        """Stop it at once, as a crash would; nothing where it does not run."""
        if (self.folder / "data" / "postmaster.pid").exists():
            self._control("stop", "-m", "immediate")

    def _control(self, *words: str) -> None:
        data = str(self.folder / "data")
        _run([str(self.programs / "pg_ctl"), "-D", data, "-s", "-w", *words])


def programs() -> Path | None:
    """Return the folder of the newest server's programs; None where there is none."""
    found = [*Path("/usr/lib/postgresql").glob("*/bin/initdb"), shutil.which("initdb")]
    folders = [Path(one).parent for one in found if one is not None]
    return max(folders, key=lambda one: (len(str(one)), str(one)), default=None)


@contextmanager
def running() -> Iterator[Server]:
    """Run a server with an empty database to copy."""
    where = programs()
    assert where is not None, "Debian's package postgresql is missing: make test-packages"
    # Short, for the name of a socket has at most 107 bytes.
    folder = Path(tempfile.mkdtemp(prefix="gc-pg-", dir="/tmp"))
    try:
        if os.geteuid() == 0:
            shutil.chown(folder, "nobody")
        server = Server(folder, where)
        _run([str(where / "initdb"), "-D", str(folder / "data"), "-U", "postgres", "-A", "trust",
              "-E", "UTF8", "--locale=C.UTF-8", "--no-sync"])  # fmt: skip
        server.start()
        try:
            # Another order of texts than Python's: what a department's server usually has.
            server.do(f"CREATE DATABASE {_TEMPLATE} TEMPLATE template0 LOCALE_PROVIDER icu"
                      " ICU_LOCALE 'uk'")  # fmt: skip
            open_engine(server.url(_TEMPLATE))
            yield server
        finally:
            server.stop()
    finally:
        shutil.rmtree(folder)


def _run(command: list[str]) -> None:
    """Run a program; not as root, which the server refuses."""
    other = ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"]
    prefix = other if os.geteuid() == 0 else []
    subprocess.run([*prefix, *command], check=True, stdout=subprocess.DEVNULL, cwd="/")  # noqa: S603 (Debian's)
