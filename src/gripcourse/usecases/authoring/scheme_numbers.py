"""The numbers of single schemes: what is printed of them comes out, and variants can be drawn.

A scheme is judged with what it is made from and nothing else, so that it can be remembered. Where
something is wrong with it, it is judged again with all of the course: a remedy may name what only
others have.
"""

from collections.abc import Collection, Iterator, Sequence
from typing import Final

from gripcourse.course.compose import of_schemes
from gripcourse.course.model import Course
from gripcourse.course.quantity import Convention
from gripcourse.course.sound_schemes import SchemeJudgement, judgement
from gripcourse.course.source_files import SourceFiles
from gripcourse.errors import GripcourseError, Problem
from gripcourse.proofs.calculations import calculations, differences
from gripcourse.proofs.interference import crossed_in_example
from gripcourse.proofs.model import ProofKind
from gripcourse.proofs.published_cases import PublishedCase
from gripcourse.variants.draw import nothing_left
from gripcourse.variants.space import load_spaces, offered_choices, spaces_in

# What no number of a scheme is computed from, and no variant of it drawn.
NOT_COMPUTED: Final = (
    *("grader/", "variants/atlas/", "variants/equilibrium/", "variants/tables/"),
    *("variants/proofs.toml", "variants/roster.csv"),
)


def numbers_of_schemes(course: Course, files: SourceFiles | None) -> SchemeJudgement | None:
    """Find out of which schemes the numbers were not found sound; None where that cannot be told.

    Args:
        course: without problems of its own.
        files: of it; taken before it was read.
    """
    if files is None or not files.are_spaces_named(course.schemes):
        return None
    # A file of spaces may name any scheme, and a range any choice of any scheme.
    beside = (repr(sorted(course.schemes)), repr(sorted(offered_choices(course))))
    return judgement(course, files, NOT_COMPUTED, "numbers", *beside)


def is_sound_alone(judged: SchemeJudgement, scheme: str, cases: Sequence[PublishedCase]) -> bool:
    """Tell whether the numbers of a scheme are sound that waits to be judged.

    Args:
        judged: see `numbers_of_schemes`.
        scheme: its id.
        cases: all published cases of the course.
    """
    alone = judged.alone[scheme]
    paths = [alone.root / name for name in judged.files.spaces_of(scheme)]
    try:
        spaces = spaces_in(paths, alone, judged.course)
    except GripcourseError:
        return False
    printed = computed_problems(alone, {scheme}, cases)
    return not printed and next(nothing_left(alone, spaces), None) is None


def computed_problems(
    course: Course, only: Collection[str], cases: Sequence[PublishedCase]
) -> list[Problem]:
    """Compute worked examples and published cases, and the outlines that are drawn with these.

    Args:
        course: without problems of its own.
        only: ids of the schemes that are computed.
        cases: all published cases of the course.
    """
    own = [one for one in cases if one.scheme in only]
    problems: list[Problem] = []
    for one in calculations(of_schemes(course, only), own):
        problems += differences(one)
        if one.kind is ProofKind.EXAMPLE and one.plan.convention is Convention.CORRECTED:
            problems += crossed_in_example(one)
    return problems


def drawn_problems(course: Course, only: Collection[str]) -> Iterator[Problem]:
    """Yield what is wrong with the spaces of a course, and which of some schemes leave nothing."""
    try:
        spaces = load_spaces(course)
    except GripcourseError as error:
        yield from error.problems
    else:
        yield from nothing_left(course, [one for one in spaces if one.scheme in only])
