"""What an instructor should look at before marks are published."""

import hmac
import math
from collections.abc import Iterator, Sequence

from gripcourse.grading.model import Finding, Flag, FlagCode
from gripcourse.submission.model import Identity, Submission
from gripcourse.text.shown import first_of
from gripcourse.text.words import counted, message
from gripcourse.variants.model import Issued

# Stored givens are decimal numbers; a spreadsheet program writes back 15 digits of them.
_SAME = 1e-12
_NAMED = 5  # answers that a sentence names


def flags_of(
    submission: Submission, issued: Issued, findings: Sequence[Finding]
) -> tuple[Flag, ...]:
    """Return the flags of a judged submission."""
    return (
        *_identity_flags(submission, issued),
        *_given_flags(submission, issued),
        *_moved_flags(submission),
        *_absent_flags(submission, issued),
        *not_judged_flags(findings),
    )


def _moved_flags(submission: Submission) -> Iterator[Flag]:
    if submission.moved:
        said = counted(
            "Rows were sorted or inserted: {count} answer was taken from the row with its title. "
            "Compare it with the file.",
            "Rows were sorted or inserted: {count} answers were taken from the rows with their "
            "titles. Compare them with the file.",
            len(submission.moved),
        )
        yield Flag(FlagCode.CELLS_MOVED, said)


def _absent_flags(submission: Submission, issued: Issued) -> Iterator[Flag]:
    """In somebody else's workbook it is no wonder that cells are absent."""
    if submission.absent and submission.identity.student in {"", issued.signed_for}:
        said = counted(
            "The workbook has no cell for {count} answer, which counts as blank: {names}. Either it"
            " was deleted, or the course asks for it only since the workbook was issued. Then issue"
            " the assignment anew: works on the earlier version are judged by what it asked for.",
            "The workbook has no cells for {count} answers, which count as blank: {names}. Either"
            " they were deleted, or the course asks for them only since the workbook was issued."
            " Then issue the assignment anew: works on the earlier version are judged by what it"
            " asked for.",
            len(submission.absent),
            names=first_of(submission.absent, _NAMED),
        )
        yield Flag(FlagCode.ANSWERS_MISSING, said)


def _identity_flags(submission: Submission, issued: Issued) -> Iterator[Flag]:
    identity = submission.identity
    if not identity.student:
        yield Flag(
            FlagCode.IDENTITY_MISSING,
            message("The workbook no longer says to whom it was issued."),
        )
    elif identity.student != issued.signed_for:
        yield Flag(
            FlagCode.ISSUED_TO_OTHER,
            message(
                "The workbook was issued to {other}; it was handed in by {student}, "
                "against whose variant it was graded.",
                other=identity.student,
                student=issued.student.id,
            ),
            (identity.student,),
        )
    elif not hmac.compare_digest(identity.signature.encode(), issued.signature.encode()):
        yield Flag(
            FlagCode.SIGNATURE,
            message("The signature of the workbook is not the one that was issued."),
        )
    if identity.other not in {"", issued.signed_for}:
        yield Flag(
            FlagCode.IDENTITY_CHANGED,
            message(
                "The workbook was issued to {other}, as its properties say, and changed to say that"
                " it is {student}'s.",
                other=identity.other,
                student=identity.student or "—",
            ),
            (identity.other,),
        )
    if identity.student == issued.signed_for and _is_changed(identity, issued):
        yield Flag(
            FlagCode.IDENTITY_CHANGED,
            message(
                "The workbook was changed to say it is of variant {variant}, scheme {scheme}; what"
                " was issued counts.",
                variant=identity.variant or "—",
                scheme=identity.scheme or "—",
            ),
        )


def _is_changed(identity: Identity, issued: Issued) -> bool:
    """Tell whether a workbook says something else of its variant than was issued."""
    variant = issued.variant
    pairs = (
        (identity.variant, variant.id),
        (identity.scheme, variant.scheme),
        (identity.options, variant.options),
    )
    return any(said and said != was_issued for said, was_issued in pairs)


def _given_flags(submission: Submission, issued: Issued) -> Iterator[Flag]:
    """Changed givens matter only in the student's own workbook: another's are all different."""
    if submission.identity.student not in {"", issued.signed_for}:
        return
    changed = [
        name
        for name, value in issued.variant.given.items()
        if name in submission.givens
        and not math.isclose(submission.givens[name], value, rel_tol=_SAME)
    ]
    missing = [name for name in issued.variant.given if name not in submission.givens]
    if changed:
        yield Flag(
            FlagCode.GIVENS_CHANGED,
            message(
                "Given values were changed in the workbook: {names}. The issued values count.",
                names=", ".join(changed),
            ),
        )
    if missing:
        yield Flag(
            FlagCode.GIVENS_MISSING,
            message(
                "Given values are missing in the workbook: {names}. The issued values count.",
                names=", ".join(missing),
            ),
        )


def not_judged_flags(findings: Sequence[Finding]) -> Iterator[Flag]:
    """Yield the flag of the answers that a person must judge, if there are any."""
    not_judged = [one.quantity for one in findings if _is_undecided(one)]
    if not_judged:
        yield Flag(
            FlagCode.NOT_JUDGED,
            message("The instructor must judge: {names}.", names=", ".join(not_judged)),
        )


def _is_undecided(finding: Finding) -> bool:
    """Tell whether a person must judge what the program should have judged."""
    return finding.outcome.traits.waits and not finding.outcome.traits.by_rubric
