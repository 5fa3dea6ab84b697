"""Checking a course that need not be one that can be loaded."""

from pathlib import Path

from gripcourse.api.choices import chosen_language
from gripcourse.api.make_results import problems_result
from gripcourse.api.refusals import refusals_said
from gripcourse.api.results import ProblemsResult
from gripcourse.api.sources import path_of
from gripcourse.machine.resources import course_root
from gripcourse.text.words import Words


@refusals_said
def validate(folder: str | Path | None = None, language: str = "en") -> ProblemsResult:
    """List every problem of a course at once, also of one that cannot be loaded.

    Args:
        folder: of the course; None for the reference course.
        language: of the sentences.

    Raises:
        UsageError: the folder is no course.
    """
    # The documents that are tried cost half a second to import.
    from gripcourse.usecases.authoring.validate import validated  # noqa: PLC0415

    root = course_root(None if folder is None else path_of(folder))
    found = validated(root)
    return problems_result(found.problems, Words(chosen_language(language)), found.notes)
