"""What can go wrong, in three kinds that are never mixed.

    GripcourseError             the author's or the user's: a list of problems, each with its remedy
    ├── CourseError             a declaration, a catalogue or the policy of a course
    ├── TableError              a variant table or a roster
    ├── RegisterError           the register of issued variants, or its key
    ├── GradebookError          the gradebook of attempts and marks
    └── UsageError              the program called with something that cannot be used

A student's mistake is never an exception: it is a `Finding` or a `Rejected` file.
Our own mistake is any other exception; a batch records it as an incident and goes on.
"""

import errno
from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import Self

from gripcourse.text.shown import one_line, shown
from gripcourse.text.words import Message, Words, message


class NextStep(StrEnum):
    """What mends a problem, where that is done with this program and not in a file.

    The sentence of a remedy says it for everybody; a front end adds its own words for it: the
    command line the command or the option, a web page a button.
    """

    ALLOW_LOWER = "allow_lower"
    CHECK_MACHINE = "check_machine"
    GRADE = "grade"
    LEAVE_WITHDRAWAL = "leave_withdrawal"
    MAKE_COURSE = "make_course"
    NAME_COURSE = "name_course"
    NAME_GRADEBOOK = "name_gradebook"
    NAME_TABLE = "name_table"
    OVERRULE = "overrule"
    REGRADE = "regrade"
    RENEW = "renew"
    SET_VALUES = "set_values"
    SIMULATE = "simulate"


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing that somebody has to correct.

    Attributes:
        file: the file it is in, as the user would type it.
        key: where in the file: a key as it is written there, `quantity.mass.formula`, or a place
            that has no name there, `row 7, column mass`, as a message; or empty.
        what: what is wrong.
        remedy: how to correct it.
        excerpt: lines to show under the sentence, for example a formula with a caret.
        parameter: name of the library's parameter that was called with something unusable; a front
            end shows what it calls it. Empty for none.
        step: what of this program mends it; None for nothing.
    """

    file: str
    key: str | Message
    what: Message
    remedy: Message
    excerpt: str = ""
    parameter: str = ""
    step: NextStep | None = None

    def say(self, words: Words) -> str:
        """Put the problem into words: place, fault, remedy, and the excerpt on lines below."""
        said = f"{words.say(self.what)} {words.say(self.remedy)}".strip()
        key = self.key if isinstance(self.key, str) else words.say(self.key)
        places = (one_line(self.file), one_line(self.parameter), one_line(key))
        line = ": ".join(part for part in (*places, said) if part)
        return f"{line}\n{shown(self.excerpt)}" if self.excerpt else line


_SYSTEM = {
    errno.ENOENT: (
        message("There is no such file or folder."),
        message("Check the path."),
    ),
    errno.EEXIST: (
        message("This exists already."),
        message("Name another place."),
    ),
    errno.EISDIR: (
        message("This is a folder, not a file."),
        message("Name a file."),
    ),
    errno.ENOTDIR: (
        message("A part of this path is a file, not a folder."),
        message("Name another place."),
    ),
    errno.EACCES: (
        message("The system does not allow to read or write this."),
        message("Change the permissions, or name another place."),
    ),
    errno.EPERM: (
        message("The system does not allow to read or write this."),
        message("Change the permissions, or name another place."),
    ),
    errno.EROFS: (
        message("Nothing can be written to this disk."),
        message("Name another place."),
    ),
    errno.EFBIG: (
        message("The system does not allow files of this size."),
        message("Lift the limit (ulimit -f), or name another place."),
    ),
    errno.EMFILE: (
        message("More files are open at once than the system allows."),
        message("Lift the limit (ulimit -n), or take fewer workers."),
    ),
    errno.EDQUOT: (
        message("Your share of this disk is full."),
        message("Make room, or name another place."),
    ),
    errno.EPIPE: (
        message("The program that reads what is printed has ended."),
        message("Write into a file first."),
    ),
    errno.ELOOP: (
        message("This link leads to itself."),
        message("Check the path."),
    ),
    errno.ENAMETOOLONG: (
        message("This name is too long for the system."),
        message("Name another place."),
    ),
    errno.ENOSPC: (
        message("The disk is full."),
        message("Make room, or name another place."),
    ),
}


def system_problem(error: OSError) -> Problem:
    """Say what the system refuses; what is rare stays as the system says it."""
    if error.errno == errno.ENOENT and error.filename is None:
        # What misses something without a name is the search for the folder that a process is in,
        # or Python's for one of temporary files, which says where it looked.
        if "temporary" not in (error.strerror or ""):
            what = message("The folder that you are in is no longer there.")
            return Problem("", "", what, message("Change into another one."))
        what = message("Nothing can be written to any folder for temporary files.")
        remedy = message("Make room, lift the limit (ulimit -f), or name a folder in TMPDIR.")
        return Problem("", "", what, remedy)
    other = message("{reason}", reason=error.strerror or str(error))
    what, remedy = _SYSTEM.get(error.errno or 0, (other, message("Try again, or elsewhere.")))
    return Problem(str(error.filename or ""), "", what, remedy)


def memory_problem() -> Problem:
    """Say that the system gave less memory than the work takes."""
    what = message("There is too little memory for this.")
    remedy = message(
        "Lift the limits (ulimit -v, ulimit -u), end other programs, or take fewer workers."
    )
    return Problem("", "", what, remedy)


class GripcourseError(Exception):
    """Something that the author of a course or the user of a command can correct."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(problem.say(Words("en")) for problem in self.problems))

    def __reduce__(self) -> tuple[type[Self], tuple[tuple[Problem, ...]]]:
        # A worker sends it with its problems; an exception would send nothing but their text.
        return type(self), (self.problems,)


class CourseError(GripcourseError):
    """A course cannot be used as it is written."""


class TableError(GripcourseError):
    """A variant table or a roster cannot be used as it is written."""


class RegisterError(GripcourseError):
    """The register of issued variants or its key cannot be used."""


class GradebookError(GripcourseError):
    """The gradebook cannot be read or written."""


class SystemRefusedError(GripcourseError):
    """The system does not let something be read or written that the caller of the library named."""


class UsageError(GripcourseError):
    """The program was called with something that cannot be used."""
