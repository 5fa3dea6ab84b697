"""What an instructor's program asks about items that a person marks."""

from dataclasses import replace
from http import HTTPStatus
from typing import Final

from gripcourse.errors import UsageError
from gripcourse.gradebook.enter import Draft
from gripcourse.machine.database.home import home_of
from gripcourse.text.words import Words
from gripcourse.usecases.marks.mark import item_of, what_waits
from gripcourse.usecases.serving.hand_in import receipt_of
from gripcourse.usecases.serving.taken import hand_ins_of, requests_of
from gripcourse.web import acts
from gripcourse.web.desk_acts import keep_mark, marks_seen
from gripcourse.web.drawings import NOT_SHOWN, painted
from gripcourse.web.marking import LONGEST_COMMENT, ItemToMark, to_mark
from gripcourse.web.refusals import NOT_FOUND, Code, WebRefusal
from gripcourse.web.rest.declare import ApiOperation, DeskCall, SentFile, TokenRole
from gripcourse.web.rest.desk_results import MarkResult
from gripcourse.web.rest.marking_results import (
    ItemResult,
    LevelResult,
    MarkingResult,
    RubricLineResult,
    WaitingResult,
)
from gripcourse.web.rest.problems import NotUsable
from gripcourse.web.rest.student import receipt_result, request_result
from gripcourse.web.rest.wishes import MarkWish


def marking(call: DeskCall) -> MarkingResult:
    """Everything that waits for a person."""
    context = call.site.context
    found = (
        to_mark(context, one) for one in what_waits(home_of(context.course.root), context.joins())
    )
    return MarkingResult(tuple(_waiting(one, call.words) for one in found if one is not None))


def item(call: DeskCall) -> ItemResult | WebRefusal:
    """An item of a student's last work: its rubric, the student's files and what was asked."""
    context, (student, quantity) = call.site.context, _place(call)
    now = item_of(home_of(context.course.root), student, quantity, context.joins())
    wanted = None if now is None else to_mark(context, now.item)
    if wanted is None:
        return NOT_FOUND
    return ItemResult(
        waiting=_waiting(wanted, call.words),
        seen=marks_seen(call.site, student, quantity),
        rubric=_lines(wanted, call.words),
        hand_ins=tuple(
            receipt_result(receipt_of(context, wanted.issued, one))
            for one in hand_ins_of(context.desk, student, context.joins())
        ),
        requests=tuple(
            request_result(one)
            for one in requests_of(context.desk, student, context.joins())
            if one.item == quantity
        ),
    )


def mark(call: DeskCall) -> MarkResult | WebRefusal | NotUsable:
    """Mark an item by the lines of its rubric, or by a share of its points; kept with your name."""
    wish: MarkWish = call.body
    student, quantity = _place(call)
    draft = Draft(
        student=student,
        quantity=quantity,
        lines=wish.lines,
        credit=wish.credit,
        comment=wish.comment.strip()[:LONGEST_COMMENT],
        override=wish.override,
        withdraw=wish.withdraw,
    )
    try:
        made = keep_mark(call.site, call.name, draft, wish.seen)
    except UsageError as refused:
        return NotUsable(tuple(replace(one, key=one.parameter) for one in refused.problems))
    if isinstance(made, WebRefusal):
        return made
    if not made.items:
        return WebRefusal(Code.CONFLICT, acts.ALREADY_SO)
    kept = made.items[0].mark
    return MarkResult(kept.quantity, kept.credit, kept.marker, kept.comment, kept.marked_at)


def drawing(call: DeskCall) -> SentFile | WebRefusal:
    """A page of a drawing that a student handed in, as a picture of our own."""
    path = call.request.path_params
    kept = acts.kept_file(call.site, str(path["student"]), int(path["number"]))
    if kept is None or not kept.is_drawing:
        return NOT_FOUND
    made = painted(call.site, kept, int(path["page"]))
    return NOT_SHOWN if made is None else SentFile(made[0], made[0].name)


def _place(call: DeskCall) -> tuple[str, str]:
    path = call.request.path_params
    return str(path["student"]), str(path["item"])


def _waiting(one: ItemToMark, words: Words) -> WaitingResult:
    person = one.issued.student
    title = one.quantity.title.of(words.language)
    return WaitingResult(person.id, person.name, one.quantity.id, title, one.again)


def _lines(one: ItemToMark, words: Words) -> tuple[RubricLineResult, ...]:
    language = words.language
    return tuple(
        RubricLineResult(
            id=line.id,
            share=line.share,
            text=line.text.of(language),
            levels=tuple(
                LevelResult(level.credit, level.text.of(language)) for level in line.levels
            ),
        )
        for line in (() if one.rubric is None else one.rubric.lines)
    )


_DESK: Final = TokenRole.INSTRUCTOR
_DRAWING: Final = "/desk/students/{student}/drawings/{number:int}"
_ITEM: Final = "/desk/marking/{student}/{item}"
MARKING_OPERATIONS: Final = (
    ApiOperation("GET", "/desk/marking", _DESK, marking, MarkingResult),
    ApiOperation("GET", _ITEM, _DESK, item, ItemResult),
    ApiOperation(
        *("POST", _ITEM, _DESK, mark, MarkResult),
        takes=MarkWish,
        refuses=(Code.CONFLICT,),
        status=HTTPStatus.CREATED,
    ),
    ApiOperation(
        *("GET", f"{_DRAWING}/{{page:int}}", _DESK, drawing, SentFile),
        refuses=(Code.NOT_USABLE,),
        media="image/png",
        waits=True,
    ),
)
