"""A student who has nothing but paper: the sheet, the printed series, a list of equations.

What is given and asked is read from the sheet as it is printed, with its units; sizes are taken by
the rule that stands beside them, verdicts by the condition that they print. All else comes from
`paper/*.toml`: equations in the symbols of the sheet, written by number from the guide or from
statics and geometry, without a look at the formulas that the course declares.
"""

import csv
import itertools
import math
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from gripcourse.documents.assignment_sheet import SheetDatum, SheetItem

EQUATIONS: Final = Path(__file__).parent / "paper"
CATALOGUES: Final = Path(__file__).parents[2] / "variants" / "catalogues"
BOOK: Final = Path(__file__).parent / "paper"  # tables of works that students have, as printed
# What printed units are in SI.
UNITS: Final = {
    "": 1.0, "mm": 1e-3, "m": 1.0, "µm": 1e-6, "um": 1e-6, "mm²": 1e-6, "mm**2": 1e-6, "m²": 1.0,
    "cm²": 1e-4, "cm³": 1e-6, "l": 1e-3, "N": 1.0, "kN": 1e3, "N·m": 1.0, "N*m": 1.0, "MPa": 1e6,
    "kPa": 1e3, "kg": 1.0, "kg/m³": 1.0, "kg·m²": 1.0, "s": 1.0, "m/s": 1.0, "mm/s": 1e-3,
    "m/s²": 1.0, "m/s**2": 1.0, "°": math.pi / 180, "deg": math.pi / 180, "rad/s²": 1.0,
    "rad/s": 1.0, "l/min": 1e-3 / 60, "rpm": 2 * math.pi / 60, "W": 1.0, "kW": 1e3, "%": 0.01,
    "V": 1.0, "A": 1.0, "Ω": 1.0, "T": 1.0, "K": 1.0, "A/mm²": 1e6, "Ω·mm²/m": 1e-6,
    "W/(m²·K)": 1.0, "N/A²": 1.0,
}  # fmt: skip
# What a sheet calls a series, and the table that it is.
SERIES: Final = {
    "GOST 6540-68; row 1": "bore_hydraulic", "rods by GOST 6540-68": "rod_hydraulic",
    "ISO 6432 up to 25 mm": "bore_pneumatic", "strokes of cylinders": "cylinder_stroke",
    "GOST 9650-80": "pin", "row Ra20": "linear_ra20", "row Ra40": "linear_ra40",
    "row Ra10": "linear_ra10", "GOST 9563-60; row 1": "module", "round cups": "cup",
    "ejectors": "ejector", "vacuum hoses": "vacuum_hose", "vacuum switch": "vacuum_setting",
    "winding wire": "winding_wire", "GOST 8032-84": "preferred_r40", "GOST 12139": "motor_power",
    "GOST 2144-76": "worm_module", "whole numbers": "ejector_count",
}  # fmt: skip
_NUMBER: Final = re.compile(r"([−-]?\d[\d\s]*(?:\.\d+)?)(?:·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?(.*)")
# Where a symbol ends: `D_0²` is a square, `l_Fe,act` another symbol than `l_Fe`.
_END: Final = r"(?![0-9A-Za-zΑ-ωА-я_′']|,[A-Za-z]{2})"
_RAISED: Final = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_RULE: Final = re.compile(r"(?:any size|one of the first \d+ sizes|the first size) not below (.+)")
_SIGNS: Final = str.maketrans({";": ",", "·": "*", "−": "-", "√": "sqrt", "∛": "cbrt", "≤": "<=",
                               "≥": ">=", "²": "**2", "π": "pi"})  # fmt: skip


_FUNCTIONS: Final = {
    "max": max, "min": min, "abs": abs,
    **{name: getattr(math, name) for name in (
        "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "cbrt", "hypot", "log", "pi"
    )},
}  # fmt: skip


class NotOnPaperError(Exception):
    """Something is asked that neither the sheet nor the list of equations tells."""


@dataclass(frozen=True, slots=True)
class Table:
    """A printed table: columns in SI by name, the sizes first."""

    columns: Mapping[str, Sequence[float]]

    @property
    def sizes(self) -> Sequence[float]:
        return next(iter(self.columns.values()))


