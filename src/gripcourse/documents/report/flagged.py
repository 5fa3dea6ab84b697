"""What somebody should look at before marks are published, in an instructor's words."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import Final

from gripcourse.course.quantity import Quantity
from gripcourse.grading.model import Report
from gripcourse.text.words import Message, Words, message

_NAMED: Final = 4  # quantities that a likeness rests on; `grades.json` has more of them


@dataclass(frozen=True, slots=True)
class FlaggedFile:
    """A file that somebody should look at, and why."""

    name: str
    file: str
    sentences: tuple[str, ...]


def flagged_files(
    reports: Sequence[Report], declared: Mapping[str, Quantity], words: Words
) -> list[FlaggedFile]:
    """Return the files with flags, in the order of the reports.

    Args:
        reports: of the cohort.
        declared: the quantities by id.
        words: the reader's language.
    """
    return [
        FlaggedFile(
            name=report.name or report.student or "—",
            file=PurePath(report.file).name,
            sentences=tuple(
                words.say(_titled(flag.message, declared, words)) for flag in report.flags
            ),
        )
        for report in reports
        if report.flags
    ]


def _titled(said: Message, declared: Mapping[str, Quantity], words: Words) -> Message:
    """Name the quantities that a message lists by their ids, the first few of them."""
    values = dict(said.values)
    for place, value in said.values.items():
        count = 0
        listed = value
        if isinstance(value, Message) and "names" in value.values:
            listed, more = value.values["names"], value.values.get("count", 0)
            count = more if isinstance(more, int) else 0
        ids = listed.split(", ") if isinstance(listed, str) else []
        if ids and all(id_ in declared for id_ in ids):
            values[place] = _named(ids, count, declared, words)
    return replace(said, values=values)


def _named(
    ids: Sequence[str], more: int, declared: Mapping[str, Quantity], words: Words
) -> Message:
    names = "; ".join(declared[id_].title.of(words.language) for id_ in ids[:_NAMED])
    count = more + len(ids[_NAMED:])
    if not count:
        return message("{names}", names=names)
    return message("{names} and {count} more", names=names, count=count)
