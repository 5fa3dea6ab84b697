"""What is keyed wrongly into a calculator: brackets, one sign for another.

Generators as those of `generic`: from a formula's surroundings to rewritten trees.
"""

from collections.abc import Iterator, Mapping

from gripcourse.formula.dimension import measured_by
from gripcourse.formula.fault import FormulaFault
from gripcourse.formula.parse import parse
from gripcourse.formula.tree import Name, Negation, Node, Number, Operation
from gripcourse.slips.rewrite import rewritings
from gripcourse.slips.surroundings import Found, Rewritten, Surroundings
from gripcourse.text.units import Dimension, dimension


def brackets_left_out(around: Surroundings) -> Iterator[Rewritten]:
    """Leave out a pair of brackets: `a*b + c` for `a*(b + c)`, `a/b*c*d` for `a/(b*c*d)`."""
    text, right = around.formula.text, around.formula.tree
    for first, last in _brackets(text):
        tree = parse(f"{text[:first]} {text[first + 1 : last]} {text[last + 1 :]}")
        if tree != right:
            yield Rewritten(f"{first}", tree, {"quantity": parse(text[first + 1 : last])})


def _brackets(text: str) -> Iterator[tuple[int, int]]:
    """Yield the places of brackets that group, and not those of a function."""
    waiting: list[int] = []
    for place, sign in enumerate(text):
        if sign == "(":
            waiting.append(place)
        elif sign == ")":
            first = waiting.pop()
            before = text[:first].rstrip()[-1:]
            if not (before.isalnum() or before == "_"):
                yield first, place


def added_for_multiplied(around: Surroundings) -> Iterator[Rewritten]:
    """Add what is to be multiplied, or the other way round, where both are of one kind."""
    known = {name: dimension(one.unit) for name, one in around.quantities.items()}

    def change(node: Node) -> Iterator[Found]:
        match node:
            case Operation("+" | "*" as sign, left, right):
                if _is_alike(left, right, known):
                    other = Operation("*" if sign == "+" else "+", left, right)
                    yield other, (f"{right.span[0]}", {"quantity": left, "other": right})

    for tree, (detail, places) in rewritings(around.formula.tree, change):
        yield Rewritten(detail, tree, places)


def _is_alike(left: Node, right: Node, known: Mapping[str, Dimension]) -> bool:
    """Tell whether two operands measure the same, and neither is a number of the formula."""
    if any(isinstance(one, Number | Negation) or one == Name("pi") for one in (left, right)):
        return False
    try:
        return measured_by(left, known, {}) == measured_by(right, known, {})
    except FormulaFault:
        return False
