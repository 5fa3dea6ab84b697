"""A virtual cohort: variants of all schemes, issued to students who do not exist."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from datetime import date
from typing import Final

import numpy as np

from gripcourse.batch.context import GradingContext
from gripcourse.course.model import Course
from gripcourse.errors import Problem, TableError, UsageError
from gripcourse.issuing.signature import KEY_BYTES, sign
from gripcourse.policy.model import Policy
from gripcourse.simulation.behaviour import draw_behaviours, drawn
from gripcourse.simulation.model import Mix
from gripcourse.simulation.student import Classroom
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message
from gripcourse.variants.draw import draw
from gripcourse.variants.model import Issued, Student, Variant
from gripcourse.variants.screening import sifter
from gripcourse.variants.space import Space, load_spaces

ISSUED_ON: Final = date(2026, 9, 7)
"""The same cohort has the same workbooks, whatever day it is."""


def make_classroom(
    course: Course, policy: Policy, mix: Mix, count: int, seed: int, scheme: str | None = None
) -> Classroom:
    """Make up a cohort.

    Args:
        course: whose variants are drawn.
        policy: by which variants are kept apart and answers are marked.
        mix: how students work.
        count: how many students.
        seed: the same seed gives the same cohort.
        scheme: only this one; None for all.

    Raises:
        GripcourseError: there is no such scheme, or too few variants can be drawn.
    """
    variants = tuple(_drawn(course, policy, _spaces(course, scheme), count, seed))
    entries = issue_to_nobody(course, mix, variants, seed)
    register = {entry.student.id: entry for entry in entries}
    return Classroom(
        GradingContext(course, policy, register), mix, draw_behaviours(entries, mix, seed)
    )


def virtual_key(seed: int) -> bytes:
    """Return the key of a virtual cohort; it protects nothing, so a seed may tell it."""
    return np.random.default_rng([seed, KEY_BYTES]).bytes(KEY_BYTES)


def issue_to_nobody(
    course: Course, mix: Mix, variants: Sequence[Variant], seed: int
) -> tuple[Issued, ...]:
    """Issue each variant to a student who does not exist."""
    rng = np.random.default_rng([seed, 0])
    key = virtual_key(seed)
    return tuple(
        Issued(
            student=Student(
                id=f"v{variant.id}",
                name=f"Virtual student {variant.id}",
                group="virtual",
                email="",
                language=drawn(mix.language, rng),
                variant=variant.id,
            ),
            variant=variant,
            issued_on=ISSUED_ON,
            deadline=None,
            signature=sign(key, course.id, f"v{variant.id}", variant),
        )
        for variant in variants
    )


def _drawn(
    course: Course, policy: Policy, spaces: Sequence[Space], count: int, seed: int
) -> Iterator[Variant]:
    """Draw variants of each space by its share, numbered through.

    They follow the policy's rules for variants as long as a space has so many that do; a cohort may
    be larger than any real one.
    """
    shares = np.cumsum([space.weight for space in spaces]) * count / sum(s.weight for s in spaces)
    counts = np.diff(np.rint(shares).astype(np.int64), prepend=0)
    found: list[Variant] = []
    for place, (space, wanted) in enumerate(zip(spaces, counts, strict=True)):
        rules = sifter(policy, len(course.sections))
        seeded = seed * len(spaces) + place
        try:
            found += draw(course, [space], int(wanted), seeded, rules).variants
        except TableError:
            found += draw(course, [space], int(wanted), seeded).variants
    width = len(str(count))
    for number, variant in enumerate(found, start=1):
        yield replace(variant, id=f"{number:0{width}d}")


def _spaces(course: Course, scheme: str | None) -> list[Space]:
    spaces = load_spaces(course)
    chosen = [one for one in spaces if scheme in {None, one.scheme}]
    if not chosen:
        what = message("There is no space to draw '{scheme}' from.", scheme=scheme or "")
        known = [one.scheme for one in spaces]
        remedy = did_you_mean(scheme or "", known)
        raise UsageError([Problem("", "", what, remedy, parameter="scheme")])
    return chosen
