"""Virtual students' workbooks: the issued ones, filled in with an ordinary library."""

import io
from collections.abc import Mapping
from pathlib import Path
from typing import TypeAlias

from gripcourse.machine.files import replacing
from gripcourse.simulation.model import SimulatedWork
from gripcourse.simulation.student import Classroom
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words
from gripcourse.workbook.names import ANSWER, cell_name
from gripcourse.workbook.write import answer_workbook

Typed: TypeAlias = Mapping[str, float | str]
"""What a student types, by quantity id: numbers, or text."""


def write_work(work: SimulatedWork, room: Classroom, target: Path) -> None:
    """Issue a student's workbook and fill it in.

    Args:
        work: of a student who works in the own workbook.
        room: the cohort that the student belongs to.
        target: file to write.
    """
    course, issued = room.context.course, room.context.register[work.student]
    plan = plan_of(course, issued.variant.composition)
    words = Words(issued.student.language or course.language)
    typed = {action.quantity: action.typed for action in work.actions if action.typed is not None}
    fill(io.BytesIO(answer_workbook(plan, issued, course, words)), typed, target)


def fill(workbook: Path | io.BytesIO, typed: Typed, target: Path) -> None:
    """Type answers into a copy of an issued workbook, found by the names of the cells.

    Args:
        workbook: as it was issued.
        typed: what is typed into which cell; the others stay blank.
        target: file to write.
    """
    from openpyxl import load_workbook  # noqa: PLC0415 (120 ms, only for this)

    book = load_workbook(workbook)
    for quantity, value in typed.items():
        for sheet, address in book.defined_names[cell_name(ANSWER, quantity)].destinations:
            book[sheet][address] = value
    with replacing(target) as temporary:
        book.save(temporary)
