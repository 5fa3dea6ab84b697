"""The register: which student was issued which numbers, for good."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from operator import attrgetter

from gripcourse.errors import Problem, RegisterError
from gripcourse.issuing.signature import verify
from gripcourse.text.words import message
from gripcourse.variants.model import Issued


@dataclass(frozen=True, slots=True)
class Register:
    """All that was issued in one course.

    Attributes:
        course_id: id of the course, part of every signature.
        entries: of each student the version that counts, in the order of the first issue.
        earlier: versions that others stand in the place of now; they were handed out.
    """

    course_id: str
    entries: tuple[Issued, ...]
    earlier: tuple[Issued, ...] = ()

    def by_student(self) -> Mapping[str, Issued]:
        """Return the entries by student id."""
        return {entry.student.id: entry for entry in self.entries}

    def versions(self) -> Mapping[str, tuple[Issued, ...]]:
        """Return all that each student was issued, oldest first."""
        found: dict[str, list[Issued]] = {}
        for entry in sorted((*self.earlier, *self.entries), key=attrgetter("version")):
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
    return tuple(
        entry
        for entry in (*register.entries, *register.earlier)
        if not any(_fits(one, register.course_id, entry) for one in (key, *former))
    )


def _fits(key: bytes, course_id: str, entry: Issued) -> bool:
    return verify(key, course_id, entry.student.id, entry.variant, entry.signature, entry.version)


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
    if len(changed) == len(register.entries) + len(register.earlier) > 1:
        what = message("Not one entry of the register fits the key: it is another one.")
        remedy = message("Restore the key that the course was issued with from a backup.")
        raise RegisterError([Problem(place, "", what, remedy)])
    if changed:
        raise RegisterError(
            Problem(
                place,
                message("student {student}", student=entry.student.id),
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
    return register
