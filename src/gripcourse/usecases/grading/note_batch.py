"""Who had files graded: kept, whoever began it where."""

from datetime import datetime

from gripcourse.access.desk.store import open_desk
from gripcourse.machine.database.home import exists


def note_batch(place: str, course: str, files: int, person: str, why: str, now: datetime) -> None:
    """Keep by whom, when and why files were graded.

    Args:
        place: of the gradebook; where there is none, nothing was kept of the files either.
        course: id.
        files: how many.
        person: who has them graded.
        why: in a few words; may be empty.
        now: the time of the attempts that the gradebook keeps of them.

    Raises:
        GradebookError: the gradebook cannot be used.
    """
    if exists(place):
        open_desk(place, course).add_batch(files, person, why, now)
