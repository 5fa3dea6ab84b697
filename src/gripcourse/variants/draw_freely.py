"""Drawing variants that are only solvable and buildable, scheme by scheme in several processes.

No scheme has to know what was drawn of another one: unlike variants that are kept apart.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

from gripcourse.course.model import Course
from gripcourse.errors import Problem, TableError
from gripcourse.machine.jobs.workers import Lost, all_done, in_order, run_each
from gripcourse.variants.bodies import bodies_check
from gripcourse.variants.draw import DrawingOrder, Drawn, Found, draw, draw_space, mixed, orders_of
from gripcourse.variants.screening import buildable
from gripcourse.variants.space import Space, load_spaces

SECONDS: Final = 3600.0  # that a scheme may take: a limit for what hangs, not for large tables


def draw_freely(
    course: Course, spaces: Sequence[Space], count: int, seed: int, workers: int = 0
) -> Drawn:
    """Draw variants that can be solved and built; nothing keeps them apart.

    Args:
        course: whose schemes are drawn.
        spaces: of the course: what is drawn from, each with its share.
        count: how many variants.
        seed: the same seed gives the same variants, however many processes draw them.
        workers: how many processes; 0 for none but this one.

    Raises:
        TableError: too few candidates can be solved; the main reasons are named.
    """
    if workers == 0:
        return draw(course, spaces, count, seed, buildable(bodies_check(course)))
    orders = orders_of(spaces, count, seed)
    jobs: Iterator[tuple[int, _DrawnScheme | Lost]] = run_each(
        _draw_scheme, orders, course, workers=workers, seconds=SECONDS
    )
    drawn = in_order(all_done(jobs))
    for one in drawn:
        if one.refused:
            raise TableError(one.refused)
    found = tuple(one.found for one in drawn if one.found is not None)
    return mixed(found, count, seed)


@dataclass(frozen=True, slots=True)
class _DrawnScheme:
    """What became of one scheme; `refused` says why there is nothing: no error of ours."""

    found: Found | None = None
    refused: tuple[Problem, ...] = ()


def _draw_scheme(order: DrawingOrder, course: Course) -> _DrawnScheme:
    """Draw the variants of one scheme in a process that knows the course."""
    space = _spaces(course)[order.scheme]
    try:
        return _DrawnScheme(draw_space(course, space, order, buildable(bodies_check(course))))
    except TableError as error:
        return _DrawnScheme(refused=tuple(error.problems))


@lru_cache(maxsize=1)
def _spaces(course: Course) -> dict[str, Space]:
    """Read the spaces of a course once in each process: they cannot be sent."""
    return {one.scheme: one for one in load_spaces(course)}
