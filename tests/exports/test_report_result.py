"""What a report is for another program."""

from dataclasses import replace

import pytest

from gripcourse.exports.make_report_result import finding_result
from gripcourse.grading.model import Report
from gripcourse.text.words import Words

IN_ENGLISH = Words("en")


@pytest.mark.parametrize("share", [1 - 5e-16, 1 + 5e-16])
def test_a_last_digit_that_processors_round_otherwise_is_not_told(
    perfect: Report, share: float
) -> None:
    for finding in (one for one in perfect.findings if one.reference is not None):
        value = finding.reference or 0.0
        moved = replace(
            finding, reference=value * share, expected=value * share, band=value * share
        )
        exact = replace(finding, expected=value, band=value)
        assert finding_result(moved, IN_ENGLISH) == finding_result(exact, IN_ENGLISH)
