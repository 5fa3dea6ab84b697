"""A department's PostgreSQL: made, brought up and refused like a file; it may go away."""

import gc
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime

import pytest
from alembic import command
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from sqlalchemy import Engine, MetaData, create_engine, event, func, insert, select, text
from sqlalchemy.engine import make_url
from sqlalchemy.pool import NullPool

from gripcourse.access.desk import schema as desk
from gripcourse.access.lti import schema as platforms
from gripcourse.errors import GradebookError
from gripcourse.gradebook import schema as gradebook
from gripcourse.gradebook.store import open_gradebook
from gripcourse.issuing import schema as register
from gripcourse.machine.database import opening
from gripcourse.machine.database.migrate import (
    NEWEST,
    REVISIONS,
    VERSION_TABLE,
    bring_up,
    revision_of,
)
from gripcourse.machine.database.opening import open_engine, refusals_named, writing
from gripcourse.machine.database.said import without_password
from gripcourse.machine.database.storable import in_code_order
from support.postgres import Server
from support.processes import wait_for

NOW = datetime(2026, 12, 2)  # noqa: DTZ001 (as it is stored)
PERSON = {
    "course": "small",
    "number": 1,
    "name": "Іваненко",
    "study_group": "",
    "email": "",
    "language": "uk",
    "fixed_variant": "",
}


@pytest.fixture
def nothing(postgresql: Server) -> Iterator[str]:
    """A database without any tables."""
    with postgresql.database("TEMPLATE template0") as place:
        yield place


@pytest.fixture
def place(postgresql: Server) -> Iterator[str]:
    with postgresql.database() as made:
        yield made


def said(place: str) -> str:
    with pytest.raises(GradebookError) as caught:
        open_engine(place)
    (problem,) = caught.value.problems
    assert str(problem.remedy)
    return f"{problem.file} {problem.what}"


def persons(engine: Engine) -> int:
    with engine.connect() as connection:
        question = select(func.count()).select_from(register.persons)
        return int(connection.execute(question).scalar_one())


def waiting(engine: Engine) -> int:
    """Return how many wait for the right to write."""
    question = "SELECT count(*) FROM pg_locks WHERE locktype = 'advisory' AND NOT granted"
    with engine.connect() as connection:
        return int(connection.exec_driver_sql(question).scalar_one())


class TestTables:
    @pytest.mark.parametrize("revision", [None, *REVISIONS[:-1]])
    def test_those_of_every_revision_are_brought_up(
        self, nothing: str, revision: str | None
    ) -> None:
        if revision is not None:
            _make_revision(nothing, revision)
        engine = open_engine(nothing)
        whole = MetaData()
        for part in (gradebook, register, desk, platforms):
            for table in part.metadata.sorted_tables:
                table.to_metadata(whole)
        with engine.connect() as connection:
            ignored = {VERSION_TABLE, "gradebook_format"}
            options = {
                "version_table": VERSION_TABLE,
                "include_name": lambda name, kind, _: kind != "table" or name not in ignored,
            }
            context = MigrationContext.configure(connection, opts=options)
            assert compare_metadata(context, whole) == []
            assert revision_of(connection) == NEWEST
        assert len(open_gradebook(nothing).attempts()) == (revision is not None)

    def test_who_would_make_them_waits_for_another_that_does(self, nothing: str) -> None:
        engine = create_engine(nothing, poolclass=NullPool)
        with ThreadPoolExecutor(1) as pool:
            with writing(engine) as connection:
                other = pool.submit(open_engine, nothing)
                wait_for(lambda: waiting(engine) == 1)
                bring_up(connection, None)
            assert persons(other.result()) == 0

    def test_texts_are_ordered_as_python_orders_them(self, place: str) -> None:
        names = ["Z", "a", "_", "B1", "b-1", "я", "Ї", "б", "s10", "s9"]
        engine = open_engine(place)
        with writing(engine) as connection:
            connection.execute(
                insert(register.persons), [PERSON | {"student": one} for one in names]
            )
        column = register.persons.c.student
        with engine.connect() as connection:
            by_code = select(column).order_by(*in_code_order(engine, column))
            assert list(connection.execute(by_code).scalars()) == sorted(names)
            by_language = select(column).order_by(column)
            assert list(connection.execute(by_language).scalars()) != sorted(names)


