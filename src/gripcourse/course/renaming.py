"""What an author of a course that was written for an earlier program is told of a key or a word."""

from typing import Final

from gripcourse.errors import NextStep, Problem
from gripcourse.text.words import Message, message

WAS_READ: Final = message("Earlier versions of the program read this key.")


def renaming(file: str, key: str, what: Message, now: str) -> Problem:
    """Say what is written now in place of a key or a word; nothing where `now` is empty."""
    remedy = message("Remove it: nothing is needed in its place.")
    if now:
        remedy = message("It is called '{name}' now: rename it.", name=now)
    return Problem(file, key, what, remedy, step=NextStep.RENEW)
