"""What stands in a table where its author wrote nothing: the worked example, else the range."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

from gripcourse.course.model import Course, Scheme
from gripcourse.solver.plan import Plan
from gripcourse.variants.model import Variant
from gripcourse.variants.space import Space, load_spaces


@dataclass(frozen=True, slots=True)
class Defaults:
    """Choices and numbers for what an instructor's table leaves out.

    Attributes:
        course: whose schemes they are for.
        spaces: what each scheme is drawn from, by its id.
    """

    course: Course
    spaces: Mapping[str, Space]

    @classmethod
    def of(cls, course: Course) -> Self:
        """Make the defaults of a course.

        Raises:
            CourseError: a space of the course cannot be used.
        """
        return cls(course, {space.scheme: space for space in load_spaces(course)})

    def option(self, scheme: Scheme, option: str) -> str:
        """Return the choice of the worked example, else the first that is declared."""
        if scheme.example is not None and option in scheme.example.options:
            return scheme.example.options[option]
        declared = next(one for one in scheme.options if one.id == option)
        return declared.choices[0].id

    def options(self, scheme: Scheme) -> dict[str, str]:
        """Return a choice for every option of a scheme."""
        return {one.id: self.option(scheme, one.id) for one in scheme.options}

    def number(self, plan: Plan, quantity: str, given: Mapping[str, float]) -> float | None:
        """Return the worked example's number, else the middle of the range.

        Args:
            plan: of the scheme with its options.
            quantity: id of a given quantity of the plan.
            given: numbers that the table has, in declared units; one of them may decide another.

        Returns:
            The number in the declared unit; None where nothing says any.
        """
        example = plan.scheme.example
        if example is not None and quantity in example.given:
            return example.given[quantity]
        space = self.spaces.get(plan.scheme.id)
        case = None if space is None else space.cases.with_options(plan.options)
        if case is None:
            return None
        if quantity in case.followers:
            follower = case.followers[quantity]
            leader = given.get(follower.leader)
            return None if leader is None else follower.values.get(leader)
        allowed = case.given.get(quantity)
        return allowed[len(allowed) // 2] if allowed else None

    def variant(self, plan: Plan, id_: str) -> Variant | None:
        """Return a variant of nothing but defaults; None where they do not say all of it."""
        given: dict[str, float] = {}
        late = [one.id for one in plan.givens]
        # Who follows another one comes after it, wherever it is declared.
        for name in (*late, *late):
            value = self.number(plan, name, given)
            if value is not None:
                given[name] = value
        if len(given) < len(plan.givens):
            return None
        return Variant(id_, plan.scheme.id, plan.options, given)
