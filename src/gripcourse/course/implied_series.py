"""Series that nobody writes a catalogue of: the multiples that choices are rounded to."""

from dataclasses import replace

import numpy as np

from gripcourse.course.model import Catalogue, Course
from gripcourse.course.multiples import Multiples
from gripcourse.text.units import known


def with_implied_series(course: Course) -> Course:
    """Return a course with a catalogue for all multiples that its choices are taken from."""
    implied = {
        one.choice.multiples.id: _catalogue(one.choice.multiples, one.file)
        for one in course.declarations()
        if one.choice is not None and one.choice.multiples is not None and known(one.unit)
    }
    return replace(course, catalogues={**course.catalogues, **implied})


def is_implied(catalogue: Catalogue) -> bool:
    """Tell whether a catalogue is made from a declaration, and has no file of its own."""
    return not catalogue.file.endswith(".csv")


def _catalogue(one: Multiples, file: str) -> Catalogue:
    return Catalogue(
        id=one.id,
        columns={"size": np.array(one.sizes)},
        units={"size": one.unit},
        source=one.title,
        file=file,
        title=one.title,
        headings={},
    )
