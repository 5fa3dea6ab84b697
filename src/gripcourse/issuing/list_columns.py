"""Columns of a list of people that offices and platforms write in more than one way.

A heading may stand over the surname, with first name and patronymic below nothing beside it; two
columns may be called alike, as the login and the number of a platform.
"""

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from gripcourse.text.spelling import plain
from gripcourse.text.words import Message, message
from gripcourse.variants.headings import Vocabulary, column_of, declared_names
from gripcourse.variants.sheet import Sheet, SheetRow, column_name

_MOST_BESIDE: Final = 3  # columns that a heading of names stands over besides its own
_WHOLE_NAMES: Final = frozenset({"name"})
_TELLS_APART: Final = "student"


def with_whole_names(sheet: Sheet, vocabulary: Vocabulary) -> Sheet:
    """Write names that stand in several columns under one heading into one column.

    So a heading that is merged over surname, first name and patronymic comes out. A note says how
    many columns it was. Remarks beside whole names are no part of them.
    """
    heads = declared_names("people").keys()
    for at, heading in enumerate(sheet.header):
        if not (vocabulary.find(heading) == _WHOLE_NAMES or plain(heading) in heads):
            continue
        beside = _parts_beside(sheet, at)
        if beside:
            return _joined(sheet, at, beside)
    return sheet


def _parts_beside(sheet: Sheet, at: int) -> int:
    """Return in how many columns without headings, right of one of names, these go on."""
    count = 0
    for place in range(at + 1, min(at + 1 + _MOST_BESIDE, len(sheet.header))):
        if sheet.header[place]:
            break
        both = [(row.cells[at], row.cells[place]) for row in sheet.rows if row.cells[place]]
        parts = sum(_is_word(one) and _is_word(other) for one, other in both)
        if not both or 2 * parts <= len(both):
            break
        count += 1
    return count


def _is_word(text: str) -> bool:
    """Tell whether a text may be a surname or a first name, and is no mark such as `+` or `н`."""
    return len(text) > 1 and " " not in text and text[0].isalpha() and not any(
        sign.isdigit() for sign in text
    )  # fmt: skip


def _joined(sheet: Sheet, at: int, beside: int) -> Sheet:
    end = at + 1 + beside

    def row_of(row: SheetRow) -> SheetRow:
        # A merged row shows one text in each of its cells.
        name = " ".join(dict.fromkeys(filter(None, row.cells[at:end])))
        return replace(row, cells=(*row.cells[:at], name, *row.cells[end:]))

    said = message(
        "{file}: the names under '{heading}' stand in {count} columns and were put together.",
        file=sheet.file,
        heading=sheet.header[at],
        count=1 + beside,
    )
    header = (*sheet.header[: at + 1], *sheet.header[end:])
    rows = tuple(map(row_of, sheet.rows))
    return replace(sheet, header=header, rows=rows, notes=(*sheet.notes, said))


def without_doubles(sheet: Sheet, vocabulary: Vocabulary) -> tuple[Sheet, tuple[Message, ...]]:
    """Leave out what is called as another column; a note says which of the two counts.

    Of ids those that tell everybody apart count, of anything else what is filled in most often; of
    equals the first.
    """
    called: dict[str, list[int]] = defaultdict(list)
    for place, heading in enumerate(sheet.header):
        ids = column_of(heading, vocabulary)
        if len(ids) == 1:
            called[next(iter(ids))].append(place)
    left: set[int] = set()
    notes: list[Message] = []
    for id_, places in called.items():
        if len(places) == 1:
            continue
        used = max(places, key=lambda place: _worth(sheet.rows, id_, place))
        others = [place for place in places if place != used]
        left.update(others)
        notes.append(
            message(
                "{file}: several columns may be '{column}': '{used}' was used, and not {others}.",
                file=sheet.file,
                column=id_,
                used=column_name(used, sheet.header),
                others=", ".join(f"'{column_name(one, sheet.header)}'" for one in others),
            )
        )
    if not left:
        return sheet, ()
    kept = [place for place in range(len(sheet.header)) if place not in left]
    rows = (SheetRow(row.number, tuple(row.cells[at] for at in kept)) for row in sheet.rows)
    header = tuple(sheet.header[at] for at in kept)
    return replace(sheet, header=header, rows=tuple(rows)), tuple(notes)


def _worth(rows: Sequence[SheetRow], id_: str, place: int) -> tuple[int, int]:
    """Return how much a column tells, and that the first of equals goes before."""
    filled = Counter(row.cells[place].casefold() for row in rows if row.cells[place])
    return (len(filled) if id_ == _TELLS_APART else filled.total(), -place)
