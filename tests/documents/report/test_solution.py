"""The worked solution of a variant: every answer, with its source."""

from collections.abc import Callable
from functools import cache
from io import BytesIO

import pytest
from pypdf import PdfReader

from gripcourse.course.model import Course
from gripcourse.documents.report.solution import solution_pdf, solution_values
from gripcourse.formula.markup import text
from gripcourse.solver.plan import Plan
from gripcourse.text.words import Words
from gripcourse.variants.model import Variant
from support.pages import not_laid_out, text_of_page


def test_every_answer_is_worked(
    plan: Plan, variant: Variant, values: dict[str, float], course: Course
) -> None:
    chapters = solution_values(plan, variant, values, course, Words("en"))["chapters"]
    assert isinstance(chapters, list)
    titles = [step.title for chapter in chapters for step in chapter.steps]
    assert sorted(titles) == sorted(one.title.of("en") for one in plan.answered)


def test_a_step_cites_its_source_and_its_errata(
    plan: Plan, variant: Variant, values: dict[str, float], course: Course
) -> None:
    chapters = solution_values(plan, variant, values, course, Words("en"))["chapters"]
    assert isinstance(chapters, list)
    sources = {step.title: step.source for chapter in chapters for step in chapter.steps}
    assert sources[plan.quantities["jaw_travel"].title.of("en")] == "[1] (29)"
    assert "corrected: E10" in sources[plan.quantities["module_required"].title.of("en")]


@pytest.fixture(scope="module")
def fresh(
    plan: Plan, variant: Variant, values: dict[str, float], course: Course
) -> Callable[[str], bytes]:
    return lambda language: solution_pdf(plan, variant, values, course, Words(language))


@pytest.fixture(scope="module")
def printed(fresh: Callable[[str], bytes]) -> Callable[[str], bytes]:
    """The document in a language, laid out once."""
    return cache(fresh)


@pytest.mark.parametrize("language", ["en", "uk"])
def test_the_document_has_given_data_results_and_sources(
    plan: Plan,
    values: dict[str, float],
    printed: Callable[[str], bytes],
    fresh: Callable[[str], bytes],
    text_of: Callable[[bytes], str],
    language: str,
) -> None:
    """In Ukrainian as it is printed, in English as it is laid out from."""
    if language == "uk":
        written = text_of(printed(language)).replace("\u00a0", " ")
    else:
        with not_laid_out():
            written = text_of_page(fresh(language))
    assert plan.quantities["mass"].title.of(language) in written
    assert Words(language).number(values["bore_required"]) in written
    assert f"[1] {plan.course.works['guide'].title.of(language)}" in written


def test_the_same_variant_gives_the_same_bytes_with_its_fonts(
    printed: Callable[[str], bytes],
    fresh: Callable[[str], bytes],
    embedded_fonts: Callable[[bytes], dict[str, bool]],
) -> None:
    first = printed("uk")
    assert first == fresh("uk")
    assert all(embedded_fonts(first).values())


def test_a_variant_that_cannot_be_solved_to_the_end_is_still_printed(
    plan: Plan,
    variant: Variant,
    values: dict[str, float],
    course: Course,
) -> None:
    broken = values | {"bore": float("nan")}
    with not_laid_out():
        written = text_of_page(solution_pdf(plan, variant, broken, course, Words("en")))
    assert "nan" not in written.casefold().split()
    chapters = solution_values(plan, variant, broken, course, Words("en"))["chapters"]
    assert isinstance(chapters, list)
    title = plan.quantities["bore"].title.of("en")
    (step,) = (one for chapter in chapters for one in chapter.steps if one.title == title)
    assert "→" not in text(step.line)


def test_it_ends_with_the_general_view_on_a_sheet_of_its_own(
    printed: Callable[[str], bytes], plan: Plan, pages_of: Callable[[bytes], list[str]]
) -> None:
    made = printed("uk")
    pages = PdfReader(BytesIO(made)).pages
    assert all(float(page.mediabox[3]) > float(page.mediabox[2]) for page in pages[:-1])
    title = plan.scheme.title.of("uk").split()[0]
    assert title in pages_of(made)[-1].casefold()
