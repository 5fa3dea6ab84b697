"""A path that cannot be used is said as an error of the library, with what would mend it."""

from collections.abc import Callable
from pathlib import Path
from typing import Final

import pytest

import gripcourse as gc
from gripcourse.errors import SystemRefusedError

ROSTER: Final = b"student,name\ns01,Anna\n"
Call = Callable[[gc.Course, str], object]

CALLS: Final[dict[str, Call]] = {
    "load": lambda _, path: gc.Course.load(path),
    "validate": lambda _, path: gc.validate(path),
    "variants": lambda course, path: course.variants(path),
    "solve": lambda course, path: course.solve("001", table=path),
    "draw_variants": lambda course, path: course.draw_variants(1, 1, out=path),
    "issue_roster": lambda course, path: course.issue(path, "out"),
    "issue_out": lambda course, path: course.issue(ROSTER, path),
    "check": lambda course, path: course.check(path),
    "grade": lambda course, path: course.grade([path]),
    "grade_out": lambda course, path: course.grade([("s01.xlsx", b"PK")], out=path),
    "init_course": lambda _, path: gc.init_course(path),
    "write_key": lambda course, path: gc.write_key(course, "001", path),
    "write_general_view": lambda course, path: gc.write_general_view(course, "001", path),
    "audit_out": gc.audit_variants,
    "audit_table": lambda course, path: gc.audit_variants(course, "out", table=path),
    "import_variants": lambda course, path: gc.import_variants(course, path, "out.csv"),
    "what_waits": lambda _, path: gc.what_waits(path),
    "enter_marks": lambda course, path: gc.enter_marks(course, path, "out.sqlite", "Ray"),
    "trace": lambda course, path: gc.trace(course, ["1843"], table=path),
    "simulate": lambda course, path: gc.simulate(course, path, count=1, seed=1),
    "evaluate": gc.evaluate,
    "audit_tolerances": lambda course, path: gc.audit_tolerances(course, table=path, count=1),
    "regrade": lambda course, path: gc.regrade(course, [path], "out.sqlite"),
    "history": lambda _, path: gc.history(path, "s01"),
    "publish": lambda _, path: gc.publish(path, by="Ray"),
    "waive": lambda course, path: gc.waive(course, path, "s01", by="Ray", why="ill"),
    "withdraw": lambda course, path: gc.withdraw(
        course, "s01", by="Ray", why="left", gradebook=path
    ),
    "undo_regrade": lambda _, path: gc.undo_regrade(path, by="Ray", why="wrong"),
    "reissue": lambda course, path: gc.reissue(course, ["s01"], path, by="Ray", why="wrong"),
}
NO_PATHS: Final = {
    "below_a_file": "notes.txt/inside",
    "too_long": "x" * 5000,
    "empty": "",
    "zero": "a\0b",
}


@pytest.fixture(scope="module")
def reference() -> gc.Course:
    return gc.Course.load()


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "notes.txt").write_text("A file.", encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize("path", NO_PATHS.values(), ids=NO_PATHS)
@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_what_is_no_path_is_an_error_of_the_library(
    reference: gc.Course, call: Call, path: str
) -> None:
    with pytest.raises(gc.GripcourseError) as refused:
        call(reference, path)
    for problem in refused.value.problems:
        assert str(problem.what)
        assert str(problem.remedy)


@pytest.mark.parametrize(
    "name",
    ["load", "validate", "variants", "issue_roster", "check", "grade", "history", "evaluate"],
)
def test_what_is_read_and_not_there_is_named_with_a_remedy(reference: gc.Course, name: str) -> None:
    with pytest.raises(gc.GripcourseError) as refused:
        CALLS[name](reference, "nowhere/that.xlsx")
    (problem,) = refused.value.problems
    assert "nowhere/that.xlsx" in problem.file
    assert str(problem.remedy)


def test_what_the_system_said_stays_with_the_error(reference: gc.Course) -> None:
    with pytest.raises(SystemRefusedError, match=r"folder, not a file\. Name a file\.") as refused:
        reference.check(".")
    assert isinstance(refused.value.__cause__, IsADirectoryError)
    assert refused.value.problems[0].file == "."


def test_this_folder_is_no_file_to_write(reference: gc.Course) -> None:
    with pytest.raises(SystemRefusedError, match="folder, not a file"):
        gc.write_key(reference, "001", ".")
