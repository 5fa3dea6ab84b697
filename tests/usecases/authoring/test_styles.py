"""Style sheets of a course judged on this machine."""

import shutil
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.usecases.authoring.styles import style_problems


def test_a_font_of_formulas_without_greek_letters_is_named_with_file_and_line(
    course: Course, tmp_path: Path
) -> None:
    templates = tmp_path / "templates"
    shutil.copytree(course.root / "templates", templates)
    sheet = templates / "style" / "formula.css"
    style = sheet.read_text(encoding="utf-8")
    sheet.write_text(style.replace("Liberation Serif", "PT Serif", 1), encoding="utf-8")
    (problem,) = style_problems(templates)
    line = style.partition("Liberation Serif")[0].count("\n") + 1
    assert (problem.file, problem.key) == ("templates/style/formula.css", f"line {line}")
    assert "PT Serif" in str(problem.what)
    assert "Greek" in str(problem.what)
