"""One word for one idea: no two classes of the program have one name."""

import ast
from collections import defaultdict
from pathlib import Path

SOURCES = Path(__file__).parents[1] / "src" / "gripcourse"

# Names that may stand for two things, each with the reason.
JUSTIFIED: dict[str, str] = {
    "Course": "the library's course is the course, with what can be done with it",
}


def places_of_classes() -> dict[str, list[str]]:
    places: dict[str, list[str]] = defaultdict(list)
    for path in sorted(SOURCES.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef):
                places[node.name].append(f"{path.relative_to(SOURCES)}:{node.lineno}")
    return places


def test_every_class_has_a_name_of_its_own() -> None:
    twice = {name: places for name, places in places_of_classes().items() if len(places) > 1}
    assert {name: twice[name] for name in twice.keys() - JUSTIFIED.keys()} == {}
    assert JUSTIFIED.keys() - twice.keys() == set()
