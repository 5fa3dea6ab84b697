"""What was issued to whom."""

from dataclasses import dataclass
from datetime import date

from gripcourse.variants.model import Student, Variant


@dataclass(frozen=True, slots=True)
class Issued:
    """One entry of the register: a student, the frozen values, and the signature over both.

    Attributes:
        student: as in the roster when it was issued.
        variant: the values that were issued; later changes of the table do not touch them.
        issued_on: day of the first issue.
        deadline: last day for handing in, None for none.
        signature: hexadecimal HMAC over the course, the student and the variant.
    """

    student: Student
    variant: Variant
    issued_on: date
    deadline: date | None
    signature: str
