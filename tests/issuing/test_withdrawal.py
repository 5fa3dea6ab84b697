"""Who left the course and who was issued to twice: taken out with a reason, and nothing removed."""

from dataclasses import replace
from datetime import UTC, date, datetime
from pathlib import Path

import pytest

from gripcourse.errors import TableError, UsageError
from gripcourse.issuing.allotment import Extended, Terms, extend
from gripcourse.issuing.made_ids import Joined, with_ids
from gripcourse.issuing.register import Register
from gripcourse.issuing.signature import key_path, make_key
from gripcourse.issuing.store import (
    VerifiedRegister,
    extend_register,
    read_register,
    shelve_register,
)
from gripcourse.issuing.withdrawal import Withdrawal, joined_to
from gripcourse.machine.database.home import address_path, home_of
from gripcourse.machine.database.opening import open_engine
from gripcourse.usecases.marks.withdraw import withdraw
from gripcourse.variants.model import Student, Variant

KEY = bytes(range(32))
TERMS = Terms(KEY, date(2026, 9, 1), None)
VARIANTS = [Variant(f"00{one}", "press", {}, {"mass": 10.0 * one}) for one in range(1, 9)]
ANNA, MARRIED, BORIS, VERA = (
    Student(id_, name, "РТК-42", "", "ru", "")
    for id_, name in (
        ("anna", "Иванова Анна"),
        ("petrova", "Петрова Анна"),
        ("boris", "Борисов Н."),
        ("vera", "О'Хара Вера"),
    )
)


@pytest.fixture
def root(tmp_path: Path, place: str) -> Path:
    """A course that issued to Anna twice, under two surnames, and to two more."""
    make_key(key_path(tmp_path), KEY)
    if "://" in place:
        address_path(tmp_path).write_text(place, encoding="utf-8")
    (tmp_path / "variants").mkdir()
    course = 'id = "small"\n'
    (tmp_path / "variants" / "course.toml").write_text(course, encoding="utf-8")
    issue(tmp_path, ANNA, BORIS)
    issue(tmp_path, MARRIED, BORIS, VERA)
    return tmp_path


def issue(root: Path, *students: Student, deadline: date | None = None) -> Extended:
    terms = replace(TERMS, deadline=deadline)
    return extend_register(root, "small", lambda before: extend(before, students, VARIANTS, terms))


def said(root: Path, student: str, same_as: str = "", *, undo: bool = False) -> list[str]:
    at = datetime(2026, 10, 5, 12, tzinfo=UTC)
    wanted = Withdrawal(student, same_as, undo, "Order 12.", "Петров", at)
    return [str(one) for one in withdraw(wanted, root, home_of(root)).notes]


def read(root: Path) -> Register:
    return read_register(root, "small")


class TestJoining:
    def test_the_person_keeps_the_first_variant_and_has_the_second_beside_it(
        self, root: Path
    ) -> None:
        said(root, "petrova", "anna")
        register = read(root)
        assert list(register.by_student()) == ["anna", "boris", "vera"]
        second, first = register.versions()["anna"]
        assert (first.variant.id, first.signed_for) == ("001", "anna")
        assert (second.variant.id, second.signed_for) == ("003", "petrova")
        assert second.student == first.student == ANNA
        assert register.find("petrova") == first

    def test_on_the_shelf_it_is_the_same(self, root: Path) -> None:
        said(root, "petrova", "anna")
        said(root, "boris")
        plain, found = read(root), shelve_register(root, "small")
        assert dict(found.last) == plain.by_student()
        assert found.last["boris"].left == "Order 12."
        assert dict(found.earlier) == {"anna": plain.versions()["anna"][:-1]}
        assert found.joined == {"petrova": "anna"}

    @pytest.mark.parametrize(
        ("first", "second", "counts"),
        [
            (date(2026, 12, 1), date(2026, 12, 10), date(2026, 12, 10)),
            (date(2026, 12, 10), date(2026, 12, 1), date(2026, 12, 10)),
            (date(2026, 12, 1), None, None),
        ],
    )
    def test_the_later_deadline_of_both_sheets_counts(
        self, root: Path, first: date, second: date | None, counts: date | None
    ) -> None:
        for student, day in ((VERA, first), (BORIS, second)):
            issue(root, replace(student, id=f"{student.id}2"), deadline=day)
        said(root, "boris2", "vera2")
        assert read(root).by_student()["vera2"].deadline == counts
        assert dict(shelve_register(root, "small").last) == read(root).by_student()

    def test_nobody_else_ever_gets_either_variant(self, root: Path) -> None:
        said(root, "petrova", "anna")
        with pytest.raises(TableError):
            issue(root, Student("new", "Новиков П.", "", "", "", "003"))
        issue(root, Student("new", "Новиков П.", "", "", "", ""))
        assert read(root).by_student()["new"].variant.id == "005"

    def test_what_was_issued_stays_in_the_tables_as_it_was(self, root: Path) -> None:
        before = read(root)
        said(root, "petrova", "anna")
        said(root, "petrova", undo=True)
        after = read(root)
        assert (after.entries, after.earlier) == (before.entries, before.earlier)
        assert [one.undone for one in after.withdrawals] == [False, True]

    def test_of_a_chain_everything_is_the_last_ones(self, root: Path) -> None:
        said(root, "petrova", "anna")
        said(root, "anna", "vera")
        register = read(root)
        assert joined_to(register.withdrawals) == {"petrova": "vera", "anna": "vera"}
        assert {one.signed_for for one in register.versions()["vera"]} == {
            "petrova",
            "anna",
            "vera",
        }
        said(root, "anna", undo=True)
        assert joined_to(read(root).withdrawals) == {"petrova": "anna"}

    @pytest.mark.parametrize(
        ("student", "same_as", "undo", "refusal"),
        [
            ("petrowa", "anna", False, "no student 'petrowa'"),
            ("petrova", "ana", False, "no student 'ana'"),
            ("petrova", "petrova", False, "the same entry"),
            ("petrova", "", True, "not withdrawn"),
            ("petrowa", "", True, "no student 'petrowa'"),
        ],
    )
    def test_what_cannot_be_joined_is_refused_and_nothing_is_kept(
        self, root: Path, student: str, same_as: str, *, undo: bool, refusal: str
    ) -> None:
        with pytest.raises(UsageError, match=refusal):
            said(root, student, same_as, undo=undo)
        assert read(root).withdrawals == ()

    def test_a_second_time_it_is_refused(self, root: Path) -> None:
        said(root, "petrova", "anna")
        with pytest.raises(UsageError, match="joined with anna already: Order 12"):
            said(root, "petrova", "vera")
        with pytest.raises(UsageError, match="Name the id of the entry that the person keeps"):
            said(root, "vera", "petrova")

    def test_without_a_reason_it_is_refused(self, root: Path) -> None:
        wanted = Withdrawal("petrova", "anna", False, " ", "Петров", datetime.now(UTC))
        with pytest.raises(UsageError, match="needs a reason"):
            withdraw(wanted, root, home_of(root))

    def test_who_asks_all_the_time_is_told_at_once(self, root: Path) -> None:
        verified = VerifiedRegister(root, "small", open_engine(home_of(root)))
        assert "petrova" in verified.read().by_student()
        said(root, "petrova", "anna")
        assert "petrova" not in verified.read().by_student()


