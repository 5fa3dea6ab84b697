"""The candidates of a quantity: its declared slips, then what the generic kinds make of it."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache

from gripcourse.course.check_slips import same_value
from gripcourse.course.column_symbols import readers_of
from gripcourse.course.model import Catalogue
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.evaluate import Column
from gripcourse.formula.tree import Formula, Node, names
from gripcourse.policy.slips import GenericSlip, SlipKind, SlipPolicy
from gripcourse.slips.ends import other_ends, taken_among
from gripcourse.slips.generic import GENERATORS
from gripcourse.slips.hints import Hint
from gripcourse.slips.model import Candidate, SlipId
from gripcourse.slips.practical import in_practical_units
from gripcourse.slips.surroundings import Rewritten, Surroundings
from gripcourse.slips.taken import is_behind
from gripcourse.solver.plan import Plan

_GENERIC = frozenset({Kind.FORMULA, Kind.PICK})
# After these a result may measure something else: its number then depends on the units of the work.
_OF_DIMENSIONS = frozenset(
    {
        SlipKind.POWER,
        SlipKind.MULTIPLIED_FOR_DIVIDED,
        SlipKind.BRACKETS,
        SlipKind.ADDED_FOR_MULTIPLIED,
    }
)
_REMEMBERED = 4096  # quantities: several courses of the size of the reference course


def candidates_of(plan: Plan, identifier: str, policy: SlipPolicy) -> tuple[Candidate, ...]:
    """Return what a student may have computed instead of a quantity's formula.

    Args:
        plan: that the quantity belongs to.
        identifier: of the quantity; one that is not computed has no candidates.
        policy: kinds of generic slips.

    Returns:
        Declared slips first. No candidate has the tree of the right formula or of an earlier
        candidate; of several that give one value only the numbers of a variant can tell.
    """
    formula = plan.reference_formula(identifier)
    return () if formula is None else _made_of(_declared(plan, identifier, formula, policy))


@dataclass(frozen=True, slots=True)
class _Declared:
    """All that the candidates of a quantity follow from: many compositions share it.

    Attributes:
        key: which objects these are; they are kept with it, so that no other takes their numbers.
        kinds: of generic slips, in order.
        quantities, independent, columns, catalogues: see `generic.Surroundings`.
    """

    key: tuple[object, ...]
    quantity: Quantity = field(compare=False)
    formula: Formula = field(compare=False)
    policy: SlipPolicy = field(compare=False)
    kinds: tuple[GenericSlip, ...] = field(compare=False)
    quantities: Mapping[str, Quantity] = field(compare=False)
    independent: frozenset[str] = field(compare=False)
    columns: Mapping[str, Column] = field(compare=False)
    catalogues: Mapping[str, Catalogue] = field(compare=False)


def _declared(plan: Plan, identifier: str, formula: Formula, policy: SlipPolicy) -> _Declared:
    """Collect what the candidates of a quantity follow from."""
    kinds = tuple(policy.kinds.values())
    ends = {
        other
        for slip in kinds
        for name in formula.names
        for other in (*other_ends(name, slip), *taken_among(name, plan.quantities, slip))
        if other in plan.quantities
    }
    independent = _independent(plan, identifier, ends)
    near = {name: plan.quantities[name] for name in (*formula.names, *sorted(ends))}
    near |= readers_of(formula.tree, plan.quantities)
    near |= _behind(plan, formula, policy)
    quantity, catalogues = plan.quantities[identifier], plan.course.catalogues
    key = (
        *(id(one) for one in (quantity, formula, catalogues, *kinds)),
        policy.declared,
        *((name, id(one)) for name, one in near.items()),
        independent,
    )
    return _Declared(
        key, quantity, formula, policy, kinds, near, independent, plan.columns, catalogues
    )


def _behind(plan: Plan, formula: Formula, policy: SlipPolicy) -> dict[str, Quantity]:
    """Return what the numbers that a formula uses are computed from, as far as a kind asks."""
    inner = (plan.quantities[name].formula for name in formula.names)
    names = dict.fromkeys(name for one in inner if one is not None for name in one.names)
    found = ((name, plan.quantities[name]) for name in names if name in plan.quantities)
    return {name: one for name, one in found if is_behind(one, policy.kinds)}


def _independent(plan: Plan, identifier: str, names: Collection[str]) -> frozenset[str]:
    """Return those of the quantities that are not computed from another one."""
    if not names:
        return frozenset()
    dependent = {identifier}
    for name in plan.quantities:  # inputs stand before what needs them
        if not dependent.isdisjoint(plan.inputs[name]):
            dependent.add(name)
    return frozenset(names) - dependent


@lru_cache(maxsize=_REMEMBERED)
def _made_of(declared: _Declared) -> tuple[Candidate, ...]:
    quantity, formula, policy = declared.quantity, declared.formula, declared.policy
    found = [
        Candidate(
            id=SlipId.declared(slip.id),
            formula=slip.formula,
            prior=policy.declared,
            credit=slip.credit,
            said=Hint(slip.hint, {}, {}, {}),
        )
        for slip in quantity.slips
    ]
    found = [one for one in found if one.formula.tree != formula.tree]
    columns = declared.columns
    if quantity.kind in _GENERIC:
        taken = {formula.tree, *(one.formula.tree for one in found)}
        for slip in declared.kinds:
            new = tuple(_of_kind(_surroundings(declared, slip), taken))
            taken.update(one.formula.tree for one in new)
            found += new
    return tuple(one for one in found if not _is_accepted(quantity, one.formula, columns))


def _is_accepted(quantity: Quantity, formula: Formula, columns: Mapping[str, Column]) -> bool:
    """Tell whether a method computes what an accepted reading does: then it is no mistake."""
    return any(same_value(quantity, one.formula, formula, columns) for one in quantity.alternatives)


def _surroundings(declared: _Declared, slip: GenericSlip) -> Surroundings:
    return Surroundings(
        quantities=declared.quantities,
        columns=declared.columns,
        catalogues=declared.catalogues,
        quantity=declared.quantity,
        formula=declared.formula,
        slip=slip,
        independent=declared.independent,
    )


def _of_kind(around: Surroundings, taken: set[Node]) -> Iterator[Candidate]:
    """Share a kind's prior among its candidates: the more ways, the rarer each."""
    slip = around.slip
    ways = tuple(GENERATORS[slip.kind](around))
    if slip.kind in _OF_DIMENSIONS:
        ways = (*ways, *in_practical_units(around, ways))
    made = {one.tree: one for one in reversed(ways)}
    new = [one for one in made.values() if one.tree not in taken and _is_known(one, around.formula)]
    for one in reversed(new):
        yield Candidate(
            id=SlipId(slip.kind, one.detail),
            formula=Formula("", one.tree, around.formula.units),
            prior=slip.prior / len(new),
            credit=slip.credit,
            said=Hint(slip.hint, one.places, around.quantities, around.catalogues, one.practical),
        )


def _is_known(one: Rewritten, formula: Formula) -> bool:
    """An empirical formula computes only with names whose unit it states."""
    return not formula.units or set(names(one.tree)) <= formula.units.keys()
