"""What of a course with problems can be computed all the same: what none of them touches.

An author who wrote one unit wrongly wants to hear of the wrong formula in another section, too. So
what a problem is about is taken out, with all that is computed from it, and the rest is tried.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import chain
from typing import Final

from gripcourse.course.check_graph import circular_names
from gripcourse.course.compose import all_part_ids, compose, of_schemes
from gripcourse.course.model import Course, Part, Scheme, WorkedExample
from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.formula.tree import Call, Formula, walk
from gripcourse.text.units import known

_NO_NUMBERS: Final = frozenset(
    {
        *("title", "symbol", "source", "explain", "decides", "note_decides", "formula_decides"),
        *("one_end", "section", "tolerance", "range", "rubric", "slip", "alternative"),
        "route",
    }
)
"""Keys of a quantity that leave its value as it is."""
_DECIDES_ALL: Final = ("parts", "options", "option_rule", "id")  # keys of a scheme
_HEADINGS: Final = ("title", "column", "source", "mark")  # of a catalogue


def unaffected(course: Course, problems: Collection[Problem]) -> Iterator[Course]:
    """Yield, for each scheme with a worked example, the course with what can be computed of it.

    Args:
        course: as read.
        problems: all that were found in its files.
    """
    for scheme in course.schemes.values():
        if scheme.example is None or _is_undecided(scheme, problems):
            continue
        left_out = _touched(course, scheme, problems)
        alone = _without(of_schemes(course, [scheme.id]), scheme, left_out)
        yield _of_example(alone, scheme, _unfit_numbers(scheme, problems))


def touched_names(problems: Iterable[Problem], files: Collection[str]) -> Iterator[str]:
    """Yield the ids of the quantities and constants of some files that problems are about."""
    for one in problems:
        match str(one.key).split("."):
            case ["quantity" | "override" | "constant", name, *rest] if one.file in files:
                if not rest or rest[0] not in _NO_NUMBERS:
                    yield name


def _is_undecided(scheme: Scheme, problems: Iterable[Problem]) -> bool:
    """Tell whether problems leave open which quantities the scheme and its example have."""
    options = {f"variants/options/{one.id}.toml" for one in scheme.options}
    example = _example_file(scheme)
    return any(
        one.file == "variants/errata.toml"
        or one.file in options
        or (one.file == scheme.file and str(one.key).startswith(_DECIDES_ALL))
        or (one.file == example and str(one.key).startswith("options"))
        for one in problems
    )


def _touched(course: Course, scheme: Scheme, problems: Collection[Problem]) -> set[str]:
    """Return the ids of a scheme that problems are about, and of all that is computed from them."""
    parts = [course.parts[one] for one in all_part_ids(scheme) if one in course.parts]
    files = {"variants/course.toml", scheme.file, *(one.file for one in parts)}
    found = {*touched_names(problems, files), *circular_names(course, scheme)}
    found |= {
        str(one.key).removeprefix("given.") for one in problems if one.file == _example_file(scheme)
    }
    tables = {
        one.file.removeprefix("variants/catalogues/").removesuffix(".csv")
        for one in problems
        if not str(one.key).startswith(_HEADINGS)
    }
    options = {} if scheme.example is None else scheme.example.options
    quantities = compose(course, scheme, options)
    for name, one in quantities.items():
        if not _has_formula(one) or not known(one.unit) or tables & _catalogues(one):
            found.add(name)
    usable, before = quantities.keys() - found, -1
    while len(usable) != before:
        before = len(usable)
        usable = {name for name in usable if usable.issuperset(_inputs(quantities[name]))}
    # What no part brings with these options is not computed, and not missed.
    return {*found, *quantities} - usable


def _has_formula(one: Quantity) -> bool:
    return one.formula is not None or not one.kind.answered


def _formulas(one: Quantity) -> Iterator[Formula]:
    """Yield the formulas that decide the value; slips and other readings do not."""
    condition = None if one.choice is None else one.choice.condition
    printed = (each.formula for each in one.as_printed)
    yield from (each for each in (one.formula, condition, *printed) if each is not None)


def _inputs(one: Quantity) -> set[str]:
    return {name for formula in _formulas(one) for name in formula.names}


def _catalogues(one: Quantity) -> set[str]:
    """Return the ids of the catalogues that a quantity reads."""
    columns = [] if one.choice is None else [one.choice.column, *one.choice.also]
    nodes = chain.from_iterable(walk(formula.tree) for formula in _formulas(one))
    read = (node.column for node in nodes if isinstance(node, Call) and node.column is not None)
    return {column.partition(".")[0] for column in (*columns, *read)}


def _without(course: Course, scheme: Scheme, left_out: Collection[str]) -> Course:
    """Return the course with this scheme, without some quantities and all that no value needs."""

    def kept(declared: Mapping[str, Quantity]) -> dict[str, Quantity]:
        return {
            name: replace(one, route=None, valid=None, slips=(), alternatives=())
            for name, one in declared.items()
            if name not in left_out
        }

    def kept_by_part(
        by_part: Mapping[str, Mapping[str, Quantity]],
    ) -> dict[str, dict[str, Quantity]]:
        return {part: kept(declared) for part, declared in by_part.items()}

    optional = {part: kept_by_part(one) for part, one in scheme.optional_overrides.items()}
    changed = replace(
        scheme,
        quantities=kept(scheme.quantities),
        overrides={part: kept(one) for part, one in scheme.overrides.items()},
        optional_overrides=optional,
    )
    parts = {
        name: Part(one.id, kept(one.quantities), one.file) for name, one in course.parts.items()
    }
    constants = kept(course.constants)
    return replace(course, schemes={scheme.id: changed}, parts=parts, constants=constants)


def _unfit_numbers(scheme: Scheme, problems: Iterable[Problem]) -> set[str]:
    """Return the keys of the example whose numbers cannot be used."""
    return {str(one.key) for one in problems if one.file == _example_file(scheme)}


def _of_example(course: Course, scheme: Scheme, unfit: Collection[str]) -> Course:
    """Return the course with those numbers of the example only that can be used."""
    example = scheme.example
    if example is None:
        return course
    expected = {
        convention: {
            name: value
            for name, value in values.items()
            if f"{convention}.expected.{name}" not in unfit
        }
        for convention, values in example.expected.items()
    }
    own: WorkedExample = replace(example, expected=expected)
    mine = course.schemes[scheme.id]
    return replace(course, schemes={scheme.id: replace(mine, example=own)})


def _example_file(scheme: Scheme) -> str:
    return f"{scheme.file.removesuffix('scheme.toml')}worked_example.toml"
