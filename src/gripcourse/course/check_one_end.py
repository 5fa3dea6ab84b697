"""Whether what says that always one of two values is taken stands beside a choice of two."""

from collections.abc import Iterator

from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.formula.tree import choices_of_two
from gripcourse.text.words import message


def check_one_end(course: Course) -> Iterator[Problem]:
    """Yield which quantities give a reason for a choice that their formula does not make.

    A scheme may bring another formula for a quantity of a part: what the part says stays.
    """
    parts = [part.quantities for part in course.parts.values()]
    own = [scheme.quantities for scheme in course.schemes.values()]
    for one in (quantity for each in (*parts, *own) for quantity in each.values()):
        if one.one_end is not None and not _chooses(one):
            yield Problem(
                one.file,
                f"quantity.{one.id}.one_end",
                message(
                    "The formula does not choose between two values, of which it could always"
                    " take the same."
                ),
                message("Remove the key, or take max(…) or min(…) of two different quantities."),
            )


def _chooses(one: Quantity) -> bool:
    return one.formula is not None and any(choices_of_two(one.formula.tree))
