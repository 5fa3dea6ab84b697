"""The reference is what the declarations give, whole and without a dead link."""

import re
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.documents.reference.pages import pages
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.reference import write_reference

if TYPE_CHECKING:
    from .conftest import Page

RACK = "rack_parallelogram.html"
LARGEST_PAGE = 640_000


def test_a_page_is_a_file_that_leads_home_where_there_is_one(
    course: Course, tmp_path: Path
) -> None:
    scheme = course.schemes["rack_parallelogram"]
    only = replace(course, schemes={scheme.id: scheme})
    written = write_reference(only, tmp_path / "made", Words("en"), home="../index.html")
    assert {path.name for path in written} == {
        RACK,
        "equations.html",
        "errata.html",
        "index.html",
    }
    assert all('href="../index.html"' in path.read_text(encoding="utf-8") for path in written)


def test_a_page_tells_titles_in_the_languages_of_its_course_alone(course: Course) -> None:
    scheme = course.schemes["rack_parallelogram"]
    only = replace(course, schemes={scheme.id: scheme}, languages=("en", "uk"))
    page = pages(only, Words("en"))[RACK]
    assert scheme.title.of("uk") in page
    assert scheme.title.of("ru") not in page
    assert 'lang="ru"' not in page


def test_every_scheme_is_drawn(course: Course, english: Mapping[str, str]) -> None:
    assert {name: english[f"{name}.html"].count("<svg") for name in course.schemes} == (
        dict.fromkeys(course.schemes, 1)
    )


def test_every_declaration_of_every_scheme_is_on_its_page(
    declared: Mapping[str, list[Quantity]], read: "Mapping[str, Page]"
) -> None:
    missing = []
    for scheme, quantities in declared.items():
        page = read[f"{scheme}.html"]
        ids = [one.partition(".")[0] for one in page.ids]
        for one in quantities:
            texts = [*one.title.by_language.values()]
            texts += [slip.hint.of("en") for slip in one.slips]
            texts += [printed.note.of("en") for printed in one.as_printed]
            if one.explain is not None:
                texts.append(one.explain.of("en"))
            if one.id not in ids or not all(page.says(one.id, text) for text in texts):
                missing.append((scheme, one.id))
    assert missing == []


def test_a_page_has_as_many_entries_as_its_scheme_has_declarations(
    declared: Mapping[str, list[Quantity]], read: "Mapping[str, Page]"
) -> None:
    for scheme, quantities in declared.items():
        ids = {one.id for one in quantities}
        entries = [one for one in read[f"{scheme}.html"].ids if one.partition(".")[0] in ids]
        assert len(entries) == len(quantities)


def test_every_link_leads_somewhere(read: "Mapping[str, Page]") -> None:
    dead = []
    for name, page in read.items():
        assert len(page.ids) == len(set(page.ids))
        for link in page.links:
            file, _, anchor = link.partition("#")
            target = read.get(file or name)
            if target is None or (anchor and anchor not in target.ids):
                dead.append((name, link))
    assert dead == []


def test_formulas_are_well_formed(english: Mapping[str, str]) -> None:
    count = 0
    for text in english.values():
        for formula in re.findall("<math.*?</math>", text, re.DOTALL):
            assert ET.fromstring(formula).tag == "math"  # noqa: S314 - made here
            count += 1
    assert count > 100


def test_a_page_needs_nothing_but_itself(english: Mapping[str, str]) -> None:
    for text in english.values():
        named = text.replace('xmlns="http://www.w3.org/2000/svg"', "")  # a name, no address
        assert not re.search(r"https?:|//\w|<script|<link|<img|@import|url\(|\bsrc=", named)


def test_pages_stay_of_a_size_that_opens_at_once(english: Mapping[str, str]) -> None:
    assert {name for name, text in english.items() if len(text.encode()) > LARGEST_PAGE} == set()


@pytest.mark.parametrize(
    "row",
    [
        # The guide, section 5, recomputed exactly; and as it prints it.
        [
            "mreq",
            "required module of the teeth by bending",
            "mm",
            "5.1057",
            "5.1057",
            "6.0535",
            "6.05",
        ],
        ["dp1", "first choice of the pin's diameter, by shear alone", "mm", "12", "12", "10", ""],
        ["lp", "working length of the pin", "mm", "40", "", "50*", ""],
    ],
)
def test_the_worked_example_stands_in_both_conventions(
    read: "Mapping[str, Page]", row: list[str]
) -> None:
    assert row in read[RACK].rows


def test_a_formula_stands_beside_its_plain_text(english: Mapping[str, str]) -> None:
    entry = english[RACK].split('<article id="velocity_ratio">')[1].split("</article>")[0]
    assert "<mfrac><mi>i</mi><mn>2</mn></mfrac>" in entry
    assert '<p class="plain">u = i/2</p>' in entry


def test_an_erratum_shows_both_versions(english: Mapping[str, str]) -> None:
    entry = english[RACK].split('<article id="module_required">')[1].split("</article>")[0]
    versions = entry.split('<table class="versions">')[1]
    assert 'href="errata.html#E10"' in versions
    plain = re.findall('<p class="plain">(.*?)</p>', versions)
    assert [("(z·ψ<sub>bd</sub>)²" in one, "z²·ψ<sub>bd</sub>" in one) for one in plain] == [
        (True, False),
        (False, True),
    ]


def test_every_erratum_is_computed_somewhere_or_says_why_not(
    course: Course, declared: Mapping[str, list[Quantity]], read: "Mapping[str, Page]"
) -> None:
    page = read["errata.html"]
    rows = [row for row in page.rows if len(row) == 4][1:]
    assert len(rows) == len(course.errata)
    for erratum, (_, printed, right, versions) in zip(course.errata.values(), rows, strict=True):
        assert (printed, right) == (erratum.printed.of("en"), erratum.right.of("en"))
        declaring = [
            scheme
            for scheme, quantities in declared.items()
            if any(
                version.erratum == erratum.id for one in quantities for version in one.as_printed
            )
        ]
        assert all(scheme in versions for scheme in declaring)
        assert declaring or erratum.no_version is not None
        if not declaring and erratum.no_version is not None:
            assert versions == erratum.no_version.of("en")


@pytest.mark.parametrize("language", ["ru", "uk"])
def test_the_pages_are_made_in_other_languages_too(course: Course, language: str) -> None:
    scheme = course.schemes["rack_parallelogram"]
    written = pages(replace(course, schemes={scheme.id: scheme}), Words(language))
    assert f'<html lang="{language}">' in written[RACK]
    assert scheme.task.of(language) in written[RACK]
    assert f'<span lang="en">{scheme.title.of("en")}</span>' in written[RACK]
