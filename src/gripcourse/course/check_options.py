"""Checking the rules among options: they name what exists, and leave something to choose."""

from collections.abc import Iterable, Iterator, Mapping

from gripcourse.course.compose import compose
from gripcourse.course.model import Course, Option, Scheme
from gripcourse.course.option_rule import OptionRule
from gripcourse.course.option_sets import option_sets
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, message


def check_option_names(course: Course, whole: Course) -> Iterator[Problem]:
    """Yield the options and choices that rules name and nothing has.

    A shared option serves many schemes: its rules may name what some scheme of the course offers. A
    scheme's own rules name its own options.

    Args:
        course: whose rules are checked; it may have a few of the schemes only.
        whole: with all schemes.
    """
    offering = whole.schemes.values()
    everywhere = _offered(option for scheme in offering for option in scheme.options)
    for scheme in course.schemes.values():
        for rule in scheme.own_rules:
            yield from _unknown(rule, _offered(scheme.options))
        for rule in (rule for option in scheme.options for rule in option.rules):
            yield from _unknown(rule, everywhere)


def check_option_rules(course: Course, scheme: Scheme) -> Iterator[Problem]:
    """Yield what the rules of a scheme do to each other: choices that nothing is left to go with.

    Args:
        course: for the quantities of its combinations.
        scheme: whose rules name what exists.
    """
    if not scheme.rules:
        return
    allowed = list(option_sets(scheme))
    if not allowed:
        yield Problem(
            scheme.file,
            "options",
            message("The rules among the options leave no combination of choices."),
            _loosen(scheme.rules),
        )
        return
    for option in scheme.options:
        left = {options[option.id] for options in allowed}
        for choice in option.choices:
            if choice.id not in left:
                yield _never(scheme, option.id, choice.id)
    for rule in scheme.rules:
        if rule.same:
            yield from _same_faults(course, scheme, rule, allowed)


def _offered(options: Iterable[Option]) -> dict[str, set[str]]:
    offered: dict[str, set[str]] = {}
    for option in options:
        offered.setdefault(option.id, set()).update(choice.id for choice in option.choices)
    return offered


def _unknown(rule: OptionRule, offered: Mapping[str, set[str]]) -> Iterator[Problem]:
    for name, asked in (("when", rule.when), ("requires", rule.requires)):
        for option, choices in asked.items():
            if option not in offered:
                yield Problem(
                    rule.file,
                    f"{rule.key}.{name}.{option}",
                    message("There is no option '{option}'.", option=option),
                    did_you_mean(option, offered),
                )
                continue
            for choice in choices:
                if choice not in offered[option]:
                    yield Problem(
                        rule.file,
                        f"{rule.key}.{name}.{option}",
                        message("There is no choice '{choice}'.", choice=choice),
                        did_you_mean(choice, offered[option]),
                    )


def _never(scheme: Scheme, option: str, choice: str) -> Problem:
    with_it = [rule for rule in scheme.rules if choice in rule.when.get(option, (choice,))]
    return Problem(
        scheme.file,
        "options",
        message(
            "The rules among the options leave nothing that '{choice}' of '{option}' goes with.",
            choice=choice,
            option=option,
        ),
        _loosen(with_it),
    )


def _same_faults(
    course: Course, scheme: Scheme, rule: OptionRule, allowed: Iterable[Mapping[str, str]]
) -> Iterator[Problem]:
    """Yield the names that are no givens where a rule counts, and givens of unlike units."""
    found: dict[str, Quantity] = {}
    for options in allowed:
        if rule.counts(options):
            quantities = compose(course, scheme, options)
            found |= {id_: quantities[id_] for id_ in rule.same if id_ in quantities}
        if found.keys() >= set(rule.same):
            break
    for id_ in rule.same:
        if id_ not in found or found[id_].kind is not Kind.GIVEN:
            yield Problem(
                rule.file,
                f"{rule.key}.same",
                message("No such quantity is given where the rule counts: '{name}'.", name=id_),
                did_you_mean(id_, (one.id for one in found.values() if one.kind is Kind.GIVEN)),
            )
    units = {one.unit for one in found.values()}
    if len(units) > 1:
        yield Problem(
            rule.file,
            f"{rule.key}.same",
            message("These givens have unlike units: {units}.", units=", ".join(sorted(units))),
            message("One number has one unit: declare them alike."),
        )


def _loosen(rules: Iterable[OptionRule]) -> Message:
    places = ", ".join(f"{rule.file} {rule.key}" for rule in rules)
    return message("Loosen one of: {rules}.", rules=places)
