"""What holds of an outcome stands in one table, and the program asks nothing else of it."""

import ast
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path

import pytest

from gripcourse.cli.simulation_text import _SAID
from gripcourse.grading.outcome import Outcome, OutcomeTraits, outcome_named
from gripcourse.simulation.confusion import Said
from support.howto import blocks

REPOSITORY = Path(__file__).parents[2]
SOURCES = REPOSITORY / "src" / "gripcourse"


def compared(tree: ast.AST) -> Iterator[int]:
    """Yield the lines that compare with single outcomes, or gather them in a set or a mapping."""
    for node in ast.walk(tree):
        match node:
            case ast.Compare():
                parts = [node.left, *node.comparators]
            case ast.Set() | ast.List():
                parts = node.elts
            case ast.Dict():
                parts = [one for one in node.keys if one is not None]
            case ast.MatchValue():
                parts = [node.value]
            case _:
                continue
        if any(is_outcome(inner) for part in parts for inner in ast.walk(part)):
            yield node.lineno if isinstance(node, ast.expr | ast.pattern) else 0


def is_outcome(node: ast.AST) -> bool:
    is_member = isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)
    return is_member and node.value.id == "Outcome" and node.attr in Outcome.__members__


def test_nothing_but_the_table_asks_which_outcome_it_is() -> None:
    found = {
        f"{path.relative_to(SOURCES)}:{line}"
        for path in SOURCES.rglob("*.py")
        for line in compared(ast.parse(path.read_text(encoding="utf-8")))
    }
    assert found == set(), "ask for one of the traits in grading/outcome.py"


@pytest.mark.parametrize(
    "source",
    [
        "a is Outcome.WRONG",
        "a in {Outcome.WRONG, Outcome.SLIP}",
        "x = frozenset({Outcome.WRONG})",
        "x = {Outcome.WRONG: 1}",
        "match a:\n    case Outcome.WRONG:\n        pass",
    ],
)
def test_such_a_question_is_found(source: str) -> None:
    assert list(compared(ast.parse(source)))


def test_an_entry_cannot_leave_anything_open() -> None:
    with pytest.raises(TypeError, match="missing"):
        OutcomeTraits(sign="!")  # type: ignore[call-arg]
    assert all(one.default is one.default_factory for one in fields(OutcomeTraits))


def test_signs_and_words_tell_outcomes_apart() -> None:
    assert len({one.traits.sign for one in Outcome}) == len(Outcome)
    assert len({one.traits.word.text for one in Outcome}) == len(Outcome)
    assert len({one.traits.meaning.text for one in Outcome}) == len(Outcome)


@pytest.mark.parametrize("outcome", list(Outcome))
def test_what_holds_of_an_outcome_makes_sense(outcome: Outcome) -> None:
    traits = outcome.traits
    assert traits.right + traits.mistake + traits.missing + traits.waits + traits.withheld == 1
    assert traits.right or not (traits.equals_reference or traits.follows)
    assert traits.mistake or not traits.named
    assert traits.waits or not traits.by_rubric


def test_every_outcome_is_found_by_its_name_in_files() -> None:
    assert [outcome_named(one.value) for one in Outcome] == list(Outcome)
    with pytest.raises(ValueError, match="rihgt"):
        outcome_named("rihgt")


def test_style_sheets_know_every_class() -> None:
    sheet = (REPOSITORY / "templates" / "style" / "student.css").read_text(encoding="utf-8")
    plain = {"waiting"}  # what waits for a person is printed as the rest
    styles = {one.traits.style for one in Outcome} - plain
    assert styles == {one for one in styles if re.search(rf"^\.{one}\b", sheet, re.MULTILINE)}


def test_the_measured_grader_says_every_outcome_that_it_can_find() -> None:
    found = {one.value for one in Outcome if not (one.traits.named or one.traits.by_rubric)}
    assert found <= set(Said)
    assert set(Said) == set(_SAID)


def test_one_entry_adds_an_outcome_everywhere(tmp_path: Path) -> None:
    """The how-to followed in a copy: statistics, the gradebook's files and signs know the new."""
    entry, *_ = blocks("add-an-outcome.md", "python")
    shutil.copytree(SOURCES, tmp_path / "gripcourse", ignore=shutil.ignore_patterns("__pycache__"))
    module = tmp_path / "gripcourse" / "grading" / "outcome.py"
    text = module.read_text(encoding="utf-8")
    module.write_text(text.replace("    SLIP = (", f"{entry}    SLIP = (", 1), encoding="utf-8")
    asked = (
        "from gripcourse.documents.report.quantities import COUNTED\n"
        "from gripcourse.grading.outcome import Outcome, outcome_named\n"
        "print(*COUNTED, outcome_named('near').traits.sign)"
    )
    places = {**os.environ, "PYTHONPATH": str(tmp_path), "PYTHONIOENCODING": "utf-8"}
    run = subprocess.run([sys.executable, "-c", asked], env=places, capture_output=True, check=True)  # noqa: S603 (own words)
    names = [one.value for one in Outcome if one.traits.counted]
    names.insert(names.index("slip"), "near")
    assert run.stdout.decode().split() == [*names, "∼"]
