"""What formulas of a course may be made of, as Markdown: functions, signs, units."""

from collections.abc import Iterator, Mapping
from typing import Final

from gripcourse.formula.functions import FUNCTIONS
from gripcourse.text.units import unit_names

_USES: Final[Mapping[str, tuple[str, str]]] = {
    "sqrt": ("sqrt(x)", "Square root."),
    "cbrt": ("cbrt(x)", "Cube root."),
    "sin": ("sin(a)", "Sine; an angle is in radians inside formulas, whatever its unit is."),
    "cos": ("cos(a)", "Cosine."),
    "tan": ("tan(a)", "Tangent."),
    "asin": ("asin(x)", "Angle of a sine."),
    "acos": ("acos(x)", "Angle of a cosine."),
    "atan": ("atan(x)", "Angle of a tangent."),
    "abs": ("abs(x)", "Without its sign."),
    "exp": ("exp(x)", "Power of e."),
    "log": ("log(x)", "Natural logarithm; log(x)/log(10) is the decimal one."),
    "atan2": ("atan2(y, x)", "Direction of a point, from −180° to 180°."),
    "hypot": ("hypot(x, y)", "Root of the sum of two squares."),
    "min": ("min(x, y, …)", "The least of several."),
    "max": ("max(x, y, …)", "The greatest of several."),
    "exceeds": (
        "exceeds(x, y)",
        "1 where x is greater than y, else 0: what is added in one case only is multiplied by it.",
    ),
    "at_least": (
        'at_least("bolt.area", x)',
        "The size (first column of bolt.csv) of the first row whose `area` is not less than x.",
    ),
    "nearest": (
        'nearest("bolt.area", x)',
        "The size of the row whose `area` is nearest to x.",
    ),
    "lookup": (
        'lookup("bolt.area", size)',
        "The `area` in the row of that size; the size stands in the first column.",
    ),
    "interpolate": (
        'interpolate("factor.value", x)',
        "The value at x on the straight line between two rows; none outside the table.",
    ),
    "hertz_crossed": (
        "hertz_crossed(x)",
        "Coefficient of the contact of two crossed cylinders, of the ratio of their radii.",
    ),
}


def formula_lines() -> Iterator[str]:
    """Yield the lines of the chapter on formulas."""
    yield from ("", "## Formulas", "")
    yield (
        "Names are ids of quantities and constants of the course, and `pi`: Latin letters, digits "
        "and `_`, for a dash would be a minus sign. Signs: `+ - * /`, `**` for a power, brackets; "
        "a decimal point. A condition compares with `<= < >= > ==`, and several comparisons are "
        "joined by `and`; there is no `or` and no `if`: use `min`, `max`, `exceeds`, or two "
        "schemes."
    )
    yield ""
    yield (
        "All names enter in SI (m, N, Pa, rad, kg, s), so a bare number that has a unit is written "
        "with a constant, or the formula says `evaluated_in`. Both sides must have one dimension. "
        "What stands in `1 + x` is declared as a share, without a unit: 0.05, not 5 %. Nothing "
        "rounds: what is rounded to whole numbers or to a step is a choice with `multiple_of`."
    )
    yield from ("", "| function | what it gives |", "|---|---|")
    for name in FUNCTIONS:
        use, meaning = _USES[name]
        yield f"| `{use}` | {meaning} |"
    yield from ("", "### Units", "")
    named = ", ".join(f"`{one}`" for one in unit_names())
    yield (
        f"A unit is one of {named}, or made of them, without brackets: `N/mm`, `m/s**2`, "
        "`W/m**2/K`. An empty text is a plain number. A temperature is in `degC`, a difference of "
        "temperatures in `K`: inside formulas either counts kelvins, that in `degC` from 0 °C, so "
        "`outlet - inlet` is right as it stands, and `inlet + celsius_zero`, a constant of 273.15 "
        "K, counts from absolute zero."
    )
