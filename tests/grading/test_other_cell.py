"""A number that stands in two cells may have been written into the wrong one."""

from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING

from gripcourse.course.quantity import Kind
from gripcourse.submission.model import Answer

if TYPE_CHECKING:
    from conftest import Case


def test_the_number_of_the_next_cell_gets_no_name_and_says_whose_it_is(
    hydraulic: "Case", typed: Callable[[str, float, int], Answer]
) -> None:
    answered = [one for one in hydraulic.plan.answered if one.kind is Kind.FORMULA]
    said = 0
    for one, other in list(pairwise(answered))[::4]:
        number = hydraulic.reference[other.id]
        if abs(number - hydraulic.reference[one.id]) < 0.1 * abs(number):
            continue
        pair = {name: typed(name, number, 4) for name in (one.id, other.id)}
        finding = hydraulic.findings({**hydraulic.answers, **pair})[one.id]
        if finding.outcome.traits.mistake and finding.slip is None:
            said += other.title.of("en") in " ".join(map(str, finding.remarks))
    assert said
