"""A program looks at a regrade as a person does: whose the files are, by which version, how far."""

from datetime import UTC, datetime
from typing import TYPE_CHECKING

import gripcourse as gc
from gripcourse.batch.graded import Graded
from gripcourse.batch.one_file import grade_file
from gripcourse.usecases.marks.gradebook import keep, with_kept_versions

if TYPE_CHECKING:
    from pathlib import Path

    from support.classroom import Classroom


def test_a_program_says_whose_a_file_is_and_is_told_of_each_that_is_done(
    own: gc.Course, issued: "Classroom", tmp_path: "Path"
) -> None:
    place = str(tmp_path / "gradebook.sqlite")
    context = with_kept_versions(issued.context, place)
    file = issued.workbook("s01")
    keep([Graded(grade_file(file, context), "")], context, place, datetime.now(UTC))
    done: list[object] = []
    seen = gc.regrade(own, [file], place, either_version=True, on_done=done.append)
    assert [one.work.student for one in seen.changes] == ["s01"]
    assert done == [file]
    anothers = gc.regrade(own, [file], place, whose={file.name: "s02"})
    assert (anothers.changes, anothers.strangers) == ((), (str(file),))
