"""A cohort's slips are counted where they were made, and each once."""

from collections.abc import Callable
from dataclasses import replace

from gripcourse.course.compose import compose
from gripcourse.course.model import Course
from gripcourse.documents.report.mistakes import kind_rows, mistakes_of, slip_rows
from gripcourse.grading.model import Flag, FlagCode, Outcome, Report
from gripcourse.policy.model import Policy
from gripcourse.slips.model import SlipId
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Texts, Words, message

Change = Callable[..., Report]
ENGLISH = Words("en")
HINT = Texts({"en": "It is in cm.", "ru": "Дано в см.", "uk": "Подано в см."})


def _slipped(with_finding: Change, report: Report, slip: str = "unit:cm") -> Report:
    said = message("A known slip: {hint}", hint=HINT)
    return with_finding(
        report, "bore_required", outcome=Outcome.SLIP, slip=SlipId.parse(slip), message=said
    )


def test_a_slip_has_its_share_of_those_who_were_wrong_there(
    perfect: Report, wrong: Change, with_finding: Change, course: Course, plan: Plan
) -> None:
    reports = [
        perfect,
        _slipped(with_finding, perfect),
        _slipped(with_finding, perfect),
        _slipped(with_finding, perfect, "sign:a"),
        wrong(perfect, "bore_required", 1.0),
    ]
    declared = compose(course, plan.scheme, plan.options)
    first, second = slip_rows(reports, declared, ENGLISH)
    assert (first.count, first.share, first.hint) == ("2", "50%", "It is in cm.")
    assert first.title == plan.quantities["bore_required"].title.of("en")
    assert (second.count, second.share) == ("1", "25%")


def test_a_declared_slip_has_its_declared_hint(perfect: Report, course: Course, plan: Plan) -> None:
    declared = compose(course, plan.scheme, plan.options)
    name = next(name for name, one in declared.items() if one.slips and name in plan.quantities)
    slip = declared[name].slips[0]
    finding = replace(
        perfect.findings[0], quantity=name, outcome=Outcome.SLIP, slip=SlipId.declared(slip.id)
    )
    (row,) = slip_rows([replace(perfect, findings=(finding,))], declared, ENGLISH)
    assert row.hint == slip.hint.of("en")


def test_a_slip_in_a_blank_step_is_counted_in_that_step_and_once(
    perfect: Report, with_finding: Change
) -> None:
    shown = {"outcome": Outcome.CARRIED, "slip": "unit:cm", "roots": ("grip_force",)}
    report = with_finding(with_finding(perfect, "drive_force", **shown), "pin_force", **shown)
    (mistake,) = mistakes_of(report)
    assert (mistake.quantity, str(mistake.slip)) == ("grip_force", "unit:cm")


def test_what_follows_from_a_mistake_and_what_is_blank_are_none(
    perfect: Report, with_finding: Change, blank: Change
) -> None:
    carried = with_finding(perfect, "drive_force", outcome=Outcome.CARRIED, roots=("grip_force",))
    assert list(mistakes_of(blank(carried, "bore"))) == []


def test_another_students_workbook_holds_nobodys_slips(perfect: Report, wrong: Change) -> None:
    flag = Flag(FlagCode.ISSUED_TO_OTHER, message("The workbook was issued to another student."))
    assert list(mistakes_of(replace(wrong(perfect, "bore", 1.0), flags=(flag,)))) == []


def test_kinds_are_counted_over_all_quantities_and_the_unexplained_stand_last(
    perfect: Report, wrong: Change, with_finding: Change, policy: Policy
) -> None:
    two = with_finding(
        _slipped(with_finding, perfect),
        "pin_force",
        outcome=Outcome.SLIP,
        slip=SlipId.parse("unit:mm"),
    )
    many = wrong(wrong(wrong(perfect, "bore", 1.0), "grip_force", 1.0), "drive_force", 1.0)
    own = with_finding(
        perfect, "pin_force", outcome=Outcome.SLIP, slip=SlipId.parse("one_shear_plane")
    )
    used = with_finding(perfect, "pin_force", outcome=Outcome.SLIP, slip=SlipId.parse("used:mass"))
    rows = kind_rows([two, many, own, used], policy.slips, ENGLISH)
    assert [(row.title, row.answers, row.students) for row in rows] == [
        ("another unit", "2", "1"),
        ("a mistake known for this formula", "1", "1"),
        ("another number than the given or found one", "1", "1"),
        ("not explained", "3", "1"),
    ]
    assert rows[0].share == "28.6%"


def test_a_number_used_wrongly_names_what_it_was_used_for(
    perfect: Report, with_finding: Change, course: Course, plan: Plan
) -> None:
    report = with_finding(
        perfect, "drive_force", outcome=Outcome.SLIP, slip=SlipId.parse("used:grip_force")
    )
    declared = compose(course, plan.scheme, plan.options)
    (row,) = slip_rows([report], declared, ENGLISH)
    title = plan.quantities["grip_force"].title.of("en")
    assert row.hint == f"Another number was used for {title}."
