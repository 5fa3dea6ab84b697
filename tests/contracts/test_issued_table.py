"""What is issued keeps the rules that the policy demands of variants."""

import pytest

from gripcourse.course.model import Course
from gripcourse.policy.model import Policy
from gripcourse.variants.audit import audit
from gripcourse.variants.model import Variant
from gripcourse.variants.space import Space


@pytest.mark.usefixtures("few_slips_counted")
def test_the_issued_table_passes_its_audit(
    course: Course, policy: Policy, spaces: tuple[Space, ...], issued: tuple[Variant, ...]
) -> None:
    found = audit(course, policy, issued, spaces)
    flagged = {
        one.variant.id: (one.broken, one.slips, one.edges, one.above)
        for one in found.variants
        if not one.passed
    }
    assert issued
    assert flagged == {}
    assert found.passed
