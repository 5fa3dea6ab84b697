"""What a command that issues says at its end."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from gripcourse.text.shown import one_line, shown
from gripcourse.text.words import Message, Words, counted, message

if TYPE_CHECKING:
    from gripcourse.usecases.issuing.issue import Issuing


def issuing_text(issuing: "Issuing", out: Path, words: Words) -> str:
    """Return what was issued, and the notes."""
    whole = [one for one in issuing.handouts if not one.faults]
    said = counted(
        "{count} assignment is in {folder}.",
        "{count} assignments are in {folder}.",
        len(whole),
        folder=str(out),
    )
    lines = [words.say(said), *(words.say(note) for note in issuing.notes)]
    if issuing.outdated:
        typed = f"gripcourse reissue {' '.join(map(shown, issuing.outdated))} --why …"
        remedy = message("To issue the new numbers as a new version: {typed}", typed=typed)
        lines.append(words.say(remedy))
    lines += (words.say(one) for one in _withdrawals(issuing))
    return "\n".join(lines)


def _withdrawals(issuing: "Issuing") -> Iterator[Message]:
    """Say which commands tell the register what the list alone cannot tell."""
    new, gone = issuing.in_and_out
    if new:
        one, other = (shown(all_[0]) if len(all_) == 1 else "…" for all_ in (new, gone))
        typed = f"gripcourse withdraw {one} --same-as {other} --why …"
        yield message("To join two that are one person: {typed}", typed=typed)
        left = f"gripcourse withdraw {other} --why …"
        yield message("To note who has left the course: {typed}", typed=left)
    for student in issuing.left:
        typed = f"gripcourse withdraw {shown(student)} --undo --why …"
        yield message("Back again: {typed}, then issue again.", typed=typed)


def unissued_text(issuing: "Issuing", words: Words) -> str:
    """Return whose documents could not be made, and why; nobody may miss it, `--quiet` or not."""
    return "\n".join(
        f"{one_line(one.student)}: {words.say(fault)}"
        for one in issuing.handouts
        for fault in one.faults
    )
