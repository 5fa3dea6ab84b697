"""Whose answers are these: flags on the submissions of a batch whose numbers are another's."""

import traceback
from collections.abc import Callable, Sequence

from gripcourse.batch.duplicates import with_flags
from gripcourse.batch.kept_reports import FlagsOf, KeptReports
from gripcourse.batch.one_file import GradingContext
from gripcourse.grading.made_for import versions_of
from gripcourse.grading.model import Report
from gripcourse.likeness.evidence import find_evidence
from gripcourse.likeness.flags import flags_by_student
from gripcourse.likeness.issued import issued_values
from gripcourse.likeness.model import Evidence
from gripcourse.likeness.works import work_of
from gripcourse.solver.plan import make_plan
from gripcourse.text.words import Texts
from gripcourse.variants.model import Issued
from gripcourse.workbook.names import AUTHOR


def mark_likeness(
    reports: Sequence[Report], context: GradingContext, kept: KeptReports | None = None
) -> tuple[tuple[Report, ...], str]:
    """Flag the submissions that hold another student's numbers.

    Args:
        reports: of the batch.
        context: the course, its policy, the register.
        kept: what an earlier run found out; None for nothing.

    Returns:
        The reports in their order, and the trace of what failed on our side (empty for nothing):
        grading is never lost for it.
    """

    def find() -> FlagsOf:
        return flags_by_student(evidence_of(reports, context, kept), _titles(context))

    try:
        flags = find() if kept is None else kept.flags_of(reports, find)
    except Exception:  # noqa: BLE001 (ours: the marks stand without this evidence)
        return tuple(reports), f"looking for likeness:\n{traceback.format_exc()}"
    marked = (
        with_flags(report, flags.get(report.student, ())) if report.judged else report
        for report in reports
    )
    return tuple(marked), ""


def evidence_of(
    reports: Sequence[Report], context: GradingContext, kept: KeptReports | None = None
) -> tuple[Evidence, ...]:
    """Compare the judged submissions of a batch with each other and with all issued variants.

    Args:
        reports: of the batch.
        context: the course, its policy, the register.
        kept: what an earlier run found out; None for nothing.
    """
    judged = [one for one in reports if one.judged and one.student in context.register]
    if not judged:
        return ()
    # Whoever worked on an earlier version has the numbers of that one.
    issued = {**context.register, **{one.student: _made_for(one, context) for one in judged}}
    works = (work_of(report, _made_for(report, context), AUTHOR) for report in judged)
    by_owner = {one.student: context.declared.get(one.declarations) for one in judged}
    declared = {owner: course for owner, course in by_owner.items() if course is not None}

    variants = [(student, entry.variant) for student, entry in issued.items()]
    if kept is None:
        values = issued_values(context.course, variants, declared)
    else:
        versions = [(student, one.version) for student, one in issued.items()]
        by = [(one.student, one.declarations) for one in judged if one.student in declared]
        kept_tables = kept.issued_values(repr((versions, by)))
        values = issued_values(context.course, variants, declared, kept_tables)
    return find_evidence(works, values, context.policy.likeness)


def _titles(context: GradingContext) -> Callable[[str, str], Texts | str]:
    """Return what tells the title of a student's quantity; its id where the variant has none."""

    def title(student: str, name: str) -> Texts | str:
        variant = context.register[student].variant
        quantities = make_plan(context.course, variant.scheme, variant.options).quantities
        return quantities[name].title if name in quantities else name

    return title


def _made_for(report: Report, context: GradingContext) -> Issued:
    versions = versions_of(report.student, context.register, context.earlier)
    return next((one for one in versions if one.version == report.made_for), versions[-1])
