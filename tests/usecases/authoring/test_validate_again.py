"""What `validate` says with what earlier runs kept is what it says without it, to the letter."""

import shutil
from pathlib import Path

import pytest

from support.changed_course import Change, random_changes, said_with

COURSE = Path(__file__).parents[3] / "examples" / "belt_drive"
SCHEMES = ("v_belt",)


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return Path(shutil.copytree(COURSE, tmp_path_factory.mktemp("changed") / "course"))


@pytest.fixture(scope="module")
def warm(root: Path) -> Path:
    """What runs keep: the first one is of the course as it is."""
    cache = root.parent / "warm"
    assert said_with(cache, root, SCHEMES) == ""
    return cache


# Templates are not changed.
@pytest.mark.usefixtures("same_templates")
@pytest.mark.parametrize("change", random_changes(COURSE, 8, 11), ids=lambda one: one.kind)
def test_a_change_by_chance(change: Change, root: Path, warm: Path, tmp_path: Path) -> None:
    change.make(root)
    said = [said_with(cache, root, SCHEMES) for cache in (warm, warm, tmp_path / "cold")]
    change.undo(root)
    assert said[0] == said[1] == said[2]


def test_a_changed_factor_is_found_each_time_and_its_mending_too(root: Path, warm: Path) -> None:
    path = root / "variants" / "sections" / "open_belt.toml"
    right = path.read_text(encoding="utf-8")
    wrong = right.replace("2*centre_distance", "3*centre_distance", 1)
    assert wrong != right
    said = []
    for text in (wrong, right, wrong, right):
        path.write_text(text, encoding="utf-8")
        said.append(said_with(warm, root, SCHEMES))
    assert said[0]
    assert said == [said[0], "", said[0], ""]