class TestRefusals:
    def test_a_database_without_cyrillic_is_refused(self, postgresql: Server) -> None:
        with postgresql.database("TEMPLATE template0 ENCODING 'LATIN1' LOCALE 'C'") as latin:
            assert "keeps its texts as LATIN1" in said(latin)

    def test_one_that_is_not_there_is_named(self, postgresql: Server) -> None:
        assert '"nowhere" does not exist' in said(postgresql.url("nowhere"))

    def test_rights_that_are_missing_are_named(self, nothing: str, postgresql: Server) -> None:
        postgresql.do("CREATE ROLE guest LOGIN PASSWORD 'secret'")
        guest = make_url(nothing).set(username="guest", password="secret")  # noqa: S106 (a test's)
        told = said(guest.render_as_string(hide_password=False))
        assert "permission denied" in told
        assert "secret" not in told

    @pytest.mark.parametrize(
        "place",
        [
            "postgresql+psycopg://teacher:secret@127.0.0.1:1/course",
            "postgres://teacher:secret@127.0.0.1:1/course?sslpassword=secret",
            "postgresql://teacher:secret@127.0.0.1:port/course",
            "postgresql+psycopg://teacher@127.0.0.1:1/course?password=secret",
            "nothing://teacher:secret@127.0.0.1/course",
        ],
    )
    def test_a_password_is_never_shown(self, place: str) -> None:
        assert "secret" not in said(place)

    def test_who_waits_too_long_for_another_is_told_so(
        self, place: str, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(opening, "_SECONDS_TO_WAIT", 0.1)
        one, other = open_engine(place), open_engine(place)
        with (
            writing(one),
            pytest.raises(GradebookError, match="does not end"),
            refusals_named("here"),
            writing(other),
        ):
            pass


def test_a_reader_does_not_wait_for_ever_for_a_locked_table(
    place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(opening, "_SECONDS_TO_WAIT", 1)
    engine = open_engine(place)
    with create_engine(place, poolclass=NullPool).begin() as administrator:
        administrator.execute(text(f"LOCK TABLE {register.persons.name}"))
        with pytest.raises(GradebookError, match="does not end"), refusals_named("here"):
            persons(engine)
    assert persons(engine) == 0


class TestGoingAway:
    """The server is killed, and started again."""

    def test_a_write_is_kept_whole_or_not_at_all_and_can_be_done_again(
        self, place: str, postgresql: Server
    ) -> None:
        engine = open_engine(place)

        def write(names: str) -> None:
            with refusals_named(without_password(engine.url)), writing(engine) as connection:
                for one in names:
                    connection.execute(insert(register.persons), PERSON | {"student": one})
                    if one == "d":
                        postgresql.stop()

        write("ab")
        with pytest.raises(GradebookError, match="gone away") as caught:
            write("cde")
        (problem,) = caught.value.problems
        assert "\n" not in str(problem.what)
        with pytest.raises(GradebookError, match="cannot be reached"):
            open_engine(place)
        postgresql.start()
        assert persons(engine) == 2
        write("ce")
        assert persons(engine) == 4

    # The libraries leave the cursor of a server that is gone to the collector of garbage.
    @pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
    def test_reading_ends_with_a_sentence_too(self, place: str, postgresql: Server) -> None:
        book = open_gradebook(place)
        stopping = threading.Event()

        @event.listens_for(book.engine, "before_cursor_execute")
        def stop(*_: object) -> None:
            if not stopping.is_set():
                stopping.set()
                postgresql.stop()

        with pytest.raises(GradebookError, match="gone away"):
            book.attempts()
        gc.collect()
        postgresql.start()
        assert book.attempts() == ()


def _make_revision(place: str, revision: str) -> None:
    """Make the tables of an earlier program, with an attempt in them."""
    config = Config()
    config.set_main_option("script_location", "gripcourse.machine.database:migrations")
    row = {"student": "s01", "number": 1, "judged": True, "graded_at": NOW, "digest": "a" * 64}
    row |= dict.fromkeys(("variant", "scheme", "file", "course", "policy"), "x")
    with create_engine(place, poolclass=NullPool).begin() as connection:
        config.attributes["connection"] = connection
        command.upgrade(config, revision)
        connection.execute(
            text(
                f"INSERT INTO gradebook_attempt ({', '.join(row)})"  # noqa: S608 (names of this test)
                f" VALUES ({', '.join(f':{name}' for name in row)})"
            ),
            row,
        )
        if revision == "1":
            # The first program had no table of revisions.
            connection.execute(text(f"DROP TABLE {VERSION_TABLE}"))
