"""What nothing uses, and what nothing proves, is told of a course that is valid, with its place."""

import shutil
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.course_notes import course_notes
from gripcourse.usecases.authoring.validate import scheme_notes, validated

BELTS = Path(__file__).parents[3] / "examples" / "belt_drive"
TITLE = 'title = { en = "spare", ru = "запас", uk = "запас" }\n'
COURSE_TOML = f"""
[constant.spare_speed]
symbol = "spare_speed"
unit = "m/s"
bounds = [0.1, 10]
value = 1
source = {{ work = "textbook" }}
{TITLE}
[work.spare_book]
title = "spare_speed, spare_table.size"
[[note]]
schemes = ["v_belt"]
quantities = ["belt_width"]
text = {{ en = "Wide.", ru = "Широкий.", uk = "Широкий." }}
"""
ERRATUM = """[erratum.spare_fault]
work = "textbook"
printed = { en = "2", ru = "2", uk = "2" }
right = { en = "3", ru = "3", uk = "3" }
"""
RUBRIC = f'{TITLE}[[line]]\nid = "all"\nshare = 1\ntext = {{ en = "a", ru = "б", uk = "в" }}\n'
TABLE = """# source: nobody
# mark: nothing
# title: spare
# title.ru: запас
# title.uk: запас
size [mm]
1
2
"""
SPARE = {
    "grader/rubric/spare.toml": RUBRIC,
    "variants/catalogues/spare_table.csv": TABLE,
    "variants/drawing/spare.toml": '[length]\nspare = "belt_length"\n',
    "variants/diagram/spare.toml": "",
    "variants/errata.toml": ERRATUM,
}


def test_what_nothing_uses_is_told_with_file_and_key(tmp_path: Path) -> None:
    root = Path(shutil.copytree(BELTS, tmp_path / "course"))
    for name, text in SPARE.items():
        (root / name).write_text(text, encoding="utf-8")
    main = root / "variants" / "course.toml"
    main.write_text(main.read_text(encoding="utf-8") + COURSE_TOML, encoding="utf-8")
    found = validated(root)
    assert [one.say(Words("en")) for one in found.problems] == []
    assert {(one.file, one.key) for one in found.notes} == {
        ("grader/rubric/spare.toml", ""),
        ("variants/catalogues/spare_table.csv", ""),
        ("variants/drawing/spare.toml", ""),
        ("variants/diagram/spare.toml", ""),
        ("variants/errata.toml", "erratum.spare_fault"),
        ("variants/course.toml", "constant.spare_speed"),
        ("variants/course.toml", "work.spare_book"),
        ("variants/course.toml", "note[1].quantities"),
    }


def test_a_scheme_that_nothing_proves_is_told(tmp_path: Path) -> None:
    root = Path(shutil.copytree(BELTS, tmp_path / "course"))
    (root / "variants" / "schemes" / "flat_belt" / "worked_example.toml").unlink()
    (root / "variants" / "published_cases.toml").unlink()
    [note] = scheme_notes(root, "flat_belt")
    assert note.file == "variants/schemes/flat_belt/worked_example.toml"
    assert "nothing proves its formulas" in str(note.what)
    assert scheme_notes(root, "v_belt") == []


def test_our_courses_are_free_of_notes(course: Course) -> None:
    assert course_notes(course) == []
    assert validated(BELTS).notes == ()
