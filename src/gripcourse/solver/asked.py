"""What decides an asked answer, in words: what is declared, the rule of a choice, the equation.

It stands beside the quantity on the sheet and in the workbook, so that a sheet has one reading.
"""

import re
from collections.abc import Iterator
from typing import Final

from gripcourse.course.model import Work
from gripcourse.course.quantity import Choice, Kind, Quantity, Rounding
from gripcourse.formula.plain import text
from gripcourse.formula.tree import Call, Formula, Node, names, walk
from gripcourse.formula.typeset import symbol_box, typeset
from gripcourse.solver.condition_text import condition_text
from gripcourse.solver.plan import Plan
from gripcourse.text.amounts import NO_BREAK_SPACE
from gripcourse.text.words import Message, Words, counted, message

NOTED: Final = frozenset({Kind.CHOICE, Kind.PICK, Kind.VERDICT})
"""Kinds of answers that the note of the source stands beside without being asked for."""

# Whoever reads a table by its first column needs to be told which, not how a program writes it.
_READINGS: Final = frozenset({"lookup", "at_least", "nearest", "interpolate"})
_TABLE: Final = re.compile(r"T(\d+)")
_NUMBER: Final = re.compile(r"\d+(?:–\d+)?")


def deciding(quantity: Quantity, plan: Plan, words: Words) -> str:
    """Return what decides an answer where title, unit and symbol leave it open; empty for nothing.

    Args:
        quantity: of the plan, asked of the student.
        plan: symbols of what a rule compares with, and the works that are cited by number.
        words: the reader's language.
    """
    return "; ".join(_parts(quantity, plan, words))


def cited_works(plan: Plan) -> tuple[Work, ...]:
    """Return the works whose equations asked quantities cite; their place is their number."""
    cited = {one.source.work for one in plan.answered if any(map(_is_number, _cited(one)))}
    return tuple(work for name, work in plan.course.works.items() if name in cited)


def _parts(quantity: Quantity, plan: Plan, words: Words) -> Iterator[str]:
    if quantity.decides is not None:
        yield quantity.decides.of(words.language)
    note = quantity.source.note
    by_itself = quantity.kind in NOTED
    if note is not None and (by_itself or quantity.note_decides):
        yield note.of(words.language)
    formula = plan.reference_formula(quantity.id)
    if quantity.formula_decides and formula is not None:
        symbol = quantity.symbol.of(words.language)
        yield f"{symbol} = {_written(formula, plan, words.language)}"
    if quantity.choice is not None:
        yield from _rule(quantity, plan, words)
    yield from _citation(quantity, plan, words)


def _rule(quantity: Quantity, plan: Plan, words: Words) -> Iterator[str]:
    """Say which sizes of the series are sound."""
    choice, formula = quantity.choice, quantity.formula
    if choice is None or formula is None:
        return
    sizes, needed = _sizes(choice), _written(formula, plan, words.language)
    if _reads_table(formula):
        # Who has said in words which sizes will do is not interrupted.
        told = quantity.decides is not None or quantity.source.note is not None
        searched = None if told else _searched(formula.tree, plan, words)
        if searched is None:
            yield words.say(message("{sizes} that will do", sizes=sizes))
        else:
            yield words.say(
                message("{sizes} for which {condition}", sizes=sizes, condition=searched)
            )
    elif choice.rounding is Rounding.NEAREST and not choice.steps:
        yield words.say(message("the size of the series nearest to {needed}", needed=needed))
    elif choice.rounding is Rounding.NEAREST:
        yield words.say(
            counted(
                "the size of the series nearest to {needed}, or one within {count} place of it",
                "the size of the series nearest to {needed}, or one within {count} places of it",
                choice.steps or 0,
                needed=needed,
            )
        )
    else:
        yield words.say(_from_needed_up(quantity, sizes, needed, plan, words))
        if quantity.steps_up:
            return
    if quantity.steps_up:
        yield condition_text(quantity, plan, words.language)
    elif choice.condition is not None and not _reads_table(choice.condition):
        yield _written(choice.condition, plan, words.language)


def _from_needed_up(
    quantity: Quantity, sizes: Message, needed: str, plan: Plan, words: Words
) -> Message:
    """Say from where on sizes are sound; and for which of them a condition holds that counts."""
    if not quantity.steps_up:
        return message("{sizes} not below {needed}", sizes=sizes, needed=needed)
    return message(
        "{sizes} not below {needed} for which {condition}",
        sizes=sizes,
        needed=needed,
        condition=condition_text(quantity, plan, words.language),
    )


def _sizes(choice: Choice) -> Message:
    """Name the sizes of the series that are sound: the first that will do, and some above it."""
    if choice.steps is None:
        return message("any size")
    if not choice.steps:
        return message("the first size")
    return counted(
        "one of the first {count} size", "one of the first {count} sizes", choice.steps + 1
    )


def _searched(tree: Node, plan: Plan, words: Words) -> str | None:
    """Say which column of a table decides on a size, and what it must reach; None: something else.

    Args:
        tree: of the value that a size must not be below.
        plan: of the size.
        words: the reader's language.
    """
    match tree:
        case Call("at_least", (needed,), str(column)) if not _reads(needed):
            catalogue, _, name = column.partition(".")
            heading = plan.course.catalogues[catalogue].headings.get(name)
            if heading is not None:
                reached = _set(needed, plan, words.language)
                return f"{heading.of(words.language)} ≥ {reached}".replace(" ", NO_BREAK_SPACE)
    return None


def _reads_table(formula: Formula) -> bool:
    return _reads(formula.tree)


def _reads(tree: Node) -> bool:
    return any(isinstance(one, Call) and one.function in _READINGS for one in walk(tree))


def _written(formula: Formula, plan: Plan, language: str) -> str:
    return _set(formula.tree, plan, language)


def _set(tree: Node, plan: Plan, language: str) -> str:
    symbols = {name: symbol_box(plan.quantities[name].symbol.of(language)) for name in names(tree)}
    return text(typeset(tree, symbols, language))


def _citation(quantity: Quantity, plan: Plan, words: Words) -> Iterator[str]:
    """Yield the work by its number with the equation: `[1, (45)]`."""
    works = [one.id for one in cited_works(plan)]
    equations = [_equation(one, words) for one in _cited(quantity) if _is_number(one)]
    if equations and quantity.source.work in works:
        number = works.index(quantity.source.work) + 1
        yield f"[{number}, {', '.join(equations)}]"


def _cited(quantity: Quantity) -> tuple[str, ...]:
    """Return what of a work a quantity cites, as declared: `T5`, `30–36`, `§5`."""
    return tuple(one.strip() for one in quantity.source.equation.split(","))


def _is_number(cited: str) -> bool:
    """Tell whether something is cited by a number that says the same in every language."""
    return bool(_TABLE.fullmatch(cited) or _NUMBER.fullmatch(cited) or cited.startswith("§"))


def _equation(cited: str, words: Words) -> str:
    table = _TABLE.fullmatch(cited)
    if table is not None:
        return words.say(message("table {number}", number=table[1]))
    return f"({cited})" if _NUMBER.fullmatch(cited) else cited
