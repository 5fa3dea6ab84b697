"""Checking what declarations name of the course: sections, works, errata and rubrics."""

from collections.abc import Iterable, Iterator

from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.errors import Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message


def check_declarations(course: Course, declared: Iterable[Quantity]) -> Iterator[Problem]:
    """Yield what is wrong with declarations wherever they are used."""
    sections = {section.id for section in course.sections}
    for one in declared:
        key = f"quantity.{one.id}"
        if one.section and one.section not in sections:
            yield Problem(
                one.file,
                f"{key}.section",
                message("The course has no section '{name}'.", name=one.section),
                did_you_mean(one.section, sections),
            )
        if one.source.work and one.source.work not in course.works:
            yield Problem(
                one.file,
                f"{key}.source.work",
                message("The course cites no work '{work}'.", work=one.source.work),
                did_you_mean(one.source.work, course.works),
            )
        for printed in one.as_printed:
            if printed.erratum not in course.errata:
                yield Problem(
                    one.file,
                    f"{key}.as_printed.{printed.erratum}",
                    message("The course lists no erratum '{erratum}'.", erratum=printed.erratum),
                    did_you_mean(printed.erratum, course.errata),
                )
        if one.rubric and not _rubric_exists(course, one.rubric):
            yield Problem(
                one.file,
                f"{key}.rubric",
                message("There is no rubric '{rubric}'.", rubric=one.rubric),
                message("Write grader/rubric/{rubric}.toml.", rubric=one.rubric),
            )


def _rubric_exists(course: Course, rubric: str) -> bool:
    return (course.root / "grader" / "rubric" / f"{rubric}.toml").is_file()
