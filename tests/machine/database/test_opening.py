"""A gradebook is a private file by default; what is none is refused with place and remedy."""

import stat
import sys
from pathlib import Path

import pytest
from sqlalchemy import create_engine, inspect, text
from sqlalchemy.engine import make_url

from gripcourse.errors import GradebookError
from gripcourse.machine.database.home import address_path, exists, gradebook_path, home_of
from gripcourse.machine.database.migrate import NEWEST
from gripcourse.machine.database.opening import demand_writing, open_engine, without_password
from gripcourse.machine.database.said import refusals_named


class TestHome:
    def test_it_is_a_file_in_the_private_folder(self, tmp_path: Path) -> None:
        assert gradebook_path(tmp_path) == tmp_path / "private" / "gradebook.sqlite"
        assert home_of(tmp_path) == str(gradebook_path(tmp_path))

    def test_a_line_in_the_private_folder_names_another(self, tmp_path: Path) -> None:
        address_path(tmp_path).parent.mkdir()
        address_path(tmp_path).write_text("postgresql://teacher@host/course\n", encoding="utf-8")
        assert home_of(tmp_path) == "postgresql://teacher@host/course"

    def test_a_file_is_looked_for_and_a_database_is_believed(self, tmp_path: Path) -> None:
        assert not exists(str(tmp_path / "gradebook.sqlite"))
        assert exists("postgresql://teacher@localhost/course")


