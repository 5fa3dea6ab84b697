"""The ranges that variants are drawn from.

A range stands beside its given. A file `variants/spaces/*.toml` says what is peculiar to a
scheme: its share, the options that are mixed, constraints, and ranges of its own. A scheme whose
givens all have ranges needs no such file.

Every range is turned into the list of values it allows, so that students get tidy numbers and
nothing has to be rounded later.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from gripcourse.course.compose import all_part_ids, compose
from gripcourse.course.model import Course, Option, Scheme
from gripcourse.course.option_rule import OptionRule
from gripcourse.course.option_sets import option_sets, pair_option_sets
from gripcourse.course.quantity import Quantity
from gripcourse.course.toml_table import Table, read_toml
from gripcourse.errors import CourseError, Problem
from gripcourse.formula.tree import Formula
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message
from gripcourse.variants.cases import Cases, SpaceCase
from gripcourse.variants.constraint import Constraint, check_constraint, read_constraints
from gripcourse.variants.contradiction import check_reach
from gripcourse.variants.keys import SPACE
from gripcourse.variants.ranges import Allowed, Follower, Range, RangeReader


@dataclass(frozen=True, slots=True)
class Space:
    """What variants of one scheme are drawn from.

    Attributes:
        scheme: its id.
        weight: its share among the schemes.
        cases: the combinations of options; every choice of an option is equally frequent.
        constraints: what each variant satisfies that has all quantities of one.
        file: where it is declared, for messages.
    """

    scheme: str
    weight: float
    cases: Cases
    constraints: tuple[Constraint, ...]
    file: str


def load_spaces(course: Course) -> tuple[Space, ...]:
    """Read all spaces of a course.

    Raises:
        CourseError: with every problem of every file: unknown names, ranges that allow nothing or
            leave the bounds, givens without a range, constraints that mean nothing.
    """
    paths = sorted((course.root / "variants" / "spaces").glob("*.toml"))
    try:
        told = tuple((path, path.read_bytes()) for path in paths)
    except OSError:  # which is told with its file and a remedy
        return spaces_in(paths, course, course)
    return _remembered(course, told)


@lru_cache(maxsize=4)
def _remembered(course: Course, told: tuple[tuple[Path, bytes], ...]) -> tuple[Space, ...]:
    """Make the spaces that files tell of a course once, as long as they tell the same."""
    return spaces_in([path for path, _ in told], course, course)


def spaces_in(paths: Sequence[Path], course: Course, whole: Course) -> tuple[Space, ...]:
    """Read the spaces of a course's schemes.

    Args:
        paths: files that say what is peculiar to one.
        course: whose spaces they are.
        whole: with all schemes, where this one has a few of them only: those of others are passed
            over.

    Raises:
        CourseError: see `load_spaces`.
    """
    problems: list[Problem] = []
    spaces: list[Space] = []
    for path in paths:
        table = read_toml(path, course.root, problems, SPACE, course.languages)
        space = None if table is None else _space(course, whole, table)
        if table is not None and space is not None:
            _refuse_second(table, spaces, space)
            spaces.append(space)
    named = {space.scheme for space in spaces}
    if not problems:  # else a file that cannot be read may be the one of the scheme
        spaces += [
            _plain_space(course, whole, scheme, problems)
            for scheme in course.schemes.values()
            if scheme.id not in named and _has_ranges(course, scheme)
        ]
    if problems:
        raise CourseError(
            {(one.file, str(one.key), str(one.what)): one for one in problems}.values()
        )
    return tuple(sorted(spaces, key=lambda space: space.file))


def _has_ranges(course: Course, scheme: Scheme) -> bool:
    """Tell whether a scheme without a file means to be drawn from: one of its givens says how."""
    parts = [course.parts[part].quantities for part in all_part_ids(scheme)]
    declared = (*parts, scheme.quantities, *scheme.changed)
    return any(one.range is not None for quantities in declared for one in quantities.values())


def offered_choices(course: Course) -> frozenset[tuple[str, str]]:
    """Return every choice that some scheme of a course offers, with its option."""
    return frozenset(
        (option.id, choice.id)
        for scheme in course.schemes.values()
        for option in scheme.options
        for choice in option.choices
    )


def _plain_space(course: Course, whole: Course, scheme: Scheme, problems: list[Problem]) -> Space:
    """Make the space of a scheme that leaves everything to the ranges beside its givens."""
    file = f"variants/spaces/{scheme.id}.toml"
    table = Table({"scheme": scheme.id}, file, "", problems, SPACE)
    return Space(scheme.id, 1.0, _cases(course, whole, table, scheme, ()), (), file)


def _refuse_second(table: Table, spaces: Sequence[Space], space: Space) -> None:
    for earlier in spaces:
        if earlier.scheme == space.scheme:
            table.add(
                "scheme",
                message("The scheme '{scheme}' already has {file}.", scheme=space.scheme,
                        file=earlier.file),
                message("Keep one of the two files."),
            )  # fmt: skip


def _space(course: Course, whole: Course, table: Table) -> Space | None:
    table.known_keys()
    id_ = table.text("scheme")
    if id_ not in course.schemes:
        if id_ and id_ not in whole.schemes:
            table.add(
                "scheme",
                message("There is no scheme '{scheme}'.", scheme=id_),
                did_you_mean(id_, whole.schemes),
            )
        return None
    weight = table.number("weight", 1.0)
    if not 0 < weight < float("inf"):
        table.add("weight", message("The weight must be above 0."), message("Write 1, or 2.5."))
    read = read_constraints(table)
    cases = _cases(course, whole, table, course.schemes[id_], read)
    return Space(id_, weight, cases, tuple(one for _, one in read), table.file)


def _mixed(scheme: Scheme, table: Table) -> Scheme:
    """Return the scheme with those choices of its options only that the space mixes."""
    mixed = table.table("options") or Table({}, table.file, "options", table.problems)
    mixed.known_keys(option.id for option in scheme.options)
    options = []
    for option in scheme.options:
        listed = _choices(option, mixed)
        kept = tuple(choice for choice in option.choices if choice.id in listed)
        options.append(replace(option, choices=kept))
    return replace(scheme, options=tuple(options))


def _choices(option: Option, mixed: Table) -> tuple[str, ...]:
    """Return the choices that the space lists; all of them where it lists none."""
    known = tuple(choice.id for choice in option.choices)
    listed = mixed.strings(option.id)
    for choice in listed:
        if choice not in known:
            mixed.add(
                option.id,
                message("There is no choice '{choice}'.", choice=choice),
                did_you_mean(choice, known),
            )
    return tuple(choice for choice in known if choice in listed or not listed)


def _cases(
    course: Course,
    whole: Course,
    table: Table,
    scheme: Scheme,
    constraints: Sequence[tuple[Table, Constraint]],
) -> Cases:
    """Read the ranges and constraints of a scheme; thousands of combinations share them.

    Any two choices of two options are looked at together. A combination is composed when it is
    asked for.
    """
    mixed = _mixed(scheme, table)
    plans = [make_plan(course, scheme.id, options) for options in pair_option_sets(mixed)]
    if not plans:
        table.add(
            "options",
            message("The rules among the options leave no combination of the choices mixed here."),
            message("Mix more choices, or loosen the rules of these options."),
        )
        return Cases.of(())
    own = table.named_tables("given")
    givens = {quantity.id: quantity for plan in plans for quantity in plan.givens}
    for id_, written in own.items():
        if id_ not in givens:
            written.add(
                "",
                message("No such quantity is given in this scheme."),
                did_you_mean(id_, givens),
            )
    options = {option.id: {choice.id for choice in option.choices} for option in mixed.options}
    for line, constraint in constraints:
        formula = constraint.formula
        check_constraint(line, formula, (*plans, *_plans_with(course, mixed, plans, formula)))
    reader = RangeReader(course, givens, options, offered_choices(whole))
    declared = {id(one): one for plan in plans for one in plan.givens}
    found = ((key, one, _written(one, own, table)) for key, one in declared.items())
    places = {key: (one, place) for key, one, place in found if place is not None}
    read = {
        key: reader.read(place, one, is_own=one.id in own) for key, (one, place) in places.items()
    }
    _check_bound(table, mixed, plans, read)
    reader.check_leaders([(place, one.id, read[key]) for key, (one, place) in places.items()])
    own_constraints = [one for _, one in constraints]
    if not table.problems:  # else ranges may be empty, and names unknown
        drawn = [(plan, _case(plan, plan.options, read, ())) for plan in plans]
        for line, constraint in constraints:
            check_reach(line, constraint.formula, drawn)

    def make(options: Mapping[str, str]) -> SpaceCase:
        return _case(make_plan(course, scheme.id, options), options, read, own_constraints)

    return Cases.made_by(option_sets(mixed), make)


def _check_bound(
    table: Table, scheme: Scheme, plans: Sequence[Plan], read: Mapping[int, Range]
) -> None:
    """Record values that a rule hands on to a given whose bounds leave them out."""
    for plan in plans:
        cases = _case(plan, plan.options, read, ())
        for id_ in (id_ for rule in scheme.rules if rule.counts(plan.options) for id_ in rule.same):
            follower, quantity = cases.followers.get(id_), plan.quantities.get(id_)
            if follower is None or quantity is None:
                continue
            low, high = quantity.bounds
            outside = [one for one in follower.values.values() if not low <= one <= high]
            if outside:
                table.add(
                    f"given.{follower.leader}",
                    message(
                        "The value {value} is outside the bounds {low} to {high} of '{name}', which"
                        " a rule among the options makes the same number.",
                        value=outside[0], low=low, high=high, name=id_,
                    ),
                    message("Narrow the range, or correct the bounds in {file}.",
                            file=quantity.file),
                )  # fmt: skip
                return


def _plans_with(
    course: Course, scheme: Scheme, plans: Sequence[Plan], constraint: Formula
) -> Iterator[Plan]:
    """Yield a plan that has all quantities of a constraint, where none of `plans` has.

    It is looked for among all combinations: three choices together may bring what no two do.
    """
    wanted = set(constraint.names)
    known = {name for plan in plans for name in plan.quantities}
    if wanted <= known and not any(wanted <= plan.quantities.keys() for plan in plans):
        for options in option_sets(scheme):
            if wanted <= compose(course, scheme, options).keys():
                yield make_plan(course, scheme.id, options)
                return


def _written(quantity: Quantity, own: Mapping[str, Table], space: Table) -> Table | None:
    """Return where the range of a given stands: in the space, else beside its declaration."""
    if quantity.id in own:
        return own[quantity.id]
    if quantity.range is not None:
        return replace(quantity.range, problems=space.problems)
    space.add(
        f"given.{quantity.id}",
        message("The given quantity has no range."),
        message(
            "Write range = {{ low = …, high = …, step = … }} beside it in {file}, or a table here.",
            file=quantity.file,
        ),
    )
    return None


def _case(
    plan: Plan,
    options: Mapping[str, str],
    read: Mapping[int, Range],
    constraints: Sequence[Constraint],
) -> SpaceCase:
    """Take from the ranges what counts for one combination of options."""
    chosen = {
        quantity.id: read[id(quantity)].chosen(options)
        for quantity in plan.givens
        if id(quantity) in read
    }
    for rule in plan.scheme.rules:
        if rule.counts(options):
            _bind(chosen, rule)
    return SpaceCase(
        options,
        {id_: one for id_, one in chosen.items() if not isinstance(one, Follower)},
        {id_: one for id_, one in chosen.items() if isinstance(one, Follower)},
        tuple(one for one in constraints if plan.quantities.keys() >= set(one.formula.names)),
    )


def _bind(chosen: dict[str, Allowed], rule: OptionRule) -> None:
    """Let the givens that a rule makes one number follow the first of them that has a range."""
    present = [id_ for id_ in rule.same if id_ in chosen]
    for leader in present:
        values = chosen[leader]
        if not isinstance(values, Follower):
            break
    else:
        return  # all of them follow another given
    same = Follower(leader, {value: value for value in values})
    chosen |= {id_: same for id_ in present if id_ != leader}
    for id_, one in chosen.items():
        if isinstance(one, Follower) and one.leader in present:
            chosen[id_] = replace(one, leader=leader)
