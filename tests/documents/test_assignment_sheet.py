"""The assignment sheet: who, what is given, what is asked, how it is judged."""

import html
import re
from collections.abc import Callable
from dataclasses import replace
from datetime import date

import pytest

from gripcourse.course.model import Course, WorkedExample
from gripcourse.course.quantity import Convention, Tolerance
from gripcourse.documents.appendix import appendix_of
from gripcourse.documents.assignment_sheet import TEMPLATE, assignment_sheet, sheet_values
from gripcourse.documents.pdf import Document, render_html
from gripcourse.issuing.seal import seal_modules, seal_of
from gripcourse.policy.model import Policy
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.text.words import Words
from gripcourse.variants.model import Issued, Student, Variant
from support.issued_table import issued_table
from support.pages import not_laid_out
from support.printed import pages_of

LONG_NAME = "Константинопольский-Верхнеднепровский Александр Всеволодович"
UNBROKEN_NAME = "Константинопольсковерхнеднепровскоалександровсковсеволодович"
ENGLISH = Words("en")
# What they take, with the appendix, in a print that can still be read.
LONGEST_PAGES = 3


@pytest.fixture(scope="module")
def issued(plan: Plan, example: WorkedExample) -> Issued:
    given = {quantity.id: example.given[quantity.id] for quantity in plan.givens}
    return Issued(
        student=Student("s017", "Иванова Ольга", "РТ-41", "", "ru", ""),
        variant=Variant("17", plan.scheme.id, dict(plan.options), given | {"mass": 61.2345}),
        issued_on=date(2025, 2, 10),
        deadline=date(2025, 5, 19),
        signature="3fa912bc77aa" + "0" * 52,
    )


def read(issued: Issued, plan: Plan, policy: Policy, course: Course, words: Words) -> str:
    """Return the text that the template puts out, every run of spaces as one space."""
    values = sheet_values(issued, plan, policy, course, words)
    page = render_html(Document(TEMPLATE, (), values), course.root / "templates", words)
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", page)).replace("\u2060", "").split())


@pytest.fixture
def text(issued: Issued, plan: Plan, policy: Policy, course: Course) -> Callable[..., str]:
    """Words of the sheet; its diagram takes most of the time, and has no part in them."""
    bare = replace(plan, scheme=replace(plan.scheme, diagram=None))

    def make(words: Words = ENGLISH, **changes: object) -> str:
        used = replace(policy, **changes)  # type: ignore[arg-type]
        return read(issued, bare, used, course, words)

    return make


def test_it_says_whose_it_is_and_until_when(text: Callable[..., str]) -> None:
    written = text()
    for part in ("Иванова Ольга", "РТ-41", "10 February 2025", "19 May 2025"):
        assert part in written


def test_given_values_are_printed_as_they_were_issued(
    text: Callable[..., str], issued: Issued, plan: Plan
) -> None:
    written = text(Words("ru"))
    assert "61,2345" in written
    for quantity in plan.givens:
        assert quantity.title.of("ru") in written
        assert (
            Words("ru").number(issued.variant.given[quantity.id], 7).replace("\u202f", " ")
            in written
        )


