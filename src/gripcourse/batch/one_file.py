"""Grading one file, whatever it is: reading, identifying, judging."""

from dataclasses import replace
from functools import cache, lru_cache
from typing import Final

from gripcourse.batch.context import GradingContext, declarations_of, handed_in_by
from gripcourse.course.composition import Composition
from gripcourse.grading.diagnose import CandidatesOf
from gripcourse.grading.flags import not_judged_flags
from gripcourse.grading.identify import HandedIn
from gripcourse.grading.judge import judge
from gripcourse.grading.made_for import (
    BY_TODAYS,
    is_of_other_declarations,
    said_of_both,
    said_of_version,
    versions_of,
)
from gripcourse.grading.model import FlagCode, Report
from gripcourse.grading.recalculated import results_flags
from gripcourse.grading.unjudged import (
    disputed_report,
    is_unreadable,
    rejected_report,
    unknown_student_report,
    unreadable_report,
)
from gripcourse.machine.archive import UnreadableMemberError
from gripcourse.machine.content import Readable, shown_name
from gripcourse.slips.candidates import candidates_of
from gripcourse.slips.model import Candidate
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Rejected, WhyRefused
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from gripcourse.submission.second import lacks_results, read_again, stores_results, stores_zeros
from gripcourse.variants.model import Issued, Variant

# Compositions of a scheme and options that are remembered: about a megabyte each.
_COMPOSITIONS: Final = 64


def grade_file(source: Readable, context: GradingContext, made: bytes | None = None) -> Report:
    """Grade one file; the student's faults are in the report, only ours are exceptions.

    Args:
        source: the file.
        context: the course, its policy, the register.
        made: what LibreOffice made of the file; None where our reader is enough.
    """
    return grade_read(read_file(source, made), shown_name(source), context, second=made is not None)


def read_file(source: Readable, made: bytes | None = None) -> RawWorkbook | Rejected:
    """Read one file, of whatever course it is.

    Args:
        source: the file.
        made: what LibreOffice made of it; None where our reader is enough.
    """
    file = shown_name(source)
    try:
        return read_workbook(source) if made is None else read_again(source, made)
    except UnreadableMemberError:
        return Rejected.because(file, "", WhyRefused.DAMAGED)
    except OSError:  # it was there when the batch began
        return Rejected.because(file, "", WhyRefused.GONE)


def grade_read(
    raw: RawWorkbook | Rejected, file: str, context: GradingContext, *, second: bool = False
) -> Report:
    """Grade what was read of a file; see `grade_file`.

    Args:
        raw: what was read.
        file: its name.
        context: the course, its policy, the register.
        second: whether LibreOffice has looked at the file already.
    """
    identity = None if isinstance(raw, Rejected) else raw.identity
    handed_in = handed_in_by(file, identity, context, raw.digest)
    report = replace(_report(raw, handed_in, context), known_by=handed_in.known_by)
    if isinstance(raw, Rejected):
        return report
    return replace(
        report,
        flags=(*report.flags, *results_flags(raw.other_results)),
        lacks_results=lacks_results(raw) or (not second and stores_zeros(raw)),
        unverified=not second and stores_results(raw),
    )


def _report(raw: RawWorkbook | Rejected, handed_in: HandedIn, context: GradingContext) -> Report:
    if isinstance(raw, Rejected):
        return rejected_report(raw, handed_in.issued)
    if handed_in.doubt is not None:
        return disputed_report(raw.file, handed_in.doubt, raw.digest)
    if handed_in.issued is None:
        return unknown_student_report(raw.file, raw.identity.student, raw.digest)
    return judge_versions(raw, handed_in.issued, context)


def judge_versions(raw: RawWorkbook, made_for: Issued, context: GradingContext) -> Report:
    """Judge a workbook by the version that it was made for; by all of them where that is allowed.

    Of several the best one counts. Flags are about the version that the workbook was made for.
    """
    report = judge_read(raw, made_for, context)
    versions = versions_of(made_for.student.id, context.register, context.earlier)
    if not report.judged or len(versions) == 1:
        return report
    said = said_of_version(made_for, versions, kept=bool(report.declarations))
    said_before = raw.digest in context.either_for
    if not (said_before if context.either_version is None else context.either_version):
        return replace(report, remarks=(*said, *report.remarks))
    # Only a corrected assignment leaves a choice: of two that were handed out, each is its own.
    own = [one for one in versions if one.issued_as == made_for.issued_as]
    others = [one for one in reversed(own) if one.version != made_for.version]
    if not others:
        return replace(report, remarks=(*said, *report.remarks))
    tried = [(made_for, report), *((one, judge_read(raw, one, context)) for one in others)]
    tried = [(one, _by_better_declarations(found, raw, one, context)) for one, found in tried]
    judged = [(one, found) for one, found in tried if found.judged]
    # Of equal ones the first: that is the version that the workbook was made for.
    counts, best = max(judged, key=lambda pair: _share(pair[1]))
    rest = [(one, found) for one, found in judged if one is not counts]
    shares = [_share(found) for found in (best, *(found for _, found in rest))]
    both = said_of_both(counts, [one for one, _ in rest], shares)
    is_of_today = is_of_other_declarations(counts, versions[-1]) and not best.declarations
    by_what = (BY_TODAYS,) if is_of_today else ()
    own_flags = (flag for flag in report.flags if flag.code is not FlagCode.NOT_JUDGED)
    return replace(
        best,
        remarks=(both, *by_what, *report.remarks),
        flags=(*own_flags, *not_judged_flags(tuple(best.findings))),
        givens=report.givens,
        made_for=made_for.version,
        either_version=True,
    )


def _share(report: Report) -> float:
    """Return the share of the points that are decided; what waits for a person waits in all."""
    possible = report.max_score + report.open_points
    return report.score / possible if possible else 0.0


def _by_better_declarations(
    found: Report, raw: RawWorkbook, issued: Issued, context: GradingContext
) -> Report:
    """Return what a version comes to by its own declarations or by today's: what gives more.

    Whoever computed by the formula as it is right has not to suffer from another on the sheet.
    """
    if not found.declarations:
        return found
    today = judge_read(raw, issued, context, by_todays=True)
    return max(found, today, key=_share) if today.judged else found


def judge_read(
    raw: RawWorkbook, issued: Issued, context: GradingContext, *, by_todays: bool = False
) -> Report:
    """Judge a workbook that was read against what was issued to who handed it in.

    Today's declarations are used where they are asked for, else those of the version; see
    `declarations_of`.
    """
    declarations = "" if by_todays else declarations_of(issued, context)
    plan, methods = _methods(context, declarations, issued.variant.composition)
    submission = interpret(raw, plan.quantities.values())
    if is_unreadable(submission):
        return unreadable_report(submission, issued)
    report = judge(submission, issued, plan, context.policy, methods)
    return replace(report, declarations=declarations)


def methods_of(context: GradingContext, variant: Variant) -> tuple[Plan, CandidatesOf]:
    """Return the plan of a variant and the wrong methods of its quantities; both are remembered."""
    return _methods(context, "", variant.composition)


@lru_cache(maxsize=_COMPOSITIONS)
def _methods(
    context: GradingContext, declarations: str, composition: Composition
) -> tuple[Plan, CandidatesOf]:
    plan = plan_of(context.declared.get(declarations, context.course), composition)

    @cache
    def methods(name: str) -> tuple[Candidate, ...]:
        return candidates_of(plan, name, context.policy.slips)

    return plan, methods
