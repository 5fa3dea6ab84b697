"""One file for a printer, asked for together with the assignments."""

import shutil
from pathlib import Path

from gripcourse.machine.resources import course_root
from support.command_line import call


def test_nobody_is_issued_anything_where_the_file_for_the_printer_cannot_be_written(
    tmp_path: Path,
) -> None:
    course = tmp_path / "course"
    shutil.copytree(course_root() / "examples" / "belt_drive", course)
    (tmp_path / "group.pdf").mkdir()
    (tmp_path / "roster.csv").write_text("student,name\ns1,Ann Lee\n", encoding="utf-8")
    asked = ("--roster", "roster.csv", "--course", "course", "--out", "out")
    done = call(tmp_path, "issue", *asked, "--print", "group.pdf")
    assert done.code == 2, done.err
    assert "group.pdf" in done.err
    assert not (tmp_path / "out").exists()
    assert not (course / "private").exists()
