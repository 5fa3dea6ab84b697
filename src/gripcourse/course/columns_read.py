"""Which catalogues an answer is taken from, and whether students can be told so by name."""

from collections.abc import Iterator

from gripcourse.course.model import Catalogue, Course
from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.formula.tree import Call, Formula, walk
from gripcourse.text.words import Message, message


def columns_of_formula(formula: Formula | None) -> tuple[str, ...]:
    """Return the `catalogue.column` names that a formula reads, each once."""
    if formula is None:
        return ()
    calls = (node.column for node in walk(formula.tree) if isinstance(node, Call))
    return tuple(dict.fromkeys(column for column in calls if column is not None))


def columns_read(quantity: Quantity, formula: Formula | None) -> tuple[str, ...]:
    """Return the columns that a quantity is found with, that it is chosen from first.

    Args:
        quantity: its declaration.
        formula: that is its reference.
    """
    choice = quantity.choice
    if choice is None:
        told = (quantity.read_from,) if quantity.read_from else ()
        return (*columns_of_formula(formula), *told)
    read = (*columns_of_formula(formula), *columns_of_formula(choice.condition))
    return tuple(dict.fromkeys((choice.column, *choice.also, *read)))


def shown_columns(catalogue: Catalogue) -> tuple[str, ...]:
    """Return the columns of a catalogue that students see: the only one, or all with a heading."""
    only = len(catalogue.columns) == 1
    return tuple(name for name in catalogue.columns if only or name in catalogue.headings)


def check_titles(course: Course) -> Iterator[Problem]:
    """Yield a problem for each catalogue or column that students need and that has no name."""
    read = {
        column
        for quantity in course.declarations()
        for column in columns_read(quantity, quantity.formula)
    }
    for catalogue in course.catalogues.values():
        needed = [name for name in catalogue.columns if f"{catalogue.id}.{name}" in read]
        if not needed:
            continue
        if catalogue.title is None:
            what = message("Students need this series, but it has no title to be printed under.")
            yield Problem(catalogue.file, "title", what, _write("title"))
        shown = shown_columns(catalogue)
        for name in dict.fromkeys((next(iter(catalogue.columns)), *needed)):
            if name not in shown:
                key = f"column.{name}"
                what = message("Students need this column, but it has no heading to be printed.")
                yield Problem(catalogue.file, key, what, _write(key))


def _write(key: str) -> Message:
    return message("Write a line '# {name}: …' on top.", name=key)
