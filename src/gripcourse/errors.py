"""What can go wrong, in three kinds that are never mixed.

    GripcourseError             the author's or the user's: a list of problems, each with its remedy
    ├── CourseError             a declaration, a catalogue or the policy of a course
    ├── TableError              a variant table or a roster
    ├── RegisterError           the register of issued variants, or its key
    ├── GradebookError          the gradebook of attempts and marks
    └── UsageError              a command called with something that cannot be used

A student's mistake is never an exception: it is a `Finding` or a `Rejected` file.
Our own mistake is any other exception; a batch records it as an incident and goes on.
"""

from collections.abc import Iterable
from dataclasses import dataclass

from gripcourse.words import Message, Words


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing that somebody has to mend.

    Attributes:
        file: the file it is in, as the user would type it.
        key: where in the file: `quantity.bore.formula`, `row 7, column mass`, or empty.
        what: what is wrong.
        remedy: how to mend it.
        excerpt: lines to show under the sentence, for example a formula with a caret.
    """

    file: str
    key: str
    what: Message
    remedy: Message
    excerpt: str = ""

    def say(self, words: Words) -> str:
        """Put the problem into words: place, fault, remedy, and the excerpt on lines below."""
        said = f"{words.say(self.what)} {words.say(self.remedy)}".strip()
        line = ": ".join(part for part in (self.file, self.key, said) if part)
        return f"{line}\n{self.excerpt}" if self.excerpt else line


class GripcourseError(Exception):
    """Something that the author of a course or the user of a command can mend."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(problem.say(Words("en")) for problem in self.problems))


class CourseError(GripcourseError):
    """A course cannot be used as it is written."""


class TableError(GripcourseError):
    """A variant table or a roster cannot be used as it is written."""


class RegisterError(GripcourseError):
    """The register of issued variants or its key cannot be used."""


class GradebookError(GripcourseError):
    """The gradebook cannot be read or written."""


class UsageError(GripcourseError):
    """A command was called with something that cannot be used."""
