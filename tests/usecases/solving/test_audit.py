"""Auditing a table: what is written, and whether a person must look."""

import hashlib
from datetime import date
from pathlib import Path

import pytest

from gripcourse.course.model import Course
from gripcourse.errors import TableError
from gripcourse.text.words import Words
from gripcourse.usecases.solving.audit import CERTIFICATE, audit_table
from gripcourse.usecases.solving.variants import draw_table
from support.pages import not_laid_out

SCHEME = "wedge_slide"
DAY = date(2026, 9, 1)
CERTIFY = "gripcourse.documents.report.certificate.certificate"

pytestmark = pytest.mark.usefixtures("few_slips_counted")


def test_a_table_that_was_drawn_by_the_rules_passes(course: Course, tmp_path: Path) -> None:
    table = tmp_path / "drawn.csv"
    draw_table(course, 6, 7, SCHEME, table)
    with not_laid_out():
        audited = audit_table(course, table, tmp_path / "audit", Words("en"), DAY)
    assert audited.audit.passed
    names = {
        "variants.csv",
        "pairs.csv",
        "quantities.csv",
        "sizes.csv",
        "ends.csv",
        "slips.csv",
        "alternatives.csv",
        "verdicts.csv",
        CERTIFICATE,
    }
    assert {path.name for path in (tmp_path / "audit").iterdir()} == names
    assert {path.name for path in audited.written} == names


def test_the_certificate_bears_the_digest_of_the_file(
    course: Course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    table = tmp_path / "drawn.csv"
    draw_table(course, 4, 7, SCHEME, table)
    seen = []

    def certificate(_audit: object, source: object, *_rest: object) -> bytes:
        seen.append(source)
        return b""

    monkeypatch.setattr(CERTIFY, certificate)
    audit_table(course, table, tmp_path / "audit", Words("en"), DAY)
    (source,) = seen
    assert source.name == "drawn.csv"
    assert source.digest == hashlib.sha256(table.read_bytes()).hexdigest()


def test_what_is_drawn_freely_need_not_keep_the_rules(
    course: Course, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(CERTIFY, lambda *_: b"")  # nobody reads this one
    table = tmp_path / "free.csv"
    draw_table(course, 10, 7, "wedge_roller", table, freely=True)
    audited = audit_table(course, table, tmp_path / "audit", Words("ru"), DAY)
    assert not audited.audit.passed


def test_a_table_with_a_variant_that_cannot_be_solved_is_refused_by_row(
    course: Course, tmp_path: Path
) -> None:
    table = tmp_path / "drawn.csv"
    draw_table(course, 4, 7, SCHEME, table)
    lines = table.read_text(encoding="utf-8-sig").splitlines()
    column = lines[0].split(",").index("mass [kg]")
    cells = lines[2].split(",")
    cells[column] = "40000"
    lines[2] = ",".join(cells)
    table.write_text("\n".join(lines), encoding="utf-8")
    with pytest.raises(TableError, match="row 3"):
        audit_table(course, table, tmp_path / "audit", Words("en"), DAY)
    assert not (tmp_path / "audit").exists()
