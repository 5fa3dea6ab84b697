"""Answers found again by the titles in their rows, where rows were sorted or inserted.

Names travel with their cells only while a spreadsheet program moves both. Whoever sorts rows,
inserts one or renames a sheet with a program that leaves names where they were, has right numbers
in cells that no name points to.
"""

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.submission.raw import RawCell, RawWorkbook
from gripcourse.text.words import LANGUAGES

_ON_THE_LINE: Final = str.maketrans("₀₁₂₃₄₅₆₇₈₉₊₋", "0123456789+-", "_")
_KEPT: Final = 1 << 13  # titles: all workbooks of a course have the same


@dataclass(frozen=True, slots=True)
class Relabelled:
    """Answer cells by quantity, and which of them stand elsewhere than their names say."""

    answers: Mapping[str, RawCell]
    moved: tuple[str, ...]


def by_label(raw: RawWorkbook, quantities: Iterable[Quantity]) -> Relabelled:
    """Take each answer from the row with its quantity's title.

    Only where the titles of several rows have changed places, or a title stands once in a row that
    no name points to: a title that somebody rewrote moves nothing.

    Args:
        raw: what stands in the file.
        quantities: that are answered.
    """
    titles = {one.id: {_plain(one.title.of(lang)) for lang in LANGUAGES} for one in quantities}
    rows: dict[str, list[RawCell]] = defaultdict(list)
    for cell in (*raw.answers.values(), *raw.beside):
        if cell.label:
            rows[_plain(cell.label)].append(cell)
    answers, moved = dict(raw.answers), []
    named = {_sheet_of(cell) for cell in raw.answers.values()}
    for name, known in titles.items():
        own = raw.answers.get(name)
        if own is not None and _stands(own, known):
            continue
        found = [one for title in sorted(known) for one in rows.get(title, ())]
        if own is None:  # removed, unless something stands there or its sheet bears another name
            found = [one for one in found if one.is_filled or _sheet_of(one) not in named]
        if len(found) == 1:
            answers[name] = found[0]
            moved.append(name)
    return Relabelled(answers, tuple(moved))


def _sheet_of(cell: RawCell) -> str:
    return cell.cell.rpartition("!")[0]


def _stands(cell: RawCell, titles: Collection[str]) -> bool:
    """Tell whether an answer is where its name says: beside its title, or beside none at all."""
    is_unlabelled = not cell.label and cell.is_filled
    return is_unlabelled or _plain(cell.label) in titles


@lru_cache(maxsize=_KEPT)
def _plain(text: str) -> str:
    """Bare a title of its looks; where a subscript stands below the line there is no `_`."""
    return " ".join(text.translate(_ON_THE_LINE).split()).casefold()
