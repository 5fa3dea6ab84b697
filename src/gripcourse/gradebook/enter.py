"""From what a person wants to enter to a mark: everything that is wrong with it, or the mark."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime

from gripcourse.errors import NextStep
from gripcourse.gradebook.model import Attempt, GradebookEntry, Mark
from gripcourse.gradebook.results import Result
from gripcourse.policy.rubric import Rubric, RubricLine
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message

_SAME = 1e-9  # 0.5 of a table and 0.5 of a level
_ROUNDED = 0.005  # documents print points with two decimals, and people type what they read


@dataclass(frozen=True, slots=True)
class Draft:
    """What a person typed about one item.

    Attributes:
        student, quantity: ids.
        lines: share of its points that each line of the rubric earns, by line id.
        points: of the item, instead of what the lines add up to; None for none.
        credit: share of the item's points, where there is no rubric; None for none.
        comment: for the student.
        override: whether the automatic result is to be overruled.
        withdraw: whether the person's marks of this item are to count no longer.
    """

    student: str
    quantity: str
    lines: Mapping[str, float]
    points: float | None = None
    credit: float | None = None
    comment: str = ""
    override: bool = False
    withdraw: bool = False


@dataclass(frozen=True, slots=True)
class Standing:
    """What the gradebook and the course say about a draft's student.

    Attributes:
        known: students of the register and of the gradebook.
        attempt: the student's last attempt that was judged; None for none.
        marked: the marks of the student that count, by quantity.
        rubrics: of the student's manual items, by quantity.
    """

    known: frozenset[str]
    attempt: Attempt | None
    marked: Mapping[str, GradebookEntry]
    rubrics: Mapping[str, Rubric]


@dataclass(frozen=True, slots=True)
class EntryFault:
    """What is wrong with a draft.

    Attributes:
        field: of the draft; a line of the rubric as `line:sizes`.
        what: is wrong.
        remedy: how to correct it.
        step: what of this program mends it; None for nothing.
    """

    field: str
    what: Message
    remedy: Message
    step: NextStep | None = None


def mark_of(
    draft: Draft, standing: Standing, marker: str, now: datetime
) -> tuple[Mark | None, tuple[EntryFault, ...]]:
    """Make a mark of a draft.

    Args:
        draft: what was typed.
        standing: of its student.
        marker: who decides.
        now: when.

    Returns:
        The mark, to be numbered by the gradebook; or None and all that is wrong.
    """
    attempt = standing.attempt
    if attempt is None:
        return None, (_not_graded(draft, standing),)
    result = attempt.by_quantity.get(draft.quantity)
    if result is None:
        return None, (_no_item(draft, attempt),)
    rubric = standing.rubrics.get(draft.quantity) if result.outcome.traits.by_rubric else None
    faults = tuple(_faults(draft, standing, result, attempt, rubric))
    if faults:
        return None, faults
    mark = Mark(
        student=draft.student,
        quantity=draft.quantity,
        number=0,
        attempt=attempt.number,
        credit=_credit(draft, result, rubric),
        lines=dict(draft.lines),
        marker=marker,
        marked_at=now,
        comment=draft.comment,
        kept_as=attempt.kept_as,
    )
    return mark, ()


def _credit(draft: Draft, result: Result, rubric: Rubric | None) -> float | None:
    if draft.withdraw:
        return None
    if draft.points is not None:
        return min(draft.points / result.max_points, 1.0) if result.max_points else 0.0
    if rubric is not None and draft.lines:
        return min(rubric.credit(draft.lines), 1.0)  # shares may add up to a bit more in binary
    return draft.credit


def _not_graded(draft: Draft, standing: Standing) -> EntryFault:
    if draft.student in standing.known:
        return EntryFault(
            "student",
            message("No file of {student} has been graded yet.", student=draft.student),
            message("Grade it first."),
            NextStep.GRADE,
        )
    return EntryFault(
        "student",
        message("The register has no student '{student}'.", student=draft.student),
        did_you_mean(draft.student, standing.known),
    )


def _no_item(draft: Draft, attempt: Attempt) -> EntryFault:
    waiting = _waiting(attempt)
    return EntryFault(
        "quantity",
        message(
            "The assignment of {student} has no item '{quantity}'.",
            student=draft.student,
            quantity=draft.quantity,
        ),
        message("Items that the instructor marks: {names}.", names=", ".join(waiting))
        if waiting
        else did_you_mean(draft.quantity, attempt.by_quantity),
    )


def _waiting(attempt: Attempt) -> list[str]:
    return [one.quantity for one in attempt.results if one.outcome.traits.waits]


def _faults(
    draft: Draft, standing: Standing, result: Result, attempt: Attempt, rubric: Rubric | None
) -> Iterator[EntryFault]:
    if draft.withdraw:
        yield from _faults_of_withdrawal(draft, standing)
        return
    if not result.outcome.traits.waits and not draft.override:
        yield EntryFault(
            "quantity",
            message("'{quantity}' was judged automatically.", quantity=draft.quantity),
            message(
                "Items that the instructor marks: {names}. To overrule the automatic result say "
                "so, with a comment.",
                names=", ".join(_waiting(attempt)) or "—",
            ),
            NextStep.OVERRULE,
        )
    if not result.outcome.traits.by_rubric and not draft.comment.strip():
        yield EntryFault(
            "comment",
            message("A decision that is not by a rubric needs a comment."),
            message("Say for the student why."),
        )
    yield from _faults_of_amount(draft, result, rubric)
    yield from _faults_of_lines(draft, rubric)


def _faults_of_withdrawal(draft: Draft, standing: Standing) -> Iterator[EntryFault]:
    if draft.quantity not in standing.marked:
        yield EntryFault(
            "withdraw",
            message("There is no mark of '{quantity}' that counts.", quantity=draft.quantity),
            message("Leave it: the automatic result counts already."),
        )
    if draft.lines or draft.points is not None or draft.credit is not None:
        yield EntryFault(
            "withdraw",
            message("A mark is either entered or withdrawn."),
            message("Leave out the points, or do not withdraw it."),
            NextStep.LEAVE_WITHDRAWAL,
        )
    if not draft.comment.strip():
        yield EntryFault(
            "comment",
            message("A withdrawal needs a comment."),
            message("Say why the mark counts no longer."),
        )


def _faults_of_amount(draft: Draft, result: Result, rubric: Rubric | None) -> Iterator[EntryFault]:
    if draft.credit is not None and not _is_share(draft.credit):
        yield _no_share("credit", draft.credit)
    points, most = draft.points, result.max_points + _ROUNDED
    if points is not None and not (math.isfinite(points) and 0 <= points <= most):
        yield EntryFault(
            "points",
            message("The item cannot have so many points: {points}.", points=points),
            message("Write a number from 0 to {most}.", most=result.max_points),
        )
    if draft.credit is not None and (points is not None or draft.lines):
        yield EntryFault(
            "credit",
            message("The share of the points is given twice."),
            message("Leave it out beside lines or points."),
        )
    if draft.credit is None and points is None and not draft.lines:
        yield EntryFault(
            "points",
            message("No points are given."),
            message("Give a share from 0 to 1 for each line: {names}.", names=_names(rubric))
            if rubric
            else message("Give points, or a share of them from 0 to 1 as credit."),
        )


def _faults_of_lines(draft: Draft, rubric: Rubric | None) -> Iterator[EntryFault]:
    lines = rubric.by_id if rubric else {}
    for name, credit in draft.lines.items():
        if rubric is None:
            yield EntryFault(
                f"line:{name}",
                message("'{quantity}' is not marked from a rubric.", quantity=draft.quantity),
                message("Give points, or a share of them from 0 to 1 as credit."),
            )
        elif name not in lines:
            yield EntryFault(
                f"line:{name}",
                message("The rubric has no line '{line}'.", line=name),
                did_you_mean(name, lines),
            )
        elif not _is_share(credit):
            yield _no_share(f"line:{name}", credit)
        else:
            yield from _faults_of_level(lines[name], credit)
    missing = [name for name in lines if name not in draft.lines]
    if draft.lines and missing and rubric is not None:
        yield EntryFault(
            f"line:{missing[0]}",
            message("Lines of the rubric are missing: {names}.", names=", ".join(missing)),
            message("Give each line a share; 0 where it earns nothing."),
        )


def _faults_of_level(line: RubricLine, credit: float) -> Iterator[EntryFault]:
    levels = [level.credit for level in line.levels]
    if levels and not any(math.isclose(credit, one, abs_tol=_SAME) for one in levels):
        yield EntryFault(
            f"line:{line.id}",
            message("The line '{line}' has no level {value}.", line=line.id, value=credit),
            message("Its levels: {names}.", names="; ".join(f"{one:g}" for one in levels)),
        )


def _is_share(value: float) -> bool:
    return 0 <= value <= 1  # false for what is no number, too


def _no_share(field: str, value: float) -> EntryFault:
    return EntryFault(
        field,
        message("The share is {value}.", value=value),
        message("Write a number from 0 to 1."),
    )


def _names(rubric: Rubric) -> str:
    return ", ".join(line.id for line in rubric.lines)
