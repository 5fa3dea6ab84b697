"""What is wrong with a template, said to its designer."""

import traceback
from dataclasses import replace
from pathlib import Path

from gripcourse.errors import Problem
from gripcourse.machine.resources import engine_template, template_folders
from gripcourse.text.words import message

# Jinja2 costs 40 ms to import: only who makes a document pays.
# ruff: noqa: PLC0415


def template_problem(error: Exception, name: str, templates: Path) -> Problem:
    """Say what a designer has to mend, with the template and the line where it failed.

    Args:
        error: that parsing or filling a template raised.
        name: of the template that was to be filled; it may have failed in another one.
        templates: the folder of the course with the templates.
    """
    from jinja2 import TemplateNotFound, TemplateSyntaxError, UndefinedError
    from jinja2.exceptions import SecurityError

    steps = traceback.extract_tb(error.__traceback__)
    places = [(step, _template_name(step.filename, templates)) for step in steps]
    inside = [(one, step.lineno) for step, one in places if one]
    place, line = inside[-1] if inside else (name, None)
    what = message("The template fails: {reason}.", reason=_reason(error))
    remedy = message("Correct what stands there; compare it with the reference course's template.")
    match error:
        case TemplateNotFound():
            what = message("There is no template {name}.", name=str(error.name))
            remedy = message("Correct the name, or copy the file from the reference course.")
        case TemplateSyntaxError():
            place, line = error.name or name, error.lineno
        case SecurityError():
            remedy = message("Leave it out; a template shows the values that it gets, no more.")
        case UndefinedError():
            remedy = message("Correct the name; it may be only the name of what stands before it.")
    found = Problem(
        f"{templates.name}/{place}", "" if line is None else f"line {line}", what, remedy
    )
    return or_without_it(found, templates)


def or_without_it(problem: Problem, templates: Path) -> Problem:
    """Say too where the engine has such a file: being a copy of an earlier one may be its fault.

    Args:
        problem: of a file in the folder of a course with the templates.
        templates: that folder.
    """
    name = problem.file.removeprefix(f"{templates.name}/")
    own, shipped = templates / name, engine_template(name)
    if shipped is None or not own.is_file() or own.samefile(shipped):
        return problem
    remedy = message(
        "{remedy} If you did not change this file, delete it: the program has a newer one.",
        remedy=problem.remedy,
    )
    return replace(problem, remedy=remedy)


def is_of_a_template(error: Exception, templates: Path) -> bool:
    """Tell whether an expression of a template failed, and not a function of ours that it calls."""
    files = [step.filename for step in traceback.extract_tb(error.__traceback__)]
    inside = [place for place, file in enumerate(files) if _template_name(file, templates)]
    ours = Path(__file__).parents[1]
    return bool(inside) and not any(
        Path(file).is_relative_to(ours) for file in files[inside[-1] + 1 :]
    )


def _template_name(file: str, templates: Path) -> str:
    """Return the name of a template by its file; empty for what is none."""
    for folder in template_folders(templates):
        if Path(file).is_relative_to(folder):
            return Path(file).relative_to(folder).as_posix()
    return ""


def _reason(error: Exception) -> str:
    """Return what a library says, without the full stop that the sentence has."""
    return (str(error) or type(error).__name__).rstrip(".")
