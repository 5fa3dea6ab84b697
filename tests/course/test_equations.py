"""Numbered equations of a work: cited, excused or reported."""

from dataclasses import replace

from gripcourse.course.check_equations import check_equations
from gripcourse.course.equations import Equations, equations_in
from gripcourse.course.model import Course
from gripcourse.text.words import Texts

REASON = Texts({"en": "A matter of words.", "ru": "Слова.", "uk": "Слова."})


def with_equations(course: Course, equations: Equations) -> Course:
    guide = replace(course.works["guide"], equations=equations)
    return replace(course, works={**course.works, "guide": guide})


def said(course: Course) -> list[str]:
    return [f"{one.key}: {one.what}" for one in check_equations(course)]


def test_a_citation_may_name_ranges_and_tables() -> None:
    assert list(equations_in("5, 24–26, T7, §5, T1–T2")) == [
        "5",
        "24",
        "25",
        "26",
        "T7",
        "T1",
        "T2",
    ]


def test_every_equation_of_the_guide_is_cited_or_excused(course: Course) -> None:
    assert said(course) == []


def test_an_equation_that_nothing_cites_is_reported(course: Course) -> None:
    known = course.works["guide"].equations
    wider = replace(known, numbers=(*known.numbers, "57"))
    assert said(with_equations(course, wider)) == [
        "work.guide.equations: No quantity and no erratum cites equation 57."
    ]


def test_an_excuse_for_a_cited_equation_is_reported(course: Course) -> None:
    known = course.works["guide"].equations
    excused = replace(known, not_used={**known.not_used, "24": REASON, "99": REASON})
    assert said(with_equations(course, excused)) == [
        "work.guide.equations.not_used.24: Equation 24 is used: a quantity cites it.",
        "work.guide.equations.not_used.99: The work lists no equation 99.",
    ]


def test_a_cited_number_that_the_work_does_not_have_is_reported(course: Course) -> None:
    known = course.works["guide"].equations
    shorter = replace(known, numbers=tuple(one for one in known.numbers if one != "46"))
    assert {line.split(": ", 1)[1] for line in said(with_equations(course, shorter))} == {
        "The work lists no equation 46."
    }
