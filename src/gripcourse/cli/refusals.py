"""What the parser refuses, as problems like any other."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from datetime import datetime
from typing import TYPE_CHECKING

import typer
from typer.core import TyperArgument, TyperOption

from gripcourse.cli.options import chosen_words
from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import Message, Words, message

if TYPE_CHECKING:
    # The library gives these types no public name.
    from typer._click import Context, Parameter


@contextmanager
def refusals_told(context: "Context") -> Iterator[None]:
    """Turn what the parser refuses into an error like any other."""
    try:
        yield
    except typer.TyperException as error:
        raise UsageError([_refused(error, context)]) from error


def value_range(parameter: TyperOption | TyperArgument) -> Message | None:
    """Say between which numbers a parameter lies; None for none."""
    if parameter.min is not None and parameter.max is not None:
        return message("from {least} to {most}", least=str(parameter.min), most=str(parameter.max))
    if parameter.min is not None:
        return message("at least {least}", least=str(parameter.min))
    return None


def _refused(error: typer.TyperException, context: "Context") -> Problem:
    """Say what the parser refuses.

    Its exceptions carry what they are about; their sentences are English and not taken over.
    """
    parameter: Parameter | None = getattr(error, "param", None)
    remedy = see_help(context)
    if isinstance(parameter, TyperOption | TyperArgument):
        name = _spoken_name(parameter, chosen_words())
        return Problem("", name, _unusable(error, parameter), remedy)
    name = getattr(error, "option_name", "")
    if not name:
        return Problem("", "", message("{reason}", reason=error.format_message()), remedy)
    options = {two: one for one in context.command.get_params(context) for two in one.opts}
    if name not in options:
        from gripcourse.text.suggestion import did_you_mean  # noqa: PLC0415 (not for --help)

        return Problem("", name, message("There is no such option."), did_you_mean(name, options))
    if getattr(options[name], "is_flag", False):
        return Problem("", name, message("This option takes no value."), remedy)
    return Problem("", name, message("A value is missing after this option."), remedy)


def _unusable(error: typer.TyperException, parameter: TyperOption | TyperArgument) -> Message:
    if not isinstance(error, typer.BadParameter) or not error.message:
        return message("It is missing.")
    found = getattr(error.__cause__, "errors", None)
    if found is None:
        return message("{reason}", reason=error.message)  # said by a reader of our own
    typed: Sequence[dict[str, object]] = found()
    return message(
        "'{text}' cannot be used here: {wanted}.",
        text=str(typed[0]["input"]),
        wanted=_wanted(parameter),
    )


def _wanted(parameter: TyperOption | TyperArgument) -> Message:
    if parameter.type_descriptor.annotation is datetime:
        return message("a date such as 2026-09-30 is wanted")
    between = value_range(parameter)
    if between is not None:
        return message("a whole number is wanted, {range}", range=between)
    return message("a whole number is wanted")


def _spoken_name(parameter: TyperOption | TyperArgument, words: Words) -> str:
    if isinstance(parameter, TyperArgument):
        return f"<{words.declared(parameter.metavar or parameter.name)}>"
    return ", ".join(parameter.opts)


def see_help(context: "Context") -> Message:
    """Point to the help of a command."""
    return message("See {command} --help.", command=context.command_path)
