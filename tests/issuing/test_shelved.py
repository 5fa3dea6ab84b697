"""The register on a shelf says what the register in memory says, and takes no room in it."""

import pickle
import tempfile
import tracemalloc
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import date
from pathlib import Path

import pytest
from sqlalchemy import text

from gripcourse.errors import RegisterError
from gripcourse.issuing.allotment import Terms, extend
from gripcourse.issuing.register import Register
from gripcourse.issuing.reissue import Correction, reissue
from gripcourse.issuing.shelved import ShelvedRegister, shelved
from gripcourse.issuing.signature import key_path, make_key, sign
from gripcourse.issuing.store import extend_register, read_register, shelve_register
from gripcourse.machine.database.home import address_path, home_of
from gripcourse.machine.database.opening import open_engine
from gripcourse.variants.model import Issued, Student, Variant, names_of

KEY = bytes(range(32))
FIRST = Terms(KEY, date(2026, 9, 1), date(2026, 12, 1), "declared so")
LATER = Terms(KEY, date(2026, 10, 5), None, "declared otherwise")
VARIANTS = [
    Variant(f"00{one}", "press", {"fluid": "oil"}, {"mass": 10.0 * one, "friction": 0.1 + 0.2})
    for one in range(1, 8)
]
ANNA, BORIS, VERA = (
    Student(id_, name, "РТК-42", "", "ru", "")
    for id_, name in (("vera", "Иванова Анна"), ("boris", "Борисов Н."), ("anna", "О'Хара Вера"))
)
MANY = 2000


@pytest.fixture
def root(tmp_path: Path, place: str) -> Path:
    """A course with three versions for one student, two for another, one for the third."""
    make_key(key_path(tmp_path), KEY)
    if "://" in place:
        address_path(tmp_path).write_text(place, encoding="utf-8")

    def correct(by: float, *students: str) -> None:
        wanted = Correction(students, "", "опечатка", "Петров")
        table = [replace(one, given={**one.given, "mass": by}) for one in VARIANTS]
        extend_register(tmp_path, "small", lambda before: reissue(before, wanted, table, LATER))

    issue(tmp_path, ANNA, BORIS, VERA)
    correct(7.0, "boris")
    correct(8.0, "boris", "anna")
    issue(tmp_path, replace(ANNA, name="Сидорова Анна"))
    return tmp_path


def issue(root: Path, *students: Student) -> None:
    extend_register(root, "small", lambda before: extend(before, students, VARIANTS, FIRST))


def refusal(
    read: Callable[[Path, str], Register | ShelvedRegister], root: Path, course: str
) -> list[str]:
    with pytest.raises(RegisterError) as caught:
        read(root, course)
    return [str(one) for one in caught.value.problems]


def many() -> Iterator[Issued]:
    for number in range(MANY):
        student = Student(f"u{number}", f"Студент {number}", "A", f"{number}@example.org", "", "")
        given = {f"length_{one}": number + one / 7 for one in range(30)}
        variant = Variant(f"v{number}", "press", {"fluid": "oil"}, given)
        signature = sign(KEY, "small", student.id, variant)
        yield Issued(student, variant, FIRST.today, FIRST.deadline, signature)


def on_shelf() -> ShelvedRegister:
    return shelved(many(), "small", [KEY], "here")


def test_it_says_what_the_register_says(root: Path) -> None:
    plain, found = read_register(root, "small"), shelve_register(root, "small")
    assert sorted(len(all_) for all_ in plain.versions().values()) == [1, 2, 3]
    last = plain.by_student()
    assert list(found.last.items()) == list(last.items())
    assert repr(list(found.last.values())) == repr(list(last.values()))
    assert (found.last == last, {**found.last} == last, "nobody" in found.last) == (
        True,
        True,
        False,
    )
    assert found.earlier == {
        student: all_[:-1] for student, all_ in plain.versions().items() if all_[1:]
    }
    assert list(names_of(found.last)) == list(names_of(last))


def test_it_is_another_where_anything_is(root: Path) -> None:
    found = shelve_register(root, "small").last
    anna = found["vera"]
    assert found != {**found, "vera": replace(anna, issued_on=date(2026, 9, 2))}
    assert found != {student: one for student, one in found.items() if one != anna}


def test_where_nothing_was_issued_it_is_empty(tmp_path: Path) -> None:
    make_key(key_path(tmp_path), KEY)
    assert not shelve_register(tmp_path, "small").last


def test_it_is_refused_with_the_same_words(root: Path) -> None:
    for statement in (
        "UPDATE register_issued SET variant = '007' WHERE version = 1 AND student <> 'vera'",
        "UPDATE register_issued SET scheme = 'other'",
        "UPDATE register_issued SET given = '[1]' WHERE student = 'anna'",
        "UPDATE register_issued SET deadline = '1' WHERE student = 'boris'",
        "DELETE FROM register_person WHERE student = 'vera'",
    ):
        with open_engine(home_of(root)).begin() as connection:
            connection.execute(text(statement))
        assert refusal(shelve_register, root, "small") == refusal(read_register, root, "small")


def test_so_are_another_course_and_a_lost_key(tmp_path: Path) -> None:
    make_key(key_path(tmp_path), KEY)
    issue(tmp_path, ANNA)
    assert refusal(shelve_register, tmp_path, "large") == refusal(read_register, tmp_path, "large")
    key_path(tmp_path).unlink()
    assert refusal(shelve_register, tmp_path, "small") == refusal(read_register, tmp_path, "small")


def test_it_travels_with_all_that_lies_on_the_shelf() -> None:
    packed = pickle.dumps(on_shelf())
    assert len(packed) < 700 * MANY
    there = pickle.loads(packed)  # noqa: S301 (ours)
    assert list(there.last.values()) == list(many())


def test_without_room_on_the_disk_it_stays_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(**_: object) -> None:
        raise OSError

    monkeypatch.setattr(tempfile, "TemporaryFile", full)
    there = pickle.loads(pickle.dumps(on_shelf()))  # noqa: S301 (ours)
    assert list(there.last.values()) == list(many())


def test_in_memory_are_ids_and_places() -> None:
    tracemalloc.start()
    try:
        found = on_shelf()
        held, _ = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert len(found.last) == MANY
    # In memory each would take more than 1000 bytes.
    assert held < 250 * MANY
