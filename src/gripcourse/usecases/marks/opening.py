"""What grading and marking need of a course, loaded and checked."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import chain
from pathlib import Path

from gripcourse.batch.context import GradingContext
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.read import course_id
from gripcourse.errors import NextStep, Problem, UsageError
from gripcourse.gradebook.deadlines import course_deadlines
from gripcourse.grading.path_pattern import path_pattern
from gripcourse.issuing.register import Register
from gripcourse.issuing.store import read_register, shelve_register
from gripcourse.machine.content import Readable
from gripcourse.machine.office import office_command
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.policy.time_rules import zone_of
from gripcourse.text.words import message
from gripcourse.usecases.issuing.declarations import kept_declarations
from gripcourse.usecases.marks.answered import with_answers
from gripcourse.usecases.marks.batch_wish import BatchWish
from gripcourse.usecases.marks.gradebook import check_gradebook, with_kept_versions
from gripcourse.usecases.marks.handed_in import HandingTime, handed_in_times
from gripcourse.usecases.marks.whose import read_whose
from gripcourse.variants.model import Issued


def open_grading(root: Path) -> GradingContext:
    """Load a course, its policy and its register.

    Raises:
        CourseError: with all problems of course or policy.
        RegisterError: the register cannot be used.
    """
    course = load_course(root)
    return grading_of(course, load_policy(course))


def issued_of(root: Path) -> Mapping[str, Issued]:
    """Read what was issued to each student, though the course has problems of its own.

    Raises:
        CourseError: its main file cannot be read, or has no id.
        RegisterError: the register cannot be used.
    """
    return register_of(root).by_student()


def register_of(root: Path) -> Register:
    """Read all that was issued, and who was withdrawn, though the course has problems of its own.

    Raises:
        CourseError: its main file cannot be read, or has no id.
        RegisterError: the register cannot be used.
    """
    return read_register(root, course_id(root))


def grading_of(course: Course, policy: Policy) -> GradingContext:
    """Read the register of a loaded course.

    Raises:
        RegisterError: the register cannot be used.
    """
    register = shelve_register(course.root, course.id)
    last, earlier = register.last, register.earlier
    return GradingContext(
        course,
        policy,
        last,
        office=office_command(),
        earlier=earlier,
        declared=kept_declarations(course.root, last, chain.from_iterable(earlier.values())),
        joined=register.joined,
        joins=register.joins,
        former=register.former,
    )


def as_wished(
    wish: BatchWish,
    files: Sequence[Readable],
    context: GradingContext,
    place: str | None,
    workers: int,
) -> tuple[GradingContext, Mapping[str, HandingTime]]:
    """Return what a batch is graded with, and when its files were handed in, by name.

    What cannot be used is refused here, before anything is graded for nothing.

    Args:
        wish: of a person.
        files: of the batch.
        context: of the course.
        place: of the gradebook, a path or a database URL; None for none.
        workers: how many processes open files.

    Raises:
        UsageError: with what cannot be used of the wish.
        GradebookError: the gradebook is there and cannot be used.
        TableError: the course's table of deadlines cannot be used.
    """
    context = by_word(wish, files, context)
    if wish.recalculate:
        context = recalculating(context, workers)
    late = context.policy.late
    times = handed_in_times(wish.handed_in, files, zone_of(late))
    if place is not None:
        check_gradebook(place)
        context = with_answers(with_kept_versions(context, place), place, files)
        # Read again where they are needed. A row for nobody would make somebody late, silently.
        entries = context.register.values()
        people = [person for one in entries for person in (one.student, *one.joined)]
        course_deadlines(context.course.root, late, people)
    return context, times


def by_word(wish: BatchWish, files: Sequence[Readable], context: GradingContext) -> GradingContext:
    """Return the same where a person says whose files are, and which versions count.

    Raises:
        UsageError: a file or a student that is named is not there, or a pattern says nothing.
    """
    known_ids = {*context.register, *context.joined}
    return replace(
        context,
        whose=read_whose(wish.whose, files, context.register, context.joined),
        pattern=None if wish.pattern is None else path_pattern(wish.pattern, known_ids),
        either_version=wish.either_version,
    )


def recalculating(context: GradingContext, workers: int) -> GradingContext:
    """Return the same where LibreOffice computes every formula once more.

    Args:
        context: what grading needs.
        workers: how many processes read files; without any, no other program is let near them.

    Raises:
        UsageError: there is no LibreOffice, or no worker.
    """
    if context.office is None:
        what = message("LibreOffice is not installed: nothing can be recalculated.")
        remedy = message("Install it, or leave the option out; a check of the machine says how.")
        raise UsageError(
            [Problem("", "", what, remedy, parameter="recalculate", step=NextStep.CHECK_MACHINE)]
        )
    if not workers:
        what = message("Formulas are recalculated by workers, and there is none.")
        remedy = message("Give one worker or more.")
        raise UsageError([Problem("", "", what, remedy, parameter="workers")])
    return replace(context, recalculate=True)