class TestMaking:
    @pytest.mark.skipif(sys.platform == "win32", reason="the mode bits are of POSIX systems")
    def test_only_the_owner_reads_it(self, tmp_path: Path) -> None:
        place = tmp_path / "private" / "gradebook.sqlite"
        open_engine(str(place))
        assert stat.S_IMODE(place.stat().st_mode) == 0o600

    def test_nothing_else_is_left_beside_it(self, tmp_path: Path) -> None:
        open_engine(str(tmp_path / "gradebook.sqlite"))
        assert [one.name for one in tmp_path.iterdir()] == ["gradebook.sqlite"]

    def test_one_that_can_only_be_read_is_refused_before_any_work(self, tmp_path: Path) -> None:
        place = tmp_path / "gradebook.sqlite"
        before = open_engine(str(place)) and place.read_bytes()
        demand_writing(open_engine(str(place)))
        assert place.read_bytes() == before
        # Whoever runs the tests may have all rights: the file itself is opened for reading.
        with pytest.raises(GradebookError, match="can be read, but not written"):
            demand_writing(create_engine(f"sqlite:///file:{place}?mode=ro&uri=true"))

    def test_where_its_making_fails_there_is_none(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        def crash(*_: object) -> None:
            raise KeyboardInterrupt

        with monkeypatch.context() as patch:
            patch.setattr("os.fsync", crash)
            with pytest.raises(KeyboardInterrupt):
                open_engine(str(tmp_path / "gradebook.sqlite"))
        assert list(tmp_path.iterdir()) == []

    def test_a_file_and_its_url_are_the_same_place(self, tmp_path: Path) -> None:
        place = tmp_path / "gradebook.sqlite"
        open_engine(str(place))
        assert without_password(open_engine(f"sqlite:///{place}").url) == str(place)

    def test_the_tables_of_others_in_the_same_database_are_left_alone(self, tmp_path: Path) -> None:
        place = tmp_path / "shared.sqlite"
        with create_engine(f"sqlite:///{place}").begin() as connection:
            connection.exec_driver_sql("CREATE TABLE attempt (id INTEGER)")
        names = set(inspect(open_engine(str(place))).get_table_names()) - {"attempt"}
        ours = ("gradebook_", "register_", "desk_", "lti_", "gripcourse_")
        assert all(one.startswith(ours) for one in names)


class TestRefusals:
    def test_a_later_revision_is_refused_and_left_alone(self, tmp_path: Path) -> None:
        place = tmp_path / "gradebook.sqlite"
        with open_engine(str(place)).begin() as connection:
            connection.execute(text("UPDATE gripcourse_revision SET version_num = '77'"))
        before = place.read_bytes()
        with pytest.raises(GradebookError) as caught:
            open_engine(str(place))
        (problem,) = caught.value.problems
        assert problem.file == str(place)
        assert f"the format 77, this program knows {NEWEST}" in str(problem.what)
        assert "or a later one" in str(problem.remedy)
        assert place.read_bytes() == before
        assert len(list(tmp_path.iterdir())) == 1

    def test_a_file_of_no_bytes_is_not_made_anew(self, tmp_path: Path) -> None:
        place = tmp_path / "gradebook.sqlite"
        place.touch()
        with pytest.raises(GradebookError, match="0 bytes"):
            open_engine(str(place))
        assert place.stat().st_size == 0

    @pytest.mark.parametrize(
        ("place", "said"),
        [
            ("mysql+nothing://localhost/course", "driver"),
            ("://", "no URL"),
            ("sqlite:////nowhere/at/all/gradebook.sqlite", "cannot be used"),
        ],
    )
    def test_a_place_that_is_none_is_one_problem_with_its_remedy(
        self, place: str, said: str
    ) -> None:
        with pytest.raises(GradebookError) as caught:
            open_engine(place)
        (problem,) = caught.value.problems
        assert said in str(problem.what)
        assert str(problem.remedy)

    @pytest.mark.parametrize(
        "place",
        [
            "postgresql+psycopg://user@127.0.0.1:1/course?colour=red",
            "postgresql+psycopg://user@127.0.0.1:1/course?plugin=colour",
            "sqlite:///gradebook.sqlite?mode=ro",
        ],
    )
    def test_an_option_of_a_url_that_there_is_not_is_to_be_corrected(
        self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str
    ) -> None:
        monkeypatch.chdir(tmp_path)
        with pytest.raises(GradebookError) as caught:
            open_engine(place)
        (problem,) = caught.value.problems
        assert "behind its question mark" in str(problem.remedy)
        assert not list(tmp_path.iterdir())

    def test_a_file_that_is_no_database_is_refused_and_left_alone(self, tmp_path: Path) -> None:
        place = tmp_path / "gradebook.sqlite"
        place.write_text("student,points\n" * 100, encoding="utf-8")
        with pytest.raises(GradebookError, match="not a database"):
            open_engine(str(place))
        assert place.read_text(encoding="utf-8").startswith("student,points")


def test_a_full_disk_is_called_so() -> None:
    with create_engine("sqlite://").begin() as connection:
        connection.execute(text("PRAGMA max_page_count = 2"))
        connection.execute(text("CREATE TABLE kept (value TEXT)"))
        with pytest.raises(GradebookError, match="The disk is full"), refusals_named("here"):
            connection.execute(text("INSERT INTO kept VALUES (zeroblob(100000))"))


def test_a_disk_that_is_only_read_is_told_in_the_readers_language() -> None:
    with create_engine("sqlite://").begin() as connection:
        connection.execute(text("PRAGMA query_only = 1"))
        with pytest.raises(GradebookError) as caught, refusals_named("here"):
            connection.execute(text("CREATE TABLE kept (value TEXT)"))
    (problem,) = caught.value.problems
    assert "not written" in str(problem.what)
    assert problem.what.values == {}, "a database speaks English"


def test_a_password_is_never_shown() -> None:
    url = make_url("postgresql+psycopg://teacher:secret@localhost/course")
    assert "secret" not in without_password(url)
    assert "teacher" in without_password(url)


@pytest.mark.parametrize("option", ["password", "sslpassword", "pasword"])
def test_an_option_that_may_be_a_secret_is_not_shown(option: str) -> None:
    url = make_url(f"postgresql+psycopg://teacher@/course?host=db.uni.ua&{option}=secret")
    assert without_password(url) == "postgresql+psycopg://teacher@/course?host=db.uni.ua"
