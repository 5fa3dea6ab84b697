"""The general view of a solved scheme on a sheet, as a document.

Pure: from the plan, the solved values, the language and what the title block says.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from gripcourse.course.view import Face, View
from gripcourse.drawing.paper.document import new_document
from gripcourse.drawing.paper.sheet import (
    FORMATS,
    Notes,
    PartsRow,
    draw_list,
    draw_notes,
    draw_sheet,
    is_explanation,
    note_lines,
)
from gripcourse.drawing.paper.strokes import Box
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.text import capital
from gripcourse.drawing.paper.title_block import TitleBlock
from gripcourse.drawing.view.contents import Figure, figure
from gripcourse.drawing.view.details import Detail, details_of
from gripcourse.drawing.view.enlarged import DetailLayout, detail_layout, draw_detail
from gripcourse.drawing.view.face import FaceLayout, draw_face, face_layout
from gripcourse.drawing.view.layout import Arranged, Pictured, Scale, SheetContent, arrange
from gripcourse.drawing.view.lengths import length_text
from gripcourse.drawing.view.made_of import made_of
from gripcourse.drawing.view.numbers import numbers_at
from gripcourse.errors import CourseError, Problem
from gripcourse.solver.plan import Plan
from gripcourse.text.units import stands_close, unit_text
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from ezdxf.document import Drawing

_FIGURES = 4  # of a characteristic
_ENLARGED = 1.5  # times that what is shown again is larger; a section shows what nothing else does
_MASS_FIGURES = 2  # outlines leave out ribs, rounds and holes


@dataclass(frozen=True, slots=True)
class GeneralView:
    """A general view: what it shows, how it lies on its sheet, and the finished document."""

    figure: Figure
    faces: Mapping[Face, FaceLayout]
    details: tuple[DetailLayout, ...]
    arranged: Arranged
    rows: tuple[PartsRow, ...]
    notes: tuple[Notes, ...]
    document: "Drawing"


def general_view(
    plan: Plan, view: View, values: Mapping[str, float], block: TitleBlock, words: Words
) -> GeneralView:
    """Draw the general view of a variant.

    Args:
        plan: of the variant.
        view: of its scheme.
        values: of every quantity, in declared units.
        block: what the title block says.
        words: of the reader.

    Raises:
        CourseError: no sheet has room for the views at any scale, or the main one shows nothing.
    """
    plain = figure(plan, view, values)
    details = details_of(plain, plan, view, values)
    required = _required(view, words, starred=bool(plain.overall or details))
    notes = tuple(_notes(_characteristics(view, plan, values, words), required))
    lines = note_lines(notes)
    main = plain.extents[Face.MAIN]
    pictured = Pictured(max(main.width, main.height), plain.detail)
    content = _content(plain, details, words)
    arranged = arrange(content, pictured, len(plain.positions), lines)
    if arranged is None:
        raise CourseError([_too_large(plain)])
    over, under = arranged.scale
    there = [details[number] for number in sorted(arranged.details)]
    shown = _numbered(plain, face_layout(plain, Face.MAIN, arranged.factor, words, there))
    faces = {face: face_layout(shown, face, arranged.factor, words, there) for face in shown.faces}
    enlarged = [
        (detail_layout(details[number], letter, arranged.details[number][0], words), number)
        for letter, number in enumerate(sorted(arranged.details))
    ]
    rows = tuple(_rows(shown, view, plan, values, words))
    block = replace(block, mass=_mass(plan, view, values, words))
    document = new_document(words.language)
    layout = document.modelspace()
    scale = f"{words.number(over)}:{words.number(under)}"
    draw_sheet(layout, arranged.sheet, block, scale, words)
    draw_list(layout, arranged.sheet, rows, words)
    draw_notes(layout, arranged.lines, notes, words)
    for face, origin in arranged.origins.items():
        draw_face(layout, shown, face, faces[face], arranged.factor, origin)
    for laid, number in enlarged:
        draw_detail(layout, laid, arranged.details[number][1])
    return GeneralView(
        shown, faces, tuple(one for one, _ in enlarged), arranged, rows, notes, document
    )


def _content(plain: Figure, details: Sequence[Detail], words: Words) -> SheetContent:
    """Return what is to be arranged: the faces with all marks, and the details."""

    def faces(factor: float) -> Mapping[Face, Sequence[Box]]:
        return {
            face: face_layout(plain, face, factor, words, details).boxes for face in plain.faces
        }

    def detail_box(number: int) -> Callable[[Scale], Box]:
        return lambda scale: detail_layout(details[number], number, scale, words).box

    return SheetContent(
        faces,
        [*plain.extents.values()],
        [detail_box(number) for number in range(len(details))],
        [1.0 if one.is_section else _ENLARGED for one in details],
    )


def _too_large(plain: Figure) -> Problem:
    extent = plain.extents[Face.MAIN]
    what = message(
        "The views do not fit a sheet of {sheet} at any scale: the main one is {width} by"
        " {height} mm.",
        sheet=FORMATS[-1][0].name,
        width=round(extent.width),
        height=round(extent.height),
    )
    remedy = message("Correct the lengths that this part is drawn from.")
    return Problem(plain.largest.file, plain.largest.key, what, remedy)


def sheet_svg(drawn: GeneralView, block: TitleBlock) -> tuple[str, str]:
    """Return the sheet as SVG, and the sentence that stands for it where it cannot be seen."""
    title = f"{block.document}: {block.title}, {block.designation}"
    sheet = drawn.arranged.sheet
    return svg_text(drawn.document, sheet.width, sheet.height, title), title


def _numbered(shown: Figure, main: FaceLayout) -> Figure:
    """Number the positions in the order of their shelves; crossing leaders change places."""
    level = {leader.note.text: leader.left for leader in main.leaders}
    numbered = enumerate(shown.positions, 1)
    ordered = sorted(numbered, key=lambda one: level[str(one[0])])
    return replace(shown, positions=[position for _, position in ordered])


def _rows(
    shown: Figure, view: View, plan: Plan, values: Mapping[str, float], words: Words
) -> Iterator[PartsRow]:
    """Yield the parts list: the sizes of a part that this variant has."""
    numbers = numbers_at(plan, view, values, view.position)
    for number, one in enumerate(shown.positions, 1):
        sizes = [name for name in one.part.sizes if _has(values, name)]
        written = "; ".join(_size(name, plan, values, words) for name in sizes)
        title = one.part.title.of(words.language) if one.part.title is not None else ""
        named = made_of(one.part, view, numbers).material
        material = named.of(words.language) if named is not None else ""
        yield PartsRow(str(number), capital(title), str(one.count), capital(material), written)


def _has(values: Mapping[str, float], name: str) -> bool:
    """Tell whether a variant has a quantity: one that its options leave out has no value."""
    return not math.isnan(values.get(name, math.nan))


def _size(name: str, plan: Plan, values: Mapping[str, float], words: Words) -> str:
    quantity = plan.quantities[name]
    symbol = quantity.symbol.of(words.language)
    value = values[name]
    written = length_text(value, words) if quantity.unit == "mm" else words.number(value, _FIGURES)
    unit = "" if quantity.unit == "mm" else unit_text(quantity.unit, words.language)
    joint = "" if stands_close(unit) else " "
    return f"{symbol} = {written}{joint}{unit}"


def _mass(plan: Plan, view: View, values: Mapping[str, float], words: Words) -> str:
    from gripcourse.drawing.view.mass import mass_of  # noqa: PLC0415 (shapely: only who draws)

    mass = mass_of(plan, view, values)
    return "" if mass is None else words.number(mass, _MASS_FIGURES)


def _characteristics(
    view: View, plan: Plan, values: Mapping[str, float], words: Words
) -> tuple[str, ...]:
    return tuple(_lines(view, plan, values, words))


def _required(view: View, words: Words, *, starred: bool) -> tuple[str, ...]:
    """Return the technical requirements; what an asterisk means is said where the view does not."""
    declared = [one.of(words.language) for one in view.requirements]
    if starred and not any(map(is_explanation, declared)):
        declared.append(words.say(message("* Dimensions for reference.")))
    return tuple(sorted(declared, key=is_explanation))


def _notes(characteristics: tuple[str, ...], required: tuple[str, ...]) -> Iterator[Notes]:
    """Yield what is written beside the drawing, without empty parts."""
    for heading, found in (
        (message("Technical characteristics"), characteristics),
        (message("Technical requirements"), required),
    ):
        if found:
            yield Notes(heading, found)


def _lines(view: View, plan: Plan, values: Mapping[str, float], words: Words) -> Iterator[str]:
    """Yield the characteristics that this variant has."""
    for name in view.characteristics:
        if not _has(values, name):
            continue
        quantity = plan.quantities[name]
        unit = unit_text(quantity.unit, words.language)
        written = words.number(values[name], _FIGURES)
        title = capital(_plain(quantity.title.of(words.language)))
        yield f"{title}: {written} {unit}".rstrip()


def _plain(title: str) -> str:
    """Leave out how a title explains itself: a second colon in one line would read as its value."""
    return title.split(": ", maxsplit=1)[0]
