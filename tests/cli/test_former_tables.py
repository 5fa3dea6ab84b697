"""A table that somebody may have filled in is never lost to the same command once more."""

from pathlib import Path

from gripcourse.machine.resources import course_root
from support.command_line import call

TEMPLATE = ("variants", "template", "--rows", "2", "--out", "own.xlsx")


def test_a_table_to_fill_in_keeps_the_one_that_was_filled_in(tmp_path: Path) -> None:
    course = ("--course", str(course_root() / "examples" / "belt_drive"))
    own = tmp_path / "own.xlsx"
    first = call(tmp_path, *TEMPLATE, *course)
    assert (first.code, "before" in first.out) == (0, False)
    blank = own.read_bytes()
    own.write_bytes(b"filled in for two hours")
    again = call(tmp_path, *TEMPLATE, *course)
    assert again.code == 0
    assert "own.xlsx was there already and said something else: it is own.before-1.xlsx now." in (
        again.out
    )
    assert (tmp_path / "own.before-1.xlsx").read_bytes() == b"filled in for two hours"
    assert own.read_bytes() == blank


def test_drawing_and_importing_keep_the_table_that_was_there(tmp_path: Path) -> None:
    course = ("--course", str(course_root() / "examples" / "belt_drive"))
    table = tmp_path / "main.csv"
    draw = ("variants", "draw", "--count", "2", "--out", "main.csv", *course, "--seed")
    assert call(tmp_path, *draw, "1").code == 0
    first = table.read_bytes()
    assert call(tmp_path, *draw, "1").code == 0
    assert [one.name for one in tmp_path.iterdir()] == ["main.csv"]
    assert call(tmp_path, *draw, "2").code == 0
    assert (tmp_path / "main.before-1.csv").read_bytes() == first
    second = table.read_bytes()
    back = call(tmp_path, "variants", "import", "main.before-1.csv", "--out", "main.csv", *course)
    assert back.code == 0
    assert (tmp_path / "main.before-2.csv").read_bytes() == second
