"""What a part of a general view is made of: the parts list and the mass agree on it."""

from dataclasses import dataclass

from gripcourse.course.view import View, ViewPart
from gripcourse.drawing.view.numbers import Numbers
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
        strongest where none is: the bounds of allowed stresses leave out what none bears. Else
        what the part, or the view, names.
    """
    formulas = view.strength.get(part.piece_of or part.id, ())
    asked = [one for one in (numbers.number(each, "MPa") for each in formulas) if one]
    if not asked:
        return Made(part.material or view.material, part.density or view.density)
    enough = (one for one in view.grades if one.yield_stress >= max(asked) * _SAME)
    grade = next(enough, view.grades[-1])
    return Made(grade.material, grade.density)
