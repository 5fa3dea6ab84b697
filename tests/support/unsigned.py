"""A workbook that another program left without anything that says whose it is."""

from pathlib import Path

import openpyxl
from openpyxl.packaging.core import DocumentProperties


def leave_unsigned(path: Path) -> None:
    """Take the hidden sheet and the properties of a document away."""
    book = openpyxl.load_workbook(path)
    for sheet in book.worksheets:
        if sheet.sheet_state != "visible":
            book.remove(sheet)
    book.properties = DocumentProperties()
    for name in list(book.custom_doc_props.names):
        del book.custom_doc_props[name]
    book.save(path)
