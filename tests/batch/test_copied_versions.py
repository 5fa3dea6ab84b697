"""Works are compared with every sheet that was handed out, also where a new one replaced it."""

from collections import deque
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from gripcourse.batch.compared_versions import ComparedVersions, judged_by
from gripcourse.batch.context import GradingContext
from gripcourse.batch.copies import evidence_of, like_others, solve_ahead, with_alike
from gripcourse.batch.graded import Graded
from gripcourse.batch.kept_reports import KeptReports
from gripcourse.course.model import Course
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Report
from gripcourse.likeness.evidence import find_evidence
from gripcourse.likeness.issued import issued_values
from gripcourse.likeness.model import NumberKind
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.variants.model import Issued, Variant

TELLING = {"other_variant", "same_answers", "copied_from"}


def moved(variant: Variant, by: float) -> Variant:
    """The same variant with most of its numbers off by a factor."""
    given = {name: one * by if one > 1 else one for name, one in variant.given.items()}
    return replace(variant, given=given)


@pytest.fixture(scope="module")
def reissued(context: GradingContext) -> GradingContext:
    """What one student was issued was corrected: both versions have numbers of their own."""
    first = context.register["s02"]
    first = replace(first, variant=moved(first.variant, 1.07), declarations="of September")
    last = replace(first, variant=moved(first.variant, 1.06), version=2, declarations="of October")
    return replace(context, register={**context.register, "s02": last}, earlier={"s02": (first,)})


def versions(context: GradingContext) -> tuple[Issued, Issued]:
    [first] = context.earlier["s02"]
    return first, context.register["s02"]


def handed_in(
    context: GradingContext, plan: Plan, issued: Issued, numbers: Mapping[str, float]
) -> Report:
    """The report of a work on what was issued, with some numbers as answers."""
    answers = {
        one.id: Answer(
            one.id, Reading.READ, numbers[one.id], "", "E6", 0.0005, "", unit_fits=True, remarks=()
        )
        for one in plan.answered
    }
    student, variant = issued.student.id, issued.variant
    identity = Identity(student, variant.id, variant.scheme, variant.options, issued.signature)
    work = Submission(f"{student}.xlsx", "", identity, "", dict(variant.given), answers, ())
    return judge(work, issued, plan, context.policy)


def said(reports: list[Report], context: GradingContext) -> str:
    """What is said of the likeness of one student's work."""
    batch = [Graded(one, "") for one in reports]
    flags = like_others(batch, context).flags["s04"]
    return " ".join(str(one.message) for one in flags)


def codes(
    reports: list[Report], context: GradingContext, kept: KeptReports | None = None
) -> dict[str, set[tuple[str, ...]]]:
    """What likeness every student's work is flagged for, each flag with the students it names."""
    batch = [Graded(one, "") for one in reports]
    marked = with_alike(batch, like_others(batch, context, kept), reports)
    assert not any(one.incident for one in marked)
    return {
        one.report.student: {
            (flag.code, *flag.others) for flag in one.report.flags if flag.code in TELLING
        }
        for one in marked
    }


@pytest.mark.parametrize("copied", [0, 1], ids=["the replaced", "the new"])
@pytest.mark.parametrize("own", [0, 1, None], ids=["first", "second", "nothing"])
def test_whoever_copies_a_sheet_is_flagged_whichever_its_owner_answered(
    reissued: GradingContext, plan: Plan, copied: int, own: int | None
) -> None:
    both = [solve_variant(plan, one.variant.given) for one in versions(reissued)]
    reports = [handed_in(reissued, plan, reissued.register["s04"], both[copied])]
    if own is not None:
        reports.append(handed_in(reissued, plan, versions(reissued)[own], both[own]))
    assert f"those of the variant of s02 (version {copied + 1}): more" in said(reports, reissued)
    found = codes(reports, reissued)
    assert ("other_variant", "s02") in found.pop("s04")
    assert found == ({} if own is None else {"s02": set()})


@pytest.mark.parametrize("made_for", [0, 1])
@pytest.mark.parametrize("every", [1, 2, 3])
def test_answers_of_both_own_versions_speak_against_nobody(
    reissued: GradingContext, plan: Plan, made_for: int, every: int
) -> None:
    issued, other = versions(reissued)[made_for], versions(reissued)[1 - made_for]
    mine, theirs = (solve_variant(plan, one.variant.given) for one in (issued, other))
    names = [one.id for one in plan.answered]
    mixed = mine | {name: theirs[name] for name in names[::every]}
    # A neighbour has what the other sheet has but for one number.
    near = {**other.variant.given, "mass": 1.2 * other.variant.given["mass"]}
    neighbour = reissued.register["s05"]
    neighbour = replace(neighbour, variant=replace(neighbour.variant, id="005", given=near))
    context = replace(reissued, register={**reissued.register, "s05": neighbour})
    reports = [
        handed_in(context, plan, issued, mixed),
        handed_in(context, plan, neighbour, solve_variant(plan, near)),
    ]
    assert codes(reports, context) == {"s02": set(), "s05": set()}


def test_both_sheets_of_a_person_who_was_listed_twice_count(
    reissued: GradingContext, plan: Plan
) -> None:
    first, last = versions(reissued)
    joined = replace(first, issued_as="s2", declarations="")
    context = replace(reissued, earlier={"s02": (joined,)}, joined={"s2": "s02"})
    copy = handed_in(context, plan, context.register["s04"], solved(plan, joined))
    own = handed_in(context, plan, joined, solved(plan, last))
    assert codes([copy, own], context) == {"s04": {("other_variant", "s02")}, "s02": set()}
    assert "of s02 (issued as s2, version 1): more" in said([copy, own], context)


