"""A problem is said whole in the reader's language: place, fault, remedy."""

import errno
import pickle

import pytest

from gripcourse.errors import Problem, TableError, system_problem
from gripcourse.text.words import LANGUAGES, Words, message


def test_a_place_without_a_name_of_its_own_is_said_in_the_readers_language() -> None:
    place = message("row {row}, column {column}", row=7, column="mass")
    problem = Problem("t.csv", place, message("The table is empty."), message("Name a file."))
    said = {language: problem.say(Words(language)) for language in LANGUAGES}
    assert said["en"].startswith("t.csv: row 7, column mass: ")
    assert said["ru"].startswith("t.csv: строка 7, столбец mass: ")
    assert said["uk"].startswith("t.csv: рядок 7, стовпець mass: ")


def test_a_key_stays_as_it_is_written_in_the_file() -> None:
    problem = Problem("t.toml", "work.derived.title", message("Name a file."), message("{x}", x=""))
    assert problem.say(Words("ru")).startswith("t.toml: work.derived.title: ")


@pytest.mark.parametrize(
    "code", [errno.ENOENT, errno.EACCES, errno.EISDIR, errno.ENOSPC, errno.EMFILE]
)
def test_what_the_system_refuses_is_said_in_every_language(code: int) -> None:
    problem = system_problem(OSError(code, "English of the system", "a.csv"))
    said = {problem.say(Words(language)) for language in LANGUAGES}
    assert len(said) == len(LANGUAGES)
    assert all(one.startswith("a.csv: ") and "English" not in one for one in said)


def test_a_rare_refusal_stays_as_the_system_says_it() -> None:
    problem = system_problem(OSError(errno.EIO, "Input/output error", "a.csv"))
    assert "Input/output error" in problem.say(Words("en"))


def test_an_error_of_a_worker_arrives_with_its_problems() -> None:
    problem = Problem("t.csv", "", message("The table is empty."), message("Name a file."))
    arrived = pickle.loads(pickle.dumps(TableError([problem])))  # noqa: S301 (our own)
    assert isinstance(arrived, TableError)
    assert arrived.problems == (problem,)


def test_a_folder_that_is_gone_is_no_lack_of_temporary_folders() -> None:
    gone = system_problem(FileNotFoundError(errno.ENOENT, "No such file or directory"))
    none = system_problem(
        FileNotFoundError(errno.ENOENT, "No usable temporary directory found in ['/tmp']")
    )
    assert "folder that you are in" in gone.say(Words("en"))
    assert "temporary files" in none.say(Words("en"))
