"""What the search sees of a report: which numbers the student's own do not explain."""

from collections.abc import Callable
from dataclasses import replace
from datetime import date
from itertools import combinations

import pytest

from gripcourse.course.model import Course
from gripcourse.grading.judge import judge
from gripcourse.grading.model import Finding, Outcome, Report
from gripcourse.likeness.evidence import find_evidence
from gripcourse.likeness.flags import flag_of, flags_by_student, odds_in_words
from gripcourse.likeness.issued import issued_values
from gripcourse.likeness.model import Evidence, NumberKind
from gripcourse.likeness.typed_numbers import Typed
from gripcourse.likeness.works import work_of
from gripcourse.policy.model import LikenessRule, Policy
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.submission.model import Answer, Identity, Reading, Submission
from gripcourse.text.words import LANGUAGES, Texts, Words
from gripcourse.variants.model import Issued, Student, Variant

RULE = LikenessRule(1e3, 3, 3)
Grade = Callable[..., Report]


@pytest.fixture(scope="session")
def pair(variants: tuple[Variant, ...]) -> tuple[Issued, Issued]:
    """Two students with the same kind of variant."""
    first, second = next(
        (one, two)
        for one, two in combinations(variants, 2)
        if (one.scheme, one.options) == (two.scheme, two.options)
    )
    return _issued("s1", first), _issued("s2", second)


def _issued(student: str, variant: Variant) -> Issued:
    return Issued(Student(student, "", "", "", "ru", ""), variant, date(2026, 9, 7), None, "")


@pytest.fixture(scope="session")
def plan(course: Course, pair: tuple[Issued, Issued]) -> Plan:
    return make_plan(course, pair[0].variant.scheme, pair[0].variant.options)


@pytest.fixture(scope="session")
def grade(plan: Plan, policy: Policy, pair: tuple[Issued, Issued]) -> Grade:
    """Grade a workbook of the first student with these answers and given values."""

    def make(answers: dict[str, float], **changes: object) -> Report:
        variant = pair[0].variant
        submission = Submission(
            file="s1.xlsx",
            digest="",
            identity=Identity("s1", variant.id, variant.scheme, variant.options, ""),
            creator="gripcourse",
            givens=dict(variant.given),
            answers={
                one.id: Answer(
                    one.id,
                    Reading.READ,
                    answers[one.id],
                    "",
                    "E6",
                    0.05,
                    "",
                    unit_fits=True,
                    remarks=(),
                )
                for one in plan.answered
                if one.id in answers
            },
            remarks=(),
        )
        submission = replace(submission, **changes)  # type: ignore[arg-type]
        return judge(submission, pair[0], plan, policy)

    return make


def _read(quantity: str, value: float) -> Answer:
    return Answer(quantity, Reading.READ, value, "", "E6", 0.05, "", unit_fits=True, remarks=())


def numbers(report: Report, pair: tuple[Issued, Issued]) -> dict[str, Typed]:
    return {one.quantity: one for one in work_of(report, pair[0], "gripcourse").numbers}


def test_right_answers_are_explained(grade: Grade, plan: Plan, pair: tuple[Issued, Issued]) -> None:
    found = numbers(grade(solve_variant(plan, pair[0].variant.given)), pair)
    assert len(found) == len(plan.answered)
    assert all(one.explained for one in found.values())
    assert {one.half_unit for one in found.values()} == {0.05}


def test_what_follows_from_an_own_wrong_number_is_explained(
    grade: Grade, plan: Plan, pair: tuple[Issued, Issued]
) -> None:
    right = solve_variant(plan, pair[0].variant.given)
    start = next(one.id for one in plan.answered if plan.inputs[one.id])
    own = solve_variant(plan, {**pair[0].variant.given, start: 1.7 * right[start]})
    found = numbers(grade(own), pair)
    assert {name for name, one in found.items() if not one.explained} == {start}


def test_what_is_off_further_than_rounding_leaves_it_does_not_follow(
    grade: Grade, plan: Plan, pair: tuple[Issued, Issued]
) -> None:
    """Numbers that somebody moved to hide where they come from may lie in the bands too."""
    right = solve_variant(plan, pair[0].variant.given)
    start = next(
        one.id
        for one in plan.answered
        if sum(one.id in plan.inputs[other.id] for other in plan.answered) > 1
    )
    own = solve_variant(plan, {**pair[0].variant.given, start: 1.7 * right[start]})
    user = next(one.id for one in plan.answered if start in plan.inputs[one.id])
    for off, explained in ((1.001, True), (1.006, False)):
        report = grade({**own, user: off * own[user]})
        [judged] = [one for one in report.findings if one.quantity == user]
        assert judged.outcome is Outcome.CARRIED
        assert numbers(report, pair)[user].explained is explained


