"""The candidates of a quantity: its declared slips, then what the generic kinds make of it."""

from collections.abc import Iterator, Mapping

from gripcourse.course.column_symbols import column_symbols
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.formula.plain import text
from gripcourse.formula.tree import Formula, Node, names
from gripcourse.formula.typeset import declared_symbol, symbol_box, typeset
from gripcourse.policy.slips import GenericSlip, SlipPolicy
from gripcourse.slips.generic import GENERATORS, Place, Rewritten, Surroundings
from gripcourse.slips.model import Candidate, SlipId
from gripcourse.solver.plan import Plan
from gripcourse.text.number_text import format_number
from gripcourse.text.units import known, unit_text
from gripcourse.text.words import LANGUAGES, Texts

_GENERIC = frozenset({Kind.FORMULA, Kind.PICK})


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
    quantity = plan.quantities[identifier]
    formula = plan.reference_formula(identifier)
    if formula is None:
        return ()
    found = [
        Candidate(SlipId.declared(slip.id), slip.formula, policy.declared, slip.credit, slip.hint)
        for slip in quantity.slips
    ]
    found = [one for one in found if one.formula.tree != formula.tree]
    if quantity.kind in _GENERIC:
        order = list(plan.quantities)
        earlier = frozenset(order[: order.index(identifier)])
        for slip in policy.kinds.values():
            taken = {formula.tree, *(one.formula.tree for one in found)}
            found += _of_kind(Surroundings(plan, quantity, formula, slip, earlier), taken)
    return tuple(found)


def _of_kind(around: Surroundings, taken: set[Node]) -> Iterator[Candidate]:
    """Share a kind's prior among its candidates: the more ways, the rarer each."""
    slip = around.slip
    made = {one.tree: one for one in reversed(tuple(GENERATORS[slip.kind](around)))}
    new = [one for one in made.values() if one.tree not in taken and _is_known(one, around.formula)]
    for one in reversed(new):
        yield Candidate(
            id=SlipId(slip.kind, one.detail),
            formula=Formula("", one.tree, around.formula.units),
            prior=slip.prior / len(new),
            credit=slip.credit,
            hint=_hint(around.plan, slip, one.places),
        )


def _is_known(one: Rewritten, formula: Formula) -> bool:
    """An empirical formula computes only with names whose unit it states."""
    return not formula.units or set(names(one.tree)) <= formula.units.keys()


def _hint(plan: Plan, slip: GenericSlip, places: Mapping[str, Place]) -> Texts:
    return Texts(
        {
            language: slip.hint.of(language).format(
                **{name: _written(plan, place, language) for name, place in places.items()}
            )
            for language in LANGUAGES
        }
    )


def _written(plan: Plan, place: Place, language: str) -> str:
    match place:
        case Quantity():
            symbol = text(declared_symbol(place.symbol.of(language)))
            return f"{place.title.of(language)} ({symbol})"
        case float():
            return format_number(place, language)
        case str():
            return unit_text(place, language) if place and known(place) else place or "1"
        case _:
            symbols = {
                name: symbol_box(plan.quantities[name].symbol.of(language)) for name in names(place)
            }
            columns = column_symbols(place, None, plan.quantities, language)
            return text(typeset(place, symbols | columns, language))
