"""The bodies of the general views as a check of variants: what cannot be built is not issued."""

from collections.abc import Mapping
from functools import partial

from gripcourse.course.catalogue import columns_of
from gripcourse.course.model import Course, Scheme
from gripcourse.drawing.view.interference import Interference, interference
from gripcourse.text.words import LANGUAGES, Texts
from gripcourse.variants.feasible import Array
from gripcourse.variants.overlaps import Overlap, OverlapCheck


def bodies_check(course: Course) -> OverlapCheck:
    """Return the check that bodies of the course's general views keep apart.

    A scheme without a view, or one whose view does not say that it shows bodies, is not looked at.
    """
    return partial(_worst_overlaps, course)  # and no inner function: it travels to other processes


def _worst_overlaps(
    course: Course, scheme_id: str, values: Mapping[str, Array]
) -> list[Overlap | None]:
    """Return the worst overlap of each variant; see `OverlapCheck`."""
    scheme = course.schemes[scheme_id]
    found = interference(scheme, columns_of(course.catalogues), values)
    count = max((len(one) for one in values.values()), default=0)
    worst = (found.of(row) for row in range(count))
    return [None if one is None else _overlap(course, scheme, one) for one in worst]


def _overlap(course: Course, scheme: Scheme, found: Interference) -> Overlap:
    titles = {} if scheme.view is None else {one.id: one.title for one in scheme.view.parts}
    first, second = (
        titles.get(one) or _plain(one) for one in (found.pair.first, found.pair.second)
    )
    position = course.positions.get(found.pair.position)
    where = _plain(found.pair.position) if position is None else position.title
    return Overlap((first, second), where, found.overlap)


def _plain(name: str) -> Texts:
    return Texts(dict.fromkeys(LANGUAGES, name))
