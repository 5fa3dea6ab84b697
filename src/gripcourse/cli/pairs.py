"""What is typed as `name=value` on the command line."""

from collections.abc import Iterable

from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import Message, message


def read_pairs(option: str, written: Iterable[str], remedy: Message) -> list[tuple[str, str]]:
    """Split `name=value` texts.

    Args:
        option: behind which they stand.
        written: as they are typed.
        remedy: how they are written.

    Raises:
        UsageError: with every text that has no equals sign.
    """
    split = [(one, *one.partition("=")) for one in written]
    problems = [
        Problem("", option, message("'{setting}' has no equals sign.", setting=one), remedy)
        for one, _, equals, _ in split
        if not equals
    ]
    if problems:
        raise UsageError(problems)
    return [(name.strip(), value.strip()) for _, name, _, value in split]


def read_lines(written: Iterable[str]) -> dict[str, float]:
    """Read what lines of a rubric earn, `id=share`.

    Raises:
        UsageError: with all that cannot be read.
    """
    from gripcourse.variants.cells import exact_number  # noqa: PLC0415 (not for --help)

    lines: dict[str, float] = {}
    problems: list[Problem] = []
    for one in written:
        typed, _, share = one.partition("=")
        name, value = typed.strip(), exact_number(share.strip(), decimal_comma=True)
        if value is None or not name or name in lines:
            what = message("'{text}' is no line with its share.", text=one)
            remedy = message("Write each line once, for example --line sizes=0.5.")
            problems.append(Problem("", "--line", what, remedy))
            continue
        lines[name] = value
    if problems:
        raise UsageError(problems)
    return lines
