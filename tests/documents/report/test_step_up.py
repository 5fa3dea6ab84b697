"""What reports and the reference say of a choice that steps up."""

from pathlib import Path

import pytest

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.documents.reference.entry import entry_of
from gripcourse.documents.reference.model import EntryRule
from gripcourse.documents.reference.occurrence import content_of
from gripcourse.documents.report.worked import worked_line
from gripcourse.formula.plain import text
from gripcourse.solver.plan import make_plan
from gripcourse.text.words import Words

SPRINGS = Path(__file__).parents[2] / "support" / "spring_course"


@pytest.fixture(scope="module")
def springs() -> Course:
    return load_course(SPRINGS)


def test_its_line_names_the_condition_before_the_size(springs: Course) -> None:
    plan = make_plan(springs, "spring", {"wire": "bright"})
    box = worked_line(plan.quantities["wire"], {"wire_required": 1.5467}, 1.8, plan, Words("ru"))
    assert box is not None
    assert text(box) == "d ≥ d_тр = 1,5467 мм; τ ≤ [τ] → 1,8 мм"


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "the smallest entry, not below the required value, for which the condition holds"),
        (
            "ru",
            "наименьшее значение ряда не ниже потребного, при котором условие выполнено",
        ),
        (
            "uk",
            "найменше значення ряду, не нижче від потрібного, за якого умову виконано",
        ),
    ],
)
def test_the_reference_says_which_size_is_taken(springs: Course, language: str, said: str) -> None:
    content = content_of(springs, springs.schemes["spring"])
    [wire] = content.by_id["wire"]
    rule = entry_of(wire, content, Words(language)).rule
    assert isinstance(rule, EntryRule)
    assert rule.rounding == said
    assert rule.condition is not None
    assert text(rule.condition) == "τ ≤ [τ]"
