"""What an instructor's program asks about everybody's work: grading, flags, figures, regrading."""

from collections.abc import Iterable
from http import HTTPStatus
from typing import Final

from gripcourse.gradebook.journal import Regrade, applied, regrades
from gripcourse.gradebook.regrade import Shift, WorkChange
from gripcourse.gradebook.store import Gradebook
from gripcourse.usecases.serving.figures import Facility, group_figures
from gripcourse.web.batch import LastBatch
from gripcourse.web.desk_acts import (
    apply_shown,
    begin_batch,
    digest_of_changes,
    grading_now,
    regrading_now,
    signed_by,
    take_last_back,
)
from gripcourse.web.overview import LaidNumber, flags_of, said_of, titles_of
from gripcourse.web.refusals import NOT_FOUND, Code, WebRefusal
from gripcourse.web.rest.declare import ApiOperation, DeskCall, TokenRole
from gripcourse.web.rest.wishes import PublishingReason, RegradingWish, UndoingWish
from gripcourse.web.rest.work_results import (
    ChangedItemResult,
    ChangedWorkResult,
    EvidenceResult,
    FacilityResult,
    FiguresResult,
    FlaggedWorkResult,
    FlagsResult,
    FlagWithEvidenceResult,
    GradingResult,
    OtherWorkResult,
    RegradeResult,
    RegradesResult,
    RegradingResult,
    StudentFlagsResult,
)


def figures(call: DeskCall) -> FiguresResult:
    """How scores are spread, and what was hard."""
    context, language = call.site.context, call.words.language
    found = group_figures(context)
    sections = {one.id: one.title.of(language) for one in context.course.sections}
    return FiguresResult(
        works=found.works,
        scores=found.scores,
        mean=found.mean,
        median=found.median,
        sections=_facilities(found.sections, sections),
        items=_facilities(found.items, titles_of(context, call.words)),
    )


def flags(call: DeskCall) -> FlagsResult:
    """Whose work somebody should look at, as the last batch found it."""
    batch, register = _last(call), call.site.context.register()
    works = () if batch is None else batch.flagged
    return FlagsResult(
        at=None if batch is None else batch.at,
        works=tuple(
            FlaggedWorkResult(
                student=one.student,
                name=register[one.student].student.name if one.student in register else "",
                file=one.file,
                codes=tuple(flag.code for flag in one.flags),
                messages=tuple(
                    said_of(call.site.context, call.words, flag)[0] for flag in one.flags
                ),
            )
            for one in works
        ),
    )


def student_flags(call: DeskCall) -> StudentFlagsResult | WebRefusal:
    """The flags of a student with their evidence: the numbers they rest on, beside the other's."""
    student = str(call.request.path_params["student"])
    if student not in call.site.context.register():
        return NOT_FOUND
    return StudentFlagsResult(
        tuple(
            FlagWithEvidenceResult(
                code=one.code,
                message=one.message,
                beside=tuple(
                    OtherWorkResult(other.student, other.name, tuple(map(_evidence, other.rows)))
                    for other in one.beside
                ),
            )
            for one in flags_of(call.site, call.words, student)
        )
    )


def grading(call: DeskCall) -> GradingResult | WebRefusal:
    """How far the batch is that is being graded, whoever began it, and who began those before."""
    site = call.site
    if site.graded is None:
        return NOT_FOUND
    now = grading_now(site, site.graded)
    return GradingResult(
        runs=now.runs,
        silent=now.silent,
        failed=now.failed,
        progress=now.progress,
        last=None if now.last is None else now.last.at,
        waiting=now.waiting,
        batches=site.context.desk.batches(),
    )


def begin_grading(call: DeskCall) -> GradingResult | WebRefusal:
    """Begin to grade the workbooks of everybody that may count; it is kept with your name."""
    wish: PublishingReason = call.body
    return begin_batch(call.site, call.name, wish.why) or grading(call)


def regrades_that_stand(call: DeskCall) -> RegradesResult:
    """The regrades that stand."""
    book = Gradebook(call.site.context.desk.engine)
    return RegradesResult(tuple(map(_regrade, applied(regrades(book)))))


