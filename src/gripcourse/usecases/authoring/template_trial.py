"""Templates tried with the documents of one worked example, and not again with the same ones."""

from collections.abc import Sequence
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Final

from gripcourse.course.atlas import atlas_schemes
from gripcourse.course.compose import of_schemes
from gripcourse.course.model import Course, Scheme
from gripcourse.course.source_files import SourceFiles
from gripcourse.errors import GripcourseError, Problem
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.judged_before import FilesSeen, unless_sound
from gripcourse.usecases.authoring.samples import samples
from gripcourse.usecases.authoring.templates import Templates, filling_problems, sample_documents
from gripcourse.variants.space import Space, load_spaces, spaces_in

_NOT_SHOWN: Final = ("variants/tables/", "variants/roster.csv")  # in no document of a sample


def trial_problems(
    course: Course,
    files: SourceFiles | None,
    templates: Path,
    look: FilesSeen,
    read: Templates,
) -> list[Problem]:
    """Fill the documents of a course's first worked example; return what is wrong with templates.

    Args:
        course: without problems of its own.
        files: of it, taken before it was read; None where these cannot be told.
        templates: the folder.
        look: all that templates are taken from, seen before it was read.
        read: its templates.
    """
    example = next((one for one in course.schemes.values() if one.example is not None), None)
    drawn = _drawn(course, files, example)
    named = {*(one.scheme for one in drawn), *atlas_schemes(course.root)}
    named |= set() if example is None else {example.id}
    shown = [one for one in course.schemes.values() if one.id in named]
    if files is None:
        return _problems(course, of_schemes(course, named), drawn, templates, read)
    shared = files.shared(_NOT_SHOWN)
    # The pages of reference show all catalogues.
    judged_from = {*shared, *files.catalogues()}
    judged_from.update(name for one in shown for name in files.of_scheme(one, shared))
    alone = files.alone(course, shown, judged_from)
    trial = partial(_problems, course, alone, drawn, templates, read)
    told = files.digest(judged_from, "templates")
    return unless_sound(f"templates with {told}", [look], trial)


def _drawn(course: Course, files: SourceFiles | None, example: Scheme | None) -> tuple[Space, ...]:
    """Return what variants for a certificate are drawn from: the example's space, if it has one.

    What is wrong with spaces is said elsewhere.
    """
    try:
        if files is not None and example is not None:
            judged_from = files.of_scheme(example, files.shared(_NOT_SHOWN))
            paths = [course.root / name for name in files.spaces_of(example.id)]
            alone = files.alone(course, [example], judged_from)
            if own := spaces_in(paths, alone, course):
                return own
        spaces = load_spaces(course)
    except GripcourseError:
        return ()
    own = tuple(one for one in spaces if example is not None and one.scheme == example.id)
    return own or spaces[:1]


def _problems(
    course: Course, shown: Course, spaces: Sequence[Space], templates: Path, read: Templates
) -> list[Problem]:
    """Fill documents with what some schemes show; where anything is wrong, with all of them.

    What is found must not depend on other schemes, because it is remembered; a remedy may name one.
    """
    policy = load_policy(course)
    read.tell(templates, course.language)
    found = _filled(shown, policy, spaces, templates, read)
    return found and _filled(course, policy, spaces, templates, read)


def _filled(
    course: Course, policy: Policy, spaces: Sequence[Space], templates: Path, read: Templates
) -> list[Problem]:
    words, problems = Words(course.language), list[Problem]()
    for sample in islice(samples(course, policy, spaces, words), 1):
        documents, hindered = sample_documents(sample)
        problems += [*hindered, *filling_problems(documents, templates, words, read.read)]
    return problems
