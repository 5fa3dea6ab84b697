"""Who gets which variant is decided once: nothing that comes later changes it."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import date

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.errors import TableError
from gripcourse.issuing.allotment import Extended, Terms, extend
from gripcourse.issuing.register import Register, changed_entries
from gripcourse.variants.model import Student, Variant
from gripcourse.variants.names import find_variant

KEY = bytes(range(32))
DAY = date(2026, 9, 1)
TERMS = Terms(KEY, DAY, date(2026, 12, 1))
EMPTY = Register("small", ())


def student(id_: str, variant: str = "") -> Student:
    return Student(id_, f"Name of {id_}", "", "", "", variant)


def table(count: int) -> tuple[Variant, ...]:
    return tuple(
        Variant(f"{number:03d}", "press", {}, {"mass": float(number)})
        for number in range(1, count + 1)
    )


def allotted(extended: Extended) -> dict[str, str]:
    return {entry.student.id: entry.variant.id for entry in extended.register.entries}


def issued(students: Sequence[Student], variants: Sequence[Variant]) -> Register:
    return extend(EMPTY, students, variants, TERMS).register


def test_students_get_the_variants_in_the_order_of_the_table() -> None:
    extended = extend(EMPTY, [student("b"), student("a")], table(5), TERMS)
    assert allotted(extended) == {"b": "001", "a": "002"}
    assert extended.notes == ()


def test_a_fixed_variant_is_set_aside_before_others_are_given_out() -> None:
    students = [student("a"), student("b", "001"), student("c")]
    assert allotted(extend(EMPTY, students, table(5), TERMS)) == {
        "a": "002",
        "b": "001",
        "c": "003",
    }


def test_a_fixed_variant_whose_zeros_were_cut_off_is_found() -> None:
    assert find_variant(table(5), "3") == table(5)[2]
    assert find_variant(table(5), "0") is None
    assert find_variant([*table(5), Variant("3", "press", {}, {})], "03") is None


class TestATableWhoseNoughtsWereDropped:
    """A spreadsheet program that saves the table makes 1 of 001."""

    SAVED = tuple(replace(one, id=one.id.lstrip("0")) for one in table(5))

    def test_nobody_gets_anothers_numbers_under_a_new_name(self) -> None:
        register = issued([student("a"), student("b")], table(5))
        later = extend(register, [student("a"), student("b"), student("c")], self.SAVED, TERMS)
        assert allotted(later) == {"a": "001", "b": "002", "c": "3"}
        (said,) = map(str, later.notes)
        assert said.endswith("they are taken for these: 1 → 001, 2 → 002.")

    def test_a_corrected_row_is_that_of_the_variant_that_was_issued(self) -> None:
        register = issued([student("a")], table(5))
        corrected = [replace(self.SAVED[0], given={"mass": 7.0}), *self.SAVED[1:]]
        later = extend(register, [student("a")], corrected, TERMS)
        assert later.outdated == ("a",)

    def test_the_table_as_it_was_before_is_that_of_what_was_issued_since(self) -> None:
        register = issued([student("a")], self.SAVED)
        later = extend(register, [student("a"), student("b")], table(5), TERMS)
        assert allotted(later) == {"a": "1", "b": "002"}

    def test_names_that_were_issued_apart_stay_apart(self) -> None:
        both = (table(1)[0], replace(self.SAVED[0], given={"mass": 9.0}))
        register = issued([student("a"), student("b")], both)
        later = extend(register, [student("a"), student("b")], both, TERMS)
        assert allotted(later) == {"a": "001", "b": "1"}
        assert later.notes == ()


def test_every_entry_is_dated_and_signed() -> None:
    register = issued([student("a"), student("b")], table(2))
    assert {entry.issued_on for entry in register.entries} == {DAY}
    assert {entry.deadline for entry in register.entries} == {date(2026, 12, 1)}
    assert changed_entries(register, KEY) == ()


def test_a_student_who_comes_later_changes_nobody_elses_variant() -> None:
    register = issued([student("a"), student("c")], table(5))
    later = extend(register, [student("a"), student("b"), student("c")], table(5), TERMS)
    assert allotted(later) == {"a": "001", "c": "002", "b": "003"}
    assert later.register.entries[:2] == register.entries


@given(
    st.lists(st.sampled_from("abcdefgh"), unique=True),
    st.lists(st.sampled_from("abcdefgh"), unique=True),
)
def test_what_was_issued_never_changes(first: list[str], second: list[str]) -> None:
    register = issued([student(id_) for id_ in first], table(8))
    later = extend(register, [student(id_) for id_ in second], table(8), TERMS).register
    assert later.entries[: len(first)] == register.entries
    assert set(later.by_student()) == {*first, *second}
    assert len({entry.variant.id for entry in later.entries}) == len(later.entries)


def test_numbers_stay_when_the_table_changes_and_a_note_says_so() -> None:
    register = issued([student("a")], table(3))
    changed = (Variant("001", "press", {}, {"mass": 99.0}), *table(3)[1:])
    later = extend(register, [student("a")], changed, TERMS)
    assert later.register == register
    assert [str(note) for note in later.notes] == [
        "a keeps variant 001 with the numbers that were issued; the table has others now."
    ]


def test_a_variant_that_left_the_table_stays_with_its_student() -> None:
    register = issued([student("a")], table(3))
    later = extend(register, [student("a"), student("b")], table(3)[1:], TERMS)
    assert allotted(later) == {"a": "001", "b": "002"}
    assert "no longer in the table" in str(later.notes[0])


def test_who_is_not_in_a_later_list_keeps_the_variant() -> None:
    register = issued([student("a")], table(3))
    later = extend(register, [student("b")], table(3), TERMS)
    assert allotted(later) == {"a": "001", "b": "002"}
    assert "1 student who has a variant is not in this list" in str(later.notes[0])


def test_who_is_new_and_who_is_gone_of_the_same_groups_are_named_together() -> None:
    register = issued([student("a"), student("b")], table(3))
    later = extend(register, [student("a"), student("c")], table(3), TERMS)
    assert "New in this list: c; no longer in it, of the same groups: b." in str(later.notes[-1])
    part = extend(register, [student("c")], table(3), TERMS)
    assert "of the same groups" not in "".join(map(str, part.notes))


def test_a_corrected_name_and_language_are_taken_over_and_nothing_else() -> None:
    register = issued([student("a")], table(3))
    corrected = replace(student("a"), name="Right Name", language="en", group="РТК-42")
    later = extend(register, [corrected], table(3), Terms(KEY, date(2026, 10, 1), None))
    (before,), (after,) = register.entries, later.register.entries
    assert after == replace(before, student=corrected)
    assert changed_entries(later.register, KEY) == ()


def test_a_variant_fixed_too_late_and_another_deadline_are_noted() -> None:
    register = issued([student("a")], table(3))
    later = extend(register, [student("a", "003")], table(3), Terms(KEY, DAY, date(2027, 1, 1)))
    assert allotted(later) == {"a": "001"}
    assert [str(note) for note in later.notes] == [
        "a keeps variant 001, although the roster says 003 now.",
        "a keeps the deadline 2026-12-01.",
    ]


def test_who_has_no_deadline_gets_none_by_issuing_again() -> None:
    first = extend(EMPTY, [student("a")], table(3), Terms(KEY, DAY, None))
    later = extend(first.register, [student("a")], table(3), Terms(KEY, DAY, date(2027, 1, 1)))
    assert [entry.deadline for entry in later.register.entries] == [None]
    (note,) = later.notes
    assert str(note).startswith("a was issued without a deadline and still has none.")


def test_too_few_variants_are_counted() -> None:
    students = [student(id_) for id_ in "abcde"]
    needed = r"need a variant: 5; variants that are free: 3; missing: 2"
    with pytest.raises(TableError, match=needed):
        extend(EMPTY, students, table(3), TERMS)


def test_wrong_fixed_variants_are_told_all_at_once() -> None:
    register = issued([student("a")], table(3))
    students = [
        student("a"),
        student("b", "001"),
        student("c", "9"),
        student("d", "2"),
        student("e", "002"),
    ]
    with pytest.raises(TableError) as caught:
        extend(register, students, table(3), TERMS)
    assert [(str(problem.key), str(problem.what)) for problem in caught.value.problems] == [
        ("student b", "The fixed variant '001' is issued to a already."),
        ("student c", "The fixed variant '9' is not in the table."),
        ("student e", "The fixed variant '002' is issued to d already."),
    ]
