"""What stands for a column of a catalogue in a printed formula."""

import pytest

from gripcourse.course.column_symbols import column_symbols
from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.formula.plain import text
from gripcourse.formula.tree import Formula
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.words import LANGUAGES
from support.issued_table import issued_table


@pytest.fixture(scope="module")
def plans(course: Course) -> tuple[Plan, ...]:
    return tuple(make_plan(course, one.scheme, one.options) for one in issued_table(course))


def printed(plan: Plan, quantity: Quantity, formula: Formula, language: str) -> dict[str, str]:
    """What is printed for each column that a formula reads."""
    found = column_symbols(
        formula.tree, quantity, plan.quantities, plan.course.catalogues, language
    )
    return {column: text(box) for column, box in found.items()}


def of_all(plans: tuple[Plan, ...], language: str) -> dict[str, set[str]]:
    found: dict[str, set[str]] = {}
    for plan in plans:
        for quantity in plan.quantities.values():
            formula = plan.reference_formula(quantity.id)
            if formula is not None:
                for column, said in printed(plan, quantity, formula, language).items():
                    found.setdefault(column, set()).add(said)
    return found


class TestColumnWithoutASymbol:
    @pytest.mark.parametrize(
        ("language", "said"),
        [("en", "“II: [M_t]”"), ("ru", "«II: [M_кр]»"), ("uk", "«II: [M_кр]»")],
    )
    def test_it_is_called_as_above_the_table_on_the_sheet(
        self, plans: tuple[Plan, ...], language: str, said: str
    ) -> None:
        assert of_all(plans, language)["flange.square_torque"] == {said}

    @pytest.mark.parametrize("language", LANGUAGES)
    def test_nobody_reads_the_id_of_a_column(self, plans: tuple[Plan, ...], language: str) -> None:
        shown = of_all(plans, language)
        assert {"motion.radial", "flange_room.inner", "bore_pneumatic.least_stroke"} <= set(shown)
        for column, said in shown.items():
            assert column.partition(".")[2] not in said, column


class TestColumnOfAQuantity:
    def test_it_has_the_symbol_of_what_is_read_from_it(self, plans: tuple[Plan, ...]) -> None:
        assert of_all(plans, "ru")["trapezoidal_thread.pitch"] == {"p_р"}
