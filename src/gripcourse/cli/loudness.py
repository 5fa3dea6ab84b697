"""How much the command line says: `--quiet` and `--verbose`, in every command, and its streams."""

import logging
import os
import sys
from functools import lru_cache
from io import TextIOWrapper
from typing import TYPE_CHECKING, Annotated

import typer

from gripcourse.machine.file_limits import largest_file

if TYPE_CHECKING:
    # The library gives this type no public name.
    from typer._click import Parameter

_ERROR_STREAM = 2  # number of its file
_LARGEST_MODULE = 4_000_000  # bytes, more than any compiled module has

_FLAGS = {"--quiet": "q", "--verbose": "v"}

QuietOption = Annotated[
    bool, typer.Option("--quiet", "-q", help="Print only the results that were asked for.")
]
VerboseOption = Annotated[
    bool, typer.Option("--verbose", "-v", help="Report on the error stream what is going on.")
]


def is_quiet() -> bool:
    """Tell whether nothing is to be said but results and problems."""
    return _is_set("--quiet")


def is_verbose() -> bool:
    """Tell whether the log is to be shown, with the traces of our own mistakes."""
    return _is_set("--verbose")


def _is_set(flag: str) -> bool:
    # As the language: the words themselves tell, also before they were parsed.
    letter = _FLAGS[flag]
    short = (one[1:] for one in sys.argv[1:] if one.startswith("-") and not one.startswith("--"))
    return flag in sys.argv[1:] or any(
        letter in one and set(one) <= set(_FLAGS.values()) for one in short
    )


def confirm(said: str) -> None:
    """Print what was done, unless nobody wants to hear it."""
    if not is_quiet():
        typer.echo(said)


@lru_cache(maxsize=1)
def loudness_parameters() -> "tuple[Parameter, ...]":
    """Make the two options that every command takes without a parameter of its function."""
    made = typer.Typer(add_completion=False)
    made.command()(_take)
    options = [one for one in typer.main.get_command(made).params if set(one.opts) & set(_FLAGS)]
    for one in options:
        one.expose_value = False
    return tuple(options)


def _take(quiet: QuietOption = False, verbose: VerboseOption = False) -> None:  # noqa: FBT002 (flags)
    """Take what every command takes."""


def prepare_streams() -> bool:
    """Let no sentence fail on a terminal that lacks its letters, and show the log if asked.

    Returns:
        Whether there is an output; where there is none, nothing that is opened takes its place.
    """
    while (opened := os.open(os.devnull, os.O_RDWR)) <= _ERROR_STREAM:
        pass
    os.close(opened)
    _keep_no_bytecode_where_files_are_cut()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="replace")
    logger = logging.getLogger("gripcourse")
    logger.setLevel(logging.DEBUG if is_verbose() else logging.WARNING)
    if is_verbose() and not logger.handlers:
        handler = logging.StreamHandler()
        handler.setFormatter(logging.Formatter("%(asctime)s %(name)s: %(message)s"))
        logger.addHandler(handler)
    return sys.stdout is not None


def _keep_no_bytecode_where_files_are_cut() -> None:
    """Let Python keep no compiled module where the system cuts files.

    It would keep a part of one, and fail on it whenever it is called again.
    """
    most = largest_file()
    if most is not None and most < _LARGEST_MODULE:
        sys.dont_write_bytecode = True
