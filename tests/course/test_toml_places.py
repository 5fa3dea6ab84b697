"""Every name of a TOML file is found where it stands: a parser finds the same ones."""

from collections.abc import Iterator
from pathlib import Path

import pytest
import tomli

from gripcourse.course.toml_places import KeyPath, key_places

BELTS = Path(__file__).parents[2] / "examples" / "belt_drive"
ODD = '''
"a b" . 'c' = 1  # a = 2
text = """
[no] = "x"
""" # ]
list = [ { x = "}" , y.z = [1, 2,], }, # {
  { x = '#' } ]
[[one]]
n = 1979-05-27 07:32:00
[one.two]
deep = {}
[[one]]
[[one.more]]
k = 1
[[one.more]]
k = -1.5e3
'''


def parsed(value: object, place: KeyPath = ()) -> Iterator[KeyPath]:
    """Yield the path of everything that has a name."""
    items = value.items() if isinstance(value, dict) else ()
    for name, inside in items:
        yield (*place, name)
        yield from parsed(inside, (*place, name))
    for number, inside in enumerate(value if isinstance(value, list) else ()):
        yield from parsed(inside, (*place, number))


def same(text: str) -> None:
    places = key_places(text)
    assert {one.path for one in places} == set(parsed(tomli.loads(text)))
    for one in places:
        assert text[slice(*one.span)].strip("\"'") == one.path[-1]
        if one.value is not None:
            tomli.loads(f"value = {text[slice(*one.value)]}")


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_names_are_found_in_every_way_of_writing(end: str) -> None:
    same(ODD.replace("\n", end))


def test_names_of_a_course_are_found() -> None:
    for path in sorted(BELTS.rglob("*.toml")):
        same(path.read_text(encoding="utf-8"))
