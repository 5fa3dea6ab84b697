"""The desk's pages about everybody: figures, flags, and the batch that is being graded."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from http import HTTPStatus
from typing import Final

from starlette.responses import RedirectResponse, Response
from starlette.routing import Route

from gripcourse.solver.plan import plan_of
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.figures import Facility, group_figures
from gripcourse.variants.model import Issued
from gripcourse.web.batch import BatchWork, FoundFlag
from gripcourse.web.desk_acts import begin_batch, grading_now
from gripcourse.web.downloads import names_of_tables
from gripcourse.web.refusals import NOT_FOUND
from gripcourse.web.seat import Seat, desk_route
from gripcourse.web.site import Site

_HARDEST: Final = 12
_OTHERS: Final = 3  # works that one flag lays beside
_NUMBERS: Final = 12
_SECONDS: Final = 3
_BATCHES: Final = 10  # that the page of grading names
_FIGURES: Final = 7


@dataclass(frozen=True, slots=True)
class LaidNumber:
    """A number that a likeness rests on, in either work.

    Attributes:
        quantity: id.
        title: what it is.
        here, there: what was typed; empty for nothing.
        right_here, right_there: what would have been right.
    """

    quantity: str
    title: str
    here: str
    there: str
    right_here: str
    right_there: str


@dataclass(frozen=True, slots=True)
class LaidBeside:
    """Another student's work beside the flagged one.

    Attributes:
        student: id; he may be in the register no longer.
        name: as the roster writes it; empty where he is not there.
        rows: the numbers.
    """

    student: str
    name: str
    rows: tuple[LaidNumber, ...]


@dataclass(frozen=True, slots=True)
class ShownFlag:
    """A flag with its evidence, and the language that its sentence is in."""

    code: str
    message: str
    language: str
    beside: tuple[LaidBeside, ...]


def overview_routes(site: Site) -> list[Route]:
    """Return the routes of these pages."""
    return [
        desk_route(site, "figures", figures),
        desk_route(site, "flags", flags),
        desk_route(site, "grading", grading),
        desk_route(site, "grading", grading_begun, "POST"),
    ]


def figures(seat: Seat) -> Response:
    """Show how scores are spread, and what was hard."""
    context, found = seat.site.context, group_figures(seat.site.context)
    language = seat.words.language
    sections = {one.id: one.title.of(language) for one in context.course.sections}
    titles = titles_of(context, seat.words)
    values: dict[str, object] = {
        "found": found,
        "late": context.policy.late is not None,
        "most": max(found.scores, default=0),
        "sections": list(_named(found.sections, sections)),
        "items": list(_named(found.items[:_HARDEST], titles)),
    }
    return seat.page("figures", values)


def flags(seat: Seat) -> Response:
    """Show whose work somebody should look at."""
    site = seat.site
    batch, register = site.batches.read(site.graded), site.context.register()
    works = () if batch is None else batch.flagged
    names = {id_: issued.student.name or id_ for id_, issued in register.items()}
    said = [
        (work, [said_of(site.context, seat.words, flag) for flag in work.flags]) for work in works
    ]
    return seat.page("flags", {"batch": batch, "works": said, "names": names})


def grading(seat: Seat) -> Response:
    """Show how far a batch is; the page renews itself where the instructor wants it to."""
    site, live = seat.site, seat.request.query_params.get("live") == "yes"
    if site.graded is None:
        return seat.refuse(NOT_FOUND)
    now, rule = grading_now(site, site.graded), site.context.attempt_rule()
    values: dict[str, object] = {
        "progress": now.progress,
        "silent": now.silent,
        "runs": now.runs,
        "failed": now.failed,
        "live": live,
        "last": None if now.last is None else now.last.at,
        "graded": 0 if now.last is None else len(now.last.works),
        "waiting": now.waiting,
        "all_works": rule is not None and rule.asks_for_all,
        "tables": names_of_tables(site),
        "batches": site.context.desk.batches()[: -_BATCHES - 1 : -1],
    }
    response = seat.page("grading", values)
    if now.runs and live:
        response.headers["Refresh"] = str(_SECONDS)
    return response


def grading_begun(seat: Seat) -> Response:
    """Begin to grade what was handed in."""
    refused = begin_batch(seat.site, seat.name, seat.sent.texts.get("why", ""))
    if refused is not None:
        return seat.refuse(refused)
    return RedirectResponse(f"{seat.home}grading?live=yes", HTTPStatus.SEE_OTHER)


def flags_of(site: Site, words: Words, student: str) -> tuple[ShownFlag, ...]:
    """Return the flags of a student with their evidence."""
    batch = site.batches.read(site.graded)
    if batch is None:
        return ()
    return tuple(
        _shown(site.context, words, work, flag, batch.works)
        for work in batch.of(student)
        for flag in work.flags
    )


def _shown(
    context: DeskContext,
    words: Words,
    work: BatchWork,
    flag: FoundFlag,
    works: tuple[BatchWork, ...],
) -> ShownFlag:
    register, titles = context.register(), titles_of(context, words)
    others = {one.student: one for one in works}
    own = register.get(work.student)
    if own is not None:
        plan = plan_of(context.course, own.variant.composition)
        titles |= {one.id: one.title.of(words.language) for one in plan.quantities.values()}
    here = _Side(work, _right(context, own), words)
    beside = []
    for id_ in flag.others[:_OTHERS]:
        issued = register.get(id_)
        there = _Side(others.get(id_), _right(context, issued), words)
        rows = tuple(
            LaidNumber(
                one,
                titles.get(one, one),
                here.typed(one),
                there.typed(one),
                here.right(one),
                there.right(one),
            )
            for one in flag.rests_on[:_NUMBERS]
        )
        beside.append(LaidBeside(id_, "" if issued is None else issued.student.name or id_, rows))
    return ShownFlag(flag.code, *said_of(context, words, flag), tuple(beside))


def said_of(context: DeskContext, words: Words, flag: FoundFlag) -> tuple[str, str]:
    """Return a flag's sentence, and its language: the course's in results of an earlier program."""
    known = words.language in flag.in_languages
    return flag.said(words.language), words.language if known else context.course.language


@dataclass(frozen=True, slots=True)
class _Side:
    """One of two works: what was typed, None where it was not graded, and what is right there."""

    work: BatchWork | None
    values: Mapping[str, float]
    words: Words

    def typed(self, quantity: str) -> str:
        return "" if self.work is None else self.work.typed.get(quantity, "")

    def right(self, quantity: str) -> str:
        value = self.values.get(quantity)
        return "" if value is None else self.words.number(value, _FIGURES)


def _right(context: DeskContext, issued: Issued | None) -> Mapping[str, float]:
    """Return what is right in a student's variant, given values too; nothing of nobody's."""
    if issued is None:
        return {}
    plan = plan_of(context.course, issued.variant.composition)
    return solve_variant(plan, issued.variant.given)


def titles_of(context: DeskContext, words: Words) -> dict[str, str]:
    """Return the titles of everything that was asked of anybody, as who came first was asked."""
    issued = tuple(context.register().values())[::-1]
    compositions = dict.fromkeys(one.variant.composition for one in issued)
    return {
        quantity.id: quantity.title.of(words.language)
        for composition in compositions
        for quantity in plan_of(context.course, composition).quantities.values()
    }


def _named(found: Iterable[Facility], titles: dict[str, str]) -> Iterator[tuple[str, Facility]]:
    for one in found:
        yield titles.get(one.id, one.id), one
