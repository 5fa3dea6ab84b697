"""Templates tried with the documents of one worked example, and not again with the same ones."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Final, TypeAlias

from gripcourse.course.atlas import atlas_schemes
from gripcourse.course.compose import of_schemes
from gripcourse.course.load import kept_course
from gripcourse.course.model import Course, Scheme
from gripcourse.course.source_files import SourceFiles
from gripcourse.errors import GripcourseError, Problem
from gripcourse.machine.jobs.limits import Limits
from gripcourse.machine.jobs.lost import Lost
from gripcourse.machine.jobs.warm import begin_apart, start_early
from gripcourse.machine.process_wide import few_collections
from gripcourse.policy.model import Policy
from gripcourse.text.words import Words
from gripcourse.usecases.authoring.judged_before import FilesSeen, is_known, unless_sound
from gripcourse.usecases.authoring.samples import samples
from gripcourse.usecases.authoring.templates import Templates, filling_problems, sample_documents
from gripcourse.variants.space import Space, load_spaces, spaces_in

_NOT_SHOWN: Final = ("variants/tables/", "variants/roster.csv")  # in no document of a sample
_LIMITS: Final = Limits()
_SECONDS: Final = 120.0  # that a trial may take beside other work; then it is done here

Tried: TypeAlias = Callable[[], list[Problem] | Lost | None]
"""Waits for what a trial apart came to; nothing where the course is not kept."""


@dataclass(frozen=True, slots=True)
class TemplateTrial:
    """What templates are tried with: the documents of a course's first worked example.

    Attributes:
        course: without problems of its own.
        shown: the same course with nothing but what these documents show.
        spaces: what variants for a certificate are drawn from.
        subject: a name of the trial, with a digest of all that is shown; None: it cannot be told.
    """

    course: Course
    shown: Course
    spaces: tuple[Space, ...]
    subject: str | None

    def is_known(self, look: FilesSeen) -> bool:
        """Tell whether the same templates were found sound with the same documents."""
        return self.subject is not None and is_known(self.subject, [look])


@dataclass(frozen=True, slots=True)
class _TrialOrder:
    """What another process must be sent; the course is kept, and unpacked faster than sent."""

    root: Path
    files: SourceFiles | None
    policy: Policy
    templates: Path
    read: Templates


def trial_of(course: Course, files: SourceFiles | None) -> TemplateTrial:
    """Return what templates are tried with.

    Args:
        course: without problems of its own.
        files: of it, taken before it was read; None where these cannot be told.
    """
    example = next((one for one in course.schemes.values() if one.example is not None), None)
    drawn = _drawn(course, files, example)
    named = {*(one.scheme for one in drawn), *atlas_schemes(course.root)}
    named |= set() if example is None else {example.id}
    if files is None:
        return TemplateTrial(course, of_schemes(course, named), drawn, None)
    shown = [one for one in course.schemes.values() if one.id in named]
    shared = files.shared(_NOT_SHOWN)
    # The pages of reference show all catalogues.
    judged_from = {*shared, *files.catalogues()}
    judged_from.update(name for one in shown for name in files.of_scheme(one, shared))
    alone = files.alone(course, shown, judged_from)
    told = files.digest(judged_from, "templates")
    return TemplateTrial(course, alone, drawn, f"templates with {told}")


def prepare_apart() -> None:
    """Start the process that `begun_apart` will ask, while this one does something else."""
    start_early(_import, _LIMITS)


def begun_apart(
    root: Path, files: SourceFiles | None, policy: Policy, templates: Path, read: Templates
) -> Tried:
    """Begin a trial in another process: it takes as long as the numbers of a course do.

    Args:
        root: of the course.
        files: see `trial_of`.
        policy: of the course.
        templates: the folder.
        read: its templates.
    """
    order = _TrialOrder(root, files, policy, templates, read)
    return begin_apart(_filled_apart, order, None, limits=_LIMITS, seconds=_SECONDS)


def trial_problems(
    trial: TemplateTrial,
    policy: Policy,
    templates: Path,
    look: FilesSeen,
    read: Templates,
    tried: Tried | None = None,
) -> list[Problem]:
    """Fill the documents of a course's first worked example; return what is wrong with templates.

    Args:
        trial: see `trial_of`.
        policy: of the course.
        templates: the folder.
        look: all that templates are taken from, seen before it was read.
        read: its templates.
        tried: see `begun_apart`; None: here and now.
    """
    judge = partial(_problems, trial, policy, templates, read, tried)
    return judge() if trial.subject is None else unless_sound(trial.subject, [look], judge)


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
    trial: TemplateTrial, policy: Policy, templates: Path, read: Templates, tried: Tried | None
) -> list[Problem]:
    """Fill documents with what some schemes show; where anything is wrong, with all of them.

    What is found must not depend on other schemes, because it is remembered; a remedy may name one.
    """
    outcome = None if tried is None else tried()
    if outcome == []:
        return []
    read.tell(templates, trial.course.language)
    # What another process found wrong, or could not do, is told by this one.
    found = outcome if isinstance(outcome, list) else None
    if found is None:
        found = _filled(trial.shown, policy, trial.spaces, templates, read)
    return found and _filled(trial.course, policy, trial.spaces, templates, read)


def _import(*_: None) -> None:
    """Import what filling documents takes: half a second."""
    from gripcourse.documents.registry import document_kinds  # noqa: PLC0415 (as said)

    document_kinds()


def _filled_apart(one: _TrialOrder, _: None) -> list[Problem] | None:
    with few_collections():
        course = kept_course(one.root)
        if course is None:
            return None
        trial = trial_of(course, one.files)
        one.read.tell(one.templates, course.language)
        return _filled(trial.shown, one.policy, trial.spaces, one.templates, one.read)


def _filled(
    course: Course, policy: Policy, spaces: Sequence[Space], templates: Path, read: Templates
) -> list[Problem]:
    words, problems = Words(course.language), list[Problem]()
    for sample in islice(samples(course, policy, spaces, words), 1):
        documents, hindered = sample_documents(sample)
        problems += [*hindered, *filling_problems(documents, templates, words, read.read)]
    return problems
