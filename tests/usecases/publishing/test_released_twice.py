"""Students see results of their own works, whoever was joined with them at the release."""

import shutil
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.exports.grades import grades_text
from gripcourse.machine.database.home import home_of
from gripcourse.text.words import Words
from gripcourse.usecases.grading.batch_tables import GRADES_CSV, GRADES_JSON, json_text
from gripcourse.usecases.publishing.publish import publish, published_to
from gripcourse.usecases.serving.desk import DeskContext, open_context
from support.office import Office, two_works

if TYPE_CHECKING:
    from support.classroom import Classroom


class Release:
    """An office that lets students see what it grades."""

    def __init__(self, office: Office, folder: Path) -> None:
        self.office, self.folder = office, folder
        self.context: DeskContext = open_context(office.root)

    def release(self, *files: Path) -> list[float]:
        """Grade files, let the results be seen, and return the points to a hundredth."""
        reports = self.office.grade(*files)
        text = json_text(reports, Words("en"))
        (self.folder / GRADES_JSON).write_text(text, encoding="utf-8")
        (self.folder / GRADES_CSV).write_text(grades_text(reports), encoding="utf-8-sig")
        publish(self.context, self.folder, "Петров", "", self.office.later())
        return [round(one.score, 2) for one in reports]

    def seen(self, student: str) -> float | None:
        """Points that a student sees, to a hundredth; None for no result."""
        found = published_to(self.context, student)
        return None if found is None else round(found.report.score or 0.0, 2)


@pytest.fixture
def release(issued: "Classroom", tmp_path: Path) -> Release:
    root = shutil.copytree(issued.course.root, tmp_path / "course")
    (tmp_path / "graded").mkdir()
    return Release(Office(root, home_of(root)), tmp_path / "graded")


@pytest.fixture(scope="module")
def works(issued: "Classroom", tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return two_works(issued, tmp_path_factory.mktemp("inbox"))


def test_what_was_released_while_two_were_joined_goes_with_the_work(
    release: Release, works: dict[str, Path]
) -> None:
    release.office.join()
    (points,) = release.release(works["s03"])
    assert release.seen("s01") == points
    release.office.join(undo=True)
    # Nobody sees the result of somebody else.
    assert (release.seen("s01"), release.seen("s03")) == (None, points)


def test_of_two_that_were_released_the_person_sees_the_one_that_counts(
    release: Release, works: dict[str, Path]
) -> None:
    first, again = release.release(works["s01"], works["s03"])
    assert (release.seen("s01"), release.seen("s03")) == (first, again)
    assert first != again
    release.office.join()
    # Without a rule the last one counts; of a batch without times that of the id that is kept.
    assert release.seen("s01") == first
    release.office.join(undo=True)
    release.office.join("s01", "s03")
    assert release.seen("s03") == again
