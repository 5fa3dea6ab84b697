"""Marking at the desk: what waits for a person, one item after the other, by its rubric.

Any other item of a student's last work has such a page too: a mark is corrected there, and what the
program found is overruled.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from http import HTTPStatus
from typing import Final
from urllib.parse import quote

from starlette.responses import RedirectResponse, Response
from starlette.routing import Route

from gripcourse.course.quantity import Quantity
from gripcourse.errors import UsageError
from gripcourse.gradebook.enter import Draft
from gripcourse.gradebook.waiting import ItemNow, Waiting
from gripcourse.machine.database.home import home_of
from gripcourse.policy.rubric import Rubric
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words
from gripcourse.usecases.marks.mark import item_of, what_waits
from gripcourse.usecases.serving.desk import DeskContext
from gripcourse.usecases.serving.hand_in import receipt_of
from gripcourse.usecases.serving.taken import hand_ins_of, requests_of
from gripcourse.variants.model import Issued
from gripcourse.web.desk_acts import keep_mark, marks_seen
from gripcourse.web.drawings import drawings_of, shown_drawing
from gripcourse.web.refusals import NOT_FOUND, WebRefusal
from gripcourse.web.seat import Seat, desk_route
from gripcourse.web.site import Site

_LINE: Final = "line:"
LONGEST_COMMENT: Final = 2000
_LONGEST_NUMBER: Final = 5


@dataclass(frozen=True, slots=True)
class ItemToMark:
    """An item that a person looks at.

    Attributes:
        issued: the student, and what was issued.
        quantity: the item.
        rubric: by which it is marked; None where the share of its points is said at once.
        again: whether it was marked already, before its file or result changed.
    """

    issued: Issued
    quantity: Quantity
    rubric: Rubric | None
    again: bool


def marking_routes(site: Site) -> list[Route]:
    """Return the routes of marking."""
    one = "marking/{student}/{item}"
    return [
        desk_route(site, "marking", waiting_items),
        desk_route(site, one, item_to_mark),
        desk_route(site, one, mark, "POST"),
    ]


def waiting_items(seat: Seat) -> Response:
    """Show everything that waits for a person."""
    found = [to_mark(seat.site.context, one) for one in _waiting(seat)]
    items = [
        {
            "address": _address(seat, one.issued.student.id, one.quantity.id),
            "student": one.issued.student,
            "title": one.quantity.title.of(seat.words.language),
            "again": one.again,
        }
        for one in found
        if one is not None
    ]
    return seat.page("marking", {"items": items})


def item_to_mark(seat: Seat) -> Response:
    """Show an item with its rubric."""
    return _shown(seat, {}, ())


def mark(seat: Seat) -> Response:
    """Keep a mark, and go on with the next item."""
    waits, here = _waiting(seat), _place(seat)
    places = [(one.student, one.quantity) for one in waits]
    following = _neighbour(waits, here, 1)
    texts = seat.sent.texts
    lines = {
        name.removeprefix(_LINE): _number(text)
        for name, text in texts.items()
        if name.startswith(_LINE)
    }
    draft = Draft(
        student=here[0],
        quantity=here[1],
        lines=lines,
        credit=_number(texts["credit"]) if texts.get("credit") else None,
        comment=texts.get("comment", "").strip()[:LONGEST_COMMENT],
    )
    now = _item_now(seat)
    draft = replace(draft, override=now is not None and now.overrules)
    try:
        made = keep_mark(seat.site, seat.name, draft, texts.get("seen"))
    except UsageError as refused:
        words = seat.words
        said = [f"{words.say(one.what)} {words.say(one.remedy)}" for one in refused.problems]
        return _shown(seat, texts, said)
    if isinstance(made, WebRefusal):
        return seat.refuse(made)
    address = f"{seat.home}marking" if following is None else _address(seat, *following)
    if here not in places:
        address = f"{seat.home}student/{quote(here[0], safe='')}"
    return RedirectResponse(address, HTTPStatus.SEE_OTHER)


def _shown(seat: Seat, typed: Mapping[str, str], faults: Sequence[str]) -> Response:
    waits, here, now = _waiting(seat), _place(seat), _item_now(seat)
    item = None if now is None else to_mark(seat.site.context, now.item)
    if item is None or now is None:
        return seat.refuse(NOT_FOUND)
    places = [(one.student, one.quantity) for one in waits]
    context = seat.site.context
    handed_in = hand_ins_of(context.desk, here[0], context.joins())
    drawings = drawings_of(handed_in)
    asked = seat.request.query_params
    wanted = asked.get("of", here[0]), asked.get("drawing")
    chosen = next((one for one in drawings if (one.student, str(one.number)) == wanted), None)
    chosen = chosen or (drawings[0] if drawings else None)
    number = asked.get("page", "")
    on_page = int(number) if number.isdecimal() and len(number) < _LONGEST_NUMBER else 1
    neighbours = {step: _neighbour(waits, here, step) for step in (-1, 1)}
    values: dict[str, object] = {
        "student": item.issued.student,
        "variant": item.issued.variant.id,
        "title": item.quantity.title.of(seat.words.language),
        "again": item.again,
        "rubric": None if item.rubric is None else _form(item.rubric, typed, seat.words),
        "place": _address(seat, *here),
        "seen": marks_seen(seat.site, *here),
        "found": now.found if now.overrules else None,
        "found_word": seat.words.say(now.found.outcome.traits.word),
        "typed": _typed(seat, *here),
        "marked": None if now.marked is None else now.marked.mark,
        "number": places.index(here) + 1 if here in places else 0,
        "count": len(waits),
        "previous": None if neighbours[-1] is None else _address(seat, *neighbours[-1]),
        "next": None if neighbours[1] is None else _address(seat, *neighbours[1]),
        "hand_ins": [receipt_of(context, item.issued, one) for one in handed_in],
        "drawings": drawings,
        "drawing": None if chosen is None else shown_drawing(seat, chosen, on_page),
        "requests": [
            one
            for one in requests_of(context.desk, here[0], context.joins())
            if one.item == here[1]
        ],
        "credit": typed.get("credit", ""),
        "comment": typed.get("comment", ""),
        "faults": faults,
    }
    return seat.page("mark", values)


def _form(rubric: Rubric, typed: Mapping[str, str], words: Words) -> dict[str, object]:
    """Return the rubric as the page shows it, with what was typed before."""
    lines = [
        {
            "name": f"{_LINE}{line.id}",
            "text": line.text.of(words.language),
            "share": line.share,
            "typed": typed.get(f"{_LINE}{line.id}", ""),
            "levels": [
                (level.credit, str(level.credit), level.text.of(words.language))
                for level in line.levels
            ],
        }
        for line in rubric.lines
    ]
    return {"title": rubric.title.of(words.language), "lines": lines}


def to_mark(context: DeskContext, waits: Waiting) -> ItemToMark | None:
    """Return what is to be marked; None where its student is in the register no longer."""
    issued = context.register().get(waits.student)
    if issued is None:
        return None
    plan = plan_of(context.course, issued.variant.composition)
    quantity = plan.quantities.get(waits.quantity)
    if quantity is None:
        return None
    by_rubric = waits.outcome.traits.by_rubric
    rubric = context.policy.rubrics[quantity.rubric] if by_rubric else None
    return ItemToMark(issued, quantity, rubric, waits.again)


def _typed(seat: Seat, student: str, item: str) -> str:
    """Return what stands in the cell, as the last batch read it; empty for nothing."""
    batch = seat.site.batches.read(seat.site.graded)
    works = () if batch is None else batch.of(student)
    return works[-1].typed.get(item, "") if works else ""


def _item_now(seat: Seat) -> ItemNow | None:
    context = seat.site.context
    return item_of(home_of(context.course.root), *_place(seat), context.joins())


def _waiting(seat: Seat) -> tuple[Waiting, ...]:
    context = seat.site.context
    return what_waits(home_of(context.course.root), context.joins())


def _place(seat: Seat) -> tuple[str, str]:
    path = seat.request.path_params
    return str(path["student"]), str(path["item"])


def _neighbour(
    waits: tuple[Waiting, ...], here: tuple[str, str], step: int
) -> tuple[str, str] | None:
    places = [(one.student, one.quantity) for one in waits]
    if here not in places:
        return None
    wanted = places.index(here) + step
    return places[wanted] if 0 <= wanted < len(places) else None


def _address(seat: Seat, student: str, item: str) -> str:
    return f"{seat.home}marking/{quote(student, safe='')}/{quote(item, safe='')}"


def _number(text: str) -> float:
    """Read a share; what is none is refused as such later on."""
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return math.nan
