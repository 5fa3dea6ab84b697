"""A student's arithmetic, which shares nothing with the engine, solves what the course issues.

`benchmarks/by_hand.py` does so with more variants of every scheme, and with every mistake.
"""

import ast
import importlib
from pathlib import Path
from types import ModuleType

import pytest

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"
SEED = 314159


@pytest.fixture
def by_hand(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(BENCHMARKS)
    return importlib.import_module("by_hand")


@pytest.mark.parametrize("scheme", ["screw", "prism_lever", "wedge_roller_3", "electromagnet"])
def test_every_answer_of_a_solution_by_hand_is_paid_in_full(
    by_hand: ModuleType, tmp_path: Path, scheme: str
) -> None:
    (handout,) = by_hand.issue(scheme, 1, SEED, tmp_path)
    found = by_hand.hand_in(handout, by_hand.solve(handout), tmp_path)
    assert {one.quantity for one in found} == handout.sheet.asked
    assert [one.quantity for one in found if by_hand.paid(one) != "right"] == []


@pytest.mark.parametrize(
    ("scheme", "what"),
    [
        ("screw", "one end of the slide rubs"),
        ("tangent_slider", "arcsine for the arctangent of the slot"),
        ("slot_crosshead", "sine of the drive arm left out"),
        ("vacuum_cups", "hose left out of the volume"),
        ("slot_lever", "slot's force divided by the cosine"),
        ("plain_lever", "whole drive force on the pivot"),
        ("rack_parallelogram", "arctangent for the arcsine"),
        ("pinion_racks", "turn in revolutions"),
        ("wedge_slide", "friction left out of the ratio"),
        ("cross_cylinder", "arms turned over in the ratio"),
    ],
)
def test_one_mistake_carried_on_is_charged_once_and_named(
    by_hand: ModuleType, tmp_path: Path, scheme: str, what: str
) -> None:
    (handout,) = by_hand.issue(scheme, 1, SEED, tmp_path)
    made = next(one for one in by_hand.mistakes_of(scheme) if one.what == what)
    notebook = by_hand.mistaken(handout, made, by_hand.solve(handout))
    assert notebook is not None
    found = by_hand.hand_in(handout, notebook, tmp_path)
    (charged,) = (one for one in found if by_hand.paid(one) != "right")
    assert charged.quantity in made.steps
    assert charged.slip is not None


def test_the_arithmetic_takes_nothing_from_the_course_or_its_engine() -> None:
    allowed = {"bisect", "collections", "dataclasses", "hand", "math", "openpyxl", "pathlib"}
    files = sorted((BENCHMARKS / "hand").glob("*.py"))
    assert files
    for file in files:
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Import):
                named = {one.name.split(".")[0] for one in node.names}
            elif isinstance(node, ast.ImportFrom):
                named = {(node.module or "").split(".")[0]}
            else:
                continue
            assert named <= {*allowed, "typing"}, file.name
