"""What a part of a general view is made of: the parts list and the mass agree on it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.view import Grade, View, ViewPart
from gripcourse.drawing.view.numbers import Numbers
from gripcourse.formula.tree import Formula
from gripcourse.text.words import Texts

_SAME = 1 - 1e-9  # of stresses that are declared as a share of the yield stress


@dataclass(frozen=True, slots=True)
class Made:
    """What a part is made of: as the parts list names it, None for nothing; and kg/m³."""

    material: Texts | None
    density: float


def made_of(part: ViewPart, view: View, numbers: Numbers) -> Made:
    """Choose the material of a part.

    Args:
        part: of the view.
        view: whose grades, the weakest first, its strength is looked for in.
        numbers: of the variant.

    Returns:
        The first grade that is strong enough for a part that asks for a strength, and the
        strongest where none is: the bounds of allowed stresses leave out what none bears. Of a
        part that was calculated with an elastic modulus only the grades nearest to it count. Else
        what the part, or the view, names.
    """
    asked = _stresses(part, view.strength, numbers)
    if not asked:
        return Made(part.material or view.material, part.density or view.density)
    grades = _as_stiff(view.grades, _stresses(part, view.elastic_modulus, numbers))
    enough = (one for one in grades if one.yield_stress >= max(asked) * _SAME)
    grade = next(enough, grades[-1])
    return Made(grade.material, grade.density)


def _stresses(
    part: ViewPart, declared: Mapping[str, Sequence[Formula]], numbers: Numbers
) -> list[float]:
    """Return what is declared for a part, MPa: of several formulas those that have a value."""
    formulas = declared.get(part.piece_of or part.id, ())
    return [one for one in (numbers.number(each, "MPa") for each in formulas) if one]


def _as_stiff(grades: Sequence[Grade], moduli: Sequence[float]) -> Sequence[Grade]:
    """Return the grades whose elastic modulus is nearest to the first of some, all for none."""
    told = {one.elastic_modulus for one in grades if one.elastic_modulus > 0}
    if not moduli or moduli[0] <= 0 or not told:
        return grades
    nearest = min(told, key=lambda one: (abs(math.log(one / moduli[0])), one))
    return [one for one in grades if one.elastic_modulus == nearest]
