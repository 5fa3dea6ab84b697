"""A shared option is listed by a scheme, and has each choice once."""

import shutil
from pathlib import Path

from gripcourse.course.read import read_course
from gripcourse.machine.resources import skeleton_root

_BELTS = Path(__file__).parents[2] / "examples" / "belt_drive"
_OIL = """
id = "oil"
title = "oil"
[[choice]]
id = "thick"
title = "thick"
parts = []
"""


def test_an_option_that_no_scheme_lists_is_named(tmp_path: Path) -> None:
    root = Path(shutil.copytree(skeleton_root(), tmp_path / "course"))
    (root / "variants" / "options").mkdir()
    (root / "variants" / "options" / "oil.toml").write_text(_OIL, encoding="utf-8")
    course, problems = read_course(root)
    assert course is not None
    assert [(one.file, str(one.what)) for one in problems] == [
        ("variants/options/oil.toml", "No scheme lists this option.")
    ]


def test_an_option_is_not_called_spare_while_a_scheme_cannot_be_read(tmp_path: Path) -> None:
    root = Path(shutil.copytree(skeleton_root(), tmp_path / "course"))
    (root / "variants" / "options").mkdir()
    (root / "variants" / "options" / "oil.toml").write_text(_OIL, encoding="utf-8")
    (root / "variants" / "schemes" / "rod" / "scheme.toml").write_text("id =", encoding="utf-8")
    _, problems = read_course(root)
    assert {one.file for one in problems} == {"variants/schemes/rod/scheme.toml"}


def test_two_choices_with_one_id_are_named(tmp_path: Path) -> None:
    root = Path(shutil.copytree(skeleton_root(), tmp_path / "course"))
    (root / "variants" / "options").mkdir()
    twice = _OIL + _OIL[_OIL.index("[[choice]]") :]
    (root / "variants" / "options" / "oil.toml").write_text(twice, encoding="utf-8")
    _, problems = read_course(root)
    assert "Two choices have the id 'thick'." in {str(one.what) for one in problems}


def test_an_option_without_choices_is_all_that_is_said(tmp_path: Path) -> None:
    root = Path(shutil.copytree(_BELTS, tmp_path / "course"))
    file = root / "variants" / "options" / "tensioning.toml"
    written = file.read_text(encoding="utf-8")
    file.write_text(written[: written.index("[[choice]]")], encoding="utf-8")
    _, problems = read_course(root)
    assert [(one.file, one.key, str(one.what)) for one in problems] == [
        ("variants/options/tensioning.toml", "choice", "The option has no choices.")
    ]
