"""Auditing a table of variants: the certificate as PDF, its numbers as CSV."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import Path

from gripcourse.course.model import Course
from gripcourse.documents.report.certificate_checks import tested_for_bodies
from gripcourse.exports.audit_tables import audit_tables
from gripcourse.machine.content import Readable, content_of, pure_path, shown_name
from gripcourse.machine.files import expect_folder, write_bytes
from gripcourse.policy.load import load_policy
from gripcourse.text.words import Words
from gripcourse.usecases.solving.variants import draw_variants
from gripcourse.variants.audit import VariantAudit, audit
from gripcourse.variants.bodies import bodies_check
from gripcourse.variants.model import Variant
from gripcourse.variants.space import load_spaces
from gripcourse.variants.table import read_table, write_table

CERTIFICATE = "certificate.pdf"
DRAWN = "drawn.csv"


@dataclass(frozen=True, slots=True)
class WrittenAudit:
    """What was found out about a table, and where it was written.

    `tested` variants had bodies to look at: those of schemes whose view shows bodies.
    """

    table: str
    audit: VariantAudit
    written: tuple[Path, ...]
    tested: int


def audit_table(
    course: Course,
    table: Readable,
    out: Path,
    words: Words,
    today: date,
    workers: int = 0,
) -> WrittenAudit:
    """Audit a table and write the certificate and its numbers into a folder.

    Args:
        course: whose variants they are.
        table: CSV or spreadsheet, a file or its bytes.
        out: folder to write to.
        words: the language of the certificate.
        today: the day that it bears.
        workers: how many processes; 0 for none but this one.

    Raises:
        GripcourseError: the table cannot be read, or holds variants that cannot be solved; every
            row is named.
        OSError: nothing can be written there.
    """
    expect_folder(out)
    found = _audited(course, read_table(table, course), workers)
    named = pure_path(table).name, content_of(table)
    files = _written(course, found, named, out, words, today)
    return WrittenAudit(shown_name(table), found, files, tested_for_bodies(found, course))


def audit_drawn(  # noqa: PLR0913, PLR0917 (what is drawn, how, and where it goes)
    course: Course,
    count: int,
    seed: int,
    scheme: str | None,
    out: Path,
    words: Words,
    today: date,
    workers: int = 0,
) -> WrittenAudit:
    """Audit variants that are drawn freely: what the spaces give before the rules choose.

    Args:
        course: whose variants are drawn.
        count: how many.
        seed: the same seed gives the same variants.
        scheme: only this one; None for all.
        out: folder to write to; the variants are written there too.
        words: the language of the certificate.
        today: the day that it bears.
        workers: how many processes; 0 for none but this one.

    Raises:
        GripcourseError: there is no such scheme, or its space gives too few variants.
        OSError: nothing can be written there.
    """
    expect_folder(out)
    variants = draw_variants(course, count, seed, scheme, freely=True, workers=workers).variants
    path = out / DRAWN
    write_table(path, variants, course)
    found = _audited(course, variants, workers)
    files = _written(course, found, (DRAWN, path.read_bytes()), out, words, today)
    return WrittenAudit(str(path), found, (path, *files), tested_for_bodies(found, course))


def _audited(course: Course, variants: Sequence[Variant], workers: int) -> VariantAudit:
    policy, spaces = load_policy(course), load_spaces(course)
    return audit(course, policy, variants, spaces, bodies_check(course), workers)


def _written(
    course: Course,
    found: VariantAudit,
    table: tuple[str, bytes],
    out: Path,
    words: Words,
    today: date,
) -> tuple[Path, ...]:
    """Write the certificate and its numbers of a table, by name and content; return the files."""
    from gripcourse.documents.report.certificate import (  # noqa: PLC0415 (matplotlib)
        CertificateSource,
        certificate,
    )

    name, content = table
    source = CertificateSource(name, hashlib.sha256(content).hexdigest())
    sections = [section.id for section in course.sections]
    files = {
        name: text.encode("utf-8-sig")
        for name, text in audit_tables(found, sections, words).items()
    }
    files[CERTIFICATE] = certificate(found, source, course, load_policy(course), words, today)
    for file, data in files.items():
        write_bytes(out / file, data)
    return tuple(out / file for file in files)
