"""Whose answers are these: flags on the submissions of a batch whose numbers are another's."""

import traceback
from array import array
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain

from gripcourse.batch.compared_versions import ComparedVersions, JudgedBy, issued_again, judged_by
from gripcourse.batch.context import GradingContext, declarations_of
from gripcourse.batch.graded import Changes, Graded, changed, reports_of, with_reports
from gripcourse.batch.kept_reports import FlagsOf, KeptReports
from gripcourse.errors import UsageError
from gripcourse.grading.made_for import versions_of
from gripcourse.grading.model import Report
from gripcourse.likeness.evidence import find_evidence
from gripcourse.likeness.flags import flags_by_student
from gripcourse.likeness.issued import issued_values, solved_ahead, solved_anew
from gripcourse.likeness.model import Evidence
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Texts


@dataclass(frozen=True, slots=True)
class Alike:
    """What comparing a batch comes to.

    Attributes:
        flags: of submissions that hold another student's numbers, by student.
        trace: of what failed on our side, empty for nothing: grading is never lost for it.
    """

    flags: FlagsOf
    trace: str = ""


def like_others(
    graded: Sequence[Graded], context: GradingContext, kept: KeptReports | None = None
) -> Alike:
    """Find the submissions that hold another student's numbers.

    Args:
        graded: the batch.
        context: the course, its policy, the register.
        kept: what an earlier run found out; None for nothing.
    """

    def find() -> FlagsOf:
        found = evidence_of(reports_of(graded), context, kept)
        return flags_by_student(found.evidence, _titles(context), found.versions.name)

    try:
        if kept is None:
            return Alike(find())
        digests = chain((one.digest for one in graded), [issued_again(context)])
        return Alike(kept.flags_of(digests, find))
    except Exception:  # noqa: BLE001 (ours: the marks stand without this evidence)
        return Alike({}, f"looking for likeness:\n{traceback.format_exc()}")


def with_alike(
    graded: Sequence[Graded], alike: Alike, compared: Sequence[Report]
) -> Sequence[Graded]:
    """Return a batch with what comparing it came to; what failed stands with the first file.

    Args:
        graded: the batch.
        alike: what comparing came to.
        compared: the reports as they were compared: what somebody has said of them since stands
            after it.
    """
    if alike.flags:
        graded = with_reports(graded, _flagged(reports_of(graded), alike.flags, compared))
    if not alike.trace or not graded:
        return graded
    first = graded[0]
    return changed(graded, [(0, replace(first, incident=first.incident + alike.trace))])


def _flagged(reports: Sequence[Report], flags: FlagsOf, compared: Sequence[Report]) -> Changes:
    for number, report in enumerate(reports):
        mine = flags.get(report.student, ()) if report.judged else ()
        if mine:
            before = compared[number].flags
            kept = tuple(one for one in report.flags if one in before)
            since = (one for one in report.flags if one not in before)
            yield number, replace(report, flags=(*kept, *mine, *since))


@dataclass(frozen=True, slots=True)
class FoundAlike:
    """What is alike in a batch.

    Attributes:
        evidence: of likeness.
        versions: what was issued, in rows that evidence names.
    """

    evidence: tuple[Evidence, ...]
    versions: ComparedVersions


def evidence_of(
    reports: Sequence[Report], context: GradingContext, kept: KeptReports | None = None
) -> FoundAlike:
    """Compare the judged submissions of a batch with each other and with all issued variants.

    Args:
        reports: of the batch.
        context: the course, its policy, the register.
        kept: what an earlier run found out; None for nothing.
    """
    judged = _Judged.of(reports, context)
    versions = ComparedVersions.of(context, judged.by)
    if not judged.places:
        return FoundAlike((), versions)
    works = (versions.work(reports[place]) for place in judged.places)
    tables = solved_anew if kept is None else kept.issued_values(versions.about)
    values = issued_values(context.course, versions.variants, versions.declared, tables)
    return FoundAlike(find_evidence(works, values, context.policy.likeness), versions)


def solve_ahead(context: GradingContext, kept: KeptReports) -> Iterator[None]:
    """Solve what works will be compared with, some variants at each step, and keep it.

    So it is done while workers judge. Where a work was judged by declarations that are not its
    version's, all is solved again by who compares; so it is where this fails, which is told there.
    """
    with suppress(Exception):
        versions = ComparedVersions.of(context)
        tables = kept.issued_values(versions.about)
        yield from solved_ahead(context.course, versions.variants, versions.declared, tables)


@dataclass(frozen=True, slots=True)
class _Judged:
    """Which works of a batch are compared.

    Attributes:
        places: of their reports.
        by: what those of students were judged by who were issued to several times.
    """

    places: "array[int]"
    by: Collection[JudgedBy]

    @classmethod
    def of(cls, reports: Iterable[Report], context: GradingContext) -> "_Judged":
        """Look through a batch."""
        places, by = array("q"), dict[JudgedBy, None]()
        for place, report in enumerate(reports):
            if report.judged and report.student in context.register:
                places.append(place)
                if report.student in context.earlier:
                    by[judged_by(report, context)] = None
        return cls(places, by)


def _titles(context: GradingContext) -> Callable[[str, str], Texts | str]:
    """Return what tells the title of a student's quantity; its id where no version has one."""

    def title(student: str, name: str) -> Texts | str:
        versions = versions_of(student, context.register, context.earlier)
        for one in reversed(versions):
            state = context.declared.get(declarations_of(one, context), context.course)
            with suppress(UsageError):  # nobody kept the declarations that it was issued with
                quantities = plan_of(state, one.variant.composition).quantities
                if name in quantities:
                    return quantities[name].title
        return name

    return title
