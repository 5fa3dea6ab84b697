"""Notes of a course: sentences that its documents print, in the author's own words.

What a student of one subject must be told ("the force is that of one belt") means nothing in
another; so it stands in `course.toml`, with where it is to be read.
"""

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from gripcourse.course.shape import Shape, strings, texts
from gripcourse.course.toml_table import Table
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Texts, message


class NotedDocument(StrEnum):
    """A document that prints notes."""

    ASSIGNMENT = "assignment"  # among the rules of an assignment sheet
    REPORT = "report"  # below a student's report


NOTE: Final = Shape(
    {
        "documents": strings("Where it is printed; everywhere where not written.", *NotedDocument),
        "schemes": strings("Ids of the schemes that it concerns; all where not written."),
        "quantities": strings("It is printed for variants with one of these; else always."),
        "text": texts("The sentence.", required=True),
    }
)


@dataclass(frozen=True, slots=True)
class CourseNote:
    """A sentence of the course's own.

    Attributes:
        documents: where it is printed.
        schemes: ids of the schemes that it concerns; empty for all.
        quantities: it is printed where the student's variant has one of these; empty for always.
        text: in every language.
        key: where it is declared, for messages.
    """

    documents: tuple[NotedDocument, ...]
    schemes: tuple[str, ...]
    quantities: tuple[str, ...]
    text: Texts
    key: str


def read_notes(table: Table) -> tuple[CourseNote, ...]:
    """Read the `[[note]]` tables of a course; a course may have none."""
    return tuple(_note(one) for one in table.tables("note"))


def notes_of(
    notes: Iterable[CourseNote], document: NotedDocument, scheme: str, quantities: Collection[str]
) -> Iterator[Texts]:
    """Yield the texts that a document prints for a variant of a scheme with these quantities."""
    for note in notes:
        concerned = not note.quantities or any(one in quantities for one in note.quantities)
        if document in note.documents and concerned and scheme in (note.schemes or (scheme,)):
            yield note.text


def _note(table: Table) -> CourseNote:
    table.known_keys()
    return CourseNote(
        documents=tuple(_documents(table)),
        schemes=table.strings("schemes"),
        quantities=table.strings("quantities"),
        text=table.texts("text"),
        key=table.key,
    )


def _documents(table: Table) -> Iterator[NotedDocument]:
    """Read where a note is printed; everywhere where that is not written."""
    if not table.has("documents"):
        yield from NotedDocument
    for written in table.strings("documents"):
        if written in list(NotedDocument):
            yield NotedDocument(written)
        else:
            what = message("Notes are not printed in '{document}'.", document=written)
            table.add("documents", what, did_you_mean(written, list(NotedDocument)))
