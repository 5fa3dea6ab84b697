"""What is printed of regrades, of what students were told, and of a student's history."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.cli.file_names import told_apart
from gripcourse.cli.table_layout import table_text
from gripcourse.cli.text import misuse
from gripcourse.text.shown import shown
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, Words, counted, message

# `gripcourse --help` needs nothing of what is graded.
# ruff: noqa: PLC0415

if TYPE_CHECKING:
    from gripcourse.batch.context import GradingContext
    from gripcourse.gradebook.journal import Published, Regrade
    from gripcourse.gradebook.model import Attempt
    from gripcourse.gradebook.regrade import Shift, WorkChange
    from gripcourse.gradebook.results import Result
    from gripcourse.usecases.marks.history import Event
    from gripcourse.usecases.marks.regrade import Regrading

_NAMED = 10  # files or works that a line names
_HEADS = (
    message("student"),
    message("file"),
    message("points"),
    message("new points"),
    message("changed since"),
)
_VERSIONS = {
    "engine": message("the program"),
    "version": message("the version"),
    "course": message("the course"),
    "policy": message("the policy"),
}


def chosen_direction(written: str | None) -> "Shift | None":
    """Read which works are to be shown; None for all that change.

    Raises:
        UsageError: there is no such filter.
    """
    from gripcourse.gradebook.regrade import Shift

    if written is None or written in list(Shift):
        return None if written is None else Shift(written)
    what = message("There is no filter '{name}'.", name=written)
    raise misuse(what, did_you_mean(written, list(Shift)))


def regrade_text(
    found: "Regrading", only: "Shift | None", context: "GradingContext", words: Words
) -> str:
    """Return what changed in the policy, the points of each work and item, and the counts.

    Args:
        found: what a regrade comes to.
        only: which works are shown; None for all that change.
        context: the course and its register, which know names and titles.
        words: of the reader.
    """
    from gripcourse.gradebook.regrade import Shift

    asked = found.to_apply if only is None else found.going(only)
    lines = list(_policies(found, words))
    called = told_apart([one.work.attempt.file for one in asked])
    if asked:
        heads = [words.say(one) for one in _HEADS]
        several = len(found.policies) > 1
        rows = [_row(one, called, context, words, named=several) for one in asked]
        lines.append(table_text(heads, rows, right={2, 3}))
    works = Counter(one.work.student for one in asked)
    for one in asked:
        file = called(one.work.attempt.file) if works[one.work.student] > 1 else ""
        lines += _items(one, file, context, words)
    counts = {one: len(found.going(one)) for one in Shift}
    lines.append(
        words.say(
            message(
                "{raised} raised, {lowered} lowered, {unchanged} unchanged.",
                raised=counts[Shift.RAISED],
                lowered=counts[Shift.LOWERED],
                unchanged=counts[Shift.UNCHANGED],
            )
        )
    )
    lines += _left_out(found, context, words)
    return "\n".join(lines)


def applied_text(done: Sequence["Attempt"], words: Words) -> str:
    """Return what stands since a regrade was applied."""
    if not done:
        return words.say(message("Nothing was changed: all of it is already so."))
    said = counted(
        "Regrade {number} was applied to {count} work. Grade again to renew the reports.",
        "Regrade {number} was applied to {count} works. Grade again to renew the reports.",
        len(done),
        number=done[0].regrade or 0,
    )
    return words.say(said)


def undone_text(done: "Regrade", words: Words) -> str:
    """Return what was taken back."""
    said = message("Regrade {number} was taken back.", number=done.undoes or 0)
    return f"{words.say(said)} {words.say(message('Grade again to renew the reports.'))}"


def published_text(told: Sequence["Published"], words: Words) -> str:
    """Return how many results are published now."""
    if not told:
        return words.say(message("Exactly this has been published to everybody already."))
    return words.say(
        counted(
            "{count} result is published; only a regrade changes it from now on. Nobody was shown"
            " anything.",
            "{count} results are published; only a regrade changes them from now on. Nobody was"
            " shown anything.",
            len(told),
        )
    )


def history_text(events: Sequence["Event"], words: Words) -> str:
    """Return a student's history as lines: when, by whom, what, why."""
    if not events:
        return words.say(message("Nothing has happened yet."))
    lines = []
    for one in events:
        # Moments are kept and shown in UTC: a history is read in more than one place.
        when = f"{one.at:%Y-%m-%d %H:%M}Z"
        who = shown(one.person) or words.say(message("the program"))
        why = f" — {shown(one.why)}" if one.why else ""
        lines.append(f"{when}  {who}: {words.say(one.what)}{why}")
    return "\n".join(lines)


def _policies(found: "Regrading", words: Words) -> Iterator[str]:
    """Yield what differs in each earlier policy, the lines below their heading."""
    from gripcourse.usecases.marks.policy_said import policy_change_said

    for change in found.policies:
        for number, said in enumerate(policy_change_said(change)):
            yield f"{'  ' if number else ''}{words.say(said)}"


def _row(
    one: "WorkChange",
    called: Callable[[str], str],
    context: "GradingContext",
    words: Words,
    *,
    named: bool,
) -> tuple[str, ...]:
    """Return the line of a work; `named` tells which of several policies it was graded by."""
    from gripcourse.usecases.marks.called import student_with_id
    from gripcourse.usecases.marks.policy_said import policy_name

    policy = policy_name(one.work.attempt.fingerprints.policy) if named else ""
    changed = ", ".join(
        f"{words.say(_VERSIONS[version])} {policy if version == 'policy' else ''}".rstrip()
        for version in one.versions
    )
    return (
        student_with_id(one.work.student, context),
        called(one.work.attempt.file),
        words.number(one.before.score, 4),
        words.number(one.after.score, 4),
        changed or "—",
    )


def _items(
    change: "WorkChange", file: str, context: "GradingContext", words: Words
) -> Iterator[str]:
    """Yield what changed about each item; `file` tells works of one student apart."""
    from gripcourse.usecases.marks.called import item_with_id, student_with_id

    student = change.work.student
    for one in change.items:
        said = message(
            "{student}, {item}: {before} → {after}.",
            student=", ".join(filter(None, (student_with_id(student, context), file))),
            item=item_with_id(student, one.quantity, context, words.language),
            before=_result(one.before),
            after=_result(one.after),
        )
        yield words.say(said)


def _result(result: "Result | None") -> Message:
    if result is None:
        return message("not asked for")
    return message(
        "{outcome}, {points} of {most}",
        outcome=result.outcome.traits.word,
        points=round(result.points, 2),
        most=round(result.max_points, 2),
    )


def _left_out(found: "Regrading", context: "GradingContext", words: Words) -> Iterator[str]:
    from gripcourse.usecases.marks.called import student_with_id

    kinds = (
        (
            message("Cannot be judged any more; what was graded stands: {names}."),
            [student_with_id(one.work.student, context) for one in found.lost],
        ),
        (
            message("The gradebook does not know these files; grade them first: {names}."),
            [shown(Path(one).name) for one in found.strangers],
        ),
        (
            message("Could not be graded: {names}."),
            [shown(Path(one).name) for one in found.failed],
        ),
        (
            message("Graded before and not among these files: {names}."),
            [
                f"{student_with_id(one.student, context)}: {shown(Path(one.attempt.file).name)}"
                for one in found.missing
            ],
        ),
    )
    for said, names in kinds:
        if names:
            more = f", … ({len(names)})" if len(names) > _NAMED else ""
            yield words.say(replace(said, values={"names": ", ".join(names[:_NAMED]) + more}))
