"""Whose a workbook says it is, and who saved it."""

from collections.abc import Iterable, Mapping
from xml.etree.ElementTree import Element

from gripcourse.machine.spreadsheet.package import Package
from gripcourse.machine.spreadsheet.xml_scan import local
from gripcourse.submission.model import Identity
from gripcourse.submission.raw import RawCell
from gripcourse.text.words import Message, message
from gripcourse.workbook import names


def identity_of(
    meta: Mapping[str, RawCell], package: Package
) -> tuple[Identity, tuple[Message, ...]]:
    """Read whose workbook it is: from the hidden sheet, else from the document's properties.

    Args:
        meta: cells of the hidden sheet, by what they hold.
        package: the workbook.

    Returns:
        What it says, and what is odd about it.
    """
    stored = _properties(package)
    hidden = {name: str(cell.value) for name, cell in meta.items() if cell.value is not None}
    fields = {name: hidden.get(name) or stored.get(name, "") for name in names.FIELDS}
    stored_student = stored.get(names.STUDENT, "")
    identity = Identity(
        student=fields[names.STUDENT],
        variant=fields[names.VARIANT],
        scheme=fields[names.SCHEME],
        options=names.read_options(fields[names.OPTIONS]),
        signature=fields[names.SIGNATURE],
        other=stored_student if stored_student != fields[names.STUDENT] else "",
    )
    if hidden:
        return identity, ()
    return identity, (
        message("The hidden sheet that says whose workbook this is has been removed."),
    )


def _properties(package: Package) -> Mapping[str, str]:
    """Return our custom properties of the document."""
    prefix = names.cell_name(names.PROPERTY, "")
    return {
        one.get("name", "").removeprefix(prefix): "".join(value.text or "" for value in one)
        for one in _of_document(package, "custom-properties")
        if local(one) == "property" and one.get("name", "").startswith(prefix)
    }


def creator_of(package: Package) -> str:
    """Return who saved a workbook last, or who made it; nothing else of its properties is read."""
    found = {local(one): one.text or "" for one in _of_document(package, "core-properties")}
    return found.get("lastModifiedBy") or found.get("creator") or ""


def _of_document(package: Package, kind: str) -> Iterable[Element]:
    parts = (one.part for one in package.related("") if one.kind == kind and package.has(one.part))
    part = next(parts, None)
    root = None if part is None else package.sound_root(part)
    return () if root is None else root.iter()
