"""A table of marks that is written to be filled in is read back, in every language and form."""

from pathlib import Path

import pytest
from openpyxl import load_workbook

from gripcourse.exports.marks_table import RowToMark, write_marks_table
from gripcourse.gradebook.table import read_marks
from gripcourse.policy.model import Policy
from gripcourse.policy.rubric import lines_of
from gripcourse.text.words import LANGUAGES, Words

HOSTILE = "=1+1|cmd"


def items(policy: Policy) -> list[RowToMark]:
    drawings = list(policy.rubrics.values())
    asked = [*drawings, None]
    return [
        RowToMark(f"s{place:02}", f"item_{place}", HOSTILE, "РТК-41", "чертёж", 4.0, rubric)
        for place, rubric in enumerate(asked)
    ]


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_was_written_is_read_in_every_language(
    language: str, policy: Policy, tmp_path: Path
) -> None:
    known = lines_of(policy.rubrics.values())
    for name in ("marks.csv", "marks.xlsx"):
        write_marks_table(tmp_path / name, items(policy), Words(language))
        table = read_marks(tmp_path / name, known)
        assert (table.rows, table.empty) == ((), len(items(policy)))
    book = load_workbook(tmp_path / "marks.xlsx")
    # The same table is the same file: what was filled in is told from what was not by its bytes.
    assert book.properties.created.year == 2000
    sheet = book.worksheets[0]
    assert {cell.data_type for row in sheet.iter_rows() for cell in row} <= {"s", "n"}
    for row in sheet.iter_rows(min_row=2):
        for cell in row[6:-2]:
            if cell.fill.fill_type is None:
                cell.value = 0.5
    book.save(tmp_path / "marks.xlsx")
    rows = read_marks(tmp_path / "marks.xlsx", known).rows
    filled = {one.draft.quantity: set(one.draft.lines) for one in rows}
    asked = {one.quantity: set(one.rubric.by_id) for one in items(policy) if one.rubric}
    assert filled == asked


def test_a_line_that_rubrics_word_otherwise_is_called_by_all_its_texts(
    policy: Policy, tmp_path: Path
) -> None:
    write_marks_table(tmp_path / "marks.csv", items(policy), Words("ru"))
    headings = (tmp_path / "marks.csv").read_text(encoding="utf-8-sig").splitlines()[0]
    shared = {id_: texts for id_, texts in lines_of(policy.rubrics.values()).items() if texts[1:]}
    assert shared
    for id_, texts in shared.items():
        assert id_ not in headings.split(";")
        assert all(text.of("ru") in headings for text in texts)


def test_nothing_in_a_cell_runs(policy: Policy, tmp_path: Path) -> None:
    write_marks_table(tmp_path / "marks.csv", items(policy), Words("ru"))
    text = (tmp_path / "marks.csv").read_text(encoding="utf-8-sig")
    assert f";'{HOSTILE};" in text
