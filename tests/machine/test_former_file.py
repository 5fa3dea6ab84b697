"""A table that a person may have filled in stays, whatever takes its place."""

from pathlib import Path

import pytest

from gripcourse.machine.former_file import keeping_former


def test_what_was_there_is_kept_beside_what_takes_its_place(tmp_path: Path) -> None:
    table = tmp_path / "marks.xlsx"
    assert keeping_former(table, lambda: table.write_text("blank")) == (5, None)
    table.write_text("filled in")
    assert keeping_former(table, lambda: table.write_text("blank"))[1] == (
        tmp_path / "marks.before-1.xlsx"
    )
    table.write_text("filled in again")
    _, kept = keeping_former(table, lambda: table.write_text("blank"))
    assert kept is not None
    assert (kept.name, kept.read_text()) == ("marks.before-2.xlsx", "filled in again")
    assert table.read_text() == "blank"
    assert (tmp_path / "marks.before-1.xlsx").read_text() == "filled in"


def test_the_same_once_more_leaves_nothing_beside_it(tmp_path: Path) -> None:
    table = tmp_path / "marks.csv"
    for _ in range(2):
        assert keeping_former(table, lambda: table.write_text("blank"))[1] is None
    assert [one.name for one in tmp_path.iterdir()] == ["marks.csv"]


def test_where_nothing_was_made_the_file_is_as_it_was(tmp_path: Path) -> None:
    table = tmp_path / "marks.csv"
    table.write_text("filled in")

    def fail() -> None:
        raise OSError("the disk is full")

    with pytest.raises(OSError, match="the disk is full"):
        keeping_former(table, fail)
    assert [(one.name, one.read_text()) for one in tmp_path.iterdir()] == [
        ("marks.csv", "filled in")
    ]


def test_who_interrupts_when_it_was_replaced_finds_both(tmp_path: Path) -> None:
    table = tmp_path / "marks.csv"
    table.write_text("filled in")

    def be_interrupted() -> None:
        table.write_text("blank")
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        keeping_former(table, be_interrupted)
    assert (tmp_path / "marks.before-1.csv").read_text() == "filled in"
