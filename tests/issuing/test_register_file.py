"""The register keeps what was issued, for good, and says when it is damaged."""

import json
import stat
import sys
from collections.abc import Callable
from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import Any

import pytest

from gripcourse.errors import RegisterError
from gripcourse.issuing.register import Register, changed_entries, verified
from gripcourse.issuing.register_file import (
    old_register_path,
    read_register_file,
    write_register_file,
)
from gripcourse.issuing.signature import sign
from gripcourse.variants.model import Issued, Student, Variant

KEY = bytes(range(32))
DAY = date(2026, 9, 1)


def entry(student: str, variant: str, deadline: date | None = None) -> Issued:
    numbers = Variant(variant, "press", {"fluid": "oil"}, {"mass": 60.0, "friction": 0.1 + 0.2})
    person = Student(student, "Фёдоров Никита", "РТК-42", "", "ru", "")
    return Issued(person, numbers, DAY, deadline, sign(KEY, "small", student, numbers))


REGISTER = Register("small", (entry("fedorov", "001"), entry("popov", "002", date(2026, 12, 1))))


def damaged(path: Path, change: Callable[[dict[str, Any]], None]) -> Path:
    write_register_file(path, REGISTER)
    content = json.loads(path.read_text(encoding="utf-8"))
    change(content)
    path.write_text(json.dumps(content), encoding="utf-8")
    return path


def test_a_written_register_is_read_back_equal(tmp_path: Path) -> None:
    path = old_register_path(tmp_path)
    write_register_file(path, REGISTER)
    assert read_register_file(path, "small") == REGISTER


def test_before_the_first_issue_the_register_is_empty(tmp_path: Path) -> None:
    assert read_register_file(tmp_path / "register.json", "small") == Register("small", ())


def test_entries_are_found_by_student() -> None:
    assert REGISTER.by_student()["popov"].variant.id == "002"


@pytest.mark.skipif(sys.platform == "win32", reason="the mode bits are of POSIX systems")
def test_only_the_owner_can_read_the_register(tmp_path: Path) -> None:
    write_register_file(tmp_path / "register.json", REGISTER)
    assert stat.S_IMODE((tmp_path / "register.json").stat().st_mode) == 0o600


def test_a_changed_number_is_found(tmp_path: Path) -> None:
    def lighter(content: dict[str, Any]) -> None:
        content["issued"][1]["given"]["mass"] = 50.0

    register = read_register_file(damaged(tmp_path / "r.json", lighter), "small")
    assert [one.student.id for one in changed_entries(register, KEY)] == ["popov"]


def test_a_changed_number_is_refused_with_its_student_and_a_remedy(tmp_path: Path) -> None:
    def lighter(content: dict[str, Any]) -> None:
        content["issued"][1]["given"]["mass"] = 50.0

    register = read_register_file(damaged(tmp_path / "r.json", lighter), "small")
    with pytest.raises(RegisterError) as caught:
        verified(register, KEY, "private")
    (problem,) = caught.value.problems
    assert (problem.file, str(problem.key)) == ("private", "student popov")
    assert "002" in str(problem.what)
    assert "backup" in str(problem.remedy)


def test_another_key_is_not_a_changed_register() -> None:
    with pytest.raises(RegisterError, match="it is another key") as caught:
        verified(REGISTER, KEY[::-1], "private")
    assert len(caught.value.problems) == 1


def test_a_corrected_name_is_no_change() -> None:
    first = REGISTER.entries[0]
    renamed = replace(first, student=replace(first.student, name="Фёдоров Н. В.", language="en"))
    assert changed_entries(Register("small", (renamed,)), KEY) == ()


@pytest.mark.parametrize("content", [b"", b"{", b"\xff\xfe", b"[]", b'{"issued": 1}', b"null"])
def test_a_file_that_is_no_register_is_told(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "register.json").write_bytes(content)
    with pytest.raises(RegisterError, match="backup"):
        read_register_file(tmp_path / "register.json", "small")


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("student", None),
        ("variant", 7),
        ("options", []),
        ("given", {"mass": "60"}),
        ("given", {"mass": True}),
        ("issued_on", "yesterday"),
        ("deadline", 20261201),
        ("signature", None),
    ],
)
def test_a_damaged_entry_is_named(tmp_path: Path, key: str, value: object) -> None:
    def spoil(content: dict[str, Any]) -> None:
        content["issued"][1][key] = value

    with pytest.raises(RegisterError) as caught:
        read_register_file(damaged(tmp_path / "r.json", spoil), "small")
    (problem,) = caught.value.problems
    assert str(problem.key) == "entry 2"


def test_all_damaged_entries_are_named_at_once(tmp_path: Path) -> None:
    def spoil(content: dict[str, Any]) -> None:
        del content["issued"][0]["scheme"]
        content["issued"][1]["given"] = None

    with pytest.raises(RegisterError) as caught:
        read_register_file(damaged(tmp_path / "r.json", spoil), "small")
    assert [str(problem.key) for problem in caught.value.problems] == ["entry 1", "entry 2"]


def test_a_student_with_two_entries_is_told(tmp_path: Path) -> None:
    def double(content: dict[str, Any]) -> None:
        content["issued"].append(content["issued"][0])

    with pytest.raises(RegisterError, match="'fedorov' has two entries"):
        read_register_file(damaged(tmp_path / "r.json", double), "small")


def test_the_register_of_another_course_is_refused(tmp_path: Path) -> None:
    write_register_file(tmp_path / "r.json", REGISTER)
    with pytest.raises(RegisterError, match="of the course 'small', not of 'large'"):
        read_register_file(tmp_path / "r.json", "large")


def test_a_register_of_a_later_program_is_refused(tmp_path: Path) -> None:
    path = damaged(tmp_path / "r.json", lambda content: content.update(format=2))
    with pytest.raises(RegisterError, match="format 2, this program knows 1"):
        read_register_file(path, "small")
