"""A course of an earlier version is written as it is read today; comments and look stay."""

from pathlib import Path

import tomli

from gripcourse.usecases.authoring.renew import renewals, write_renewals

SCHEME = """# as it was
[kinematics]  # how it moves
  jaw   = "y"   # what falls
  jaws = "2"
drive = "x"
"""
RENEWED = """# as it was
[kinematics]  # how it moves
  output   = "y"   # what falls
  direction = "falls"
  outputs = "2"
drive = "x"
"""
DIAGRAM = """[[element]]
kind = "prism"
at = "P"

[[element]]
kind = "end_view"
at = "Q"  # where
count = 3
"""
DIAGRAM_RENEWED = """[[element]]
kind = "vee"
at = "P"

[[element]]
kind = "end_view"
count = 3
"""
DRAWING = 'uses = ["a"]\n[[part]]\nid = "b"\ndensity_per = "c"\nmirror = true\n'
EXAMPLE = "[guide]\n[guide.expected]\nforce = [1, 2]\n"
ATLAS = '[[row]]\nnumber = 1\nsize = { angle = "1" }\ndiameter = "2"\n'
FILES = {
    "variants/schemes/a/scheme.toml": (SCHEME, RENEWED),
    "variants/sections/b.toml": (
        'kinematics = { jaw = "y", drive = "x" }\n',
        'kinematics = { output = "y", direction = "falls", drive = "x" }\n',
    ),
    "variants/schemes/a/diagram.toml": (DIAGRAM, DIAGRAM_RENEWED),
    "variants/schemes/a/drawing.toml": (
        DRAWING,
        'behind = ["a"]\n[[part]]\nid = "b"\nmirror = true\n',
    ),
    "variants/schemes/a/worked_example.toml": (EXAMPLE, EXAMPLE.replace("guide", "as_printed")),
    "variants/schemes/b/scheme.toml": ('parts = ["b"]\n', 'parts = ["b"]\n'),
    # Both ways of writing in one row: no parser would read it if it were renamed word by word.
    "variants/atlas/c.toml": (ATLAS, ATLAS),
}


def written(root: Path, end: str) -> Path:
    for name, (before, _) in FILES.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(before.replace("\n", end).encode())
    return root


def test_what_is_called_otherwise_is_renamed_and_all_else_stays(tmp_path: Path) -> None:
    root = written(tmp_path, "\n")
    found = renewals(root).files
    assert {one.file for one in found} == {
        name for name, (before, after) in FILES.items() if before != after
    }
    copies = write_renewals(root, found)
    for name, (_, after) in FILES.items():
        assert (root / name).read_text(encoding="utf-8") == after
    assert len(copies) == len(found)
    assert (root / "variants/schemes/a/scheme.toml.former").read_text(encoding="utf-8") == SCHEME
    assert renewals(root).files == ()


def test_a_file_that_cannot_be_renamed_word_by_word_is_named(tmp_path: Path) -> None:
    assert renewals(written(tmp_path, "\n")).by_hand == ("variants/atlas/c.toml",)


def test_a_second_renewal_keeps_the_first_copy(tmp_path: Path) -> None:
    root = written(tmp_path, "\n")
    write_renewals(root, renewals(root).files)
    (root / "variants/schemes/a/scheme.toml").write_text(SCHEME, encoding="utf-8")
    [copy] = write_renewals(root, renewals(root).files)
    assert copy.name == "scheme.toml.former1"


def test_lines_of_another_system_mean_the_same(tmp_path: Path) -> None:
    root = written(tmp_path, "\r\n")
    for one in renewals(root).files:
        assert tomli.loads(one.text) == tomli.loads(FILES[one.file][1])
