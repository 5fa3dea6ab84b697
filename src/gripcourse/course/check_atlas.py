"""Loading an atlas: every name in it is one of its scheme, of the atlas itself, or of a row."""

from collections.abc import Collection, Iterator, Mapping

from gripcourse.course.atlas import Atlas, AtlasFigure, AtlasRow, atlas_path, read_atlas
from gripcourse.course.compose import compose
from gripcourse.course.model import Course, Scheme
from gripcourse.course.quantity import Kind, Quantity
from gripcourse.errors import CourseError, Problem
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message

_Named = Iterator[tuple[str, str, Collection[str]]]  # key, name, and which names it may be


def load_atlas(course: Course, identifier: str) -> Atlas:
    """Load and check an atlas of a course.

    Args:
        course: whose atlas it is.
        identifier: of the atlas, with hyphens.

    Raises:
        CourseError: with all problems of the file.
    """
    problems: list[Problem] = []
    atlas = read_atlas(course.root, identifier, course.languages, problems)
    if atlas is not None and not problems:
        file = atlas_path(course.root, identifier).relative_to(course.root).as_posix()
        problems += _unknown_names(course, atlas, file)
    if atlas is None or problems:
        raise CourseError(problems)
    return atlas


def _unknown_names(course: Course, atlas: Atlas, file: str) -> Iterator[Problem]:
    for key, name, known in _names(course, atlas):
        if name not in known:
            what = message("The name '{name}' is not known.", name=name)
            yield Problem(file, key, what, did_you_mean(name, known))


def _names(course: Course, atlas: Atlas) -> _Named:
    yield "work", atlas.work, course.works
    yield "scheme", atlas.scheme, course.schemes
    if atlas.scheme not in course.schemes:
        return
    quantities = _quantities(course, course.schemes[atlas.scheme])
    for place, figure in enumerate(atlas.figures, start=1):
        yield from _of_figure(f"figure[{place}]", figure, quantities)
    for place, row in enumerate(atlas.rows, start=1):
        yield from _of_row(f"row[{place}]", row, {*quantities, *atlas.inputs})


def _quantities(course: Course, scheme: Scheme) -> Mapping[str, Quantity]:
    """Return what a figure can be drawn of: the options are those of the worked example."""
    if scheme.example is not None:
        return compose(course, scheme, scheme.example.options)
    return compose(course, scheme, {one.id: one.choices[0].id for one in scheme.options})


def _of_figure(key: str, figure: AtlasFigure, quantities: Mapping[str, Quantity]) -> _Named:
    free = {one.id for one in quantities.values() if one.kind is not Kind.MANUAL}
    drawn = {one for one in free if quantities[one].kind.answered}
    yield f"{key}.against", figure.against, free
    for place, curve in enumerate(figure.curves, start=1):
        yield f"{key}.curves[{place}].quantity", curve.quantity, drawn
        for name in curve.at:
            yield f"{key}.curves[{place}].at.{name}", name, free


def _of_row(key: str, row: AtlasRow, known: Collection[str]) -> _Named:
    for name in row.example:
        yield f"{key}.example.{name}", name, known
    found = set(row.example)
    for size, formula in row.sizes.items():
        for name in formula.names:
            yield f"{key}.size.{size}", name, found
        found.add(size)
