"""Works of a whole group, made by putting answers into the bytes of issued workbooks."""

import io
import random
import re
import secrets
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, replace
from datetime import date
from pathlib import Path
from xml.sax.saxutils import escape

from gripcourse.cli.demo.students import correct
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.gradebook.fingerprint import fingerprints
from gripcourse.issuing.allotment import Terms, extend
from gripcourse.issuing.signature import KEY_BYTES, key_path, read_key
from gripcourse.issuing.store import extend_register
from gripcourse.machine.resources import course_root
from gripcourse.simulation.write import Typed
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.init import init_course
from gripcourse.variants.model import Issued, Student
from gripcourse.variants.table import read_table
from gripcourse.workbook.names import ANSWER, cell_name
from gripcourse.workbook.write import answer_workbook

WRONG = 3  # answers of each student
SEED = 26063
_SHEET = re.compile(r'<sheet name="([^"]*)"[^>]*r:id="rId(\d+)"')
_NAME = re.compile(r'<definedName name="([^"]*)">([^<]*)</definedName>')


def hand_in(base: Path, works: int) -> None:
    """Issue a course to as many students, and let all of them answer.

    Args:
        base: folder for the `course` and the `works`.
        works: how many students.
    """
    init_course(base / "course", secrets.token_bytes(KEY_BYTES), Words("en"))
    course = load_course(base / "course")
    drawn = read_table(course_root() / "variants" / "tables" / "main.csv", course)
    variants = [replace(drawn[n % len(drawn)], id=f"v{n:05}") for n in range(works)]
    students = [Student(f"u{n:05}", f"Student {n:05}", "A", "", "en", "") for n in range(works)]
    key = read_key(key_path(course.root))
    terms = Terms(key, date(2026, 9, 1), None, fingerprints(course.root).course)
    issued = extend_register(
        course.root, course.id, lambda register: extend(register, students, variants, terms)
    )
    entries = issued.register.entries
    blanks = [Blank.of(entry, course) for entry in entries[: len(drawn)]]
    (base / "works").mkdir()
    chance = random.Random(SEED)  # noqa: S311 (not for secrets)
    for number, entry in enumerate(entries):
        work = blanks[number % len(blanks)].filled(entry, chance)
        (base / "works" / f"{entry.student.id}.xlsx").write_bytes(work)


@dataclass(frozen=True, slots=True)
class Blank:
    """An issued workbook, taken apart: its members, where answers go, and the right ones."""

    entry: Issued
    members: Mapping[str, str]
    places: Mapping[str, tuple[str, str]]
    answers: Typed

    @classmethod
    def of(cls, entry: Issued, course: Course) -> "Blank":
        """Make it for a student."""
        plan = plan_of(course, entry.variant.composition)
        with zipfile.ZipFile(io.BytesIO(answer_workbook(plan, entry, course, Words("en")))) as file:
            members = {name: file.read(name).decode() for name in file.namelist()}
        book = members["xl/workbook.xml"]
        sheets = {name: f"xl/worksheets/sheet{number}.xml" for name, number in _SHEET.findall(book)}
        named = dict(_NAME.findall(book))
        answers = correct(plan, entry)
        places = {}
        for quantity in answers:
            sheet, _, cell = named[cell_name(ANSWER, quantity)].rpartition("!")
            places[quantity] = sheets[sheet.strip("'")], cell.replace("$", "")
        return cls(entry, members, places, answers)

    def filled(self, entry: Issued, chance: random.Random) -> bytes:
        """Return the workbook of another student of the same numbers, filled in."""
        numbers = [name for name, value in self.answers.items() if not isinstance(value, str)]
        wrong = {name: chance.uniform(1.2, 9.0) for name in chance.sample(numbers, WRONG)}
        members = dict(self.members)
        for quantity, value in self.answers.items():
            member, cell = self.places[quantity]
            typed = value if isinstance(value, str) else float(value) * wrong.get(quantity, 1.0)
            members[member] = _typed(members[member], cell, typed)
        swaps = (
            (self.entry.student.id, entry.student.id),
            (self.entry.student.name, entry.student.name),
            (self.entry.variant.id, entry.variant.id),
            (self.entry.signature, entry.signature),
        )
        stream = io.BytesIO()
        with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as file:
            for name, text in members.items():
                for mine, theirs in swaps:
                    text = text.replace(mine, theirs)  # noqa: PLW2901 (one swap after the other)
                file.writestr(name, text)
        return stream.getvalue()


def _typed(sheet: str, cell: str, value: float | str) -> str:
    """Put an answer into a blank cell of a sheet."""
    begin = sheet.index(f'<c r="{cell}"')
    end = sheet.index("/>", begin)
    if isinstance(value, str):
        content = f' t="inlineStr"><is><t>{escape(value)}</t></is></c>'
    else:
        content = f"><v>{value:.15g}</v></c>"
    return sheet[:begin] + sheet[begin:end] + content + sheet[end + 2 :]
