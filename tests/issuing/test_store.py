"""The register is a store: nothing is lost, given twice, changed unseen, or issued over."""

import stat
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from datetime import date
from pathlib import Path

import pytest
from sqlalchemy import text

from gripcourse.errors import RegisterError, TableError
from gripcourse.issuing.allotment import Extended, Terms, extend
from gripcourse.issuing.register import Register
from gripcourse.issuing.register_file import old_register_path, write_register_file
from gripcourse.issuing.signature import key_path, make_key, sign
from gripcourse.issuing.store import (
    VerifiedRegister,
    extend_register,
    read_register,
    shelve_register,
)
from gripcourse.machine.database.home import address_path, gradebook_path, home_of
from gripcourse.machine.database.opening import open_engine
from gripcourse.variants.model import Issued, Student, Variant

KEY = bytes(range(32))
TERMS = Terms(KEY, date(2026, 9, 1), date(2026, 12, 1))
VARIANTS = [
    Variant(f"00{one}", "press", {"fluid": "oil"}, {"mass": 10.0 * one, "friction": 0.1 + 0.2})
    for one in range(1, 5)
]
ANNA, BORIS = (Student(id_, name, "РТК-42", "", "ru", "") for id_, name in
               (("anna", "Иванова Анна"), ("boris", "Борисов Н.")))  # fmt: skip


@pytest.fixture
def own(tmp_path: Path) -> Path:
    """A course's folder with its key, and its database in a file."""
    make_key(key_path(tmp_path), KEY)
    return tmp_path


@pytest.fixture
def root(own: Path, place: str) -> Path:
    """The same, with either kind of database."""
    if "://" in place:
        address_path(own).write_text(place, encoding="utf-8")
    return own


def issue(root: Path, *students: Student) -> Register:
    def change(register: Register) -> Extended:
        return extend(register, students, VARIANTS, TERMS)

    return extend_register(root, "small", change).register


def issue_often(root: Path, group: str, times: int) -> None:
    many = [Variant(f"{one:03}", "press", {}, {"mass": float(one)}) for one in range(1, 99)]
    for number in range(times):
        students = [replace(ANNA, id=f"{group}{number}{one}") for one in "ab"]
        extend_register(
            root, "small", lambda register, new=students: extend(register, new, many, TERMS)
        )


def spoil(root: Path, statement: str) -> None:
    with open_engine(home_of(root)).begin() as connection:
        connection.execute(text(statement))


class TestKeeping:
    def test_what_was_issued_is_read_back_equal(self, root: Path) -> None:
        issued = issue(root, ANNA, BORIS)
        assert read_register(root, "small") == issued
        assert [one.variant.id for one in issued.entries] == ["001", "002"]

    def test_before_the_first_issue_it_is_empty_and_nothing_is_made(self, own: Path) -> None:
        assert read_register(own, "small") == Register("small", ())
        assert {one.name for one in key_path(own).parent.iterdir()} == {"key"}

    @pytest.mark.skipif(sys.platform == "win32", reason="the mode bits are of POSIX systems")
    def test_only_the_owner_can_read_it(self, own: Path) -> None:
        issue(own, ANNA)
        assert stat.S_IMODE(gradebook_path(own).stat().st_mode) == 0o600

    def test_a_later_issue_keeps_the_order_and_the_numbers(self, root: Path) -> None:
        first = issue(root, BORIS)
        assert issue(root, ANNA, BORIS).entries[:1] == first.entries
        assert list(read_register(root, "small").by_student()) == ["boris", "anna"]

    def test_a_corrected_name_counts_and_the_earlier_one_stays_in_the_tables(
        self, root: Path
    ) -> None:
        issue(root, ANNA, BORIS)
        issue(root, replace(ANNA, name="Петрова Анна"), BORIS)
        issue(root, replace(ANNA, name="Петрова Анна"), BORIS)
        assert read_register(root, "small").by_student()["anna"].student.name == "Петрова Анна"
        with open_engine(home_of(root)).connect() as connection:
            names = connection.execute(text("SELECT name FROM register_person"))
            assert sorted(names.scalars()) == ["Борисов Н.", "Иванова Анна", "Петрова Анна"]
        assert shelve_register(root, "small").former == {"anna": ("Иванова Анна",)}

    def test_what_is_refused_leaves_nothing(self, root: Path) -> None:
        with pytest.raises(TableError):
            issue(root, replace(ANNA, variant="777"))
        assert not gradebook_path(root).exists()
        before = issue(root, ANNA)
        with pytest.raises(TableError):
            issue(root, ANNA, replace(BORIS, variant="001"))
        assert read_register(root, "small") == before

    def test_connections_that_issue_at_once_lose_nothing_and_give_no_variant_twice(
        self, root: Path
    ) -> None:
        groups, times = "abcd", 3
        open_engine(home_of(root))
        with ThreadPoolExecutor(len(groups)) as pool:
            for _ in pool.map(issue_often, [root] * len(groups), groups, [times] * len(groups)):
                pass
        entries = read_register(root, "small").entries
        assert len(entries) == len(groups) * times * 2
        assert max(Counter(one.variant.id for one in entries).values()) == 1

    def test_programs_that_issue_at_once_lose_nothing_and_give_no_variant_twice(
        self, own: Path
    ) -> None:
        """They make the database together, too."""
        root = own
        script, groups, times = Path(__file__).with_name("issuer.py"), "abcdef", 3
        running = [
            subprocess.Popen([sys.executable, str(script), str(root), group, str(times)])  # noqa: S603 (ours)
            for group in groups
        ]
        assert [one.wait() for one in running] == [0] * len(groups)
        entries = read_register(root, "small").entries
        assert len(entries) == len(groups) * times * 2
        assert max(Counter(one.variant.id for one in entries).values()) == 1


