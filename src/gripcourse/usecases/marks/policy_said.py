"""What changed in a policy, in sentences for instructors: a few lines, however much it was."""

from collections.abc import Iterable, Sequence
from typing import Final

from gripcourse.gradebook.policy_changes import PolicyLine
from gripcourse.text.words import Message, counted, message
from gripcourse.usecases.marks.kept_policies import PolicyChange

_LINES: Final = 10  # that are said of one policy; the others are counted
_SIGNS: Final = 60  # of a value
_BEFORE: Final = 15  # signs before the first one that differs, where a value is cut
_DIGITS: Final = 7  # of a fingerprint, as a history shows it


def policy_name(fingerprint: str) -> str:
    """Return what tells one policy from another: the first digits of its fingerprint."""
    return fingerprint[:_DIGITS]


def policy_change_said(change: PolicyChange) -> tuple[Message, ...]:
    """Say how a policy differs from today's: a heading, then its lines.

    Returns:
        Nothing where the policy was not kept.
    """
    if change.lines is None:
        return ()
    name = policy_name(change.fingerprint)
    if not change.lines:
        only = counted(
            "The policy {policy} of {count} work has changed since in comments, layout or order"
            " alone.",
            "The policy {policy} of {count} works has changed since in comments, layout or order"
            " alone.",
            change.works,
            policy=name,
        )
        return (only,)
    heading = counted(
        "The policy {policy} of {count} work has changed since:",
        "The policy {policy} of {count} works has changed since:",
        change.works,
        policy=name,
    )
    return heading, *lines_said(change.lines)


def lines_said(lines: Sequence[PolicyLine]) -> Iterable[Message]:
    """Say of each line what it was and is; of many the first ones, and how many more there are."""
    yield from map(_said, lines[:_LINES])
    if len(lines) > _LINES:
        yield message("and {count} more", count=len(lines) - _LINES)


def changed_since_said(event: Message, lines: Sequence[PolicyLine]) -> Message:
    """Say after what happened, in the same sentence, what had changed in the policy by then."""
    for number, line in enumerate(lines_said(lines)):
        if number == 0:
            event = message("{event} Changed in the policy: {line}", event=event, line=line)
        else:
            event = message("{event}; {line}", event=event, line=line)
    return event


def _said(line: PolicyLine) -> Message:
    if not line.key:
        return _of_file(line)
    before, after = _shortened(line.before or "", line.after or "")
    place = f"{line.file}: {line.key}"
    if line.before is None:
        return message("{place}: added {value}", place=place, value=after)
    if line.after is None:
        return message("{place}: removed {value}", place=place, value=before)
    return message("{place} {before} → {after}", place=place, before=before, after=after)


def _of_file(line: PolicyLine) -> Message:
    if line.before is None:
        return message("{file}: added", file=line.file)
    if line.after is None:
        return message("{file}: removed", file=line.file)
    return message("{file}: another one; the two cannot be compared", file=line.file)


def _shortened(before: str, after: str) -> list[str]:
    """Cut long values so that what differs stays to be seen."""
    pairs = enumerate(zip(before, after, strict=False))
    differs = next((place for place, (one, other) in pairs if one != other), 0)
    is_long = max(len(before), len(after)) > _SIGNS
    begin = max(0, differs - _BEFORE) if is_long else 0
    return [_cut(one, begin) for one in (before, after)]


def _cut(value: str, begin: int) -> str:
    end = begin + _SIGNS
    return f"{'…' if begin else ''}{value[begin:end]}{'…' if value[end:] else ''}"
