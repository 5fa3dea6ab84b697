"""From the rows of a table to variants: every cell is judged, nothing is guessed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course, Option, Scheme
from gripcourse.course.option_sets import broken_rules
from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.machine.enclosed import LONGEST_NAME, is_file_name
from gripcourse.solver.family import families_of
from gripcourse.solver.plan import Plan, plan_of
from gripcourse.text.spelling import plain
from gripcourse.text.words import LANGUAGES, Message, Texts, message
from gripcourse.variants.cells import converted, exact_number, is_formula, said_of_formula
from gripcourse.variants.defaults import Defaults
from gripcourse.variants.explain import broken_option_rule, explain, with_unit
from gripcourse.variants.feasible import Reason, judge
from gripcourse.variants.headings import TableColumn
from gripcourse.variants.model import Variant
from gripcourse.variants.named_choices import allowed_names
from gripcourse.variants.names import without_leading_zeros
from gripcourse.variants.row_faults import CellFault, RowRefusal, problems_of, refusals_of
from gripcourse.variants.sheet import Sheet, SheetRow

_PERCENT: Final = "%"


@dataclass(frozen=True, slots=True)
class RowReader:
    """Reads the rows of one table.

    Attributes:
        course: whose variants they are.
        sheet: the table.
        columns: its columns by id.
        absent: ids of columns that are not there, which has been said once for all rows.
        defaults: what stands for a column that is not there; None where nothing does.
        filled: titles of what the defaults were taken for, by id.
        problems: where everything that is wrong is recorded.
        language: of the table's titles; empty for ids.
    """

    course: Course
    sheet: Sheet
    columns: Mapping[str, TableColumn]
    absent: frozenset[str]
    problems: list[Problem]
    defaults: Defaults | None = None
    filled: dict[str, Texts] = field(default_factory=dict)
    plans: dict[Composition, Plan] = field(default_factory=dict)
    faults: list[CellFault] = field(default_factory=list)
    language: str = ""

    def read(self) -> list[Variant]:
        """Return the variants of all rows that are right."""
        rows: list[tuple[SheetRow, Variant]] = []
        seen: dict[str, SheetRow] = {}
        for place, row in enumerate(self.sheet.rows, start=1):
            variant = self._variant(row, place, seen)
            if variant is not None:
                rows.append((row, variant))
        self.problems.extend(problems_of(self.sheet.file, self.faults))
        self._refuse_infeasible(rows)
        return [variant for _, variant in rows]

    def _variant(self, row: SheetRow, place: int, seen: dict[str, SheetRow]) -> Variant | None:
        before = len(self.faults)
        id_ = self._id(row, place, seen)
        scheme = self._scheme(row)
        if scheme is None:
            return None
        options = self._options(row, scheme)
        if len(options) < len(scheme.options):
            return None
        for rule, forbidden in broken_rules(scheme.rules, options):
            what = broken_option_rule(scheme, options, rule, forbidden)
            remedy = message("Change one of these choices.")
            self._add(row, f"option:{forbidden}", what, remedy)
        plan = self._plan(scheme, options)
        given = self._givens(row, plan)
        self._refuse_unused(row, plan)
        if len(self.faults) > before:
            return None
        return Variant(id_, scheme.id, options, given)

    def _id(self, row: SheetRow, place: int, seen: dict[str, SheetRow]) -> str:
        if self.defaults is not None and "variant" not in self.columns:
            return f"{place:03d}"
        id_ = self._cell(row, "variant")
        if not id_:
            self._add(row, "variant", message("The variant has no name."), message("Write one."))
        elif (other := seen.get(without_leading_zeros(id_))) is not None:
            self._add(
                row,
                "variant",
                message("The variant '{variant}' is in row {row} already.",
                        variant=self._cell(other, "variant"), row=other.number),
                message("Give each variant a name of its own, and not one that differs in leading"
                        " zeros alone: spreadsheet programs drop them."),
            )  # fmt: skip
        elif not is_file_name(id_):
            self._add(
                row,
                "variant",
                message("The variant '{variant}' cannot name a file.", variant=id_),
                message(
                    "Use at most {most} letters, digits and the signs - _ . inside.",
                    most=LONGEST_NAME,
                ),
            )
        seen.setdefault(without_leading_zeros(id_), row)
        return id_

    def _scheme(self, row: SheetRow) -> Scheme | None:
        written = self._cell(row, "scheme")
        if not written and "scheme" not in self.columns and len(self.course.schemes) == 1:
            return next(iter(self.course.schemes.values()))
        for scheme in self.course.schemes.values():
            if _means(written, scheme.id, scheme.title):
                return scheme
        what = (
            message("There is no scheme '{scheme}'.", scheme=written)
            if written
            else message("The scheme is missing.")
        )
        known = ((one.id, one.title) for one in self.course.schemes.values())
        self._add(row, "scheme", what, allowed_names(written, known, self.language))
        return None

    def _options(self, row: SheetRow, scheme: Scheme) -> dict[str, str]:
        found = {option.id: self._option(row, option, scheme) for option in scheme.options}
        return {id_: choice for id_, choice in found.items() if choice is not None}

    def _option(self, row: SheetRow, option: Option, scheme: Scheme) -> str | None:
        key = f"option:{option.id}"
        if self.defaults is not None and key not in self.columns:
            self.filled[key] = option.title
            return self.defaults.option(scheme, option.id)
        written = self._cell(row, key)
        for choice in option.choices:
            if _means(written, choice.id, choice.title):
                return choice.id
        what = (
            message("There is no choice '{choice}'.", choice=written)
            if written
            else message("The choice is missing.")
        )
        known = ((one.id, one.title) for one in option.choices)
        self._add(row, key, what, allowed_names(written, known, self.language))
        return None

    def _plan(self, scheme: Scheme, options: Mapping[str, str]) -> Plan:
        composition = Composition.of(scheme.id, options)
        if composition not in self.plans:
            self.plans[composition] = plan_of(self.course, composition)
        return self.plans[composition]

    def _givens(self, row: SheetRow, plan: Plan) -> dict[str, float]:
        """Return the numbers of a row; what defaults stand for comes after what decides it."""
        filled = [one for one in plan.givens if self.defaults and one.id not in self.columns]
        given: dict[str, float] = {}
        for quantity in plan.givens:
            if quantity not in filled:
                value = self._given(row, quantity)
                given |= {} if value is None else {quantity.id: value}
        for quantity in filled:
            value = self.defaults.number(plan, quantity.id, given) if self.defaults else None
            if value is None:
                self._given(row, quantity)  # says that it is missing
            else:
                given[quantity.id] = value
                self.filled[quantity.id] = quantity.title
        return given

    def _given(self, row: SheetRow, quantity: Quantity) -> float | None:
        written = self._cell(row, quantity.id)
        if not written:
            self._add(
                row,
                quantity.id,
                message("The value is missing: the scheme of the row needs it."),
                message("Write a number."),
            )
            return None
        unit = self.columns[quantity.id].unit
        number, is_percent = _without_percent(written, quantity)
        value = exact_number(number, decimal_comma=self.sheet.decimal_comma)
        if value is None:
            self._add(row, quantity.id, *_no_number(written))
            return None
        if is_percent:
            unit = _PERCENT
        value = converted(value, quantity.unit if unit is None else unit, quantity.unit)
        self._check(row, quantity, value)
        return value

    def _check(self, row: SheetRow, quantity: Quantity, value: float) -> None:
        low, high = quantity.bounds
        if not low <= value <= high:
            self._add(
                row,
                quantity.id,
                message("The value {value} is not possible for '{quantity}'.", value=value,
                        quantity=quantity.title),
                message("Write a number from {low} to {high}.", low=low,
                        high=with_unit(high, quantity)),
            )  # fmt: skip
        elif quantity.integer and not value.is_integer():
            self._add(
                row,
                quantity.id,
                message("The value {value} is not a whole number.", value=value),
                message("Write a whole number."),
            )

    def _refuse_unused(self, row: SheetRow, plan: Plan) -> None:
        """Refuse a number that the scheme would not use: it stands in the wrong row or column."""
        used = {quantity.id for quantity in plan.givens}
        used |= {"variant", "scheme", *(f"option:{id_}" for id_ in plan.options)}
        for id_ in self.columns:
            if id_ not in used and self._cell(row, id_):
                self._add(
                    row,
                    id_,
                    message("The scheme '{scheme}' with these options does not use this.",
                            scheme=plan.scheme.title),
                    message("Clear the cell."),
                )  # fmt: skip

    def _refuse_infeasible(self, rows: list[tuple[SheetRow, Variant]]) -> None:
        # Where a column is missing altogether, that is said elsewhere.
        whole = [one for one in rows if self._is_whole(one[1])]
        found: list[RowRefusal] = []
        for places, family in families_of(self.course, [one.composition for _, one in whole]):
            own = [whole[place] for place in places]
            given = {
                one.quantity.id: np.array(
                    [variant.given.get(one.quantity.id, np.nan) for _, variant in own]
                )
                for one in family.givens
            }
            feasibility = judge(family, given)
            for place, (row, variant) in enumerate(own):
                plan = self.plans[variant.composition]
                reasons = [one for one, at in feasibility.refused.items() if at[place]]
                for reason in _roots(plan, reasons):
                    what = explain(plan, feasibility, reason, place)
                    found.append(RowRefusal(row.number, variant.id, _alike(reason), what))
        self.problems.extend(refusals_of(self.sheet.file, found))

    def _is_whole(self, variant: Variant) -> bool:
        """Tell whether a variant has all numbers that its scheme needs."""
        return all(one.id in variant.given for one in self.plans[variant.composition].givens)

    def _cell(self, row: SheetRow, id_: str) -> str:
        column = self.columns.get(id_)
        return row.cells[column.position] if column is not None else ""

    def _add(self, row: SheetRow, id_: str, what: Message, remedy: Message) -> None:
        if id_ in self.absent:
            return
        column = self.columns.get(id_)
        name = column.name if column is not None else id_.removeprefix("option:")
        self.faults.append(CellFault(row.number, name, what, remedy))


def _roots(plan: Plan, reasons: Sequence[Reason]) -> list[Reason]:
    """Leave out what is computed from something that is refused itself: corrected with it."""
    refused = {one.quantity for one in reasons}
    return [one for one in reasons if not refused & _inputs_of_all(plan, one.quantity)]


def _inputs_of_all(plan: Plan, name: str) -> set[str]:
    """Return the ids of all that a quantity is computed from, on the way too."""
    found: set[str] = set()
    waiting = list(plan.inputs.get(name, ()))
    while waiting:
        one = waiting.pop()
        if one not in found:
            found.add(one)
            waiting += plan.inputs[one]
    return found


def _alike(reason: Reason) -> tuple[str, str, str]:
    """Return what is the same in all rows that are refused for it, whatever their options."""
    formula = "" if reason.formula is None else reason.formula.text
    return reason.cause, reason.quantity, formula


def _means(written: str, id_: str, title: Texts) -> bool:
    """Whether a cell names something by its id or by its title in any language."""
    names = {id_, *(title.of(language) for language in LANGUAGES)}
    return plain(written) in {plain(name) for name in names}


def _without_percent(written: str, quantity: Quantity) -> tuple[str, bool]:
    """Return a number without the sign behind it, which a cell of a share may show: `95 %`."""
    is_share = written.endswith(_PERCENT) and quantity.unit in {"", _PERCENT}
    return (written.removesuffix(_PERCENT).rstrip(), True) if is_share else (written, False)


def _no_number(written: str) -> tuple[Message, Message]:
    """Say that a cell holds no number, and the remedy."""
    if is_formula(written):
        return said_of_formula()
    return (
        message("'{text}' is not a number.", text=written),
        message(
            "Write digits and one decimal sign; if the program made a date of it, set"
            " the format of the column to a number and write it again."
        ),
    )
