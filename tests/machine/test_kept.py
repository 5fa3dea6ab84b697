import os
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.errors import CourseError
from gripcourse.machine.kept import digest_of, keep, read_kept, read_value, write_value


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "gripcourse"


def test_what_was_kept_comes_back_and_nothing_else() -> None:
    keep("a", {"mass": 60.0})
    assert read_kept("a") == {"mass": 60.0}
    assert read_kept("b") is None


def test_the_digest_changes_with_a_name_a_content_and_a_cut_between_files(tmp_path: Path) -> None:
    def digest(**files: str) -> str:
        folder = tmp_path / "-".join(f"{name}{text}" for name, text in files.items())
        folder.mkdir()
        for name, text in files.items():
            (folder / name).write_text(text)
        return digest_of(folder, folder.iterdir())

    found = [digest(a="1", b="2"), digest(a="1", c="2"), digest(a="12", b=""), digest(a="1", b="3")]
    assert len(set(found)) == len(found)


def test_a_damaged_file_counts_as_not_kept(cache: Path) -> None:
    keep("a", 1)
    [path] = cache.iterdir()
    path.write_bytes(path.read_bytes()[:-3])
    assert read_kept("a") is None


def test_a_file_that_others_may_write_is_not_believed(cache: Path) -> None:
    keep("a", 1)
    [path] = cache.iterdir()
    path.chmod(0o666)
    assert read_kept("a") is None


def test_a_kept_file_is_its_owners_alone(cache: Path) -> None:
    keep("a", 1)
    [path] = cache.iterdir()
    assert path.stat().st_mode & 0o077 == 0
    assert cache.stat().st_mode & 0o077 == 0


def test_only_the_latest_stay(cache: Path) -> None:
    for number in range(40):
        keep(str(number), number)
        os.utime(cache / f"{number}.kept", (number, number))
    assert sorted(int(path.stem) for path in cache.iterdir()) == list(range(8, 40))


@pytest.mark.parametrize("place", ["relative/folder", ""])
def test_a_machine_without_a_place_keeps_nothing(
    place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", place)
    monkeypatch.delenv("HOME", raising=False)
    keep("a", 1)
    assert read_kept("a") is None


SMALL = Path(__file__).parents[1] / "variants" / "small_course"


def copy_of_small_course(folder: Path) -> Path:
    for path in SMALL.rglob("*"):
        if path.is_file():
            target = folder / path.relative_to(SMALL)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(path.read_bytes())
    return folder


def test_a_kept_course_is_the_course_as_it_is_now(tmp_path: Path, cache: Path) -> None:
    root = copy_of_small_course(tmp_path / "course")
    path = root / "variants" / "course.toml"
    text = path.read_text(encoding="utf-8")
    before = load_course(root).title.of("en")
    for title in ("A title of its own", "Another title", "A title of its own"):
        path.write_text(text.replace(before, title), encoding="utf-8")
        assert load_course(root).title.of("en") == title
    assert len(list(cache.glob("*.kept"))) >= 2


def test_a_fault_is_found_after_the_sound_course_was_kept(tmp_path: Path) -> None:
    root = copy_of_small_course(tmp_path / "course")
    load_course(root)
    (root / "variants" / "course.toml").write_text("id =", encoding="utf-8")
    with pytest.raises(CourseError):
        load_course(root)


def test_a_course_in_another_place_knows_its_own_place(tmp_path: Path) -> None:
    one = copy_of_small_course(tmp_path / "one")
    other = copy_of_small_course(tmp_path / "other")
    assert load_course(one).root == one
    assert load_course(other).root == other


def test_a_course_that_stayed_as_it_was_is_the_same_to_who_loads_it_again(tmp_path: Path) -> None:
    root = copy_of_small_course(tmp_path / "course")
    load_course(root)
    again = load_course(root)
    assert load_course(root) is again
    path = root / "variants" / "course.toml"
    path.write_text(f"{path.read_text(encoding='utf-8')}\n#\n", encoding="utf-8")
    assert load_course(root) is not again


def test_a_value_is_written_for_its_owner_and_only_believed_whole(tmp_path: Path) -> None:
    path = tmp_path / "kept" / "one.kept"
    assert read_value(path) is None
    write_value(path, ("mass", 60.0))
    assert read_value(path) == ("mass", 60.0)
    assert path.stat().st_mode & 0o077 == path.parent.stat().st_mode & 0o077 == 0
    path.parent.chmod(0o777)
    assert read_value(path) is None


@dataclass(frozen=True, slots=True)
class Plain:
    name: str
    sizes: tuple[float, ...] = ()
    below: "Plain | None" = None


@dataclass(frozen=True, slots=True)
class Counted:
    """What more than its fields makes: it must not be made again by them."""

    name: str
    length: int = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "length", len(self.name))


@dataclass(slots=True)
class Changed:
    name: str


@pytest.mark.parametrize(
    "value",
    [
        Plain("rod", (1.0, 2.0), Plain("pin")),
        Counted("rod"),
        Changed("rod"),
        {"a": [Plain("rod"), Counted("pin")]},
        (Plain, Counted),
    ],
)
def test_a_value_comes_back_as_it_was(tmp_path: Path, value: object) -> None:
    path = tmp_path / "private" / "value"
    write_value(path, value)
    assert read_value(path) == value