def test_a_personal_link_stands_as_text_and_in_the_code_where_it_is_wanted(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    link = "https://course.example.org/s/s017~1~0~code/"
    pages = []
    for wanted in ("", link):
        values = sheet_values(issued, plan, policy, course, ENGLISH, wanted)
        page = render_html(Document(TEMPLATE, (), values), course.root / "templates", ENGLISH)
        pages.append((values["seal"], page.count(link), "own page" in page))
    assert pages[0][1:] == (0, False)
    # Round the code, and as an address with its own text.
    assert pages[1][1:] == (3, True)
    assert pages[0][0] != pages[1][0]


def test_a_square_code_with_an_address_is_wide_enough_to_be_read_from_paper(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    link = "https://course.example.org/s/s017~1~0~code/"
    at_home = replace(course, address="https://course.example.org/grippers/")
    for wanted, module in (("", 0.37), (link, 0.5)):  # in mm; this sheet is one of the longest
        values = sheet_values(issued, plan, policy, at_home, ENGLISH, wanted)
        width = values["seal_width"]
        assert isinstance(width, float)
        assert width >= 20.0
        code = seal_of(issued, course.id), wanted or at_home.address
        assert width / seal_modules(*code) >= module
        page = render_html(Document(TEMPLATE, (), values), course.root / "templates", ENGLISH)
        assert f'style="width: {width}mm; height: {width}mm"' in page


@pytest.mark.parametrize("language", ["en", "ru", "uk"])
def test_every_section_and_every_asked_quantity_is_named(
    text: Callable[..., str], plan: Plan, course: Course, language: str
) -> None:
    written = text(Words(language))
    assert plan.scheme.task.of(language) in written
    for section in course.sections:
        assert section.title.of(language) in written
    for quantity in (*plan.answered, *plan.manual):
        assert quantity.title.of(language) in written


@pytest.fixture(scope="module")
def fresh(issued: Issued, plan: Plan, policy: Policy, course: Course) -> Callable[[str], bytes]:
    """Lay the sheet of somebody with a long name out in a language."""
    named = replace(issued, student=replace(issued.student, name=LONG_NAME))
    return lambda language: assignment_sheet(named, plan, policy, course, Words(language))


def test_it_is_the_same_each_time(fresh: Callable[[str], bytes]) -> None:
    with not_laid_out():
        assert fresh("en") == fresh("en")


def test_it_is_one_sheet_of_paper_with_an_appendix(fresh: Callable[[str], bytes]) -> None:
    """In Russian, which is longer than English."""
    words = Words("ru")
    pages = pages_of(fresh("ru"))
    assert len(pages) <= 3
    assert any(words.translate("Series and tables") in page for page in pages[1:])
    assert LONG_NAME in pages[0].replace("- ", "-")  # a line may end at the hyphen
    assert all("3fa912bc77aa" in page for page in pages)
    assert not any("3fa912bc77aa0" in page for page in pages)


def test_it_says_at_which_jaw_the_grip_force_is(text: Callable[..., str]) -> None:
    assert "Grip force is the force at ONE jaw" in text()


def test_it_names_the_band_and_every_unusual_one(text: Callable[..., str]) -> None:
    written = text(tolerance=Tolerance(0.01, 0.0), tolerances={"grip_force": Tolerance(0.02, 0.0)})
    assert "by no more than 1%" in written
    assert "± 2%" in written


def test_it_says_what_a_mistake_costs_further_on(text: Callable[..., str]) -> None:
    assert "A mistake costs its points once" in text(carried_credit=1.0)
    assert "earns 75% of its points" in text(carried_credit=0.75)
    assert "A mistake" not in text(carried_credit=0.0)


def test_it_says_whether_misprints_of_the_guide_are_accepted(text: Callable[..., str]) -> None:
    assert "counts in full, with a remark" in text(printed_credit=1.0)
    assert "earns 50% of its points" in text(printed_credit=0.5)
    assert "only the corrected formulas count" in text(printed_credit=None)


def test_it_says_when_the_sources_count_as_they_print(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    printed = replace(plan, convention=Convention.AS_PRINTED)
    written = read(issued, printed, policy, course, ENGLISH)
    assert "follows the formulas as the sources print them" in written


def test_without_a_deadline_there_is_no_line_for_it(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    open_ended = replace(issued, deadline=None)
    written = read(open_ended, plan, policy, course, ENGLISH)
    assert "Deadline" not in written


def test_a_name_is_text_and_never_markup(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    named = replace(issued, student=replace(issued.student, name='<b>&"Иван'))
    values = sheet_values(named, plan, policy, course, ENGLISH)
    page = render_html(Document(TEMPLATE, (), values), course.root / "templates", ENGLISH)
    assert '<b>&"Иван' in html.unescape(page)
    assert "&lt;b&gt;" in page
    assert "<b>&" not in page


def test_it_shows_the_diagram_with_a_text_for_who_does_not_see_it(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    values = sheet_values(issued, plan, policy, course, ENGLISH)
    page = render_html(Document(TEMPLATE, (), values), course.root / "templates", ENGLISH)
    assert plan.scheme.title.of("en") in html.unescape(page).partition('alt="Diagram')[2]
    assert "The diagram shows the type of the mechanism" in page


def test_a_scheme_without_a_diagram_has_a_sheet_without_one(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    bare = replace(plan, scheme=replace(plan.scheme, diagram=None))
    assert "The diagram shows" not in read(issued, bare, policy, course, ENGLISH)


def test_every_sheet_carries_the_code_of_its_student(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    other = replace(issued, student=replace(issued.student, id="s018"))
    seals = [sheet_values(one, plan, policy, course, ENGLISH)["seal"] for one in (issued, other)]
    assert seals[0] != seals[1]


def test_a_scheme_fits_its_pages(policy: Policy, course: Course) -> None:
    """The longest assignment of a scheme in the course's table, in its longest language."""
    longest: dict[str, tuple[int, Variant, Plan]] = {}
    for variant in issued_table(course):
        plan = make_plan(course, variant.scheme, variant.options)
        size = len(plan.quantities)
        if size > longest.get(variant.scheme, (0,))[0]:
            longest[variant.scheme] = size, variant, plan
    assert longest.keys() == course.schemes.keys()
    # Each takes two seconds: if the one with most quantities fits, the others do.
    _, variant, plan = max(longest.values(), key=lambda one: one[0])
    student = Student("s017", LONG_NAME, "РТ-41", "", "ru", "")
    entry = Issued(student, variant, date(2025, 2, 10), date(2025, 5, 19), "0" * 64)
    pages = pages_of(assignment_sheet(entry, plan, policy, course, Words("ru")))
    assert len(pages) <= LONGEST_PAGES
    bare = replace(plan, scheme=replace(plan.scheme, diagram=None))
    values = sheet_values(entry, bare, policy, course, Words("ru"))
    assert not out_of_order(pages, values["sections"])


def out_of_order(pages: list[str], sections: object) -> list[str]:
    """Find the questions that a reader meets before one that the sheet declares earlier."""
    assert isinstance(sections, tuple | list)
    read_as = letters("".join(pages))
    place = read_as.index(letters(sections[0].task))
    found: list[str] = []
    for item in (item for section in sections for item in section.items):
        next_place = read_as.find(letters(item.text)[:22], place)
        found += [item.text] if next_place < 0 else []
        place = max(place, next_place)
    return found


def letters(text: str) -> str:
    return re.sub(r"[\s_\u2060-]", "", text)


def test_tasks_tell_only_of_what_the_scheme_has(course: Course) -> None:
    """Each sentence belongs to something that the course declares, and only to that."""
    declared: dict[str, set[str]] = {scheme: set() for scheme in course.schemes}
    for variant in issued_table(course):
        declared[variant.scheme] |= make_plan(
            course, variant.scheme, variant.options
        ).quantities.keys()
    every = set().union(*declared.values())
    told = dict.fromkeys(course.schemes, "")
    for section in course.sections:
        for detail in section.details:
            assert every & set(detail.quantities), detail.text.of("en")
        for scheme, quantities in declared.items():
            told[scheme] += section.task_of(quantities, "ru").lower()
    assert [one for one in told if "губ" in told[one]] == [
        one for one in told if one not in {"vacuum_cups", "electromagnet"}
    ]
    assert [one for one in told if "эжектор" in told[one]] == ["vacuum_cups"]
    assert [one for one in told if "электромагнит" in told[one]] == ["electromagnet"]


LONGEST = {
    "grip_model": "contact_exact",
    "object_position": "pairs_between",
    "jaw_shape": "prism",
    "mounting": "flange",
}


@pytest.mark.parametrize("scheme", ["rack_parallelogram", "screw"])
def test_the_longest_assignments_fit_their_pages_too(
    issued: Issued,
    policy: Policy,
    course: Course,
    scheme: str,
    beyond_the_edge: Callable[[bytes], list[str]],
) -> None:
    example = course.schemes[scheme].example
    assert example is not None
    long = make_plan(course, scheme, {**example.options, **LONGEST})
    given = {one.id: sum(one.bounds) / 2 for one in long.givens}
    variant = Variant("17", scheme, dict(long.options), given)
    student = replace(issued.student, name=UNBROKEN_NAME, group="РТК-41-" * 8)
    sheet = assignment_sheet(
        replace(issued, student=student, variant=variant), long, policy, course, Words("uk")
    )
    assert 2 <= len(pages_of(sheet)) <= LONGEST_PAGES + 1
    assert not beyond_the_edge(sheet)


@pytest.mark.parametrize(
    ("scheme", "changed", "density"),
    [
        ("electromagnet", {}, "dense running"),
        ("wedge_slide", LONGEST, "dense long running"),
    ],
)
def test_the_more_there_is_to_read_the_smaller_the_print(
    issued: Issued,
    policy: Policy,
    course: Course,
    scheme: str,
    changed: dict[str, str],
    density: str,
) -> None:
    example = course.schemes[scheme].example
    assert example is not None
    plan = make_plan(course, scheme, {**example.options, **changed})
    given = {one.id: sum(one.bounds) / 2 for one in plan.givens}
    variant = Variant("17", scheme, dict(plan.options), given)
    values = sheet_values(replace(issued, variant=variant), plan, policy, course, ENGLISH)
    assert values["density"] == density


def test_a_unit_stands_in_its_column_and_degrees_with_their_number(
    issued: Issued, plan: Plan, policy: Policy, course: Course
) -> None:
    values = sheet_values(issued, plan, policy, course, ENGLISH)
    assert isinstance(values["data"], list)
    units = {datum.unit for datum in values["data"]}
    assert "mm" in units
    assert not any(unit.startswith("°") for unit in units)


def test_a_choice_cites_its_series_in_the_appendix(text: Callable[..., str], plan: Plan) -> None:
    written = text()
    appendix = appendix_of(plan, ENGLISH)
    for one in (*appendix.series, *appendix.tables):
        assert f"{one.number}. {one.title.partition('_')[0]}" in written
    stroke = next(one for one in appendix.series if "strokes of cylinders" in one.title)
    assert f"[app.\u00a0{stroke.number}]".replace("\u00a0", " ") in written


def test_the_order_of_a_direction_is_told_where_a_formula_takes_one(course: Course) -> None:
    examples = {id_: course.schemes[id_].example for id_ in ("prism_lever", "screw")}
    told = {
        id_: appendix_of(make_plan(course, id_, one.options), ENGLISH).has_directions
        for id_, one in examples.items()
        if one is not None
    }
    assert told == {"prism_lever": True, "screw": False}


def test_formulas_of_works_that_students_do_not_have_are_printed(course: Course) -> None:
    at_hand = {work.title.of("en") for work in course.works.values() if work.at_hand}
    example = course.schemes["prism_lever"].example
    assert example is not None
    appendix = appendix_of(make_plan(course, "prism_lever", example.options), ENGLISH)
    assert appendix.works
    assert not at_hand.intersection(work.title for work in appendix.works)