class TestVerifying:
    def test_a_changed_number_is_refused_with_its_student(self, root: Path) -> None:
        issue(root, ANNA, BORIS)
        spoil(
            root,
            'UPDATE register_issued SET given = \'{"mass": 5, "friction": 0.3}\''
            " WHERE student = 'boris'",
        )
        for use in (lambda: read_register(root, "small"), lambda: issue(root, ANNA)):
            with pytest.raises(RegisterError) as caught:
                use()
            (problem,) = caught.value.problems
            assert str(problem.key) == "student boris"
            assert "backup" in str(problem.remedy)

    @pytest.mark.parametrize(
        "change", ["options = '['", "given = '[1]'", "issued_on = 'yesterday'", "deadline = '1'"]
    )
    def test_a_damaged_entry_is_named(self, root: Path, change: str) -> None:
        issue(root, ANNA)
        spoil(root, f"UPDATE register_issued SET {change}")  # noqa: S608 (of this test)
        with pytest.raises(RegisterError, match="student anna: The entry is damaged"):
            read_register(root, "small")

    def test_who_asks_all_the_time_sees_every_change_and_no_lie(self, root: Path) -> None:
        issued = issue(root, ANNA)
        asked = VerifiedRegister(root, "small", open_engine(home_of(root)))
        assert asked.read() == issued
        assert asked.read() is asked.read()
        longer = issue(root, ANNA, BORIS)
        assert asked.read() == longer
        issue(root, replace(ANNA, name="Иванова-Петрова Анна"))
        assert asked.read().entries[0].student.name == "Иванова-Петрова Анна"
        was = key_path(root).read_text(encoding="utf-8")
        key_path(root).write_text("0" * 64 + "\n", encoding="utf-8")
        with pytest.raises(RegisterError):
            asked.read()
        key_path(root).write_text(was, encoding="utf-8")
        assert len(asked.read().entries) == 2
        spoil(
            root, """UPDATE register_issued SET given = '{"mass": 1.0}' WHERE student = 'boris'"""
        )
        with pytest.raises(RegisterError):
            asked.read()

    def test_without_its_key_nothing_is_believed(self, root: Path) -> None:
        issue(root, ANNA)
        key_path(root).unlink()
        with pytest.raises(RegisterError, match="key of the signatures is missing"):
            read_register(root, "small")

    def test_the_register_of_another_course_is_refused(self, own: Path) -> None:
        issue(own, ANNA)
        with pytest.raises(RegisterError, match="of the course 'small', not of 'large'"):
            read_register(own, "large")

    def test_a_course_with_a_file_is_not_issued_anew_in_a_database(self, own: Path) -> None:
        issue(own, ANNA)
        url = f"sqlite:///{own / 'department.sqlite'}"
        address_path(own).write_text(url, encoding="utf-8")
        with pytest.raises(RegisterError, match="has a file of its own"):
            issue(own, ANNA)


class TestTakingOver:
    def old(self, root: Path, *students: Student) -> Register:
        entries = tuple(
            Issued(one, variant, TERMS.today, None, sign(KEY, "small", one.id, variant))
            for one, variant in zip(students, VARIANTS, strict=False)
        )
        write_register_file(old_register_path(root), Register("small", entries))
        return Register("small", entries)

    def test_the_register_of_an_earlier_program_is_taken_over_once(self, root: Path) -> None:
        old = self.old(root, ANNA, BORIS)
        content = old_register_path(root).read_bytes()
        assert read_register(root, "small") == old
        assert not old_register_path(root).exists()
        copy = old_register_path(root).with_name("register.json.imported")
        assert copy.read_bytes() == content
        assert read_register(root, "small") == old

    def test_an_issue_goes_on_from_it(self, root: Path) -> None:
        self.old(root, BORIS)
        assert [one.variant.id for one in issue(root, ANNA, BORIS).entries] == ["001", "002"]

    def test_after_a_crash_before_it_was_put_aside_it_is_the_same(self, root: Path) -> None:
        old = self.old(root, ANNA, BORIS)
        read_register(root, "small")
        self.old(root, ANNA, BORIS)
        assert read_register(root, "small") == old

    def test_one_that_was_changed_is_not_taken_over(self, own: Path) -> None:
        self.old(own, ANNA, BORIS)
        path = old_register_path(own)
        path.write_text(path.read_text(encoding="utf-8").replace("20.0", "2.0"), encoding="utf-8")
        with pytest.raises(RegisterError, match="student boris"):
            read_register(own, "small")
        assert path.exists()
        assert not gradebook_path(own).exists()

    def test_one_that_says_otherwise_than_the_database_is_refused(self, root: Path) -> None:
        issue(root, BORIS)
        self.old(root, ANNA, BORIS)
        with pytest.raises(RegisterError, match="says of boris"):
            read_register(root, "small")
        assert old_register_path(root).exists()
