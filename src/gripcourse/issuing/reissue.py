"""Issuing anew: a new version beside what was handed out, which stays as it was. Pure."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from typing import TypeAlias

from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem, UsageError
from gripcourse.issuing.allotment import Extended, Terms, holders_of, named_as_issued
from gripcourse.issuing.register import Register
from gripcourse.issuing.signature import sign
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, Texts, message
from gripcourse.variants.explain import with_unit
from gripcourse.variants.model import Issued, Variant
from gripcourse.variants.names import find_variant

QuantityOf: TypeAlias = Callable[[Variant, str], Quantity | None]
"""What a given quantity of a variant is declared to be, by its id; None where nobody knows it."""

DeclaredOtherwise: TypeAlias = Callable[[Issued], Sequence[Texts]]
"""Titles of the quantities that a version was issued with other declarations of than today's."""


@dataclass(frozen=True, slots=True)
class Correction:
    """What is issued anew, and why.

    Attributes:
        students: ids.
        variant: id of another variant; empty for the row of each student's own.
        why: the reason, kept for good.
        person: who does it.
    """

    students: tuple[str, ...]
    variant: str
    why: str
    person: str


def reissue(
    register: Register,
    correction: Correction,
    variants: Sequence[Variant],
    terms: Terms,
    quantity_of: QuantityOf = lambda *_: None,
    otherwise: DeclaredOtherwise = lambda _: (),
) -> Extended:
    """Put a new version in the place of what students were issued; the old one stays beside it.

    Who was issued the very same for the same reason before gets no further version: whoever was
    interrupted says the same again, to have the documents made.

    Args:
        register: what was issued before.
        correction: to whom, and why.
        variants: the table.
        terms: of the new versions; without a deadline everybody's own is kept.
        quantity_of: what quantities are, for the notes; they have their ids where nothing is said.
        otherwise: which quantities of a version are declared otherwise today, for the notes.

    Returns:
        The register with the new versions, and a note for each student that says what changed.

    Raises:
        UsageError: with everything that cannot be done; nothing is to be kept then.
    """
    problems = list(_faults_of_call(correction))
    variants, renamed = named_as_issued(variants, register)
    known, holders = register.by_student(), holders_of(register)
    fresh: dict[str, Issued] = {}
    again: list[Issued] = []
    for student in dict.fromkeys(correction.students):
        entry = known.get(student)
        if entry is None:
            what = message("The register has no student '{student}'.", student=student)
            problems.append(_problem("student", what, did_you_mean(student, known)))
            continue
        variant = _wanted(entry, correction, variants)
        if isinstance(variant, Problem):
            problems.append(variant)
            continue
        if _is_done(entry, variant, correction, terms):
            again.append(entry)
            continue
        refused = _refusal(entry, variant, holders, terms)
        if refused is not None:
            problems.append(refused)
            continue
        holders[variant.id] = student
        fresh[student] = _next_version(register.course_id, entry, variant, correction, terms)
    if problems:
        raise UsageError(problems)
    return Extended(
        replace(
            register,
            entries=tuple(fresh.get(entry.student.id, entry) for entry in register.entries),
            earlier=(*register.earlier, *(known[student] for student in fresh)),
        ),
        (
            *renamed,
            *map(_said_again, again),
            *(
                _with_declarations(
                    _said(known[student], entry, quantity_of), known[student], otherwise
                )
                for student, entry in fresh.items()
            ),
        ),
    )


def _faults_of_call(correction: Correction) -> Iterator[Problem]:
    if not correction.why.strip():
        yield _problem(
            "why",
            message("A reissue needs a reason."),
            message("Say why: whoever asks in a year reads it."),
        )
    if not correction.students:
        yield _problem(
            "student",
            message("Name the students to reissue to."),
            message("Name the students by their ids."),
        )


def _wanted(
    entry: Issued, correction: Correction, variants: Sequence[Variant]
) -> Variant | Problem:
    """Return what a student gets: the named variant, else the row of their own as it is now."""
    if not correction.variant:
        return find_variant(variants, entry.variant.id) or entry.variant
    found = find_variant(variants, correction.variant)
    if found is not None:
        return found
    what = message("The table has no variant '{variant}'.", variant=correction.variant)
    remedy = did_you_mean(correction.variant, (one.id for one in variants))
    return _problem("variant", what, remedy)


