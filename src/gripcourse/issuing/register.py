"""The register: which student was issued which numbers, for good."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from operator import attrgetter

from gripcourse.errors import Problem, RegisterError
from gripcourse.issuing.signature import verify
from gripcourse.issuing.withdrawal import Join, Withdrawal, joined_to, joins_of
from gripcourse.text.words import message
from gripcourse.variants.model import Issued, Student


@dataclass(frozen=True, slots=True)
class Register:
    """All that was issued in one course.

    Attributes:
        course_id: id of the course, part of every signature.
        entries: of each student the version that counts, in the order of the first issue.
        earlier: versions that others stand in the place of now; they were handed out. Among them is
            what was issued under ids that were joined with a student's.
        withdrawals: all that were kept, oldest first.
        joined: persons as they were listed under ids that were joined with a student's.
    """

    course_id: str
    entries: tuple[Issued, ...]
    earlier: tuple[Issued, ...] = ()
    withdrawals: tuple[Withdrawal, ...] = ()
    joined: tuple[Student, ...] = ()

    def by_student(self) -> Mapping[str, Issued]:
        """Return the entries by student id."""
        return {entry.student.id: entry for entry in self.entries}

    @property
    def joins(self) -> tuple[Join, ...]:
        """Which ids stand for one person, in the order in which they were joined."""
        return joins_of(self.withdrawals)

    def find(self, student: str) -> Issued | None:
        """Return the entry of whom an id names, also where it was joined with another's."""
        person = joined_to(self.withdrawals).get(student, student)
        return self.by_student().get(person)

    def versions(self) -> Mapping[str, tuple[Issued, ...]]:
        """Return all that each student was issued, oldest first; what was joined stands first."""
        found: dict[str, list[Issued]] = {}
        by_version = sorted((*self.earlier, *self.entries), key=attrgetter("version"))
        for entry in sorted(by_version, key=lambda one: not one.issued_as):
            found.setdefault(entry.student.id, []).append(entry)
        return {student: tuple(entries) for student, entries in found.items()}


def changed_entries(
    register: Register, key: bytes, former: Sequence[bytes] = ()
) -> tuple[Issued, ...]:
    """Return the entries whose numbers do not fit their signature: somebody changed them.

    Args:
        register: as it was read.
        key: that signs now.
        former: keys that signed before.
    """
    keys = (key, *former)
    return tuple(
        entry
        for entry in (*register.entries, *register.earlier)
        if not is_unchanged(entry, register.course_id, keys)
    )


def is_unchanged(entry: Issued, course_id: str, keys: Sequence[bytes]) -> bool:
    """Tell whether the numbers of an entry fit its signature by any of some keys."""
    student, variant, signed = entry.signed_for, entry.variant, entry.signature
    return any(verify(key, course_id, student, variant, signed, entry.version) for key in keys)


def verified(register: Register, key: bytes, place: str, former: Sequence[bytes] = ()) -> Register:
    """Return a register of which nobody has changed anything.

    Args:
        register: as it was read.
        key: of the signatures.
        place: where the register is, for a person.
        former: keys that signed before.

    Raises:
        RegisterError: naming every student whose numbers are not those that were issued.
    """
    changed = changed_entries(register, key, former)
    refuse_changed(changed, len(register.entries) + len(register.earlier), place)
    return register


def refuse_changed(changed: Sequence[Issued], entries: int, place: str) -> None:
    """Refuse a register of which somebody has changed anything.

    Args:
        changed: what does not fit its signature.
        entries: how many there are in all.
        place: where the register is, for a person.

    Raises:
        RegisterError: naming every student whose numbers are not those that were issued.
    """
    if len(changed) == entries > 1:
        what = message("No entry of the register fits the key: it is another key.")
        remedy = message("Restore the key that the course was issued with from a backup.")
        raise RegisterError([Problem(place, "", what, remedy)])
    if changed:
        raise RegisterError(
            Problem(
                place,
                message("student {student}", student=entry.signed_for),
                message(
                    "The register was changed: scheme, options or given numbers of variant"
                    " {variant} are not those that were issued.",
                    variant=entry.variant.id,
                ),
                message(
                    "Restore it from a backup; the student's own workbook and sheet are as issued."
                ),
            )
            for entry in changed
        )
