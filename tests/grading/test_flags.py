"""What an instructor should look at before marks are published."""

from dataclasses import replace
from typing import TYPE_CHECKING

import pytest

from gripcourse.submission.model import Identity
from gripcourse.text.words import Words

if TYPE_CHECKING:
    from conftest import Case


def flags(case: "Case", **changes: object) -> dict[str, str]:
    """The flags of an otherwise right workbook, with what each says."""
    return {
        one.code: Words("en").say(one.message) for one in case.judge(case.answers, **changes).flags
    }


def identity(case: "Case", **changes: str) -> Identity:
    return replace(case.submission({}).identity, **changes)


def test_an_untouched_workbook_has_no_flags(hydraulic: "Case") -> None:
    assert flags(hydraulic) == {}


def test_a_workbook_that_does_not_say_whose_it_is_is_flagged(hydraulic: "Case") -> None:
    nobody = Identity("", "", "", {}, "")
    assert set(flags(hydraulic, identity=nobody)) == {"identity_missing"}


@pytest.mark.parametrize("signature", ["", "00" * 32, "подпись", "a1" * 31])
def test_another_signature_is_flagged_whatever_it_is(hydraulic: "Case", signature: str) -> None:
    assert set(flags(hydraulic, identity=identity(hydraulic, signature=signature))) == {"signature"}


def test_another_students_workbook_is_flagged_once_and_names_both(hydraulic: "Case") -> None:
    givens = {name: value + 1 for name, value in hydraulic.given.items()}
    others = identity(hydraulic, student="s02", signature="00" * 32)
    found = flags(hydraulic, identity=others, givens=givens)
    assert set(found) == {"issued_to_other"}
    assert "s01" in found["issued_to_other"]
    assert "s02" in found["issued_to_other"]


def test_changed_given_values_are_named_and_do_not_count(hydraulic: "Case") -> None:
    givens = {**hydraulic.given, "mass": 1.0, "friction": 0.9}
    found = flags(hydraulic, givens=givens)
    assert set(found) == {"givens_changed"}
    assert "mass" in found["givens_changed"]
    assert "friction" in found["givens_changed"]
    report = hydraulic.judge(hydraulic.answers, givens=givens)
    assert report.score == pytest.approx(report.max_score)


def test_a_given_value_that_is_gone_is_named(hydraulic: "Case") -> None:
    givens = {name: value for name, value in hydraulic.given.items() if name != "mass"}
    found = flags(hydraulic, givens=givens)
    assert set(found) == {"givens_missing"}
    assert "mass" in found["givens_missing"]


def test_answers_that_the_workbook_has_no_cells_for_are_named_some_of_them(
    hydraulic: "Case",
) -> None:
    absent = tuple(one.id for one in hydraulic.plan.answered)
    found = flags(hydraulic, absent=absent[:1])
    assert set(found) == {"answers_missing"}
    assert "1 answer," in found["answers_missing"]
    assert absent[0] in found["answers_missing"]
    said = flags(hydraulic, absent=absent)["answers_missing"]
    assert f"{len(absent)} answers," in said
    assert absent[-1] not in said


def test_in_the_workbook_of_another_student_other_cells_are_no_flag(hydraulic: "Case") -> None:
    others = identity(hydraulic, student="s02", signature="00" * 32)
    assert set(flags(hydraulic, identity=others, absent=("mass",))) == {"issued_to_other"}


def test_the_last_digits_that_a_spreadsheet_loses_are_no_change(hydraulic: "Case") -> None:
    givens = {name: float(f"{value:.15g}") * (1 + 1e-15) for name, value in hydraulic.given.items()}
    assert flags(hydraulic, givens=givens) == {}
