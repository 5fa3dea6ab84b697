"""From a declared range to the values it allows.

A range is written in one of four ways: `low`, `high`, `step`; `values`; `catalogue` (with `low` and
`high` where it is not the whole column); or `follows`, where another given quantity decides, as the
number of teeth decides the form factor.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from typing import TypeAlias

from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.course.toml_table import Table
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import dimension, factor
from gripcourse.text.words import message

_WAYS = ("step", "values", "catalogue", "follows")
_MOST_VALUES = 100_000  # a finer step is a slip of the pen, and no tidy number


@dataclass(frozen=True, slots=True)
class Follower:
    """A given quantity whose value another one decides.

    Attributes:
        leader: id of the other.
        values: value by the leader's value, both in declared units.
    """

    leader: str
    values: Mapping[float, float]


Allowed: TypeAlias = tuple[float, ...] | Follower
"""Values in the declared unit, ascending, or whom to follow; empty after a problem."""


@dataclass(frozen=True, slots=True)
class Range:
    """The allowed values of a given quantity.

    Attributes:
        usual: where no option says otherwise.
        special: what replaces them: option, choice, values.
    """

    usual: Allowed
    special: tuple[tuple[str, str, Allowed], ...]

    def chosen(self, options: Mapping[str, str]) -> Allowed:
        """Return what counts with these options: the first special case that fits."""
        for option, choice, allowed in self.special:
            if options.get(option) == choice:
                return allowed
        return self.usual


@dataclass(frozen=True, slots=True)
class RangeReader:
    """Reads the ranges of one scheme; problems are recorded in the tables.

    Attributes:
        course: whose catalogues a range may name.
        givens: the given quantities of the scheme.
        options: the choices that the space mixes, by option id.
        offered: the choices that any scheme offers, each with its option.
    """

    course: Course
    givens: Mapping[str, Quantity]
    options: Mapping[str, Collection[str]]
    offered: Collection[tuple[str, str]]

    def read(self, table: Table, quantity: Quantity, *, is_own: bool) -> Range:
        """Read a range and its special cases `[[given.<id>.when]]`.

        Args:
            table: of the range.
            quantity: that it belongs to.
            is_own: whether the space itself says it. A range beside a given serves many schemes:
                a case of it that needs an option of others is passed over.
        """
        table.known_keys()
        special = []
        for case in table.tables("when"):
            case.known_keys()
            option, choice = case.text("option"), case.text("choice")
            if choice not in self.options.get(option, ()):
                if not is_own and (option, choice) in self.offered:
                    continue
                case.add(
                    "choice",
                    message("The space has no '{choice}' of '{option}'.", choice=choice,
                            option=option),
                    message("Write an option and a choice that [options] mixes."),
                )  # fmt: skip
            special.append((option, choice, self._allowed(case, quantity)))
        return Range(self._allowed(table, quantity), tuple(special))

    def check_leaders(self, read: Sequence[tuple[Table, str, Range]]) -> None:
        """Record followers whose leader follows too, or has values that they do not know.

        Args:
            read: every range with its table and the id of its given.
        """
        for table, _, one in read:
            for follower in (one.usual, *(allowed for _, _, allowed in one.special)):
                if isinstance(follower, Follower) and follower.values:
                    for _, leader, other in read:
                        if leader == follower.leader:
                            _check_leader(table, follower, other)

    def _allowed(self, table: Table, quantity: Quantity) -> Allowed:
        ways = [name for name in _WAYS if table.has(name)]
        if len(ways) != 1:
            table.add(
                "",
                message("The range is not written in one of the four ways."),
                message("Write low, high and step, or values, or catalogue, or follows."),
            )
            return ()
        match ways[0]:
            case "follows":
                follower = _follower(table, self.givens)
                _check(table, tuple(follower.values.values()), quantity)
                return follower
            case "values":
                values = _series(table)
            case "catalogue":
                values = _catalogue(self.course, table, quantity)
            case _:
                values = _steps(table)
        _check(table, values, quantity)
        return values


def _check_leader(table: Table, follower: Follower, leader: Range) -> None:
    for allowed in (leader.usual, *(one for _, _, one in leader.special)):
        if isinstance(allowed, Follower):
            table.add(
                "follows",
                message("'{leader}' follows another quantity itself.", leader=follower.leader),
                message("Follow the quantity that it follows."),
            )
            return
        for value in allowed:
            if value not in follower.values:
                table.add(
                    "pairs",
                    message("There is no pair for {leader} = {value}.", leader=follower.leader,
                            value=value),
                    message("Write a pair for every value of the quantity that is followed."),
                )  # fmt: skip


def _follower(table: Table, givens: Mapping[str, Quantity]) -> Follower:
    leader = table.text("follows")
    if leader not in givens:
        table.add(
            "follows",
            message("No such quantity is given in this scheme."),
            did_you_mean(leader, givens),
        )
    written = table.values.get("pairs")
    pairs = [_pair(pair) for pair in written] if isinstance(written, list) else []
    sound = [pair for pair in pairs if pair is not None]
    if sound and len(sound) == len(pairs):
        return Follower(leader, dict(sound))
    table.add(
        "pairs",
        message("The pairs are not written as pairs of numbers."),
        message("Write them like [[17, 4.26], [20, 4.07]]."),
    )
    return Follower(leader, {})


def _pair(written: object) -> tuple[float, float] | None:
    match written:
        case [int() | float() as one, int() | float() as other]:
            return float(one), float(other)
        case _:
            return None


def _steps(table: Table) -> tuple[float, ...]:
    before = len(table.problems)
    written = [table.number(name) for name in ("low", "high", "step")]
    if len(table.problems) > before:
        return ()
    # Decimals: 0.1 + 2 * 0.05 is 0.2 for the student, and must not be 0.20000000000000001.
    low, high, step = (Decimal(repr(number)) for number in written)
    if step <= 0 or high < low:
        table.add("", message("The range is upside down."), message("Write low < high, step > 0."))
        return ()
    count = (high - low) / step
    if count != int(count):
        table.add(
            "step",
            message("The steps from low do not meet high."),
            message("Write high = {high}.", high=float(low + int(count) * step)),
        )
        return ()
    if count >= _MOST_VALUES:
        table.add(
            "step",
            message("The range has {count} values.", count=int(count) + 1),
            message("Write a coarser step: students like tidy numbers."),
        )
        return ()
    return tuple(float(low + number * step) for number in range(int(count) + 1))


def _series(table: Table) -> tuple[float, ...]:
    written = table.values["values"]
    values = written if isinstance(written, list) else []
    numbers = [
        float(one) for one in values if isinstance(one, int | float) and not isinstance(one, bool)
    ]
    if numbers and len(numbers) == len(values):
        return tuple(sorted(set(numbers)))
    table.add(
        "values",
        message("The series is not a list of numbers."),
        message("Write it like [6.3, 10, 16]."),
    )
    return ()


def _catalogue(course: Course, table: Table, quantity: Quantity) -> tuple[float, ...]:
    name = table.text("catalogue")
    id_, _, column = name.partition(".")
    known = {
        f"{catalogue.id}.{one}"
        for catalogue in course.catalogues.values()
        for one in catalogue.columns
    }
    if name not in known:
        table.add(
            "catalogue",
            message("There is no column '{column}' in the catalogues.", column=name),
            did_you_mean(name, known),
        )
        return ()
    unit = course.catalogues[id_].units[column]
    if dimension(unit) != dimension(quantity.unit):
        table.add(
            "catalogue",
            message("The column is in '{unit}', the quantity in '{wanted}'.", unit=unit,
                    wanted=quantity.unit),
            message("Name a column of the same kind."),
        )  # fmt: skip
        return ()
    low = table.number("low", float("-inf"))
    high = table.number("high", float("inf"))
    sizes = course.catalogues[id_].columns[column] / factor(quantity.unit)
    # Twelve figures undo the noise of the way to SI and back.
    tidy = sorted({float(f"{size:.12g}") for size in sizes})
    values = tuple(size for size in tidy if low <= size <= high)
    if not values:
        table.add(
            "",
            message("The catalogue has nothing between low and high."),
            message("Widen the range."),
        )
    return values


def _check(table: Table, values: tuple[float, ...], quantity: Quantity) -> None:
    low, high = quantity.bounds
    for value in values:
        if not low <= value <= high:
            table.add(
                "",
                message("The value {value} is outside the bounds {low} to {high} of the quantity.",
                        value=value, low=low, high=high),
                message("Narrow the range, or correct the bounds in {file}.", file=quantity.file),
            )  # fmt: skip
            break
    if quantity.integer and any(not value.is_integer() for value in values):
        table.add(
            "",
            message("The quantity takes whole numbers only."),
            message("Write whole numbers and a whole step."),
        )
