"""Checking the worked example of a scheme: complete, and about things that exist."""

from collections.abc import Iterator, Mapping

from gripcourse.course.compose import compose
from gripcourse.course.model import Course, Scheme, WorkedExample
from gripcourse.course.quantity import Convention, Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message


def check_example(course: Course, scheme: Scheme) -> Iterator[Problem]:
    """Yield the problems of a scheme's worked example."""
    example = scheme.example
    if example is None:
        return
    file = f"{scheme.file.removesuffix('scheme.toml')}worked_example.toml"
    if example.source.work and example.source.work not in course.works:
        yield Problem(
            file,
            "source.work",
            message("The course cites no work '{work}'.", work=example.source.work),
            did_you_mean(example.source.work, course.works),
        )
    yield from _convention_faults(course, example, file)
    faults = list(_option_faults(scheme, example, file))
    yield from faults
    if not faults:
        quantities = compose(course, scheme, example.options)
        yield from _given_faults(quantities, example, file)
        yield from _expected_faults(quantities, example, file)


def _option_faults(scheme: Scheme, example: WorkedExample, file: str) -> Iterator[Problem]:
    known = [option.id for option in scheme.options]
    for name in example.options:
        if name not in known:
            yield Problem(
                file,
                f"options.{name}",
                message(
                    "The scheme {scheme} has no option '{option}'.", scheme=scheme.id, option=name
                ),
                did_you_mean(name, known),
            )
    for option in scheme.options:
        choices = [choice.id for choice in option.choices]
        chosen = example.options.get(option.id)
        if chosen in choices:
            continue
        what = (
            message("The example does not say which choice it has.")
            if chosen is None
            else message("There is no choice '{choice}'.", choice=chosen)
        )
        yield Problem(file, f"options.{option.id}", what, did_you_mean(chosen or "", choices))


def _given_faults(
    quantities: Mapping[str, Quantity], example: WorkedExample, file: str
) -> Iterator[Problem]:
    inputs = {
        name: one for name, one in quantities.items() if one.kind in {Kind.GIVEN, Kind.CONSTANT}
    }
    for name, one in inputs.items():
        if one.kind is Kind.GIVEN and name not in example.given:
            yield Problem(
                file,
                f"given.{name}",
                message("The example gives no value of '{name}'.", name=name),
                message(
                    "Write it, or write default = … beside the given in {file}.", file=one.file
                ),
            )
    for name, value in example.given.items():
        if name not in inputs:
            yield Problem(
                file,
                f"given.{name}",
                message("The scheme has no given '{name}'.", name=name),
                did_you_mean(name, inputs),
            )
        elif not inputs[name].bounds[0] <= value <= inputs[name].bounds[1]:
            low, high = inputs[name].bounds
            yield Problem(
                file,
                f"given.{name}",
                message("The value {value} is outside the bounds {low} to {high} of the quantity.",
                        value=value, low=low, high=high),
                message("Write a value between the bounds, or correct the bounds."),
            )  # fmt: skip


def _convention_faults(course: Course, example: WorkedExample, file: str) -> Iterator[Problem]:
    """Yield what an example gives by a convention that the course does not have."""
    for convention in Convention:
        given = example.chosen[convention] or example.expected[convention]
        if given and convention not in course.conventions:
            yield Problem(
                file,
                convention,
                message("The course lists no errata: nothing is printed otherwise."),
                message("Remove the table, or list the errata in variants/errata.toml."),
            )


def _expected_faults(
    quantities: Mapping[str, Quantity], example: WorkedExample, file: str
) -> Iterator[Problem]:
    computed = {name for name, one in quantities.items() if one.kind.answered}
    tables = (("chosen", example.chosen), ("expected", example.expected))
    for key, by_convention in tables:
        for convention, values in by_convention.items():
            for name in values:
                if name not in computed:
                    yield Problem(
                        file,
                        f"{convention}.{key}.{name}",
                        message("The scheme computes no '{name}'.", name=name),
                        did_you_mean(name, computed),
                    )
