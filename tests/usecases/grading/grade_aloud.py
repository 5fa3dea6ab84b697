"""Grade in a process of its own, saying what is done, until somebody kills it."""

import importlib
import sys
from collections.abc import Callable
from datetime import UTC, date, datetime
from pathlib import Path
from zoneinfo import ZoneInfo

from gripcourse.usecases.grading import cohort_print
from gripcourse.usecases.grading import grade as command
from gripcourse.usecases.grading.collect import collect
from gripcourse.usecases.grading.unchanged import open_earlier
from gripcourse.usecases.grading.versions import versions_of
from gripcourse.usecases.marks.gradebook import keep
from gripcourse.usecases.marks.handed_in import handed_in_times
from gripcourse.usecases.marks.opening import open_grading

NOW = datetime(2026, 12, 9, 9, tzinfo=UTC)


def say(word: str) -> Callable[[object], None]:
    """Make what says a word for each file."""

    def told(_: object) -> None:
        sys.stdout.write(f"{word}\n")
        sys.stdout.flush()

    return told


def main() -> None:
    """Grade `works` into `out`, in the folder that the process works in."""
    fake = importlib.import_module("fake_documents")
    cohort_print.cohort_pdf = fake.cohort_page  # type: ignore[attr-defined]
    root, out = Path("course"), Path("out")
    versions = versions_of(root)
    context = open_grading(root)
    earlier = open_earlier(out, context, versions, workers=1)
    files = collect([Path("works")]).files
    graded = command.grade(files, context, 1, say("graded"), earlier)
    times = handed_in_times((), files, ZoneInfo("Europe/Kyiv"))
    graded = keep(graded, context, "course/private/trial.sqlite", NOW, times)
    command.write_results(
        graded,
        context,
        out,
        date(2026, 12, 2),
        1,
        say("reported"),
        lay_out=fake.page,
        earlier=earlier,
    )


if __name__ == "__main__":
    main()
