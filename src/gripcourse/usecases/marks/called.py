"""What people call students and quantities that grades know by their ids."""

from gripcourse.batch.context import GradingContext
from gripcourse.errors import UsageError
from gripcourse.grading.made_for import versions_of
from gripcourse.solver.plan import plan_of
from gripcourse.text.shown import one_line
from gripcourse.text.words import Texts


def name_of(student: str, context: GradingContext) -> str:
    """Return the name of a student; empty for somebody without one, or not on the register."""
    issued = context.register.get(student)
    return "" if issued is None else one_line(issued.student.name)


def student_with_id(student: str, context: GradingContext) -> str:
    """Return what people call a student, and behind it the id, which commands ask for."""
    return _with_id(name_of(student, context), student)


def item_with_id(student: str, quantity: str, context: GradingContext, language: str) -> str:
    """Return what people call a student's quantity, and behind it the id; alone without a title."""
    title = title_of(student, quantity, context)
    return _with_id("" if title is None else title.of(language), quantity)


def title_of(student: str, quantity: str, context: GradingContext) -> Texts | None:
    """Return the title of a student's quantity, by the last version of the assignment that has it.

    Returns:
        The title in each language; None where the course has no such quantity any more.
    """
    if student not in context.register:
        return None
    for issued in reversed(versions_of(student, context.register, context.earlier)):
        try:
            declared = plan_of(context.course, issued.variant.composition).quantities
        except UsageError:  # issued from an earlier version of the course
            continue
        if quantity in declared:
            return declared[quantity].title
    return None


def _with_id(said: str, id_: str) -> str:
    return f"{said} ({id_})" if said and said != id_ else id_
