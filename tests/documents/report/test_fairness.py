"""Whether one variant was harder than another is told with its uncertainty."""

from dataclasses import replace

import pytest

from gripcourse.course.model import Course
from gripcourse.documents.report.fairness import difference, fairness_rows
from gripcourse.grading.model import Report
from gripcourse.text.words import Words

ENGLISH = Words("en")


def _with_share(report: Report, share: float, variant: str, scheme: str = "") -> Report:
    return replace(
        report,
        score=share * report.max_score,
        variant=variant,
        scheme=scheme or report.scheme,
    )


def test_a_scheme_has_a_row_and_a_variant_only_where_several_had_it(
    perfect: Report, course: Course
) -> None:
    given = ((1.0, "1"), (0.5, "1"), (0.8, "2"))
    reports = [_with_share(perfect, share, variant) for share, variant in given]
    scheme, variant = fairness_rows(reports, course, ENGLISH)
    assert (scheme.variants, scheme.students, scheme.inside) == ("2", "3", False)
    assert scheme.title == course.schemes[perfect.scheme].title.of("en")
    assert (variant.title, variant.students, variant.inside) == ("variant 1", "2", True)
    assert (variant.mean, variant.extent) == ("75%", "50% … 100%")


def test_a_group_is_compared_with_everybody_else(perfect: Report, course: Course) -> None:
    other = next(name for name in course.schemes if name != perfect.scheme)
    easy = [_with_share(perfect, share, "1") for share in (0.98, 1.0, 0.99)]
    hard = [_with_share(perfect, share, "2", other) for share in (0.4, 0.42, 0.41)]
    rows = [row for row in fairness_rows([*easy, *hard], course, ENGLISH) if not row.inside]
    assert {row.difference for row in rows} == {"+58 ± 0.8", "−58 ± 0.8"}
    assert all(row.telling for row in rows)


def test_a_difference_that_chance_makes_is_not_pointed_out() -> None:
    found = difference([0.5, 0.9], [0.6, 1.0, 0.7])
    assert found is not None
    assert found.away == pytest.approx(-1 / 15)
    assert not found.telling


@pytest.mark.parametrize(("group", "others"), [([0.5], [0.5, 0.6]), ([0.5, 0.6], [0.5]), ([], [])])
def test_one_student_is_no_group(group: list[float], others: list[float]) -> None:
    assert difference(group, others) is None


def test_a_file_that_could_not_be_judged_makes_no_variant_harder(
    perfect: Report, course: Course
) -> None:
    unread = replace(perfect, judged=False, score=0.0, max_score=0.0)
    (row,) = fairness_rows([perfect, unread], course, ENGLISH)
    assert (row.students, row.mean, row.deviation, row.difference) == ("1", "100%", "—", "—")
