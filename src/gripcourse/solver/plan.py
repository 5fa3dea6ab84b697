"""The plan of a calculation: a scheme with a variant's options, put into order."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import lru_cache
from typing import Any

from gripcourse.course.catalogue import columns_of
from gripcourse.course.compose import (
    compose,
    default_values,
    reference_formula,
)
from gripcourse.course.composition import Composition
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Convention, Kind, Quantity
from gripcourse.course.step_up import StepUp, inputs_of, step_ups
from gripcourse.errors import Problem, UsageError
from gripcourse.formula.evaluate import Column
from gripcourse.formula.tree import Formula
from gripcourse.solver.order import in_order_of_need
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

# Of the thousands of compositions of a course those that a batch or a table has; 50 kB each.
_REMEMBERED = 256
_COURSES = 4  # whose columns are remembered


@dataclass(frozen=True, slots=True)
class Plan:
    """What is computed, in which order, from what.

    Attributes:
        course, scheme: what the plan belongs to.
        options: what the variant chose.
        convention: whose version of a formula is the reference.
        quantities: every quantity by id, in order of calculation: inputs before what needs them.
        inputs: ids that the value of each quantity is computed from directly.
        step_ups: the choices that step up, by id, with what decides whether a size will do.
        columns: catalogue columns in SI, by `catalogue.column`.
        answered, givens, manual: quantities in the order of the assignment: by section, inside a
            section in order of calculation.
        constants: the course's constants that the reference uses.
        made: what was made of it once, to compute it: by whoever made it, and never sent away.
    """

    course: Course
    scheme: Scheme
    options: Mapping[str, str]
    convention: Convention
    quantities: Mapping[str, Quantity]
    inputs: Mapping[str, tuple[str, ...]]
    step_ups: Mapping[str, StepUp]
    columns: Mapping[str, Column]
    answered: tuple[Quantity, ...]
    givens: tuple[Quantity, ...]
    manual: tuple[Quantity, ...]
    constants: tuple[Quantity, ...]
    made: dict[str, Any] = field(init=False, repr=False, compare=False, default_factory=dict)

    def __reduce__(self) -> "tuple[type[Plan], tuple[object, ...]]":
        return type(self), tuple(getattr(self, one.name) for one in fields(self) if one.init)

    @property
    def composition(self) -> Composition:
        """What the plan computes."""
        return Composition.of(self.scheme.id, self.options)

    @property
    def asked(self) -> tuple[Quantity, ...]:
        """What a student is asked: what the program judges, then what a person marks."""
        return (*self.answered, *self.manual)

    def reference_formula(self, identifier: str) -> Formula | None:
        """Return the formula that gives the reference of a quantity in this plan's convention."""
        return reference_formula(self.quantities[identifier], self.convention)


def make_plan(
    course: Course,
    scheme_id: str,
    options: Mapping[str, str],
    convention: Convention | None = None,
) -> Plan:
    """Make the plan of a scheme and options that do not travel together; see `plan_of`."""
    return plan_of(course, Composition.of(scheme_id, options), convention)


@lru_cache(maxsize=_REMEMBERED)
def plan_of(course: Course, composition: Composition, convention: Convention | None = None) -> Plan:
    """Put a scheme with a variant's options into the order of calculation.

    Args:
        course: what is declared.
        composition: the scheme and its options.
        convention: whose version of a formula is the reference; None for the course's.

    Raises:
        UsageError: for an unknown scheme, an option that is missing or unknown, or a convention
            that the course does not have.
    """
    scheme = _scheme(course, composition.scheme)
    chosen = composition.options
    _check_options(scheme, chosen)
    options = {option.id: chosen[option.id] for option in scheme.options}
    convention = convention or course.convention
    _check_convention(course, convention)
    declared = compose(course, scheme, options)
    ups = step_ups(declared, convention)
    inputs = {name: inputs_of(one, convention, ups) for name, one in declared.items()}
    order = in_order_of_need(inputs)
    used = {name for one in inputs.values() for name in one}
    ranks = {section.id: rank for rank, section in enumerate(course.sections)}

    def of_kind(*kinds: Kind) -> tuple[Quantity, ...]:
        chosen = (declared[name] for name in order if declared[name].kind in kinds)
        return tuple(sorted(chosen, key=lambda one: ranks.get(one.section, -1)))

    return Plan(
        course=course,
        scheme=scheme,
        options=options,
        convention=convention,
        quantities={name: declared[name] for name in order},
        inputs=inputs,
        step_ups=ups,
        columns=_columns(course),
        answered=of_kind(*(kind for kind in Kind if kind.answered)),
        givens=of_kind(Kind.GIVEN),
        manual=of_kind(Kind.MANUAL),
        constants=tuple(one for one in of_kind(Kind.CONSTANT) if one.id in used),
    )


@lru_cache(maxsize=_COURSES)
def _columns(course: Course) -> Mapping[str, Column]:
    """Return the columns of a course's catalogues, which all its plans share."""
    return columns_of(course.catalogues)


def default_options(scheme: Scheme) -> dict[str, str]:
    """Return the options of a scheme's worked example, else the first choice of each."""
    if scheme.example is not None:
        return dict(scheme.example.options)
    return {option.id: option.choices[0].id for option in scheme.options}


def usual_values(plan: Plan) -> dict[str, float]:
    """Return givens and constants as the worked example has them, else the defaults of givens.

    Args:
        plan: of any options; what the example says of others' quantities is left out.

    Returns:
        Values in declared units; of constants only those that the example changes.
    """
    example = plan.scheme.example
    stated = {} if example is None else example.given
    inputs = {one.id for one in (*plan.givens, *plan.constants)}
    return default_values(plan.givens) | {
        name: value for name, value in stated.items() if name in inputs
    }


def depends_on_given(plan: Plan, name: str) -> bool:
    """Tell whether a quantity depends on what was issued: others are the same in every variant."""
    waiting, seen = [name], set[str]()
    while waiting:
        one = waiting.pop()
        if plan.quantities[one].kind is Kind.GIVEN:
            return True
        if one not in seen:
            seen.add(one)
            waiting += plan.inputs[one]
    return False


def _scheme(course: Course, scheme_id: str) -> Scheme:
    if scheme_id in course.schemes:
        return course.schemes[scheme_id]
    what = message("The course has no scheme '{scheme}'.", scheme=scheme_id)
    raise UsageError([Problem("", "", what, did_you_mean(scheme_id, course.schemes))])


def _check_convention(course: Course, convention: Convention) -> None:
    if convention not in course.conventions:
        what = message("The course lists no errata: nothing is printed otherwise.")
        raise UsageError([Problem("", "", what, did_you_mean(convention, course.conventions))])


def _check_options(scheme: Scheme, options: Mapping[str, str]) -> None:
    problems = []
    for option in scheme.options:
        choices = [choice.id for choice in option.choices]
        if options.get(option.id) not in choices:
            what = message(
                "The option '{option}' of the scheme {scheme} cannot be '{choice}'.",
                option=option.id,
                scheme=scheme.id,
                choice=options.get(option.id, ""),
            )
            problems.append(
                Problem("", "", what, did_you_mean(options.get(option.id, ""), choices))
            )
    known = {option.id for option in scheme.options}
    problems += [
        Problem(
            "",
            "",
            message("The scheme {scheme} has no option '{option}'.", scheme=scheme.id, option=name),
            did_you_mean(name, known),
        )
        for name in options
        if name not in known
    ]
    if problems:
        raise UsageError(problems)