def read_table(name: str) -> Table:
    """Read a table as the appendix prints it, or a work that students have."""
    printed = (folder / f"{name}.csv" for folder in (CATALOGUES, BOOK))
    path = next(one for one in printed if one.exists())
    lines = path.read_text(encoding="utf-8").splitlines()
    header, *rows = csv.reader(one for one in lines if one and not one.startswith("#"))
    columns = {}
    for number, heading in enumerate(header):
        title, _, unit = heading.partition(" [")
        size = UNITS[unit.rstrip("]")]
        columns[title] = [float(row[number]) * size for row in rows]
    return Table(columns)


@dataclass(slots=True)
class Paper:
    """What the student knows so far: numbers in SI by printed symbol."""

    known: dict[str, float]
    pattern: re.Pattern[str]
    tables: dict[str, Table] = field(default_factory=dict)
    codes: dict[str, tuple[str, dict[str, str]]] = field(default_factory=dict)

    def table(self, name: str) -> Table:
        if name not in self.tables:
            self.tables[name] = read_table(name)
        return self.tables[name]

    def first(self, table: str, column: str, needed: float) -> float:
        """Return the first size whose entry in a column is not below what is needed."""
        read = self.table(table)
        entries = zip(read.sizes, read.columns[column], strict=True)
        return next((size for size, one in entries if one >= needed * (1 - 1e-9)), math.nan)

    def read(self, table: str, column: str, size: float) -> float:
        """Return the entry of a column at a size."""
        read = self.table(table)
        entries = zip(read.sizes, read.columns[column], strict=True)
        return next(one for row, one in entries if math.isclose(row, size, rel_tol=1e-6))

    def between(self, table: str, column: str, size: float) -> float:
        """Return the entry of a column on a straight line between two rows."""
        read = self.table(table)
        rows = list(zip(read.sizes, read.columns[column], strict=True))
        (x_1, y_1), (x_2, y_2) = next(
            (pair for pair in itertools.pairwise(rows) if size <= pair[1][0]), rows[-2:]
        )
        return y_1 + (y_2 - y_1) * (size - x_1) / (x_2 - x_1)

    def value(self, expression: str) -> float:
        """Evaluate an expression in printed symbols; KeyError for one that is not known yet."""
        if expression not in self.codes:
            used: dict[str, str] = {}
            code = self.pattern.sub(
                lambda found: used.setdefault(found[0], f"_{len(used)}"), expression
            )
            self.codes[expression] = code.translate(_SIGNS), used
        code, used = self.codes[expression]
        names = {place: self.known[symbol] for symbol, place in used.items()}
        tables = {"first": self.first, "read": self.read, "between": self.between}
        # The expressions are ours, or the sheet's.
        return float(eval(code, {"__builtins__": {}}, {**_FUNCTIONS, **tables, **names}))  # noqa: S307


@dataclass(frozen=True, slots=True)
class Asked:
    """An item of the sheet, taken apart.

    Attributes:
        symbol: as printed.
        unit: as printed; empty for a plain number.
        beside: what stands beside it.
        is_verdict: whether yes or no is asked.
    """

    symbol: str
    unit: str
    beside: str
    is_verdict: bool


def read_item(item: SheetItem) -> Asked:
    """Take an item apart: name, unit and what decides it are one text."""
    # The tables are read by the name of the series; their numbers are for a person's eye.
    head, _, beside = re.sub(r"\s*\[app\.[^\]]*\]", "", item.text).partition("; ")
    parts = [re.sub(r"\s", " ", one.strip()) for one in head.split(",")]
    unit = next((one for one in reversed(parts[1:]) if one in UNITS), "")
    return Asked(item.symbol, unit, beside, "(yes or no)" in head)


def read_given(datum: SheetDatum) -> float:
    """Read a printed number with its unit into SI."""
    found = _NUMBER.fullmatch(datum.value)
    if found is None:
        raise NotOnPaperError(datum.symbol, datum.value)
    digits = re.sub(r"\s", "", found[1]).replace("−", "-")
    power = int(found[2].translate(_RAISED)) if found[2] else 0
    unit = (datum.unit or found[3]).strip()
    return float(digits) * 10.0**power * UNITS[unit]


