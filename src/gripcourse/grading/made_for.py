"""Which version of an assignment a workbook was made for: told by its signature."""

import hmac
from collections.abc import Iterable, Mapping, Sequence
from typing import Final

from gripcourse.submission.model import Identity
from gripcourse.text.words import Message, message
from gripcourse.variants.model import Issued

BY_TODAYS: Final = message(
    "Formulas and tolerances are today's, which give more than those that this version was issued"
    " with."
)


def is_signed_as(identity: Identity, issued: Issued) -> bool:
    """Tell whether a workbook bears the signature of what was issued."""
    return hmac.compare_digest(identity.signature.encode(), issued.signature.encode())


def version_made_for(
    identity: Identity | None, versions: Sequence[Issued], named_as: str = ""
) -> Issued:
    """Return the version that a workbook was made for; where none signed it, the last of its id.

    Of two ids that were joined each has its own sheet: joining says whose a work is, and nothing of
    the sheet that it was made for.

    Args:
        identity: what the workbook says; None where it could not be read.
        versions: of one student, oldest first.
        named_as: the id by which something else names the student, where the workbook names none;
            empty for none.
    """
    if identity is not None:
        signed = (one for one in versions if is_signed_as(identity, one))
        if (found := next(signed, None)) is not None:
            return found
    last = {one.signed_for: one for one in versions}
    inside = "" if identity is None else identity.student
    return last.get(inside) or last.get(named_as) or versions[-1]


def versions_of(
    student: str, register: Mapping[str, Issued], earlier: Mapping[str, Sequence[Issued]]
) -> tuple[Issued, ...]:
    """Return all that a student was issued, oldest first; the student is on the register."""
    return (*earlier.get(student, ()), register[student])


def is_of_other_declarations(issued: Issued, last: Issued) -> bool:
    """Tell whether a version was issued by other declarations than the one that replaced it."""
    differs = issued.declarations != last.declarations and not issued.issued_as
    return issued.version < last.version and bool(issued.declarations) and differs


def said_of_version(
    issued: Issued, versions: Sequence[Issued], *, kept: bool = False
) -> tuple[Message, ...]:
    """Say which version a work was judged by; nothing where there was only one.

    Args:
        issued: that version.
        versions: all of the student, oldest first.
        kept: whether it was judged by declarations of its own.
    """
    last = versions[-1]
    if issued.issued_as:
        other = message(
            "This workbook was issued to {id}, which was joined with {student}; it was judged by"
            " the values on its sheet, variant {variant}.",
            id=issued.issued_as,
            student=last.student.id,
            variant=issued.variant.id,
        )
        return (other,)
    if last.version == 1:
        return ()
    if issued.version == last.version:
        said = message(
            "Judged by version {version} of the assignment, the last one.", version=last.version
        )
    else:
        said = message(
            "This workbook was made for version {version} of the assignment and was judged by it;"
            " version {last} was issued later.",
            version=issued.version,
            last=last.version,
        )
    if kept:
        own = message("Formulas and tolerances are those that this version was issued with.")
        return (said, own)
    if is_of_other_declarations(issued, last):
        lost = message(
            "Since then formulas or tolerances of the course have changed, and those of that"
            " version are not there any more: the work was judged by today's."
        )
        return (said, lost)
    return (said,)


def said_of_both(counts: Issued, others: Iterable[Issued], shares: Sequence[float]) -> Message:
    """Say that a work was judged by several versions, and which of them counts.

    Args:
        counts: the version that counts.
        others: the versions that do not.
        shares: of the points that are decided, 0…1: of `counts`, then of `others`.
    """
    best, *rest = (round(100 * share, 1) for share in shares)
    return message(
        "Judged by several versions of the assignment, as the instructor allowed: version {version}"
        " counts ({percent} %); not counted: {others}.",
        version=counts.version,
        percent=best,
        others=", ".join(
            f"{one.version} ({share:g} %)" for one, share in zip(others, rest, strict=True)
        ),
    )
