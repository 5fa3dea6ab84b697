"""Templates tried with the documents of one worked example, and not again with the same ones."""

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import islice
from pathlib import Path

from gripcourse.course.atlas import atlas_schemes
from gripcourse.course.compose import of_schemes
from gripcourse.course.model import Course
from gripcourse.errors import GripcourseError, Problem
from gripcourse.machine.resources import template_folders
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.judged_before import unless_sound
from gripcourse.usecases.samples import samples
from gripcourse.usecases.templates import Templates, filling_problems, sample_documents
from gripcourse.variants.space import Space, load_spaces


def trial_problems(
    course: Course, digests: Mapping[str, str], templates: Path, read: Templates
) -> list[Problem]:
    """Fill the documents of a course's first worked example; return what is wrong with templates.

    Args:
        course: without problems of its own.
        digests: of what each of its schemes is made from, and all that they share.
        templates: the folder.
        read: its templates.
    """
    spaces = _spaces(course)
    example = next((one.id for one in course.schemes.values() if one.example is not None), "")
    drawn = [one for one in spaces if one.scheme == example] or spaces[:1]
    named = {example, *(one.scheme for one in drawn), *atlas_schemes(course.root)}
    shown = named & course.schemes.keys()
    trial = partial(_problems, course, shown, drawn, templates, read)
    if not shown <= digests.keys():
        return trial()
    told = " ".join(digests[one] for one in sorted(shown))
    return unless_sound(f"templates with {told}", course.root, template_folders(templates), trial)


def _problems(
    course: Course, shown: set[str], spaces: Sequence[Space], templates: Path, read: Templates
) -> list[Problem]:
    """Fill documents with what some schemes show; where anything is wrong, with all of them.

    What is found must not depend on other schemes, because it is remembered; a remedy may name one.
    """
    policy = load_policy(course)
    read.tell(templates, course.language)
    found = _filled(of_schemes(course, shown), policy, spaces, templates, read)
    return found and _filled(course, policy, spaces, templates, read)


def _filled(
    course: Course, policy: Policy, spaces: Sequence[Space], templates: Path, read: Templates
) -> list[Problem]:
    words, problems = Words(course.language), list[Problem]()
    for sample in islice(samples(course, policy, spaces, words), 1):
        documents, hindered = sample_documents(sample)
        problems += [*hindered, *filling_problems(documents, templates, words, read.read)]
    return problems


def _spaces(course: Course) -> tuple[Space, ...]:
    """Return what can be drawn from; what is wrong with it is said elsewhere."""
    try:
        return load_spaces(course)
    except GripcourseError:
        return ()