class TestLists:
    JOINED = Joined((MARRIED,), {"petrova": "anna"})

    @pytest.mark.parametrize("listed", [ANNA, MARRIED, replace(MARRIED, id="")])
    def test_either_name_and_either_id_are_the_same_person(self, listed: Student) -> None:
        (student,), _, problems = with_ids([listed], [ANNA, BORIS], self.JOINED)
        assert (student.id, student.name, problems) == ("anna", listed.name, [])

    def test_that_an_id_is_another_now_is_said(self) -> None:
        _, (note,), _ = with_ids([MARRIED], [ANNA], self.JOINED)
        assert "petrova → anna" in str(note)

    def test_both_in_one_list_are_one_too_many(self) -> None:
        _, _, [(place, (what, _))] = with_ids([ANNA, MARRIED], [ANNA], self.JOINED)
        assert place == 1
        assert str(what) == "'Петрова Анна' is in the list already: petrova was joined with anna."

    def test_nobody_new_gets_an_id_that_was_joined(self) -> None:
        (student,), _, _ = with_ids([Student("", "Petrova", "B", "", "", "")], [ANNA], self.JOINED)
        assert student.id == "petrova-2"

    def test_a_new_surname_with_first_name_and_patronymic_is_asked_about_before_anything_is_issued(
        self,
    ) -> None:
        known = Student("i", "Иванова Мария Петровна", "РТК-41", "", "", "")
        listed = replace(known, id="", name="Кузнецова Мария Петровна", group="РТК 41")
        _, _, [(_, (what, _))] = with_ids([listed], [known])
        assert "'Кузнецова Мария Петровна' may be 'Иванова Мария Петровна'" in str(what)

    @pytest.mark.parametrize(
        "name", ["Кузнецова Мария Олеговна", "Иванова Ольга Петровна", "Кузнецова Мария"]
    )
    def test_less_in_common_is_another_person(self, name: str) -> None:
        known = Student("i", "Иванова Мария Петровна", "РТК-41", "", "", "")
        _, _, problems = with_ids([replace(known, id="", name=name)], [known])
        assert problems == []

    def test_an_office_that_gives_ids_has_told_a_namesake_apart(self) -> None:
        known = Student("7001", "Иванова Мария Петровна", "РТК-41", "", "", "")
        listed = replace(known, id="7002", name="Кузнецова Мария Петровна")
        assert with_ids([listed], [known])[2] == []


class TestLeaving:
    def test_the_entry_stays_and_says_why(self, root: Path) -> None:
        said(root, "boris")
        assert read(root).by_student()["boris"].left == "Order 12."
        with pytest.raises(UsageError, match="has left already: Order 12"):
            said(root, "boris")

    def test_who_left_is_named_where_a_list_has_them_still(self, root: Path) -> None:
        said(root, "boris")
        extended = issue(root, ANNA, BORIS)
        assert extended.left == ("boris",)
        assert "boris is in the list and has left the course: Order 12." in str(extended.notes[0])

    def test_nobody_is_asked_whether_who_left_has_another_name_now(self, root: Path) -> None:
        assert issue(root, BORIS, VERA, ANNA, replace(ANNA, id="new")).in_and_out == (
            ("new",),
            ("petrova",),
        )
        said(root, "petrova")
        assert issue(root, BORIS, VERA, ANNA, replace(ANNA, id="newer")).in_and_out == (
            ("newer",),
            ("new",),
        )

    def test_who_comes_back_has_what_was_issued(self, root: Path) -> None:
        before = read(root).by_student()["boris"]
        said(root, "boris")
        said(root, "boris", undo=True)
        assert read(root).by_student()["boris"] == before
        assert issue(root, ANNA, BORIS).left == ()

    def test_who_left_may_turn_out_to_be_somebody_else(self, root: Path) -> None:
        said(root, "petrova")
        said(root, "petrova", "anna")
        assert joined_to(read(root).withdrawals) == {"petrova": "anna"}
