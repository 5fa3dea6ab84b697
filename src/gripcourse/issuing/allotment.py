"""Who gets which variant: decided once, and never changed by what comes later."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import date
from typing import Final

from gripcourse.errors import Problem, TableError
from gripcourse.issuing.register import Register
from gripcourse.issuing.signature import sign
from gripcourse.text.shown import first_of
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import Message, counted, message
from gripcourse.variants.model import Issued, Student, Variant
from gripcourse.variants.names import find_variant, without_leading_zeros

_NAMED: Final = 10  # variants or students that a note names


@dataclass(frozen=True, slots=True)
class Terms:
    """What counts for everybody who is new.

    Attributes:
        key: of the signatures.
        today: day of the issue.
        deadline: last day for handing in, None for none.
        declarations: fingerprint of the course's declarations.
    """

    key: bytes
    today: date
    deadline: date | None
    declarations: str = ""


@dataclass(frozen=True, slots=True)
class Extended:
    """A register with its new entries, and what the instructor should know.

    Attributes:
        register: old entries first, in their order; new ones in the order of the roster.
        notes: what was kept although the roster or the table says otherwise now.
        outdated: students of whose variants the table has other numbers now.
        left: students of the roster who have left the course.
        in_and_out: students who are new, and those of the same groups who are not in the list:
            one of them may be another of them under a new name.
    """

    register: Register
    notes: tuple[Message, ...]
    outdated: tuple[str, ...] = ()
    left: tuple[str, ...] = ()
    in_and_out: tuple[tuple[str, ...], tuple[str, ...]] = ((), ())


def extend(
    register: Register, students: Sequence[Student], variants: Sequence[Variant], terms: Terms
) -> Extended:
    """Issue variants to those students who have none.

    A student who is in the register keeps variant, numbers, date and deadline; only the person's
    data follow the roster. A new student gets the variant that the roster fixes, or the next free
    one in the order of the table, after all fixed ones are set aside.

    Args:
        register: what was issued before.
        students: the roster.
        variants: the table.
        terms: for the new ones.

    Returns:
        The new register and notes.

    Raises:
        TableError: a fixed variant is unknown or taken, or there are not enough variants; all
            problems at once.
    """
    variants, renamed = named_as_issued(variants, register)
    known = register.by_student()
    roster = {student.id: student for student in students}
    kept = tuple(_updated(entry, roster) for entry in register.entries)
    new = [student for student in students if student.id not in known]
    chosen = _allot(new, variants, holders_of(register))
    issued = tuple(
        Issued(
            student,
            chosen[student.id],
            terms.today,
            terms.deadline,
            sign(terms.key, register.course_id, student.id, chosen[student.id]),
            declarations=terms.declarations,
        )
        for student in new
    )
    in_and_out = _in_and_out(register, roster)
    notes = _notes(register, roster, variants, terms.deadline)
    extended = replace(register, entries=(*kept, *issued))
    return Extended(
        extended,
        (*renamed, *notes, *_under_another_name(*in_and_out)),
        _outdated(register, roster, variants),
        tuple(one for one in roster if one in known and known[one].left),
        in_and_out,
    )


def _outdated(
    register: Register, roster: Mapping[str, Student], variants: Sequence[Variant]
) -> tuple[str, ...]:
    table = {variant.id: variant for variant in variants}
    return tuple(
        entry.student.id
        for entry in register.entries
        if entry.student.id in roster
        and table.get(entry.variant.id, entry.variant) != entry.variant
    )


def holders_of(register: Register) -> dict[str, str]:
    """Return by variant the student who was handed it out, now or in an earlier version."""
    return {entry.variant.id: entry.student.id for entry in (*register.earlier, *register.entries)}


def _updated(entry: Issued, roster: Mapping[str, Student]) -> Issued:
    """Take name, group, mail address and language from the roster; the fixed variant stays."""
    student = roster.get(entry.student.id)
    if student is None:
        return entry
    return replace(entry, student=replace(student, variant=entry.student.variant))


def _allot(
    new: Sequence[Student], variants: Sequence[Variant], taken: Mapping[str, str]
) -> dict[str, Variant]:
    """Return the variant of each new student: fixed ones first, then the free ones in order."""
    problems: list[Problem] = []
    chosen: dict[str, Variant] = {}
    holders = dict(taken)
    for student in (one for one in new if one.variant):
        variant = find_variant(variants, student.variant)
        if variant is None or variant.id in holders:
            problems.append(_refusal(student, variant, variants, holders))
            continue
        chosen[student.id] = variant
        holders[variant.id] = student.id
    free = [variant for variant in variants if variant.id not in holders]
    waiting = [student for student in new if not student.variant]
    if len(waiting) > len(free):
        problems.append(
            Problem(
                "",
                "",
                message(
                    "Students who need a variant: {students}; variants that are free: {free};"
                    " missing: {missing}.",
                    students=len(waiting),
                    free=len(free),
                    missing=len(waiting) - len(free),
                ),
                message("Draw or import more variants; those that are issued stay as they are."),
            )
        )
    if problems:
        raise TableError(problems)
    return chosen | {student.id: variant for student, variant in zip(waiting, free, strict=False)}


def named_as_issued(
    variants: Sequence[Variant], register: Register
) -> tuple[tuple[Variant, ...], tuple[Message, ...]]:
    """Return a table whose rows are called as they were when they were issued, and what is said.

    A spreadsheet program makes 1 of 001. As a variant of its own it would be handed out once more.
    """
    table = {variant.id for variant in variants}
    issued: dict[str, set[str]] = {}
    for id_ in holders_of(register):
        issued.setdefault(without_leading_zeros(id_), set()).add(id_)
    renamed: dict[str, str] = {}
    for id_ in table:
        meant = issued.get(without_leading_zeros(id_), set())
        if id_ not in meant and len(meant - table) == 1 == len(meant):
            (renamed[id_],) = meant
    if not renamed:
        return tuple(variants), ()
    pairs = [f"{one.id} → {renamed[one.id]}" for one in variants if one.id in renamed]
    said = message(
        "The table lacks the leading zeros of variants that were issued, as after a spreadsheet"
        " program; they are taken for these: {pairs}.",
        pairs=first_of(pairs, _NAMED),
    )
    return tuple(replace(one, id=renamed.get(one.id, one.id)) for one in variants), (said,)


def _refusal(
    student: Student,
    variant: Variant | None,
    variants: Sequence[Variant],
    holders: Mapping[str, str],
) -> Problem:
    key = message("student {student}", student=student.id)
    if variant is None:
        what = message("The fixed variant '{variant}' is not in the table.",
                       variant=student.variant)  # fmt: skip
        return Problem("", key, what, did_you_mean(student.variant, (one.id for one in variants)))
    what = message("The fixed variant '{variant}' is issued to {holder} already.",
                   variant=variant.id, holder=holders[variant.id])  # fmt: skip
    remedy = message("Fix another one, or leave the cell blank for the next free one.")
    return Problem("", key, what, remedy)


def _notes(
    register: Register,
    roster: Mapping[str, Student],
    variants: Sequence[Variant],
    deadline: date | None,
) -> tuple[Message, ...]:
    """Say what was kept although the roster, the table or the deadline says otherwise now."""
    table = {variant.id: variant for variant in variants}
    notes: list[Message] = []
    absent: list[str] = []
    for entry in register.entries:
        name, id_ = entry.student.id, entry.variant.id
        student = roster.get(name)
        if student is None:
            # A part of a group may be listed alone: that is no list of all.
            absent += [] if entry.left else [name]
            continue
        if entry.left:
            notes.append(message("{student} is in the list and has left the course: {why}. Nothing"
                                 " is handed out.", student=name,
                                 why=entry.left.rstrip(".")))  # fmt: skip
            continue
        now = table.get(id_)
        if now is None:
            notes.append(message("{student} keeps variant {variant}, which is no longer in the"
                                 " table.", student=name, variant=id_))  # fmt: skip
        elif now != entry.variant:
            notes.append(message("{student} keeps variant {variant} with the numbers that were"
                                 " issued; the table has others now.", student=name,
                                 variant=id_))  # fmt: skip
        if student.variant and without_leading_zeros(student.variant) != without_leading_zeros(id_):
            notes.append(message("{student} keeps variant {variant}, although the roster says"
                                 " {fixed} now.", student=name, variant=id_,
                                 fixed=student.variant))  # fmt: skip
        if deadline is not None and entry.deadline != deadline:
            notes.append(_kept_deadline(name, entry.deadline))
    if absent:
        notes.append(
            counted(
                "{count} student who has a variant is not in this list and keeps it.",
                "{count} students who have a variant are not in this list and keep it.",
                len(absent),
            )
        )
    return tuple(notes)


def _under_another_name(new: Sequence[str], gone: Sequence[str]) -> Iterator[Message]:
    """Ask whether one of those who are new is one of those who are gone: only a surname changed."""
    if new:
        yield message(
            "New in this list: {new}; no longer in it, of the same groups: {gone}. Is anybody"
            " in both under another name?",
            new=first_of(new, _NAMED),
            gone=first_of(gone, _NAMED),
        )


def _in_and_out(
    register: Register, roster: Mapping[str, Student]
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return who is new and who is gone of the same groups; nobody where either is nobody."""
    known = register.by_student()
    groups = {student.group for id_, student in roster.items() if id_ in known}
    gone = tuple(
        id_
        for id_, one in known.items()
        if id_ not in roster and not one.left and one.student.group in groups
    )
    new = tuple(id_ for id_ in roster if id_ not in known)
    return (new, gone) if new and gone else ((), ())


def _kept_deadline(student: str, deadline: date | None) -> Message:
    """Say that issuing again gave nobody another deadline."""
    if deadline is None:
        return message(
            "{student} was issued without a deadline and still has none. Write one into"
            " variants/deadlines.csv, which counts before what was issued.",
            student=student,
        )
    return message(
        "{student} keeps the deadline {deadline}.", student=student, deadline=deadline.isoformat()
    )
