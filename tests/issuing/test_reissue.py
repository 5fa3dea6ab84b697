"""A new version stands beside what was handed out, which stays as it was for good."""

from dataclasses import replace
from datetime import date
from pathlib import Path

import pytest
from sqlalchemy import text

from gripcourse.errors import RegisterError, UsageError
from gripcourse.issuing.allotment import Extended, Terms, extend
from gripcourse.issuing.register import Register
from gripcourse.issuing.reissue import Correction, reissue
from gripcourse.issuing.signature import key_path, make_key
from gripcourse.issuing.store import extend_register, read_register
from gripcourse.machine.database.home import gradebook_path
from gripcourse.machine.database.opening import open_engine
from gripcourse.variants.model import Student, Variant

KEY = bytes(range(32))
FIRST = Terms(KEY, date(2026, 9, 1), date(2026, 12, 1), "declared so")
LATER = Terms(KEY, date(2026, 10, 5), None, "declared so")
VARIANTS = [
    Variant(f"00{one}", "press", {"fluid": "oil"}, {"mass": 10.0 * one}) for one in range(1, 5)
]
CORRECTED = [replace(one, given={"mass": one.given["mass"] + 1}) for one in VARIANTS]
ANNA, BORIS = (Student(one, one.title(), "РТК-42", "", "ru", "") for one in ("anna", "boris"))


def correction(*students: str, variant: str = "", why: str = "опечатка") -> Correction:
    return Correction(students or ("anna",), variant, why, "Петров")


@pytest.fixture
def before() -> Register:
    """Anna has variant 001, Boris 002."""
    return extend(Register("small", ()), [ANNA, BORIS], VARIANTS, FIRST).register


@pytest.fixture
def root(tmp_path: Path, before: Register) -> Path:
    """The folder of a course that issued the same."""
    make_key(key_path(tmp_path), KEY)
    extend_register(tmp_path, "small", lambda _: Extended(before, ()))
    return tmp_path


def refusal(register: Register, wanted: Correction, terms: Terms = LATER) -> list[str]:
    with pytest.raises(UsageError) as caught:
        reissue(register, wanted, VARIANTS, terms)
    return [str(one.what) for one in caught.value.problems]


def test_a_row_that_lost_its_leading_zeros_is_issued_anew_under_its_name(before: Register) -> None:
    saved = [replace(one, id=one.id.lstrip("0")) for one in CORRECTED]
    extended = reissue(before, correction(), saved, LATER)
    assert extended.register.by_student()["anna"].variant == CORRECTED[0]
    assert "they are taken for these: 1 → 001, 2 → 002." in str(extended.notes[0])


class TestVersions:
    def test_the_row_of_the_table_as_it_is_now_is_the_second_version(
        self, before: Register
    ) -> None:
        after = reissue(before, correction(), CORRECTED, LATER).register
        old, new = after.versions()["anna"]
        assert old == before.by_student()["anna"]
        assert new == after.by_student()["anna"]
        assert (new.version, new.variant, new.why, new.issued_by) == (
            *(2, CORRECTED[0]),
            *("опечатка", "Петров"),
        )
        assert (new.issued_on, new.deadline) == (LATER.today, FIRST.deadline)

    def test_nobody_else_gets_one(self, before: Register) -> None:
        after = reissue(before, correction(), CORRECTED, LATER).register
        assert after.versions()["boris"] == before.versions()["boris"]

    def test_what_changed_is_said(self, before: Register) -> None:
        (note,) = reissue(before, correction(), CORRECTED, LATER).notes
        assert "mass: 10 → 11" in str(note)
        (note,) = reissue(before, correction(variant="3"), VARIANTS, LATER).notes
        assert {"003", "001"} <= set(str(note).replace(",", "").split())

    def test_who_was_interrupted_says_the_same_again(self, before: Register) -> None:
        once = reissue(before, correction(), CORRECTED, LATER).register
        tomorrow = replace(LATER, today=date(2026, 10, 6))
        twice = reissue(once, correction(), CORRECTED, tomorrow)
        assert twice.register == once
        assert "already" in str(twice.notes[0])
        later = replace(LATER, deadline=date(2026, 12, 15))
        for other, terms in ((correction(why="ещё раз"), LATER), (correction(), later)):
            with pytest.raises(UsageError, match="just these numbers"):
                reissue(once, other, CORRECTED, terms)

    def test_the_same_numbers_are_a_version_of_their_own_after_an_erratum(
        self, before: Register
    ) -> None:
        corrected = replace(LATER, declarations="declared otherwise")
        after = reissue(before, correction(), VARIANTS, corrected).register
        old, new = after.versions()["anna"]
        assert old.variant == new.variant
        assert old.signature != new.signature

    def test_another_deadline_counts_from_the_new_version_on(self, before: Register) -> None:
        later = replace(LATER, deadline=date(2026, 12, 15))
        after = reissue(before, correction(), CORRECTED, later).register
        deadlines = [one.deadline for one in after.versions()["anna"]]
        assert deadlines == [date(2026, 12, 1), date(2026, 12, 15)]

    def test_a_variant_that_was_handed_out_once_is_given_to_nobody_else(
        self, before: Register
    ) -> None:
        after = reissue(before, correction(variant="003"), VARIANTS, LATER).register
        clara = replace(ANNA, id="clara", name="Clara")
        issued = extend(after, [ANNA, BORIS, clara], VARIANTS, LATER).register
        assert issued.by_student()["clara"].variant.id == "004"
        assert issued.versions()["anna"] == after.versions()["anna"]


class TestRefusals:
    def test_the_same_numbers_by_the_same_declarations(self, before: Register) -> None:
        (said,) = refusal(before, correction())
        assert "anna" in said

    def test_all_that_is_wrong_is_said_at_once(self, before: Register) -> None:
        said = refusal(before, correction("nobody", "anna", variant="777", why="  "))
        assert len(said) == 3

    def test_a_variant_that_somebody_else_has_is_named_with_its_holder(
        self, before: Register
    ) -> None:
        (said,) = refusal(before, correction(variant="002"))
        assert "boris" in said

    def test_one_variant_is_not_given_to_two(self, before: Register) -> None:
        (said,) = refusal(before, correction("anna", "boris", variant="003"))
        assert "anna" in said


class TestKeeping:
    def test_all_versions_are_read_back_equal(self, root: Path) -> None:
        def change(register: Register) -> Extended:
            return reissue(register, correction(), CORRECTED, LATER)

        after = extend_register(root, "small", change).register
        assert read_register(root, "small") == after
        again = extend_register(
            root, "small", lambda one: reissue(one, correction(variant="4"), VARIANTS, LATER)
        ).register
        assert read_register(root, "small") == again
        assert [one.variant.id for one in again.versions()["anna"]] == ["001", "001", "004"]

    @pytest.mark.parametrize("change", ["given = '{\"mass\": 5}'", "version = 3"])
    @pytest.mark.parametrize("version", [1, 2])
    def test_a_version_that_somebody_changed_is_refused_with_its_student(
        self, root: Path, version: int, change: str
    ) -> None:
        extend_register(root, "small", lambda one: reissue(one, correction(), CORRECTED, LATER))
        statement = f"UPDATE register_issued SET {change} WHERE student = 'anna' AND version = "  # noqa: S608 (our own)
        with open_engine(str(gradebook_path(root))).begin() as connection:
            connection.execute(text(statement + str(version)))
        with pytest.raises(RegisterError) as caught:
            read_register(root, "small")
        assert {str(one.key) for one in caught.value.problems} == {"student anna"}
