"""A grader in a process of its own: grades and marks the same student again and again."""

import sys
from datetime import UTC, datetime

from gripcourse.gradebook.model import Attempt, Fingerprints, Mark
from gripcourse.gradebook.results import Result
from gripcourse.gradebook.store import open_gradebook
from gripcourse.grading.model import Outcome


def write(place: str, marker: str, times: int) -> None:
    """Keep so many attempts and marks of one student, each different from all others."""
    book = open_gradebook(place)
    now = datetime(2026, 12, 2, tzinfo=UTC)
    for number in range(times):
        results = (Result("drawing", Outcome.MANUAL, 0.0, 10.0),)
        book.add_attempts(
            [
                Attempt(
                    student="s01",
                    number=0,
                    variant="001",
                    scheme="rack",
                    file=f"{marker}-{number}.xlsx",
                    digest=f"{marker}{number:0>50}",
                    graded_at=now,
                    fingerprints=Fingerprints("c" * 64, "d" * 64),
                    judged=True,
                    results=results,
                )
            ]
        )
        book.add_marks(
            [
                Mark(
                    student="s01",
                    quantity="drawing",
                    number=0,
                    attempt=1,
                    credit=number / times,
                    lines={"sizes": number / times},
                    marker=marker,
                    marked_at=now,
                    comment=str(number),
                )
            ]
        )


if __name__ == "__main__":
    write(sys.argv[1], sys.argv[2], int(sys.argv[3]))
