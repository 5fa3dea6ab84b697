"""What is said of an answer that counts by another version of a formula than the reference's."""

from gripcourse.course.quantity import Alternative, AsPrinted
from gripcourse.text.words import Message, message


def read_otherwise(other: Alternative) -> Message:
    """Say how an answer was read."""
    return message("Read otherwise: {remark}", remark=other.remark)


def as_printed(printed: AsPrinted) -> Message:
    """Say which misprint of a source an answer comes from."""
    return message(
        "As the source prints it (erratum {erratum}): {note}",
        erratum=printed.erratum,
        note=printed.note,
    )
