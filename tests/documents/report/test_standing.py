"""A report says how points are called, and in words what still waits for a person."""

from collections.abc import Callable

from gripcourse.course.model import Course
from gripcourse.documents.report.standing import grades_of, waiting_text
from gripcourse.grading.model import Report
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words

Change = Callable[..., Report]


def test_what_waits_is_said_in_points_and_by_name(perfect: Report, plan: Plan) -> None:
    said = waiting_text(perfect, plan.quantities, Words("en"))
    assert said.startswith("Points that wait for a person: 4 of 136; ")
    names = [
        plan.quantities[one.quantity].title.of("en") for one in perfect.findings if one.is_open
    ]
    assert names
    assert all(one in said for one in names)


def test_every_scale_calls_the_points(perfect: Report, policy: Policy, course: Course) -> None:
    assert grades_of(perfect, policy.scales, Words(course.language)) != []
    assert grades_of(perfect, (), Words("en")) == []
