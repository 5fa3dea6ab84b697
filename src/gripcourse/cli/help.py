"""Help pages and refusals of the command line, in the language of whoever reads them.

The library that parses the command line has one place for this: classes of commands. Ours put into
words what they show, and turn what the parser refuses into a `UsageError` like any other.
"""

from collections.abc import Iterator
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption

from gripcourse.cli.loudness import loudness_parameters
from gripcourse.cli.options import WRONG_USE, LanguageOption, chosen_words
from gripcourse.cli.refusals import refusals_told, see_help, value_range
from gripcourse.errors import Problem, UsageError
from gripcourse.text.words import Message, Words, message

if TYPE_CHECKING:
    # The library gives these types no public name.
    from typer._click import Command, Context, HelpFormatter, Parameter
    from typer._click.shell_completion import CompletionItem

WIDTH = 100

# The library that parses makes these two itself.
_COMPLETION = {
    "--install-completion": message("Install the completion of commands for this shell."),
    "--show-completion": message("Print the completion script, to copy or change it."),
}


class SpokenCommand(TyperCommand):
    """A command whose help and refusals are in the reader's language."""

    # What is left over is refused below, with what it is.
    allow_extra_args = True

    def get_params(self, ctx: "Context") -> "list[Parameter]":
        """Return the parameters of a command, with those that all commands take."""
        return _with_loudness(super().get_params(ctx))

    def shell_complete(self, ctx: "Context", incomplete: str) -> "list[CompletionItem]":
        """Complete what is typed, with the help in the reader's language."""
        return _in_words(super().shell_complete(ctx, incomplete))

    def get_short_help_str(self, limit: int = WIDTH) -> str:  # noqa: ARG002 (the parser names it)
        """Return what it is for, as a shell shows it beside what it completes."""
        return chosen_words().declared(self.help)

    def format_help(self, ctx: "Context", formatter: "HelpFormatter") -> None:
        """Write the help page."""
        _write_page(self, ctx, formatter, chosen_words())

    def parse_args(self, ctx: "Context", args: list[str]) -> list[str]:
        """Parse what stands behind the command.

        Raises:
            UsageError: it cannot be used.
        """
        with refusals_told(ctx):
            left = super().parse_args(ctx, args)
        if left and not ctx.resilient_parsing:
            what = message("There is no place for '{text}'.", text=" ".join(left))
            raise UsageError([Problem("", "", what, see_help(ctx))])
        return left


class SpokenGroup(TyperGroup):
    """A group of commands whose help and refusals are in the reader's language."""

    def get_params(self, ctx: "Context") -> "list[Parameter]":
        """Return the parameters of a group, with those that all commands take."""
        return _with_loudness(super().get_params(ctx))

    def shell_complete(self, ctx: "Context", incomplete: str) -> "list[CompletionItem]":
        """Complete what is typed, with the help in the reader's language."""
        return _in_words(super().shell_complete(ctx, incomplete))

    def get_short_help_str(self, limit: int = WIDTH) -> str:  # noqa: ARG002 (the parser names it)
        """Return what it is for, as a shell shows it beside what it completes."""
        return chosen_words().declared(self.help)

    def format_help(self, ctx: "Context", formatter: "HelpFormatter") -> None:
        """Write the help page with the list of the commands."""
        _write_page(self, ctx, formatter, chosen_words())

    def parse_args(self, ctx: "Context", args: list[str]) -> list[str]:
        """Parse what stands before the name of a command.

        Raises:
            UsageError: it cannot be used.
        """
        with refusals_told(ctx):
            return super().parse_args(ctx, args)

    def resolve_command(
        self, ctx: "Context", args: list[str]
    ) -> "tuple[str | None, Command | None, list[str]]":
        """Find the command that is meant.

        Raises:
            UsageError: there is none of this name.
        """
        if args[0] not in self.commands and not ctx.resilient_parsing:
            from gripcourse.text.suggestion import did_you_mean  # noqa: PLC0415 (not for --help)

            what = message("There is no command '{name}'.", name=args[0])
            raise UsageError([Problem("", "", what, did_you_mean(args[0], self.commands))])
        return super().resolve_command(ctx, args)


def command_group(text: str, *, is_program: bool = False) -> typer.Typer:
    """Make a group of commands.

    Args:
        text: what it is for, in English.
        is_program: whether it is all of them, and so tells its version and completes words.
    """
    made = typer.Typer(
        cls=SpokenGroup,
        help=text,
        add_completion=is_program,
        invoke_without_command=True,
        pretty_exceptions_enable=False,
        context_settings={"max_content_width": WIDTH},
    )
    made.callback()(_program if is_program else _alone)
    return made


