"""What an author is told of a choice that cannot step up."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.errors import CourseError, Problem

SPRINGS = Path(__file__).parents[1] / "support" / "spring_course"
SCHEME = Path("variants") / "schemes" / "spring" / "scheme.toml"
Edit = tuple[str, str]
CONDITION = 'condition = "stress <= stress_allowed"'
SLEEVE = 'at_least = "(index + 1)*wire"'
WAITING_SLEEVE = """at_least = "10*wire_required"
condition = "sleeve >= (index + 1)*wire"
step_up = true"""


@pytest.fixture
def problem_with(tmp_path: Path) -> Callable[..., Problem]:
    """Return the only problem of the spring course with these edits of its scheme."""

    def problem(*edits: Edit) -> Problem:
        root = tmp_path / "course"
        shutil.copytree(SPRINGS, root)
        text = (root / SCHEME).read_text(encoding="utf-8")
        for old, new in edits:
            assert text.count(old) == 1
            text = text.replace(old, new)
        (root / SCHEME).write_text(text, encoding="utf-8")
        with pytest.raises(CourseError) as raised:
            load_course(root)
        [found] = raised.value.problems
        return found

    return problem


@pytest.mark.parametrize(
    ("edits", "key", "what", "remedy"),
    [
        (
            [(f"{CONDITION}\n", "")],
            "quantity.wire.step_up",
            "There is no condition to step up by.",
            "Write the condition that the size must satisfy",
        ),
        (
            [("step_up = true", 'step_up = true\nrounding = "nearest"')],
            "quantity.wire.step_up",
            "The nearest size does not step up.",
            "Leave rounding out",
        ),
        (
            [(CONDITION, 'condition = "index <= 10"')],
            "quantity.wire.condition",
            "The condition does not depend on the size: no larger one would satisfy it.",
            "Write a condition on the size",
        ),
        (
            [
                (SLEEVE, f'{SLEEVE}\ncondition = "sleeve >= 8*wire"\nstep_up = true'),
                (CONDITION, 'condition = "sleeve <= 10*wire_required"'),
            ],
            "quantity.wire.condition",
            "The condition depends on 'sleeve', which steps up itself and by this size.",
            "Let one of the two step up.",
        ),
        (
            [
                (SLEEVE, WAITING_SLEEVE),
                (CONDITION, 'condition = "index*wire >= sleeve/2"'),
            ],
            "quantity.sleeve.condition",
            "To step up by the condition, a size needs what depends on it: sleeve → wire → sleeve.",
            "Write a condition that needs no such value.",
        ),
    ],
    ids=["no condition", "nearest", "no size in it", "one inside the other", "in a circle"],
)
def test_each_is_one_problem_with_its_place_and_remedy(
    problem_with: Callable[..., Problem], edits: list[Edit], key: str, what: str, remedy: str
) -> None:
    problem = problem_with(*edits)
    assert (problem.file, str(problem.key)) == (SCHEME.as_posix(), key)
    assert str(problem.what) == what
    assert remedy in str(problem.remedy)


def test_another_sort_of_value_is_told(problem_with: Callable[..., Problem]) -> None:
    problem = problem_with(("step_up = true", 'step_up = "yes"'))
    assert str(problem.key) == "quantity.wire.step_up"
