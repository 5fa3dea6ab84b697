"""A table that was judged once is believed as long as neither it nor its course has changed."""

import shutil
from pathlib import Path

import pytest

from gripcourse.errors import TableError
from gripcourse.variants import table as table_reading
from gripcourse.variants.kept_table import load_with_table

SMALL = Path(__file__).parent / "small_course"
HEADER = (
    "variant,scheme,fluid,mass [kg],acceleration [m/s**2],friction,pressure [MPa],teeth,"
    "form_factor,arm [mm],travel [mm],noise"
)


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A small course, and a cache that nobody has used."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    shutil.copytree(SMALL, tmp_path / "course")
    return tmp_path / "course"


def table_with(folder: Path, mass: str) -> Path:
    path = folder / "table.csv"
    path.write_text(f"{HEADER}\n1,press,oil,{mass},5,0.15,10,17,4.26,100,50,\n", encoding="utf-8")
    return path


def masses(root: Path, table: Path) -> list[float]:
    return [one.given["mass"] for one in load_with_table(root, table)[1]]


def test_a_sound_table_is_judged_once(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    table = table_with(tmp_path, "60")
    judged = load_with_table(root, table)
    monkeypatch.delattr(table_reading, "read_table")
    course, variants = load_with_table(root, table)
    assert variants == judged[1]
    assert course.id == judged[0].id


def test_a_changed_table_is_judged_anew(root: Path, tmp_path: Path) -> None:
    assert masses(root, table_with(tmp_path, "60")) == [60.0]
    assert masses(root, table_with(tmp_path, "70")) == [70.0]
    for _ in range(2):
        with pytest.raises(TableError):
            load_with_table(root, table_with(tmp_path, "-1"))
    assert masses(root, table_with(tmp_path, "60")) == [60.0]


def test_a_sound_table_of_a_changed_course_is_judged_anew(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    table = table_with(tmp_path, "60")
    load_with_table(root, table)
    part = root / "variants" / "catalogues" / "bore.csv"
    part.write_text(part.read_text(encoding="utf-8") + "# looked through\n", encoding="utf-8")
    monkeypatch.setattr(table_reading, "read_table", lambda *_: ("judged anew",))
    assert load_with_table(root, table)[1] == ("judged anew",)


def test_a_table_that_is_not_there_is_a_problem_of_the_table(root: Path, tmp_path: Path) -> None:
    with pytest.raises(TableError):
        load_with_table(root, tmp_path / "none.csv")
