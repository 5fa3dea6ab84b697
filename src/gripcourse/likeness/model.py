"""What was handed in, as the search for likeness sees it, and what it finds."""

from dataclasses import dataclass
from enum import StrEnum

from gripcourse.likeness.typed_numbers import TypedNumbers


class NumberKind(StrEnum):
    """What is alike; the codes of the flags."""

    OTHER_VARIANT = "other_variant"  # answers or given values are those of another's variant
    SAME_ANSWERS = "same_answers"  # answers equal what another student typed
    COPIED_FROM = "copied_from"  # others typed this student's own numbers
    SAME_CREATOR = "same_creator"  # the workbooks name the same author


@dataclass(frozen=True, slots=True)
class ComparedWork:
    """One submission.

    Attributes:
        student: id of who handed it in.
        numbers: answers, and the given values that differ from the issued ones.
        creator: the author that the workbook names; empty for none, or for who issued it.
        version: which of the student's rows of issued values it was judged by, counted from 0.
    """

    student: str
    numbers: TypedNumbers
    creator: str
    version: int = 0


@dataclass(frozen=True, slots=True)
class Evidence:
    """A likeness that chance explains badly.

    Attributes:
        kind: what is alike.
        students: whose submission it is, then whose variant or answers it is like.
        odds: how many times likelier copying makes it than chance, divided by the number of
            comparisons in which chance could have done it.
        rests_on: ids of the quantities, the strongest first; the author's name for a creator.
        row: of the issued values that the submission is like; None where it is like no variant.
    """

    kind: NumberKind
    students: tuple[str, ...]
    odds: float
    rests_on: tuple[str, ...]
    row: int | None = None


@dataclass(frozen=True, slots=True)
class Chances:
    """What counts as coincidence: probabilities of a number that the student's own do not explain.

    Attributes:
        least: that it equals a certain other one, at least: nobody knows chance better than this.
        discrete: likewise for a size from a series or a table.
        shared: likewise where both students have the same right value: the same wrong method gives
            the same wrong value.
        slip: that it comes from the method that was recognised in it, at least.
        moved: relative; how far taken numbers may lie from the right ones: as rounding on the way
            moves them, and as far as somebody moves them who hides where they come from.
        typed: likewise from what another student typed.
    """

    least: float = 0.002
    discrete: float = 0.1
    shared: float = 0.1
    slip: float = 0.05
    moved: tuple[float, ...] = (0.002, 0.011)
    typed: tuple[float, ...] = (0.0, 0.011)
