"""A blank answer workbook of the reference course, and ways to change what is in it."""

import io
import re
import zipfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import date
from pathlib import Path

import pytest
from openpyxl import Workbook, load_workbook
from openpyxl.cell.cell import Cell

from gripcourse.course.load import load_course
from gripcourse.solver.plan import Plan, default_options, make_plan
from gripcourse.submission.interpret import interpret
from gripcourse.submission.model import Submission
from gripcourse.submission.raw import RawWorkbook
from gripcourse.submission.read import read_workbook
from gripcourse.text.words import Words
from gripcourse.variants.model import Issued, Student, Variant
from gripcourse.workbook.write import answer_workbook

SECTION = "xl/worksheets/sheet2.xml"
SCHEME = "rack_parallelogram"


@dataclass(frozen=True, slots=True)
class Returned:
    """Fills in the blank workbook and reads it back."""

    blank: bytes
    opened: Workbook
    plan: Plan
    folder: Path

    def book(self) -> Workbook:
        return load_workbook(io.BytesIO(self.blank))

    def cell(self, book: Workbook, quantity: str) -> Cell:
        [(sheet, address)] = book.defined_names[f"answer.{quantity}"].destinations
        cell: Cell = book[sheet][address.replace("$", "")]
        return cell

    def saved(self, book: Workbook) -> Path:
        path = self.folder / "returned.xlsx"
        book.save(path)
        return path

    def read(self, path: Path) -> Submission:
        raw = read_workbook(path)
        assert isinstance(raw, RawWorkbook), raw
        return interpret(raw, self.plan.quantities.values())

    def filled(self, values: Mapping[str, object]) -> Submission:
        """Return what is read after cells were set to values, as a spreadsheet program would."""
        cells = {quantity: self.cell(self.opened, quantity) for quantity in values}
        formats = {quantity: cell.number_format for quantity, cell in cells.items()}
        for quantity, cell in cells.items():
            value = values[quantity]
            cell.value = value  # type: ignore[assignment]
            if isinstance(value, str) and not value.startswith("=#"):
                cell.data_type = "s"  # text stays text, also `=1,5*2` and `#N/A`
        path = self.saved(self.opened)
        for quantity, cell in cells.items():  # blank again for the next test
            cell.value, cell.number_format = None, formats[quantity]
        return self.read(path)

    def patched(self, changes: Mapping[str, Callable[[bytes], bytes]]) -> Path:
        """Return a file in which parts of the blank workbook were rewritten."""
        path = self.folder / "patched.xlsx"
        with (
            zipfile.ZipFile(io.BytesIO(self.blank)) as source,
            zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as target,
        ):
            for member in source.infolist():
                data = source.read(member)
                target.writestr(member.filename, changes.get(member.filename, bytes)(data))
        return path

    def stored(self, number: str) -> tuple[str, Path]:
        """Return a file whose first answer cell stores this text as its number."""
        return self.holding(f"<v>{number}</v>")

    def holding(self, content: str, kind: str = "n") -> tuple[str, Path]:
        """Return a file whose first answer cell has this XML inside, and is of this kind."""
        book = self.book()
        quantity = self.plan.answered[0].id
        address = self.cell(book, quantity).coordinate
        empty = re.compile(rf'<c r="{address}" (s="\d+")/>'.encode())
        start = f'<c r="{address}" '.encode()

        def fill(found: re.Match[bytes]) -> bytes:
            return start + found[1] + f' t="{kind}">{content}</c>'.encode()

        return quantity, self.patched({SECTION: lambda part: empty.sub(fill, part)})


@pytest.fixture(scope="session")
def plan() -> Plan:
    course = load_course(Path(__file__).parents[2])
    return make_plan(course, SCHEME, default_options(course.schemes[SCHEME]))


@pytest.fixture(scope="session")
def blank(plan: Plan) -> bytes:
    example = plan.scheme.example
    assert example is not None
    given = {quantity.id: example.given[quantity.id] for quantity in plan.givens}
    variant = Variant("07", SCHEME, dict(plan.options), given)
    student = Student("s001", "Иванов Иван", "РТ-41", "", "ru", "07")
    issued = Issued(student, variant, date(2026, 2, 3), None, "ab" * 32)
    return answer_workbook(plan, issued, plan.course, Words("ru"))


@pytest.fixture(scope="session")
def opened(blank: bytes) -> Workbook:
    """The blank workbook, opened once: whoever fills it in leaves it blank."""
    return load_workbook(io.BytesIO(blank))


@pytest.fixture
def returned(blank: bytes, opened: Workbook, plan: Plan, tmp_path: Path) -> Returned:
    return Returned(blank, opened, plan, tmp_path)