def _with_loudness(own: "list[Parameter]") -> "list[Parameter]":
    # Help stands last.
    return [*own[:-1], *loudness_parameters(), *own[-1:]]


def _in_words(items: "list[CompletionItem]") -> "list[CompletionItem]":
    words = chosen_words()
    for item in items:
        item.help = words.declared(item.help)
    return items


def _alone(context: typer.Context, language: LanguageOption = None) -> None:  # noqa: ARG001
    # The language is for the commands of the group: each asks for it, see `LanguageOption`.
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())
        raise typer.Exit(WRONG_USE)


def _program(
    context: typer.Context,
    language: LanguageOption = None,
    version: Annotated[  # noqa: FBT002 (a flag)
        bool, typer.Option("--version", help="Show the version of the program.")
    ] = False,
) -> None:
    if version:
        from gripcourse import __version__  # noqa: PLC0415 (the program is above this)

        typer.echo(f"gripcourse {__version__}")
        raise typer.Exit
    _alone(context, language)


def _write_page(
    command: "Command", context: "Context", formatter: "HelpFormatter", words: Words
) -> None:
    some, one_of = words.translate("options"), words.translate("command")
    pieces = [f"[{some}]"]
    arguments: list[tuple[str, str]] = []
    options: list[tuple[str, str]] = []
    for parameter in command.get_params(context):
        if isinstance(parameter, TyperArgument):
            name = _argument_name(parameter, words)
            pieces.append(name)
            arguments.append((name, _described(parameter, context, words)))
        elif isinstance(parameter, TyperOption) and not parameter.hidden:
            value = _value_name(parameter, words)
            names = (*parameter.opts, *parameter.secondary_opts)
            written = ", ".join(names) + (f" <{value}>" if value else "")
            options.append((written, _described(parameter, context, words)))
    commands: list[tuple[str, str]] = []
    if isinstance(command, TyperGroup):
        pieces.append(f"<{one_of}>…")
        commands = [(name, words.declared(one.help)) for name, one in command.commands.items()]
    usage = words.translate("Usage")
    formatter.write_usage(context.command_path, " ".join(pieces), prefix=f"{usage}: ")
    formatter.write_paragraph()
    formatter.write_text(words.declared(command.help))
    for heading, rows in (
        (words.translate("Arguments"), arguments),
        (words.translate("Options"), options),
        (words.translate("Commands"), commands),
    ):
        if rows:
            with formatter.section(heading):
                formatter.write_dl(rows)


def _argument_name(parameter: TyperArgument, words: Words) -> str:
    name = words.declared(parameter.metavar or parameter.name)
    more = "" if parameter.nargs == 1 else "…"
    return f"<{name}>{more}" if parameter.required else f"[{name}]{more}"


def _value_name(parameter: TyperOption, words: Words) -> str:
    """Name what follows an option; nothing follows a flag."""
    if parameter.is_flag:
        return ""
    if parameter.metavar:
        return words.declared(parameter.metavar)
    kind = parameter.type_descriptor.annotation
    if kind is datetime:
        return words.translate("YYYY-MM-DD")
    if kind is Path:
        return words.translate("path")
    if kind in {int, float}:
        return words.translate("number")
    return words.translate("text")


def _described(parameter: TyperOption | TyperArgument, context: "Context", words: Words) -> str:
    """Say what a parameter is for, and in brackets what may be given."""
    if set(parameter.opts) & set(context.help_option_names):
        return words.translate("Show this help.")
    ours = _COMPLETION.get(parameter.opts[0])
    text = words.say(ours) if ours else words.declared(parameter.help)
    notes = "; ".join(words.say(one) for one in _notes(parameter, words))
    return f"{text} [{notes}]" if notes else text


def _notes(parameter: TyperOption | TyperArgument, words: Words) -> Iterator[Message]:
    shown: object = parameter.default
    if isinstance(parameter.show_default, str):
        shown = words.declared(parameter.show_default)
    if parameter.required and isinstance(parameter, TyperOption):
        yield message("required")
    elif shown not in {None, ""} and shown is not False:
        yield message("default: {value}", value=str(shown))
    if isinstance(parameter, TyperOption) and parameter.multiple:
        yield message("may be repeated")
    if between := value_range(parameter):
        yield between
