"""Lines of a table are taken over from an earlier run, and only where they say the same."""

import errno
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from gripcourse.machine.files import write_together
from gripcourse.usecases.grading.lines_before import LinesBefore, TableLine

NAMES = ("Anna", "Bohdan", "Оксана")


@dataclass
class Table:
    """A table of names, one in a line, and the lines that were made for it."""

    folder: Path
    made: list[str] = field(default_factory=list)

    @property
    def path(self) -> Path:
        return self.folder / "table.json"

    @property
    def note(self) -> Path:
        return self.folder / "kept" / "table.json.lines"

    def write(self, *names: str, made_with: str = "the course") -> str:
        """Write it, and return what it says."""
        self.made.clear()
        pieces = ["[", *(self._line(name) for name in names), "]"]
        lines = LinesBefore(self.note, made_with)
        write_together({self.path: lines.taken_over(self.path, pieces)})
        return self.path.read_text(encoding="utf-8")

    def _line(self, name: str) -> TableLine:
        def make() -> str:
            self.made.append(name)
            return f"\n«{name}»"

        return TableLine(name, make)


@pytest.fixture
def table(tmp_path: Path) -> Table:
    found = Table(tmp_path)
    found.write(*NAMES)
    return found


def test_a_new_line_among_known_ones_is_the_only_one_that_is_made(table: Table) -> None:
    assert (
        table.write("Anna", "Danylo", "Bohdan", "Оксана")
        == "[\n«Anna»\n«Danylo»\n«Bohdan»\n«Оксана»]"
    )
    assert table.made == ["Danylo"]


def test_lines_may_come_in_another_order_and_some_may_go(table: Table) -> None:
    assert table.write("Оксана", "Anna") == "[\n«Оксана»\n«Anna»]"
    assert table.made == []


def test_lines_are_taken_over_from_run_to_run(table: Table) -> None:
    table.write("Оксана", "Anna", "Danylo")
    table.write(*NAMES, "Danylo")
    assert table.made == ["Bohdan"]


def test_what_lines_are_made_with_makes_all_of_them_anew(table: Table) -> None:
    table.write(*NAMES, made_with="another course")
    assert table.made == list(NAMES)


def _one_letter_is_another(table: Table) -> None:
    table.path.write_bytes(table.path.read_bytes().replace(b"Bohdan", b"Bogdan"))


def _a_letter_more(table: Table) -> None:
    table.path.write_bytes(b" " + table.path.read_bytes())


def _cut_off(table: Table) -> None:
    table.path.write_bytes(table.path.read_bytes()[:5])


def _gone(table: Table) -> None:
    table.path.unlink()


def _no_note(table: Table) -> None:
    table.note.unlink()


def _damaged_note(table: Table) -> None:
    table.note.write_bytes(table.note.read_bytes()[:-7])


@pytest.mark.parametrize(
    ("change", "left"),
    [
        (_one_letter_is_another, {"Anna", "Оксана"}),
        (_a_letter_more, set()),
        (_cut_off, set()),
        (_gone, set()),
        (_no_note, set()),
        (_damaged_note, set()),
    ],
)
def test_what_was_changed_since_is_made_again(
    table: Table, change: Callable[[Table], None], left: set[str]
) -> None:
    before = table.path.read_bytes()
    change(table)
    table.write(*NAMES)
    assert table.path.read_bytes() == before
    assert set(NAMES) - set(table.made) == left


def test_a_table_that_could_not_be_written_leaves_the_one_of_before_and_its_lines(
    table: Table,
) -> None:
    before = table.path.read_bytes()

    def cut_short() -> Iterator[str | TableLine]:
        yield "["
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    lines = LinesBefore(table.note, "the course")
    with pytest.raises(OSError, match=os.strerror(errno.ENOSPC)):
        write_together({table.path: lines.taken_over(table.path, cut_short())})
    assert table.path.read_bytes() == before
    table.write(*NAMES, "Danylo")
    assert table.made == ["Danylo"]
