"""Which declarations a scheme has: from which part each comes, and under which options."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from gripcourse.course.compose import all_part_ids, direct_inputs, used_names
from gripcourse.course.model import Course, Option, OptionChoice, Part, Scheme
from gripcourse.course.quantity import Convention, Quantity


@dataclass(frozen=True, slots=True)
class OptionCondition:
    """Choices of an option, any of which brings a part."""

    option: Option
    choices: tuple[OptionChoice, ...]


@dataclass(frozen=True, slots=True)
class Occurrence:
    """A declaration as a scheme has it.

    Attributes:
        quantity: with the scheme's own changes.
        part: id of the part that declares it; empty for the scheme and the course.
        conditions: options that bring it, any of them; none where it is always there.
        anchor: its place on the page: the id, and the part where the id is declared before.
        changed: whether the scheme changes what the part declares.
    """

    quantity: Quantity
    part: str
    conditions: tuple[OptionCondition, ...]
    anchor: str
    changed: bool


@dataclass(frozen=True, slots=True)
class Content:
    """Everything that a scheme computes with any options.

    Attributes:
        course, scheme: what it belongs to.
        occurrences: inputs before what needs them, otherwise as declared.
        by_id: the declarations of an id; more than one where options exclude each other.
        using: those whose formula or rule has an id, in their order; without those of the id.
    """

    course: Course
    scheme: Scheme
    occurrences: tuple[Occurrence, ...]
    by_id: Mapping[str, tuple[Occurrence, ...]]
    using: Mapping[str, Sequence[Occurrence]]

    def meant(self, identifier: str, user: Occurrence | None = None) -> tuple[Occurrence, ...]:
        """Return the declarations that an id in a formula of another declaration may mean.

        Those of the same part count first, else all that some variant has together with the user.
        """
        versions = self.by_id[identifier]
        if user is None:
            return versions
        own = tuple(one for one in versions if one.part == user.part)
        return own or tuple(one for one in versions if _together(one, user)) or versions


def content_of(course: Course, scheme: Scheme) -> Content:
    """Collect the declarations of a scheme with all its options."""
    declared = tuple(_declared(course, scheme))
    used = used_names(one.quantity for one in declared)
    constants = (_always(one) for name, one in course.constants.items() if name in used)
    occurrences = _arranged((*constants, *declared))
    by_id: dict[str, tuple[Occurrence, ...]] = {}
    using: dict[str, list[Occurrence]] = {}
    for one in occurrences:
        by_id[one.quantity.id] = (*by_id.get(one.quantity.id, ()), one)
        for name in inputs_of(one.quantity):
            using.setdefault(name, []).append(one)
    return Content(course, scheme, occurrences, by_id, using)


def inputs_of(quantity: Quantity) -> tuple[str, ...]:
    """Return the ids that the declared formula and the rule of a quantity use."""
    formulas = [quantity.formula]
    if quantity.choice is not None:
        formulas.append(quantity.choice.condition)
    used = (name for formula in formulas if formula is not None for name in formula.names)
    return tuple(dict.fromkeys(name for name in used if name != quantity.id))


def parts_of(course: Course, scheme: Scheme) -> tuple[Part, ...]:
    """Return the parts that a scheme uses with any options, each once."""
    return tuple(course.parts[part] for part in all_part_ids(scheme))


def conditions_of(scheme: Scheme, part: str) -> tuple[OptionCondition, ...]:
    """Return which choices bring a part; nothing where every variant has it."""
    if part in scheme.parts:
        return ()
    found = []
    for option in scheme.options:
        choices = tuple(one for one in option.choices if part in one.parts)
        if len(choices) == len(option.choices):
            return ()
        if choices:
            found.append(OptionCondition(option, choices))
    return tuple(found)


def _together(one: Occurrence, other: Occurrence) -> bool:
    """Tell whether a variant may have both: no option brings the one or the other."""
    if len(one.conditions) != 1 or len(other.conditions) != 1:
        return True
    [mine], [theirs] = one.conditions, other.conditions
    if mine.option.id != theirs.option.id:
        return True
    return not {choice.id for choice in mine.choices}.isdisjoint(
        choice.id for choice in theirs.choices
    )


def _declared(course: Course, scheme: Scheme) -> Iterable[Occurrence]:
    seen: set[str] = set()
    for part in parts_of(course, scheme):
        conditions = conditions_of(scheme, part.id)
        for name, one in part.quantities.items():
            changed = name in scheme.overrides.get(part.id, {})
            quantity = scheme.overrides[part.id][name] if changed else one
            anchor = f"{name}.{part.id}" if name in seen else name
            seen.add(name)
            yield Occurrence(quantity, part.id, conditions, anchor, changed)
    for bringing, parts in scheme.optional_overrides.items():
        conditions = conditions_of(scheme, bringing)
        for id_, own in parts.items():
            for name, one in own.items():
                both = (*conditions_of(scheme, id_), *conditions)
                yield Occurrence(one, id_, both, f"{name}.{id_}.{bringing}", changed=True)
    yield from map(_always, scheme.quantities.values())


def _always(quantity: Quantity) -> Occurrence:
    return Occurrence(quantity, "", (), quantity.id, changed=False)


def _arranged(declared: tuple[Occurrence, ...]) -> tuple[Occurrence, ...]:
    """Put inputs before what needs them, as far as options that exclude each other allow it."""
    needed: dict[str, set[str]] = {}
    for one in declared:
        own = needed.setdefault(one.quantity.id, set())
        own.update(direct_inputs(one.quantity, Convention.CORRECTED))
    waiting = dict.fromkeys(needed)
    placed: list[str] = []
    while waiting:
        ready = (name for name in waiting if waiting.keys().isdisjoint(needed[name] - {name}))
        # In a circle of options that exclude each other, begin where least else is missing.
        name = next(ready, None) or min(
            waiting, key=lambda one: len(_missing(one, needed, waiting))
        )
        placed.append(name)
        del waiting[name]
    rank = {name: number for number, name in enumerate(placed)}
    return tuple(sorted(declared, key=lambda one: rank[one.quantity.id]))


def _missing(name: str, needed: Mapping[str, set[str]], waiting: Collection[str]) -> set[str]:
    """Return what is still waiting among all that a quantity is computed from in the end."""
    found: set[str] = set()
    look_at = [name]
    while look_at:
        new = {one for one in needed[look_at.pop()] if one in waiting} - found
        found |= new
        look_at += new
    return found