def test_answers_of_another_variant_are_not_explained_and_are_told(
    grade: Grade, plan: Plan, course: Course, pair: tuple[Issued, Issued]
) -> None:
    report = grade(solve_variant(plan, pair[1].variant.given))
    issued = issued_values(course, [(one.student.id, one.variant) for one in pair])
    work = work_of(report, pair[0], "gripcourse")
    [found] = find_evidence([work], issued, RULE)
    assert (found.kind, found.students) == (NumberKind.OTHER_VARIANT, ("s1", "s2"))


def test_only_changed_given_values_count_as_typed(
    grade: Grade, plan: Plan, pair: tuple[Issued, Issued]
) -> None:
    right = solve_variant(plan, pair[0].variant.given)
    assert set(numbers(grade(right), pair)) == {one.id for one in plan.answered}
    others = dict(pair[1].variant.given)
    found = numbers(grade({}, givens=others), pair)
    differing = {name for name, one in others.items() if one != pair[0].variant.given[name]}
    assert set(found) == differing
    assert not any(one.explained for one in found.values())


def test_copied_given_values_are_told(
    grade: Grade, course: Course, pair: tuple[Issued, Issued]
) -> None:
    report = grade({}, givens=dict(pair[1].variant.given))
    issued = issued_values(course, [(one.student.id, one.variant) for one in pair])
    [found] = find_evidence([work_of(report, pair[0], "")], issued, RULE)
    assert found.students == ("s1", "s2")
    assert set(found.rests_on) <= set(pair[1].variant.given)


def test_the_author_of_an_issued_workbook_is_nobody(
    grade: Grade, pair: tuple[Issued, Issued]
) -> None:
    assert work_of(grade({}), pair[0], "gripcourse").creator == ""
    assert work_of(grade({}, creator="Petrov"), pair[0], "gripcourse").creator == "Petrov"


def wrong(report: Report, **changes: object) -> Finding:
    found = next(one for one in report.findings if one.given is not None)
    return replace(found, reference=1.0, expected=1.0, band=0.01, given=2.0, **changes)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("slip", "named"), [("radius_for_diameter", "radius_for_diameter"), ("used:mass", "")]
)
def test_a_method_explains_in_part_and_a_wrong_number_does_not(
    grade: Grade, plan: Plan, pair: tuple[Issued, Issued], slip: str, named: str
) -> None:
    report = grade(solve_variant(plan, pair[0].variant.given))
    finding = wrong(report, outcome=Outcome.SLIP, slip=SlipId.parse(slip))
    [one] = work_of(replace(report, findings=(finding,)), pair[0], "").numbers
    assert (one.explained, str(one.slip or "")) == (False, named)


def test_carried_from_a_copied_given_value_is_not_explained(
    grade: Grade, plan: Plan, pair: tuple[Issued, Issued]
) -> None:
    report = grade(solve_variant(plan, pair[0].variant.given))
    finding = wrong(report, outcome=Outcome.CARRIED)
    [one] = work_of(replace(report, findings=(finding,)), pair[0], "").numbers
    assert not one.explained


@pytest.mark.parametrize(
    ("odds", "said"),
    [
        (5e12, "million million"),
        (1e9, "a thousand million"),
        (2e6, "a million"),
        (1e3, "a thousand"),
        (999.0, "a hundred"),
        (10.0, "ten"),
        (3.0, "two to one"),
        (1.2, "hardly"),
    ],
)
def test_odds_are_said_in_words_and_never_too_large(odds: float, said: str) -> None:
    assert said in str(odds_in_words(odds))


def title_of(_student: str, quantity: str) -> Texts:
    return Texts(dict.fromkeys(LANGUAGES, f"title of {quantity}"))


def test_a_flag_names_students_odds_and_what_it_rests_on_and_is_no_verdict() -> None:
    others = tuple(f"s{number}" for number in range(2, 10))
    for kind in (NumberKind.OTHER_VARIANT, NumberKind.SAME_ANSWERS):
        flag = flag_of(Evidence(kind, ("s1", *others), 5e6, ("grip_force", "bore")), title_of)
        said = str(flag.message)
        assert flag.code == kind.value
        assert "s2, s3, s4, s5, s6 and 3 more" in said
        assert "more than a million to one" in said
        assert "title of grip_force; title of bore" in said
        assert "not a verdict" in said
        assert all(Words(language).say(flag.message) for language in LANGUAGES)


def test_flags_go_to_the_submission_that_they_are_about() -> None:
    found = Evidence(NumberKind.SAME_CREATOR, ("s1", "s2"), 5.0, ("Petrov",))
    flags = flags_by_student([found, found], title_of)
    assert list(flags) == ["s1"]
    assert len(flags["s1"]) == 1
    assert "“Petrov”" in str(flags["s1"][0].message)