def show_regrading(call: DeskCall) -> RegradingResult | WebRefusal:
    """What today's course and policy would change about everything that was handed in."""
    found = regrading_now(call.site)
    if isinstance(found, WebRefusal):
        return found
    counts = {one: len(found.going(one)) for one in Shift}
    return RegradingResult(
        seen=digest_of_changes(found),
        raised=counts[Shift.RAISED],
        lowered=counts[Shift.LOWERED],
        unchanged=counts[Shift.UNCHANGED],
        works=tuple(map(_changed, found.to_apply)),
        failed=found.failed,
        missing=tuple(one.student for one in found.missing),
        policies=found.policies,
    )


def apply_regrading(call: DeskCall) -> RegradesResult | WebRefusal:
    """Let a regrade count, if it still comes to what was seen; it is kept with name and reason."""
    wish: RegradingWish = call.body
    signed = signed_by(call.site, call.name, wish.why)
    made = apply_shown(call.site, signed, wish.seen, allow_lower=wish.allow_lower)
    return made if isinstance(made, WebRefusal) else regrades_that_stand(call)


def undo_regrading(call: DeskCall) -> RegradeResult | WebRefusal:
    """Take the last regrade that stands back; both stay on record."""
    wish: UndoingWish = call.body
    signed = signed_by(call.site, call.name, wish.why)
    made = take_last_back(call.site, signed, allow_lower=wish.allow_lower)
    return made if isinstance(made, WebRefusal) else _regrade(made)


def _last(call: DeskCall) -> LastBatch | None:
    return call.site.batches.read(call.site.graded)


def _evidence(one: LaidNumber) -> EvidenceResult:
    return EvidenceResult(
        one.quantity, one.title, one.here, one.there, one.right_here, one.right_there
    )


def _facilities(found: Iterable[Facility], titles: dict[str, str]) -> tuple[FacilityResult, ...]:
    return tuple(
        FacilityResult(one.id, titles.get(one.id, one.id), one.share, one.works) for one in found
    )


def _regrade(one: Regrade) -> RegradeResult:
    signed = one.signed
    return RegradeResult(one.number, one.undoes, signed.person, signed.why, signed.done_at)


def _changed(one: WorkChange) -> ChangedWorkResult:
    return ChangedWorkResult(
        student=one.work.student,
        digest=one.work.digest,
        direction=one.direction,
        told=one.published,
        before=one.before.score,
        after=one.after.score,
        items=tuple(
            ChangedItemResult(
                item.quantity,
                None if item.before is None else item.before.points,
                None if item.after is None else item.after.points,
            )
            for item in one.items
        ),
    )


_DESK: Final = TokenRole.INSTRUCTOR
_REGRADING: Final = "/desk/regrading"
WORK_OPERATIONS: Final = (
    ApiOperation("GET", "/desk/figures", _DESK, figures, FiguresResult),
    ApiOperation("GET", "/desk/flags", _DESK, flags, FlagsResult),
    ApiOperation("GET", "/desk/students/{student}/flags", _DESK, student_flags, StudentFlagsResult),
    ApiOperation("GET", "/desk/grading", _DESK, grading, GradingResult, refuses=(Code.NOT_FOUND,)),
    ApiOperation(
        *("POST", "/desk/grading", _DESK, begin_grading, GradingResult),
        takes=PublishingReason,
        refuses=(Code.NOT_FOUND, Code.CONFLICT),
        status=HTTPStatus.ACCEPTED,
    ),
    ApiOperation("GET", _REGRADING, _DESK, regrades_that_stand, RegradesResult),
    ApiOperation(
        *("POST", _REGRADING, _DESK, show_regrading, RegradingResult), refuses=(Code.CONFLICT,)
    ),
    ApiOperation(
        *("POST", f"{_REGRADING}/apply", _DESK, apply_regrading, RegradesResult),
        takes=RegradingWish,
        refuses=(Code.CONFLICT,),
        status=HTTPStatus.CREATED,
    ),
    ApiOperation(
        *("POST", f"{_REGRADING}/undo", _DESK, undo_regrading, RegradeResult),
        takes=UndoingWish,
        refuses=(Code.CONFLICT,),
        status=HTTPStatus.CREATED,
    ),
)