def solved(plan: Plan, issued: Issued) -> Mapping[str, float]:
    return solve_variant(plan, issued.variant.given)


@pytest.fixture(scope="module")
def september(course: Course, plan: Plan) -> Course:
    """The course as it was when the first version was issued: with another gravity."""
    gravity = replace(course.constants["gravity"], value=11.0)
    only = {plan.scheme.id: course.schemes[plan.scheme.id]}
    return replace(course, constants={**course.constants, "gravity": gravity}, schemes=only)


def test_a_replaced_version_is_computed_by_the_declarations_that_it_was_issued_with(
    reissued: GradingContext, plan: Plan, september: Course
) -> None:
    first, last = versions(reissued)
    before = make_plan(september, plan.scheme.id, plan.options)
    by_them, by_todays = (solve_variant(one, first.variant.given) for one in (before, plan))
    changed = [one.id for one in plan.answered if by_them[one.id] != by_todays[one.id]]
    assert len(changed) > 3
    context = replace(reissued, declared={"of September": september})
    copied = handed_in(context, plan, context.register["s04"], by_them)
    reports = [copied, handed_in(context, plan, last, solved(plan, last))]

    def odds(where: GradingContext) -> float:
        evidence = evidence_of(reports, where).evidence
        found = (one for one in evidence if one.students == ("s04", "s02"))
        return max((one.odds for one in found if one.kind is NumberKind.OTHER_VARIANT), default=0)

    assert odds(context) > 1e3 * odds(reissued)
    assert codes(reports, context)["s02"] == set()


def test_a_work_is_measured_by_the_version_that_counts_and_its_sheet_by_its_own(
    reissued: GradingContext, plan: Plan
) -> None:
    first, last = versions(reissued)
    report = handed_in(reissued, plan, last, solved(plan, last))
    # A workbook made for the first version, of which the second counts.
    both = replace(report, made_for=1, either_version=True, givens=first.variant.given)
    rows = ComparedVersions.of(reissued, [judged_by(both, reissued)])
    work = rows.work(both)
    assert work.version == 0
    assert {one.quantity for one in work.numbers} == {one.id for one in plan.answered}
    assert all(one.explained for one in work.numbers)
    of_first = handed_in(reissued, plan, first, solved(plan, first))
    assert rows.work(of_first).version == 1


def test_a_version_judged_by_todays_declarations_too_is_in_both_rows(
    reissued: GradingContext, plan: Plan, september: Course
) -> None:
    first, _ = versions(reissued)
    context = replace(reissued, declared={"of September": september})
    by_todays = handed_in(context, plan, first, solved(plan, first))
    alone = ComparedVersions.of(context)
    rows = ComparedVersions.of(context, [judged_by(by_todays, context)])
    assert (len(alone.variants), len(rows.variants)) == (9, 10)
    assert rows.about != alone.about
    assert rows.work(by_todays).version == 2
    values = issued_values(context.course, rows.variants, rows.declared)
    assert find_evidence([rows.work(by_todays)], values, context.policy.likeness) == ()


def test_the_same_numbers_issued_again_are_one_row(reissued: GradingContext) -> None:
    _, last = versions(reissued)
    again = replace(reissued, earlier={"s02": (replace(last, version=1),)})
    rows = ComparedVersions.of(again)
    assert len(rows.variants) == len(again.register)
    assert {rows.name(row) for row in range(len(rows.variants))} == {None}
    assert len(ComparedVersions.of(reissued).variants) == len(reissued.register) + 1


def test_what_was_kept_before_somebody_was_issued_to_again_is_not_used(
    reissued: GradingContext, plan: Plan, tmp_path: Path
) -> None:
    first, last = versions(reissued)
    before = replace(reissued, register={**reissued.register, "s02": last}, earlier={})
    copy = handed_in(before, plan, before.register["s04"], solved(plan, first))
    kept = KeptReports(tmp_path / "kept", {})
    assert codes([copy], before, kept) == {"s04": set()}
    assert codes([copy], reissued, kept) == {"s04": {("other_variant", "s02")}}


def test_other_numbers_of_a_replaced_version_are_other_rows(reissued: GradingContext) -> None:
    first, _ = versions(reissued)
    other = replace(first, variant=moved(first.variant, 1.01))
    changed = replace(reissued, earlier={"s02": (other,)})
    assert ComparedVersions.of(changed).about != ComparedVersions.of(reissued).about
    assert ComparedVersions.of(replace(reissued)).about == ComparedVersions.of(reissued).about


def test_what_is_solved_ahead_serves_whichever_version_was_handed_in(
    reissued: GradingContext, plan: Plan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, last = versions(reissued)
    kept = KeptReports(tmp_path / "kept", {})
    deque(solve_ahead(reissued, kept), maxlen=0)
    monkeypatch.setattr("gripcourse.likeness.issued._solved", None)  # nothing is solved any more
    for own in (first, last):
        copy = handed_in(reissued, plan, reissued.register["s04"], solved(plan, first))
        reports = [copy, handed_in(reissued, plan, own, solved(plan, own))]
        assert ("other_variant", "s02") in codes(reports, reissued, kept)["s04"]
