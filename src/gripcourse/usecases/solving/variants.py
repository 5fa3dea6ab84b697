"""Making variant tables: drawn from the course's spaces, or an instructor's own."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from gripcourse.course.composition import Composition
from gripcourse.course.model import Course
from gripcourse.errors import Problem, UsageError
from gripcourse.machine.content import Readable
from gripcourse.machine.files import expect_file
from gripcourse.policy.load import load_policy
from gripcourse.solver.plan import plan_of
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message
from gripcourse.variants.answers import solve_groups
from gripcourse.variants.bodies import bodies_check
from gripcourse.variants.defaults import Defaults
from gripcourse.variants.draw import Drawn, draw
from gripcourse.variants.draw_freely import draw_freely
from gripcourse.variants.expected_table import expect_room
from gripcourse.variants.model import Variant
from gripcourse.variants.readable import expect_kind
from gripcourse.variants.screening import sifter
from gripcourse.variants.space import Space, load_spaces
from gripcourse.variants.table import OwnTable, read_own_table, read_table, write_table


def draw_variants(  # noqa: PLR0913 (the last three are for those who need them)
    course: Course,
    count: int,
    seed: int,
    scheme: str | None,
    *,
    freely: bool = False,
    workers: int = 0,
    apart_from: Sequence[Variant] = (),
) -> Drawn:
    """Draw variants.

    Args:
        course: whose variants are drawn.
        count: how many.
        seed: the same seed gives the same variants.
        scheme: only this one; None for all.
        freely: whether to leave the policy's rules for variants aside: what is drawn can be solved
            and built, but nothing keeps it apart.
        workers: how many processes draw freely; 0 for none but this one. What is kept apart is
            drawn one after the other.
        apart_from: variants of other tables, for example of last year, that what is drawn must be
            as far from as from each other.

    Raises:
        GripcourseError: there is no such scheme, or its space gives too few variants.
    """
    spaces = _spaces(course, scheme)
    if freely:
        return draw_freely(course, spaces, count, seed, workers)
    others = solve_groups(course, apart_from)
    rules = sifter(load_policy(course), len(course.sections), bodies_check(course), others)
    return draw(course, spaces, count, seed, rules)


def _spaces(course: Course, scheme: str | None) -> list[Space]:
    all_ = load_spaces(course)
    spaces = [one for one in all_ if scheme in {None, one.scheme}]
    if not spaces:
        what = message("There is no space to draw '{scheme}' from.", scheme=scheme or "")
        remedy = did_you_mean(scheme or "", [one.scheme for one in all_])
        raise UsageError([Problem("", "", what, remedy, parameter="scheme")])
    return spaces


def draw_table(  # noqa: PLR0913 (the last two are for those who need them)
    course: Course,
    count: int,
    seed: int,
    scheme: str | None,
    out: Path,
    *,
    freely: bool = False,
    apart_from: Sequence[Readable] = (),
) -> Drawn:
    """Draw variants and write them as a table, apart from those of others; see `draw_variants`."""
    expect_kind(out)
    expect_file(out)
    expect_room(out, course, _spaces(course, scheme), count, seed)
    others = [variant for one in apart_from for variant in read_table(one, course)]
    drawn = draw_variants(course, count, seed, scheme, freely=freely, apart_from=others)
    write_table(out, drawn.variants, course)
    return drawn


def import_table(course: Course, source: Readable, out: Path) -> OwnTable:
    """Check an instructor's table and write it as the other commands read it.

    Raises:
        TableError: with every bad row, named by row and column.
    """
    table = read_own_table(source, course)
    write_table(out, table.variants, course)
    return table


def write_template(course: Course, scheme: str | None, rows: int, out: Path) -> tuple[Variant, ...]:
    """Write a table for an instructor to fill in: the worked example in every row.

    Args:
        course: whose schemes.
        scheme: the one that the table is for; None for all of them, `rows` of each.
        rows: how many variants of a scheme.
        out: a `.xlsx` or `.csv` file.

    Raises:
        GripcourseError: there is no such scheme, or nothing says its defaults.
    """
    chosen = [one for one in course.schemes.values() if scheme in {None, one.id}]
    if not chosen:
        what = message("There is no scheme '{scheme}'.", scheme=scheme or "")
        remedy = did_you_mean(scheme or "", course.schemes)
        raise UsageError([Problem("", "", what, remedy, parameter="scheme")])
    defaults = Defaults.of(course)
    variants: list[Variant] = []
    for one in chosen:
        plan = plan_of(course, Composition.of(one.id, defaults.options(one)))
        made = defaults.variant(plan, "")
        if made is None:
            what = message("The scheme '{scheme}' has neither a worked example nor ranges for all"
                           " of its numbers.", scheme=one.id)  # fmt: skip
            remedy = message("Write one of them; then a table can be made of it.")
            raise UsageError([Problem(one.file, "", what, remedy)])
        first = len(variants) + 1
        variants += (replace(made, id=f"{number:03d}") for number in range(first, first + rows))
    write_table(out, variants, course)
    return tuple(variants)
