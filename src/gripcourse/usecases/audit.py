"""Auditing a table of variants: the certificate as PDF, its numbers as CSV."""

import hashlib
from dataclasses import dataclass
from datetime import date
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.exports.audit_tables import audit_tables
from gripcourse.machine.content import Readable, content_of, pure_path, shown_name
from gripcourse.machine.files import write_bytes
from gripcourse.policy.load import load_policy
from gripcourse.text.words import Words
from gripcourse.variants.audit import VariantAudit, audit
from gripcourse.variants.space import load_spaces
from gripcourse.variants.table import read_table

CERTIFICATE = "certificate.pdf"


@dataclass(frozen=True, slots=True)
class WrittenAudit:
    """What was found out about a table, and where it was written."""

    table: str
    audit: VariantAudit
    written: tuple[Path, ...]


def audit_table(
    course: Course, table: Readable, out: Path, words: Words, today: date
) -> WrittenAudit:
    """Audit a table and write the certificate and its numbers into a folder.

    Args:
        course: whose variants they are.
        table: CSV or spreadsheet, a file or its bytes.
        out: folder to write to.
        words: the language of the certificate.
        today: the day that it bears.

    Raises:
        GripcourseError: the table cannot be read, or holds variants that cannot be solved; every
            row is named.
    """
    from gripcourse.documents.report.certificate import (  # noqa: PLC0415 (matplotlib)
        CertificateSource,
        certificate,
    )

    policy = load_policy(course)
    found = audit(course, policy, read_table(table, course), load_spaces(course))
    digest = hashlib.sha256(content_of(table)).hexdigest()
    source = CertificateSource(pure_path(table).name, digest)
    sections = [section.id for section in course.sections]
    files = {
        name: text.encode("utf-8-sig")
        for name, text in audit_tables(found, sections, words).items()
    }
    files[CERTIFICATE] = certificate(found, source, course, policy, words, today)
    for name, content in files.items():
        write_bytes(out / name, content)
    return WrittenAudit(shown_name(table), found, tuple(out / name for name in files))
