"""Values that stand behind the answer cells: no answers, but no blanks either."""

from typing import TYPE_CHECKING

import pytest

from gripcourse.grading.unjudged import is_unreadable
from gripcourse.submission.model import Reading

if TYPE_CHECKING:
    from conftest import Returned


@pytest.mark.parametrize("further", [1, 2])
def test_who_types_into_the_next_column_is_told_so(returned: "Returned", further: int) -> None:
    book = returned.book()
    returned.cell(book, "grip_force").offset(column=further).value = "3 850,6 Н"
    read = returned.read(returned.saved(book))
    answer = read.answers["grip_force"]
    assert (answer.reading, answer.value) == (Reading.UNREADABLE, None)
    assert answer.typed == "3 850,6 Н"
    assert "beside the answer cell" in str(answer.remarks)
    assert read.answers["drive_force"].reading is Reading.BLANK


def test_a_whole_work_in_the_next_column_is_a_question_and_no_zero(returned: "Returned") -> None:
    book = returned.book()
    for asked in returned.plan.answered:
        if asked.kind.value != "manual":
            returned.cell(book, asked.id).offset(column=2).value = 12.5
    assert is_unreadable(returned.read(returned.saved(book)))


def test_notes_beside_an_answer_are_nobody_s_business(returned: "Returned") -> None:
    book = returned.book()
    cell = returned.cell(book, "grip_force")
    cell.value = 3850.6
    cell.offset(column=2).value = 4000
    returned.cell(book, "drive_force").offset(column=2).value = "see page 3"
    read = returned.read(returned.saved(book))
    assert read.answers["grip_force"].value == 3850.6
    assert read.answers["drive_force"].reading is Reading.BLANK
