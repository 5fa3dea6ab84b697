"""What an earlier program kept is brought up to this one, whole, with a copy beside it."""

import sqlite3
import stat
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from alembic.script import ScriptDirectory
from sqlalchemy import MetaData, Table, insert
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.engine import Dialect
from sqlalchemy.schema import CreateTable

from gripcourse.access.desk import schema as desk
from gripcourse.access.lti import schema as lti
from gripcourse.gradebook import schema as gradebook
from gripcourse.gradebook.store import open_gradebook
from gripcourse.issuing import schema as register
from gripcourse.machine.database.migrate import NEWEST, REVISIONS, VERSION_TABLE, revision_of
from gripcourse.machine.database.opening import open_engine

PARTS = (gradebook, register, desk, lti)
TABLES = [table for part in PARTS for table in part.metadata.sorted_tables]
FIRST_VERSION = Path(__file__).with_name("first_version.sql").read_text(encoding="utf-8")


@pytest.fixture
def old(tmp_path: Path) -> Path:
    """The gradebook of the first version."""
    place = tmp_path / "gradebook.sqlite"
    with closing(sqlite3.connect(place)) as connection:
        connection.executescript(FIRST_VERSION)
    return place


def dump(place: Path) -> list[str]:
    with closing(sqlite3.connect(place)) as connection:
        return list(connection.iterdump())


def test_every_row_of_the_first_version_is_kept(old: Path) -> None:
    rows = {line for line in dump(old) if line.startswith("INSERT") and "_format" not in line}
    assert len(rows) == 4
    book = open_gradebook(str(old))
    # A row may have got columns behind those that it had.
    now = dump(old)
    assert all(any(line.startswith(row.removesuffix(");")) for line in now) for row in rows)
    (entry,) = book.entries()
    assert (entry.mark.marker, entry.mark.lines) == ("Петров", {"sizes": 0.5})
    with book.engine.connect() as connection:
        assert revision_of(connection) == NEWEST


def test_a_private_copy_is_kept_beside_it(old: Path) -> None:
    before = dump(old)
    open_engine(str(old))
    copy = old.with_name(f"gradebook.sqlite.before-{NEWEST}")
    assert dump(copy) == before
    if sys.platform != "win32":
        assert stat.S_IMODE(copy.stat().st_mode) == 0o600
    assert {one.name for one in old.parent.iterdir()} == {old.name, copy.name}


def test_it_is_brought_up_once(old: Path) -> None:
    open_engine(str(old))
    copy = old.with_name(f"gradebook.sqlite.before-{NEWEST}")
    copy.unlink()
    open_engine(str(old))
    assert not copy.exists()


def test_a_crash_on_the_way_leaves_it_as_it_was(old: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def crash(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    before = dump(old)
    with monkeypatch.context() as patch:
        patch.setattr("alembic.op.execute", crash)
        with pytest.raises(KeyboardInterrupt):
            open_engine(str(old))
    assert dump(old) == before
    open_engine(str(old))
    assert dump(old) != before


def test_programs_that_open_it_at_once_find_it_whole(old: Path) -> None:
    script = str(Path(__file__).with_name("opener.py"))
    running = [
        subprocess.Popen([sys.executable, script, str(old)], stdout=subprocess.PIPE)  # noqa: S603 (ours)
        for _ in range(3)
    ]
    assert [one.communicate()[0].decode() for one in running] == [NEWEST] * 3
    assert len(open_gradebook(str(old)).attempts()) == 1


def test_the_first_version_refuses_what_was_brought_up(old: Path) -> None:
    """It reads a number from a table of its own, and knows only the first."""
    open_engine(str(old))
    with closing(sqlite3.connect(old)) as connection:
        assert connection.execute("SELECT version FROM gradebook_format").fetchall() == [(2,)]


def test_the_program_knows_all_revisions_in_their_order() -> None:
    config = Config()
    config.set_main_option("script_location", "gripcourse.machine.database:migrations")
    scripts = ScriptDirectory.from_config(config).walk_revisions()
    assert tuple(one.revision for one in scripts) == REVISIONS[::-1]


def test_the_revisions_make_the_tables_that_the_program_uses(tmp_path: Path) -> None:
    whole = MetaData()
    for table in TABLES:
        table.to_metadata(whole)
    ignored = {VERSION_TABLE, "gradebook_format"}
    with open_engine(str(tmp_path / "new.sqlite")).connect() as connection:
        options = {
            "version_table": VERSION_TABLE,
            "include_name": lambda name, kind, _: kind != "table" or name not in ignored,
        }
        context = MigrationContext.configure(connection, opts=options)
        assert compare_metadata(context, whole) == []


@pytest.mark.parametrize("dialect", [postgresql.dialect(), sqlite.dialect()], ids=lambda d: d.name)
@pytest.mark.parametrize("table", TABLES, ids=lambda table: table.name)
def test_the_tables_are_written_for_either_database(table: Table, dialect: Dialect) -> None:
    assert table.name in str(CreateTable(table).compile(dialect=dialect))
    assert table.name in str(insert(table).compile(dialect=dialect))
