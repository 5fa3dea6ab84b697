"""A gradebook is a private file by default; what is none is refused with place and remedy."""

import stat
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from sqlalchemy import create_engine, insert, inspect, update
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.engine import make_url
from sqlalchemy.schema import CreateTable

from gripcourse.errors import GradebookError
from gripcourse.gradebook.model import Attempt
from gripcourse.gradebook.opening import exists, gradebook_path, open_engine, without_password
from gripcourse.gradebook.schema import VERSION, format_table, metadata
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.grading.model import Report


def test_it_lies_beside_the_register(tmp_path: Path) -> None:
    assert gradebook_path(tmp_path) == tmp_path / "private" / "gradebook.sqlite"


def test_only_the_owner_reads_it(tmp_path: Path) -> None:
    place = tmp_path / "private" / "gradebook.sqlite"
    open_engine(str(place))
    assert stat.S_IMODE(place.stat().st_mode) == 0o600


def test_opening_it_again_finds_what_was_kept(
    book: Gradebook,
    report: Callable[..., Report],
    attempts: Callable[..., Sequence[Attempt]],
) -> None:
    book.add_attempts(attempts(report()))
    assert open_gradebook(book.place).attempts() == book.attempts()


def test_a_file_and_its_url_are_the_same_place(tmp_path: Path) -> None:
    place = tmp_path / "gradebook.sqlite"
    open_engine(str(place))
    assert without_password(open_engine(f"sqlite:///{place}").url) == str(place)


def test_a_file_is_looked_for_and_a_database_is_believed(tmp_path: Path) -> None:
    assert not exists(str(tmp_path / "gradebook.sqlite"))
    assert exists("postgresql://teacher@localhost/course")


def test_a_later_format_is_refused_and_left_alone(book: Gradebook) -> None:
    with book.engine.begin() as connection:
        connection.execute(update(format_table).values(version=VERSION + 1))
    with pytest.raises(GradebookError) as caught:
        open_gradebook(book.place)
    (problem,) = caught.value.problems
    assert problem.file == book.place
    assert f"the format {VERSION + 1}, this program knows {VERSION}" in str(problem.what)
    assert "or a later one" in str(problem.remedy)


def test_the_tables_of_others_in_the_same_database_are_left_alone(tmp_path: Path) -> None:
    place = tmp_path / "shared.sqlite"
    with create_engine(f"sqlite:///{place}").begin() as connection:
        connection.exec_driver_sql("CREATE TABLE attempt (id INTEGER)")
    engine = open_engine(str(place))
    assert {"attempt", *metadata.tables} == set(inspect(engine).get_table_names())
    assert all(name.startswith("gradebook_") for name in metadata.tables)


@pytest.mark.parametrize(
    ("place", "said"),
    [
        ("mysql+nothing://localhost/course", "driver"),
        ("://", "no URL"),
        ("sqlite:////nowhere/at/all/gradebook.sqlite", "cannot be used"),
    ],
)
def test_a_place_that_is_none_is_one_problem_with_its_remedy(place: str, said: str) -> None:
    with pytest.raises(GradebookError) as caught:
        open_engine(place)
    (problem,) = caught.value.problems
    assert said in str(problem.what)
    assert str(problem.remedy)


def test_a_file_that_is_no_database_is_refused_and_left_alone(tmp_path: Path) -> None:
    place = tmp_path / "gradebook.sqlite"
    place.write_text("student,points\n" * 100, encoding="utf-8")
    with pytest.raises(GradebookError, match="not a database"):
        open_engine(str(place))
    assert place.read_text(encoding="utf-8").startswith("student,points")


def test_a_password_is_never_shown() -> None:
    url = make_url("postgresql+psycopg://teacher:secret@localhost/course")
    assert "secret" not in without_password(url)
    assert "teacher" in without_password(url)


@pytest.mark.parametrize("dialect", [postgresql.dialect(), sqlite.dialect()], ids=lambda d: d.name)
def test_the_tables_are_written_for_either_database(dialect: object) -> None:
    for table in metadata.sorted_tables:
        assert table.name in str(CreateTable(table).compile(dialect=dialect))  # type: ignore[arg-type]
        assert table.name in str(insert(table).compile(dialect=dialect))  # type: ignore[arg-type]
