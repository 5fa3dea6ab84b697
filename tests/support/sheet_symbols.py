"""What an assignment says of symbols: which it defines, and which givens its formulas name."""

import re
from collections.abc import Iterator, Mapping

from gripcourse.course.quantity import Quantity
from gripcourse.documents.assignment_rules import course_notes
from gripcourse.formula.prose import SYMBOL
from gripcourse.formula.tree import names
from gripcourse.solver.asked import deciding
from gripcourse.solver.needed_tables import needed_tables
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words


def undefined_symbols(plan: Plan, words: Words, read: Mapping[str, str]) -> set[tuple[str, str]]:
    """Return symbols in the texts of a sheet that stand for nothing there, with where they are.

    Args:
        plan: of the sheet.
        words: its language.
        read: what stands beside each answer, by id.
    """
    defined = _defined(plan, words.language)
    texts = dict(read)
    texts |= {one.id: one.title.of(words.language) for one in (*plan.givens, *plan.constants)}
    texts["task"] = plan.scheme.task.of(words.language)
    for section in plan.course.sections:
        if any(one.section == section.id for one in plan.asked):
            texts[section.id] = section.task_of(plan.quantities, words.language)
    texts |= {f"note {place}": text for place, text in enumerate(course_notes(plan, words))}
    return {
        (place, symbol)
        for place, text in texts.items()
        for symbol in SYMBOL.findall(text)
        if symbol not in defined
    }


def idle_givens(plan: Plan, words: Words, read: Mapping[str, str]) -> set[str]:
    """Return givens that only formulas read which the sheet writes out, each without naming them.

    Whoever takes these formulas from the sheet has a number that is of no use.
    """
    readers = dict[str, list[Quantity]]()
    for one in plan.quantities.values():
        formula = plan.reference_formula(one.id)
        for name in () if formula is None else names(formula.tree):
            readers.setdefault(name, []).append(one)
    return {
        given.id
        for given in (*plan.givens, *plan.constants)
        if readers.get(given.id)
        and all(
            _writes_out(one, read, words.language)
            and not _names(read[one.id], given.symbol.of(words.language))
            for one in readers[given.id]
        )
    }


def beside_answers(plan: Plan, words: Words) -> dict[str, str]:
    """Return by id what a sheet says of each answer: its title and what decides it."""
    return {
        one.id: f"{one.title.of(words.language)}; {deciding(one, plan, words)}"
        for one in plan.asked
    }


def _writes_out(one: Quantity, read: Mapping[str, str], language: str) -> bool:
    """Tell whether the sheet writes out how an answer is computed: `P_0 = …`."""
    symbol = one.symbol.of(language)
    return bool(symbol) and _names(read.get(one.id, ""), symbol, " = ")


def _names(text: str, symbol: str, after: str = "") -> bool:
    return re.search(rf"(?<![\w\[]){re.escape(symbol)}(?!\w){after}", text) is not None


def _defined(plan: Plan, language: str) -> set[str]:
    listed = (*plan.givens, *plan.constants, *plan.answered, *plan.manual)
    return {one.symbol.of(language) for one in listed} | set(_of_tables(plan, language))


def _of_tables(plan: Plan, language: str) -> Iterator[str]:
    for one in needed_tables(plan):
        for heading in one.catalogue.headings.values():
            yield from SYMBOL.findall(heading.of(language))
