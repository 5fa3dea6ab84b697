"""The engine does not know that it grips: words of the course stand in the course alone.

Looked for in names, texts and comments of the engine, in the templates, and in the sentences that
are translated. What a course declares (ids of quantities, schemes, sections, parts, options,
catalogues, works) is looked for as well, where it is more than a plain word.
"""

import re
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import pytest

from gripcourse.course.model import Course

REPOSITORY = Path(__file__).parents[1]
ENGINE = REPOSITORY / "src" / "gripcourse"
TEMPLATES = REPOSITORY / "templates"
# What the first courses were written with, when the program knew one subject: kept to be told.
FORMER = ENGINE / "course" / "former.py"

# Stems of the subject; a word of the engine that begins with one is a fault.
STEMS = (
    *("grip", "jaw", "finger", "cylinder", "piston", "bore", "pneumat", "hydraul", "ejector"),
    *(
        "vacuum",
        "suction",
        "clamp",
        "workpiece",
        "robot",
        "prism",
        "rack",
        "misprint_of",
        "lifting",
    ),
    *("parallelogram", "crosshead", "electromagnet", "bayonet", "flange", "guide"),
    *("захват", "захоп", "схват", "губк", "губок", "зажим", "затиск", "присос", "поршн", "пособи"),
)
# Why a word may stand in the engine after all: by the word, where, and the reason.
ALLOWED = {
    "fingerprint": "of a file",
    "fingerprints": "as above",
    "cylinder": "a symbol of GOST 2.780, and the shape",
    "cylinders": "the shape, in Hertz's theory of contact",
    "piston": "a part of that symbol",
    "rack": "a symbol of GOST 2.770",
    "guide": "a symbol of GOST 2.770; a text that leads a reader",
    "guided": "the verb",
    "guides": "as above",
}
# What a course asks for and the engine draws: the word is the same.
KINDS_OF_DOCUMENT = {"kinematic_diagram", "general_view"}
# What free bodies do to each other in any mechanism; a course may call a number so.
STATICS = {"friction_angle", "pressure_angle"}
WORD = re.compile(r"[^\W\d_]+")
# Names that are not read as words.
_NAMES = re.compile(r"gripcourse|floating_cylinder", re.IGNORECASE)


def words_of(text: str) -> Iterator[str]:
    return (word.lower() for word in WORD.findall(_NAMES.sub("", text)))


@cache
def lines() -> Mapping[str, tuple[str, ...]]:
    """Every line of the engine once, with all places where it stands."""
    sources, looks = ENGINE.rglob("*.py"), TEMPLATES.rglob("*")
    files = [*sources, *looks, *(ENGINE / "locale").glob("*.po"), *ENGINE.rglob("*.toml")]
    found: dict[str, list[str]] = {}
    for path in sorted(one for one in files if one.is_file() and one != FORMER):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            found.setdefault(line, []).append(f"{path.relative_to(REPOSITORY)}:{number}")
    return {line: tuple(places) for line, places in found.items()}


def test_the_engine_has_no_word_of_the_subject() -> None:
    found = [
        f"{place}: {word}"
        for line, places in lines().items()
        for word in words_of(line)
        if word.startswith(STEMS) and word not in ALLOWED
        for place in places
    ]
    assert found == []


@pytest.fixture(scope="module")
def declared(course: Course) -> set[str]:
    """The ids of the course that are more than one plain word."""
    ids = {
        *course.schemes,
        *course.parts,
        *course.catalogues,
        *course.constants,
        *(name for part in course.parts.values() for name in part.quantities),
        *(name for scheme in course.schemes.values() for name in scheme.quantities),
        *(option.id for scheme in course.schemes.values() for option in scheme.options),
    }
    return {one for one in ids if "_" in one}


def test_the_engine_names_nothing_that_the_course_declares(declared: set[str]) -> None:
    name = re.compile(r"[a-z][a-z0-9]*(?:_[a-z0-9]+)+")
    found = [
        f"{place}: {one}"
        for line, places in lines().items()
        for one in name.findall(line)
        if one in declared and one not in KINDS_OF_DOCUMENT | STATICS
        for place in places
    ]
    assert found == []
