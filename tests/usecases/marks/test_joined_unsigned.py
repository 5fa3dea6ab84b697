"""Joining says whose a work is, and nothing of the sheet that it was made for.

A workbook without its signature is tied to a sheet by the id that its path, its own cells or a
person names. The two sheets have different numbers, so that a work that is judged by the wrong one
has hardly a point.
"""

from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.usecases.marks.mark import existing_gradebook
from support.office import Office, two_works
from support.unsigned import leave_unsigned

if TYPE_CHECKING:
    from support.classroom import Classroom


@pytest.fixture(scope="module")
def unsigned(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Works of s01 and s03 that bear nobody's name inside, as another program left them."""
    folder = tmp_path_factory.mktemp("inbox")
    works = two_works(issued, folder)
    for path in works.values():
        leave_unsigned(path)
    return works


def variants(office: Office) -> list[tuple[str, str]]:
    """Under which id every attempt is kept, and by whose numbers it was judged."""
    return [(one.student, one.variant) for one in existing_gradebook(office.place).attempts()]


def test_a_work_that_its_path_ties_to_the_second_id_is_judged_by_that_sheet(
    office: Office, unsigned: dict[str, Path]
) -> None:
    (alone,) = office.grade(unsigned["s03"])
    office.join()
    (joined,) = office.grade(unsigned["s03"])
    assert (joined.student, joined.variant, joined.score) == ("s01", alone.variant, alone.score)
    assert office.regrade(unsigned["s03"]).to_apply == ()
    office.join(undo=True)
    (again,) = office.grade(unsigned["s03"])
    assert (again.student, again.score) == ("s03", alone.score)
    assert variants(office) == [("s03", alone.variant)]


def test_one_that_came_first_under_the_joined_id_goes_with_its_sheet(
    office: Office, unsigned: dict[str, Path]
) -> None:
    office.join()
    first, second = office.grade(unsigned["s01"], unsigned["s03"])
    assert (first.student, second.student) == ("s01", "s01")
    office.join(undo=True)
    assert variants(office) == [("s01", first.variant), ("s03", second.variant)]


def test_a_person_who_names_either_id_names_its_sheet(
    office: Office, unsigned: dict[str, Path], tmp_path: Path
) -> None:
    nameless = tmp_path / "work.xlsx"
    nameless.write_bytes(unsigned["s03"].read_bytes())
    (alone,) = office.grade(nameless, whose="s03")
    office.join()
    (joined,) = office.grade(nameless, whose="s03")
    assert (joined.student, joined.variant, joined.score) == ("s01", alone.variant, alone.score)
    (other,) = office.grade(nameless, whose="s01")
    assert other.variant != alone.variant
