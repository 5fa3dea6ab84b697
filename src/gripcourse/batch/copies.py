"""Whose answers are these: flags on the submissions of a batch whose numbers are another's."""

import traceback
from array import array
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

from gripcourse.batch.context import GradingContext
from gripcourse.batch.graded import Changes, Graded, changed, reports_of, with_reports
from gripcourse.batch.kept_reports import FlagsOf, KeptReports
from gripcourse.grading.made_for import versions_of
from gripcourse.grading.model import Report
from gripcourse.likeness.evidence import find_evidence
from gripcourse.likeness.flags import flags_by_student
from gripcourse.likeness.issued import issued_values, solved_ahead, solved_anew
from gripcourse.likeness.model import Evidence
from gripcourse.likeness.works import work_of
from gripcourse.machine.shelf import Viewed
from gripcourse.solver.plan import make_plan
from gripcourse.text.words import Texts
from gripcourse.variants.model import Issued, Variant
from gripcourse.workbook.names import AUTHOR


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
        return flags_by_student(found, _titles(context))

    try:
        digests = (one.digest for one in graded)
        return Alike(find() if kept is None else kept.flags_of(digests, find))
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


def evidence_of(
    reports: Sequence[Report], context: GradingContext, kept: KeptReports | None = None
) -> tuple[Evidence, ...]:
    """Compare the judged submissions of a batch with each other and with all issued variants.

    Args:
        reports: of the batch.
        context: the course, its policy, the register.
        kept: what an earlier run found out; None for nothing.
    """
    judged = _Judged.of(reports, context)
    if not judged.places:
        return ()
    works = (
        work_of(report, judged.issued_to(report.student, context), AUTHOR)
        for report in (reports[place] for place in judged.places)
    )

    declared = {owner: context.declared[name] for owner, name in judged.by.items()}
    tables = solved_anew if kept is None else kept.issued_values(judged.about)
    values = issued_values(context.course, judged.variants(context), declared, tables)
    return find_evidence(works, values, context.policy.likeness)


def solve_ahead(context: GradingContext, kept: KeptReports) -> Iterator[None]:
    """Solve what works will be compared with, some variants at each step, and keep it.

    So it is done while workers judge. Where somebody handed in a work of an earlier version, all is
    solved again by who compares; so it is where this fails, which is told there.
    """
    nobody = _Judged(array("q"), {}, {})
    with suppress(Exception):
        yield from solved_ahead(
            context.course, nobody.variants(context), kept.issued_values(nobody.about)
        )


@dataclass(frozen=True, slots=True)
class _Judged:
    """Which works of a batch are compared.

    Attributes:
        places: of their reports.
        made_for: by student, version and variant that a work was made for, where there are several.
        by: by student, the fingerprint of the declarations that a work was judged by, where these
            are not today's.
    """

    places: "array[int]"
    made_for: Mapping[str, tuple[int, str]]
    by: Mapping[str, str]

    @classmethod
    def of(cls, reports: Iterable[Report], context: GradingContext) -> "_Judged":
        """Look through a batch."""
        places, made_for, by = array("q"), dict[str, tuple[int, str]](), dict[str, str]()
        for place, report in enumerate(reports):
            if report.judged and report.student in context.register:
                places.append(place)
                by.pop(report.student, None)
                if report.declarations in context.declared:
                    by[report.student] = report.declarations
                if report.student in context.earlier:
                    made_for[report.student] = (report.made_for, report.variant)
        return cls(places, made_for, by)

    @property
    def about(self) -> str:
        """What tells which of all versions are compared, and by which declarations."""
        return repr((sorted(self.made_for.items()), sorted(self.by.items())))

    def variants(self, context: GradingContext) -> Sequence[tuple[str, Variant]]:
        """Return what everybody was issued that works are compared with, with its owner."""

        def variant(student: str) -> tuple[str, Variant]:
            return student, self.issued_to(student, context).variant

        return Viewed(tuple(context.register), variant)

    def issued_to(self, student: str, context: GradingContext) -> Issued:
        """Return what a work was made for: whoever had an earlier version has its numbers."""
        versions = versions_of(student, context.register, context.earlier)
        wanted = self.made_for.get(student)
        asked = (one for one in versions if (one.version, one.variant.id) == wanted)
        return next(asked, versions[-1])


def _titles(context: GradingContext) -> Callable[[str, str], Texts | str]:
    """Return what tells the title of a student's quantity; its id where the variant has none."""

    def title(student: str, name: str) -> Texts | str:
        variant = context.register[student].variant
        quantities = make_plan(context.course, variant.scheme, variant.options).quantities
        return quantities[name].title if name in quantities else name

    return title
