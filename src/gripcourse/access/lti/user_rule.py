"""By what somebody of a platform is known to be a student of the roster."""

from enum import StrEnum


class UserRule(StrEnum):
    """What a platform says of a person that the roster has too."""

    SOURCEDID = "sourcedid"  # the office's number of the person is the student's id
    EMAIL = "email"
