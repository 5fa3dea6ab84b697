"""What tells whose a file is, by the codes that files hold."""

from enum import StrEnum


class KnownBy(StrEnum):
    """What told who handed a file in, the surest first."""

    PERSON = "person"  # somebody said so
    SIGNATURE = "signature"  # of the workbook
    PLATFORM = "platform"  # a learning platform's folder or file name
    FILE_NAME = "file_name"  # a file or folder named as the student's id
    NOTHING = ""
