"""A person's word for who handed files in, where the program cannot tell."""

from collections.abc import Container, Iterable, Mapping, Sequence
from pathlib import PurePath
from types import MappingProxyType

from gripcourse.errors import Problem, UsageError
from gripcourse.machine.content import Readable, shown_name
from gripcourse.text.words import message

_NONE: Mapping[str, str] = MappingProxyType({})


def read_whose(
    written: Iterable[str],
    files: Sequence[Readable],
    students: Container[str],
    joined: Mapping[str, str] = _NONE,
) -> Mapping[str, str]:
    """Read decisions that are written as `file=student`.

    Args:
        written: the decisions; a file is named as it was found, or by the end of its path where
            only one file of the batch ends so.
        files: of the batch.
        students: ids of the register.
        joined: by id that was joined with another's, the id of the student.

    Returns:
        By the whole name of each file that is decided the id that is written, which tells the sheet
        as well.

    Raises:
        UsageError: with every decision that cannot be used.
    """
    names = [shown_name(file) for file in files]
    whole = frozenset(names)
    decided: dict[str, str] = {}
    problems: list[Problem] = []
    for one in written:
        # A file may hold an equals sign in its name, an id does not.
        file, _, student = (part.strip() for part in one.rpartition("="))
        found = [file] if file in whole else [name for name in names if _ends_so(name, file)]
        if not file or not student:
            what = message("'{text}' is no file with its student.", text=one)
        elif joined.get(student, student) not in students:
            what = message("The register has no student '{student}'.", student=student)
        elif len(found) != 1:
            what = message(
                "{count} files of the batch are called '{file}', not one.",
                count=len(found),
                file=file,
            )
        else:
            decided[found[0]] = student
            continue
        remedy = message("Write file=student, for example work/s002.xlsx=s003.")
        problems.append(Problem("", "", what, remedy, parameter="whose"))
    if problems:
        raise UsageError(problems)
    return decided


def _ends_so(name: str, end: str) -> bool:
    parts, last = PurePath(name).parts, PurePath(end).parts
    return name == end or (bool(last) and parts[-len(last) :] == last)
