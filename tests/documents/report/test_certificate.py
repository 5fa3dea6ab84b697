"""The certificate says what was demanded, what was found, and which file it was."""

import csv
import io
from collections.abc import Callable
from dataclasses import replace
from datetime import date
from functools import cache
from itertools import pairwise

import pytest

from gripcourse.course.compose import declared_in
from gripcourse.course.model import Course
from gripcourse.documents.pdf import Document, render_html
from gripcourse.documents.report.certificate import (
    STYLES,
    TEMPLATE,
    CertificateSource,
    certificate,
    certificate_values,
)
from gripcourse.exports.audit_tables import audit_tables
from gripcourse.policy.model import Policy
from gripcourse.policy.slips import SlipKind
from gripcourse.text.words import LANGUAGES, Words
from gripcourse.variants.audit import VariantAudit, audit
from gripcourse.variants.draw import draw
from gripcourse.variants.space import load_spaces
from support.laid_out import boxes, cells, lines, pages_of, text_edges
from support.pages import not_laid_out, text_of_page

SOURCE = CertificateSource("autumn.csv", "ab" * 32)
DAY = date(2026, 9, 1)
APART = 2.5  # mm between numbers that are no one number


@pytest.fixture(scope="module")
def audited(course: Course, policy: Policy) -> VariantAudit:
    """Variants as they were drawn, and two of them alike."""
    spaces = [one for one in load_spaces(course) if one.scheme in {"screw", "wedge_roller"}]
    variants = draw(course, spaces, 8, 3).variants
    return audit(course, policy, (*variants, replace(variants[0], id="=twin")), spaces)


@pytest.fixture(scope="module")
def values(audited: VariantAudit, course: Course, policy: Policy) -> dict[str, object]:
    return certificate_values(audited, SOURCE, course, policy, Words("en"))


@pytest.fixture(scope="module")
def printed_in(audited: VariantAudit, course: Course, policy: Policy) -> Callable[[str], bytes]:
    """The certificate in a language, made once; tests of all documents lay it out."""

    def make(language: str) -> bytes:
        with not_laid_out():
            return certificate(audited, SOURCE, course, policy, Words(language), DAY)

    return cache(make)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_certificate_names_the_table_and_the_day(
    printed_in: Callable[[str], bytes],
    course: Course,
    language: str,
) -> None:
    written = text_of_page(printed_in(language))
    assert "autumn.csv" in written
    assert SOURCE.digest in written.replace(" ", "")
    assert "2026" in written
    assert course.title.of(language) in written


def test_a_certificate_is_the_same_each_time(
    audited: VariantAudit, course: Course, policy: Policy, printed_in: Callable[[str], bytes]
) -> None:
    with not_laid_out():
        again = certificate(audited, SOURCE, course, policy, Words("en"), DAY)
    assert again == printed_in("en")


def test_each_rule_has_its_limit_and_what_was_found(values: dict[str, object]) -> None:
    checks = values["checks"]
    assert isinstance(checks, list)
    assert next(kept for *_, kept in checks) is True
    limits = [limit for _, limit, _, _ in checks]
    assert limits == ["0", "0", "0", "2.5", "10%", "50%"]
    assert checks[4][2] == "100%"
    assert not values["passed"]


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "no interference in 9 variants"),
        ("ru", "пересечений нет, вариантов: 9"),
        ("uk", "перетинів немає, варіантів: 9"),
    ],
)
def test_bodies_that_keep_apart_are_said_with_how_many_were_tested(
    audited: VariantAudit, course: Course, policy: Policy, language: str, said: str
) -> None:
    looked = replace(audited, overlaps=0)
    checks = certificate_values(looked, SOURCE, course, policy, Words(language))["checks"]
    assert isinstance(checks, list)
    assert checks[3][2:] == (said, True)


def test_what_is_to_be_looked_at_is_said_variant_by_variant(values: dict[str, object]) -> None:
    flagged = values["flagged"]
    assert isinstance(flagged, list)
    said = {id_: sentences for id_, _, sentences in flagged}
    assert "too near to another variant; the nearest is 001" in said["=twin"]


def test_each_verdict_has_its_shares_of_yes_and_no(
    audited: VariantAudit, course: Course, policy: Policy
) -> None:
    sure, never, *_ = dict.fromkeys(one.quantity for one in audited.verdicts)
    shares = tuple(
        replace(one, yes=one.variants, must_hold=True)
        if one.quantity == sure
        else replace(one, yes=0, must_hold=False)
        if one.quantity == never
        else one
        for one in audited.verdicts
    )
    mixed = replace(audited, verdicts=shares)
    found = certificate_values(mixed, SOURCE, course, policy, Words("en"))["verdicts"]
    assert isinstance(found, list)
    assert len(found) == len({one.quantity for one in audited.verdicts})
    remarks = [remark for *_, remark in found]
    assert remarks[:2] == ["always yes: the course demands it", "always no"]
    held = {row["quantity"]: row["must_hold"] for row in rows(mixed, course, "verdicts.csv")}
    assert (held[sure], held[never]) == ("yes", "no")


