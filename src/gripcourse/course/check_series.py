"""Checking the series that design decisions are taken from."""

from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.formula.evaluate import Column
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.units import Dimension, dimension, known
from gripcourse.text.words import Message, message


def check_series(
    quantities: Iterable[Quantity],
    columns: Mapping[str, Column],
    column_dimensions: Mapping[str, tuple[Dimension, Dimension]],
) -> Iterator[Problem]:
    """Yield the problems of every series: it must exist, be sizes, and be what is decided.

    Of the tables that a computed quantity may be read from, those that there are not.
    """
    for one in quantities:
        if one.read_from and one.read_from not in columns:
            yield _unknown(one, f"quantity.{one.id}.read_from", one.read_from, columns)
        if one.choice is None:
            continue
        for key, name in (("series", one.choice.column), *(("also", n) for n in one.choice.also)):
            if not name:  # reported as missing
                continue
            place = f"quantity.{one.id}.{key}"
            if name not in columns:
                yield _unknown(one, place, name, columns)
            elif not _holds_sizes(columns[name]):
                yield Problem(one.file, place, _NO_SIZES, _TAKE_SIZES)
            elif known(one.unit) and column_dimensions[name][1] != dimension(one.unit):
                yield Problem(one.file, place, _OTHER_DIMENSION, _remedy(name))


def _unknown(one: Quantity, place: str, name: str, columns: Iterable[str]) -> Problem:
    what = message("There is no catalogue column '{name}'.", name=name)
    return Problem(one.file, place, what, did_you_mean(name, columns))


_NO_SIZES: Message = message("The column does not hold the sizes of its catalogue.")
_OTHER_DIMENSION: Message = message("The sizes do not measure what the quantity measures.")
_TAKE_SIZES: Message = message("Name the first column of a catalogue of such sizes.")


def _remedy(name: str) -> Message:
    catalogue, _, column = name.partition(".")
    return message(
        "Name the first column of a catalogue of such sizes, or write their unit behind the heading"
        " '{column}' of variants/catalogues/{catalogue}.csv, as in '{column} [mm]'.",
        catalogue=catalogue,
        column=column,
    )


def _holds_sizes(column: Column) -> bool:
    """Tell whether the column is the first one: an entry is found and judged by its size."""
    return np.array_equal(column.sizes, column.values)
