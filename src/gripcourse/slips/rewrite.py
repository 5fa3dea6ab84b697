"""Formula trees with one place changed."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TypeVar, assert_never

from gripcourse.formula.tree import Call, Name, Negation, Node, Number, Operation

Told = TypeVar("Told")


def rewritings(
    node: Node, change: Callable[[Node], Iterator[tuple[Node, Told]]]
) -> Iterator[tuple[Node, Told]]:
    """Yield the tree once for each change of each of its places.

    Args:
        node: the whole tree.
        change: yields what may stand in the place of a node, each with what is to be told of it.
    """
    yield from change(node)
    match node:
        case Negation(operand):
            for one, told in rewritings(operand, change):
                yield replace(node, operand=one), told
        case Operation(_, left, right):
            for one, told in rewritings(left, change):
                yield replace(node, left=one), told
            for one, told in rewritings(right, change):
                yield replace(node, right=one), told
        case Call(_, arguments):
            for place, argument in enumerate(arguments):
                for one, told in rewritings(argument, change):
                    changed = (*arguments[:place], one, *arguments[place + 1 :])
                    yield replace(node, arguments=changed), told
        case Number() | Name():
            return
        case _:
            assert_never(node)


def everywhere(node: Node, change: Callable[[Node], Node]) -> Node:
    """Return the tree with every place changed, from the leaves up."""
    match node:
        case Negation(operand):
            return change(replace(node, operand=everywhere(operand, change)))
        case Operation(_, left, right):
            return change(
                replace(node, left=everywhere(left, change), right=everywhere(right, change))
            )
        case Call(_, arguments):
            changed = tuple(everywhere(one, change) for one in arguments)
            return change(replace(node, arguments=changed))
        case Number() | Name():
            return change(node)
        case _:
            assert_never(node)


def renamed(node: Node, names: dict[str, Node]) -> Node:
    """Return the tree with other nodes in the places of some names."""
    return everywhere(node, lambda one: names.get(one.id, one) if isinstance(one, Name) else one)


def somewhere(node: Node, name: str, new: Node) -> Iterator[tuple[int, Node]]:
    """Yield the tree with another node in one of the places of a name, and where that is.

    Nothing for a name that stands in one place only.
    """

    def change(one: Node) -> Iterator[tuple[Node, int]]:
        if one == Name(name):
            yield new, one.span[0]

    found = [(place, tree) for tree, place in rewritings(node, change)]
    yield from found if len(found) > 1 else ()


def number(value: float) -> Number:
    """Make a number of a tree."""
    return Number(value, f"{value:.12g}")


def scaled(node: Node, by: float) -> Node:
    """Return a node times a number."""
    return Operation("*", number(by), node)