def test_the_worst_pair_comes_first(values: dict[str, object]) -> None:
    pairs = values["pairs"]
    assert isinstance(pairs, list)
    own, other, shares, same = pairs[0]
    assert {own, other} == {"001", "=twin"}
    assert shares[0] in {"100%", "100.0%"}  # with as many decimals as those below it
    assert "grip force" in same
    assert values["beyond"]


def test_a_sound_table_gets_a_clean_certificate(
    audited: VariantAudit, course: Course, policy: Policy
) -> None:
    sound = replace(audited, variants=tuple(
        replace(one, broken=(), slips=(), edges=(), above=False) for one in audited.variants
    ))  # fmt: skip
    shown = certificate_values(sound, SOURCE, course, policy, Words("en")) | {"day": DAY}
    written = render_html(Document(TEMPLATE, (), shown), course.root / "templates", Words("en"))
    assert "The table keeps all rules." in written
    assert "Variants to look at" not in written


def rows(audited: VariantAudit, course: Course, name: str) -> list[dict[str, str]]:
    sections = [section.id for section in course.sections]
    text = audit_tables(audited, sections, Words("en"))[name]
    return list(csv.DictReader(io.StringIO(text)))


def test_every_variant_has_its_row(audited: VariantAudit, course: Course) -> None:
    found = rows(audited, course, "variants.csv")
    assert len(found) == len(audited.variants)
    twin = found[-1]
    assert twin["variant"] == "'=twin"  # no spreadsheet runs it
    assert (twin["nearest"], twin["share"], twin["above_a_limit"]) == ("001", "1", "yes")
    assert {row["passed"] for row in found} <= {"yes", "no"}


def test_the_tables_hold_what_the_audit_found(audited: VariantAudit, course: Course) -> None:
    pairs = rows(audited, course, "pairs.csv")
    assert len(pairs) == len(audited.pairs)
    assert "grip_force" in pairs[0]["equal"].split("; ")
    slips = rows(audited, course, "slips.csv")
    assert len(slips) == len(audited.slips)
    # Two sizes of a series are far apart or the same: no variant is refused for those.
    refusing = {(one.quantity, one.slip) for one in audited.slips if not one.only_counted}
    for row in slips:
        refuses = row["kind"] == "declared" and (row["quantity"], row["slip"]) in refusing
        assert row["refuses"] == ("yes" if refuses else "no")
    quantities = rows(audited, course, "quantities.csv")
    weak = {(row["scheme"], row["quantity"]) for row in quantities if row["weak"] == "yes"}
    assert weak == {(one.scheme, one.quantity) for one in audited.weak_items}


def test_numbers_of_neighbouring_columns_stand_apart(
    audited: VariantAudit, course: Course, policy: Policy
) -> None:
    values = certificate_values(audited, SOURCE, course, policy, Words("uk")) | {"day": DAY}
    wide = ("потужність двигуна", "1234", "0,0178 кВт", "0,0425 кВт", "0,49 кВт", "100,0 %")
    html = render_html(
        Document(
            TEMPLATE,
            (),
            values | {"sizes": [wide], "verdicts": [(*wide[:2], "73,3 %", "26,7 %", "")]},
        ),
        course.root / "templates",
        Words("uk"),
    )
    rows = [row for page in pages_of(html, STYLES) for row in boxes(page, "tr")]
    looked_at = 0
    for row in rows:
        cells = [
            text_edges(one) for one in row.children if "number" in one.element.get("class", "")
        ]
        for left, right in pairwise(filter(None, cells)):
            looked_at += 1
            assert right[0] - left[1] >= APART, row.element.text
    assert looked_at


@pytest.mark.parametrize("language", ["ru", "uk"])
def test_a_heading_of_a_column_ends_no_line_inside_a_word(
    audited: VariantAudit, course: Course, policy: Policy, language: str
) -> None:
    values = certificate_values(audited, SOURCE, course, policy, Words(language)) | {"day": DAY}
    page = Document(TEMPLATE, (), values)
    html = render_html(page, course.root / "templates", Words(language))
    headings = [one for made in pages_of(html, STYLES) for one in cells(made, "th")]
    assert headings
    for heading in headings:
        written = "".join(heading.element.itertext()).split(" ")
        assert [word for line in lines(heading) for word in line.split(" ") if word] == written


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_slip_is_named_by_its_title_and_not_by_its_id(
    audited: VariantAudit, course: Course, policy: Policy, language: str
) -> None:
    quantities = declared_in(course, (one.composition for one in audited.steps))
    quantity, slip = next((one, slip) for one in quantities.values() for slip in one.slips)
    near = ((quantity.id, slip.id), (quantity.id, "power_of_ten:0.1"))
    first = replace(audited.variants[0], slips=near)
    found = replace(audited, variants=(first, *audited.variants[1:]))
    values = certificate_values(found, SOURCE, course, policy, Words(language))
    said = str(values["flagged"])
    assert slip.hint.of(language).rstrip(".") in said
    assert policy.slips.kinds[SlipKind.POWER_OF_TEN].title.of(language) in said
    assert "power_of_ten" not in said
