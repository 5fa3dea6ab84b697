"""The columns left of the frame that an archive fills in, fields 19 to 25 of GOST 2.104."""

from collections.abc import Iterable

from gripcourse.drawing.paper.cells import PAD, SMALL, Pen
from gripcourse.drawing.paper.document import LineKind
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.text import add_text
from gripcourse.text.words import Message, Words, message

_HEADING, _ENTRY = 5.0, 7.0  # widths of the columns, mm
# From the bottom of the frame upwards, and from its top downwards, each with its height.
_LOWER: tuple[tuple[Message, float], ...] = (
    (message("Orig. inv. no."), 25.0),
    (message("Signed, date"), 35.0),
    (message("Repl. inv. no."), 25.0),
    (message("Dupl. inv. no."), 25.0),
    (message("Signed, date"), 35.0),
)
_UPPER: tuple[tuple[Message, float], ...] = (
    (message("First use"), 60.0),
    (message("Reference no."), 60.0),
)


def draw_margin(pen: Pen, frame: Box, words: Words) -> None:
    """Draw the columns beside a frame."""
    left = frame.left - _HEADING - _ENTRY
    for bottom, top, heading in (*_upwards(frame.bottom), *_downwards(frame.top)):
        pen.box(Box(left, bottom, frame.left, top), LineKind.OUTLINE)
        middle = (left + _HEADING / 2, (bottom + top) / 2)
        room = top - bottom - 2 * PAD
        text = words.say(heading)
        add_text(pen.layout, text, middle, SMALL, align="MIDDLE_CENTER", rotation=90.0, widest=room)
    for low, high in (
        (frame.bottom, frame.bottom + sum(height for _, height in _LOWER)),
        (frame.top - sum(height for _, height in _UPPER), frame.top),
    ):
        pen.line((left + _HEADING, low), (left + _HEADING, high))


def _upwards(bottom: float) -> Iterable[tuple[float, float, Message]]:
    for heading, height in _LOWER:
        yield bottom, bottom + height, heading
        bottom += height


def _downwards(top: float) -> Iterable[tuple[float, float, Message]]:
    for heading, height in _UPPER:
        yield top - height, top, heading
        top -= height