def equations_of(names: Sequence[str]) -> dict[str, tuple[str, str]]:
    """Return by symbol the citation and the expression of what a gripper is composed of.

    Args:
        names: of its parts and of its scheme; a group `a+b` counts where both are there. What comes
            later goes before, and what needs two before what needs one.
    """
    written: dict[str, dict[str, str | list[str]]] = {}
    for path in sorted(EQUATIONS.glob("*.toml")):
        written |= tomllib.loads(path.read_text(encoding="utf-8"))
    both = [one for one in written if "+" in one and {*one.split("+")} <= {*names}]
    found: dict[str, tuple[str, str]] = {}
    for group in (*names, *both):
        for symbol, said in written.get(group, {}).items():
            cited, expression = said if isinstance(said, list) else ("", said)
            found[symbol] = (cited, expression)
    return found


def walk(
    given: Sequence[SheetDatum],
    asked: Sequence[SheetItem],
    equations: Mapping[str, tuple[str, str]],
) -> dict[str, float]:
    """Compute everything that a sheet asks for, from paper alone: SI by printed symbol.

    Raises:
        NotOnPaperError: with the symbols that nothing tells, or a citation that is not printed.
    """
    left = [read_item(one) for one in asked if one.symbol]
    known = {one.symbol: read_given(one) for one in given}
    paper = Paper(known, _pattern([*known, *(one.symbol for one in left if not one.is_verdict)]))
    while left:
        waiting = [one for one in left if not _answer(one, paper, equations)]
        if len(waiting) == len(left):
            raise NotOnPaperError([one.symbol for one in waiting])
        left = waiting
    return paper.known


def _pattern(symbols: Sequence[str]) -> re.Pattern[str]:
    """Find any symbol of a sheet, of two the longer one."""
    longest = sorted((re.escape(one) for one in symbols), key=len, reverse=True)
    return re.compile(rf"(?<![\w\]'])(?:{'|'.join(longest)}){_END}")


def _answer(one: Asked, paper: Paper, equations: Mapping[str, tuple[str, str]]) -> bool:
    """Compute one answer; False where something that it needs is not known yet."""
    cited, expression = equations.get(one.symbol, ("", ""))
    if cited and cited not in one.beside:
        raise NotOnPaperError(one.symbol, cited, one.beside)
    parts = list(_parts(one.beside))
    printed = next((part for part in parts if part.startswith(f"{one.symbol} = ")), None)
    rule = next(filter(None, map(_RULE.fullmatch, parts)), None)
    try:
        if expression:
            value = paper.value(expression)
        elif printed is not None:
            value = paper.value(printed.removeprefix(f"{one.symbol} = "))
        elif one.is_verdict:
            value = float(all(paper.value(f"1 if {part} else 0") for part in _conditions(one)))
        elif rule is not None:
            value = _accepted(one, rule[1], paper)
        else:
            return False
    except KeyError:
        return False
    paper.known[one.symbol] = value
    return True


def _conditions(one: Asked) -> Sequence[str]:
    return one.symbol.split(", ")


def _parts(beside: str) -> Iterator[str]:
    """Yield what stands between semicolons; those in brackets part the arguments of a function."""
    depth, start = 0, 0
    for place, sign in enumerate(beside):
        depth += (sign in "([") - (sign in ")]")
        if sign == ";" and depth == 0:
            yield beside[start:place].strip()
            start = place + 1
    yield beside[start:].strip()


def _accepted(one: Asked, rule: str, paper: Paper) -> float:
    """Return the first size of the printed series that is not below what the rule says."""
    named = [words for words in SERIES if words in one.beside]
    if not named:
        raise NotOnPaperError(one.symbol, "series", one.beside)
    name = SERIES[min(named, key=one.beside.index)]  # others are accepted besides
    needed = paper.value(rule)
    return next((size for size in paper.table(name).sizes if size >= needed * (1 - 1e-9)), math.nan)