def _is_done(entry: Issued, variant: Variant, correction: Correction, terms: Terms) -> bool:
    """Tell whether the last version of a student is the one that is asked for."""
    return (
        entry.version > 1
        and entry.why == correction.why.strip()
        and terms.deadline in {None, entry.deadline}
        and _is_same(entry, variant, terms)
    )


def _is_same(entry: Issued, variant: Variant, terms: Terms) -> bool:
    return variant == entry.variant and entry.declarations == terms.declarations


def _refusal(
    entry: Issued, variant: Variant, holders: Mapping[str, str], terms: Terms
) -> Problem | None:
    student = entry.student.id
    holder = holders.get(variant.id, student)
    if holder != student:
        return _problem(
            "variant",
            message(
                "The variant '{variant}' is issued to {holder} already.",
                variant=variant.id,
                holder=holder,
            ),
            message("Name a variant that nobody has."),
        )
    if _is_same(entry, variant, terms):
        return _problem(
            "student",
            message(
                "{student} has just these numbers of variant {variant}, and the declarations are"
                " those that they were issued by.",
                student=student,
                variant=variant.id,
            ),
            message(
                "Correct the row of the table or the declarations first, or name another variant."
                " A lost sheet is made again by issuing; another deadline needs no new version."
            ),
        )
    return None


def _next_version(
    course_id: str, entry: Issued, variant: Variant, correction: Correction, terms: Terms
) -> Issued:
    version = entry.version + 1
    return replace(
        entry,
        variant=variant,
        issued_on=terms.today,
        deadline=terms.deadline or entry.deadline,
        own_deadline=None if terms.deadline else entry.own_deadline,
        signature=sign(terms.key, course_id, entry.student.id, variant, version),
        version=version,
        why=correction.why.strip(),
        issued_by=correction.person,
        declarations=terms.declarations,
    )


def _said_again(entry: Issued) -> Message:
    return message(
        "{student}: version {version} of variant {variant} was issued for this reason already; its"
        " documents are made again.",
        student=entry.student.id,
        version=entry.version,
        variant=entry.variant.id,
    )


def _said(before: Issued, after: Issued, quantity_of: QuantityOf) -> Message:
    """Say what a new version changes; of the same variant, which numbers."""
    old, new = before.variant, after.variant
    student, version = after.student.id, after.version
    if old == new:
        return message(
            "{student}: version {version} of variant {variant}, with the same numbers.",
            student=student,
            version=version,
            variant=new.id,
        )
    if (old.id, old.scheme, old.options) != (new.id, new.scheme, new.options):
        return message(
            "{student}: version {version} is variant {variant}, scheme {scheme}; before it was"
            " variant {old}, scheme {old_scheme}.",
            student=student,
            version=version,
            variant=new.id,
            scheme=new.scheme,
            old=old.id,
            old_scheme=old.scheme,
        )
    changes = (
        message(
            "{quantity}: {before} → {after}",
            quantity=_called(name, quantity_of(new, name)),
            before=_written(old.given.get(name), quantity_of(old, name)),
            after=_written(new.given.get(name), quantity_of(new, name)),
        )
        for name in dict.fromkeys((*old.given, *new.given))
        if old.given.get(name) != new.given.get(name)
    )
    return message(
        "{student}: version {version} of variant {variant}. {changes}.",
        student=student,
        version=version,
        variant=new.id,
        changes=reduce(_listed, changes),
    )


def _with_declarations(said: Message, before: Issued, otherwise: DeclaredOtherwise) -> Message:
    """Say besides which quantities a version declared otherwise than today's course does."""
    titles = [message("{title}", title=one) for one in otherwise(before)]
    if not titles:
        return said
    return message(
        "{said} Declared otherwise since: {quantities}.",
        said=said,
        quantities=reduce(_listed, titles),
    )


def _called(name: str, quantity: Quantity | None) -> Texts | str:
    return name if quantity is None else quantity.title


def _written(value: float | None, quantity: Quantity | None) -> Message | float | str:
    if value is None:
        return "—"
    return value if quantity is None else with_unit(value, quantity)


def _listed(before: Message, after: Message) -> Message:
    return message("{before}; {after}", before=before, after=after)


def _problem(parameter: str, what: Message, remedy: Message) -> Problem:
    return Problem("", "", what, remedy, parameter=parameter)
