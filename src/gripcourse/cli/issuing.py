"""What the two commands that issue have in common: a bar meanwhile, the text, the exit code."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import typer

from gripcourse.cli import text as cli_text
from gripcourse.cli.issuing_text import issuing_text, unissued_text
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import DONE, NEEDS_PERSON, say_limits
from gripcourse.text.words import Words, message

if TYPE_CHECKING:
    from gripcourse.usecases.issuing.issue import Issuing


class IssueAll(Protocol):
    """Issues to everybody who is to get something."""

    def __call__(
        self, *, on_counted: Callable[[int], None], on_done: Callable[[str], None]
    ) -> "Issuing":
        """Issue; `on_counted` is called first with how many there are, `on_done` with each."""


def issue_with_progress(issue_all: IssueAll, out: Path, words: Words) -> "Issuing":
    """Show a bar while documents are made, and say afterwards what was issued into a folder."""
    say_limits(words)
    with cli_text.progress(words) as step:
        ticks: list[Callable[[], None]] = []
        issuing = issue_all(
            on_counted=lambda total: ticks.append(step(words.say(message("Issuing")), total)),
            on_done=lambda _: ticks[0](),
        )
    confirm(issuing_text(issuing, out, words))
    unissued = unissued_text(issuing, words)
    if unissued:
        typer.echo(unissued)
    return issuing


def exit_code(issuing: "Issuing") -> int:
    """Tell a script whether a person has to look at documents that could not be made."""
    return NEEDS_PERSON if any(one.faults for one in issuing.handouts) else DONE
