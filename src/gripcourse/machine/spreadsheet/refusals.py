"""Why a file is no workbook that we can read: a code for programs, a sentence for its sender."""

from collections.abc import Mapping
from enum import StrEnum
from typing import Final

from gripcourse.text.words import Message, message


class WhyRefused(StrEnum):
    """Why a file was refused; the value stands in JSON and in tables."""

    ARCHIVE = "archive"
    DAMAGED = "damaged"
    DELIMITED_TEXT = "plain_text"
    EMPTY = "empty"
    FOREIGN = "foreign"
    FOREIGN_CONTENT = "foreign_content"
    GONE = "cannot_be_opened"
    INVALID_XML = "invalid_xml"
    LINK = "link"
    LOCK_FILE = "lock_file"
    MERGED = "merged"
    NO_WORKBOOK = "no_workbook"
    NUMBERS = "numbers"
    OLD_FORMAT = "xls"
    OPEN_DOCUMENT = "ods"
    PART_MISSING = "part_missing"
    PASSWORD = "password"  # noqa: S105 (no password but a code)
    PDF = "pdf"
    PICTURE = "picture"
    TEXT_DOCUMENT = "text_document"
    TOO_COSTLY = "too_costly"
    TOO_LARGE = "too_large"
    UNREADABLE_CONTENT = "unreadable_content"
    WEB_PAGE = "web_page"
    XLSB = "xlsb"


_COPY: Final = message("Copy the answers into the workbook that was issued and send that.")

REASONS: Final[Mapping[WhyRefused, Message]] = {
    WhyRefused.ARCHIVE: message(
        "The file is an archive, whatever its name says. Unpack it and send the .xlsx workbook."
    ),
    WhyRefused.DAMAGED: message(
        "The file is damaged: it was not copied or sent as a whole. Send it again."
    ),
    WhyRefused.DELIMITED_TEXT: message(
        "The file is plain text, for example a CSV table, not an .xlsx workbook. Fill in the "
        "workbook that was issued."
    ),
    WhyRefused.EMPTY: message("The file is empty: it has no bytes."),
    WhyRefused.FOREIGN: message(
        "The workbook has none of the answer cells: it is not the workbook that was issued. "
        "{remedy}",
        remedy=_COPY,
    ),
    WhyRefused.FOREIGN_CONTENT: message(
        "The workbook holds content that no spreadsheet program writes. Copy the answers into the "
        "workbook that was issued."
    ),
    WhyRefused.GONE: message(
        "The file is no longer there, or it may not be read. Put it back, or grade without it."
    ),
    WhyRefused.INVALID_XML: message(
        "Open the answer workbook in a spreadsheet program and save it again."
    ),
    WhyRefused.LINK: message(
        "The file is only a link to a document that lies elsewhere. Download the document as an "
        ".xlsx workbook and send that."
    ),
    WhyRefused.LOCK_FILE: message(
        "This is the lock file of a workbook that is open. Close the spreadsheet program "
        "and send the workbook itself."
    ),
    WhyRefused.MERGED: message(
        "Whole columns or rows, or very many cells, of the workbook are merged. Undo the merging "
        "and save the workbook again."
    ),
    WhyRefused.NO_WORKBOOK: message(
        "The file is not a workbook. Send the .xlsx file that was issued."
    ),
    WhyRefused.NUMBERS: message(
        "The file is a document of Apple Numbers. Export it as an .xlsx workbook."
    ),
    WhyRefused.OLD_FORMAT: message(
        "The file has the old .xls format. Save it as an .xlsx workbook."
    ),
    WhyRefused.OPEN_DOCUMENT: message(
        "The file is an OpenDocument file. Save it as an .xlsx workbook."
    ),
    WhyRefused.PART_MISSING: message("A part of the workbook is missing. {remedy}", remedy=_COPY),
    WhyRefused.PASSWORD: message(
        "The workbook is protected by a password. Remove the password and save it."
    ),
    WhyRefused.PDF: message("The file is a PDF document. Send the .xlsx workbook itself."),
    WhyRefused.PICTURE: message("The file is a picture. Send the .xlsx workbook itself."),
    WhyRefused.TEXT_DOCUMENT: message(
        "The file is a text document. Send the .xlsx workbook itself."
    ),
    WhyRefused.TOO_COSTLY: message(
        "The workbook takes more time or memory to read than an answer workbook may. {remedy}",
        remedy=_COPY,
    ),
    WhyRefused.TOO_LARGE: message(
        "The file holds far more than an answer workbook does. Copy the answers into the workbook "
        "that was issued."
    ),
    WhyRefused.UNREADABLE_CONTENT: message(
        "The workbook holds content that cannot be read, for example two sheets of one title. "
        "{remedy}",
        remedy=_COPY,
    ),
    WhyRefused.WEB_PAGE: message(
        "The file is a web page or XML, not an .xlsx workbook, whatever its name says. Save it "
        "as an .xlsx workbook."
    ),
    WhyRefused.XLSB: message("The file has the .xlsb format. Save it as an .xlsx workbook."),
}
"""What each means, and what to do."""

OF_THE_MACHINE: Final = frozenset({WhyRefused.GONE, WhyRefused.TOO_COSTLY})
"""What another day or another machine may do better; all else is said of a file's very bytes."""
