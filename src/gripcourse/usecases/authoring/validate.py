"""Checking a whole course at once: declarations, catalogues, policy, spaces and tables."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from gripcourse.course.check import check_course
from gripcourse.course.check_equations import check_equations
from gripcourse.course.compose import all_part_ids
from gripcourse.course.load import judge_course, kept_course
from gripcourse.course.model import Course, Scheme
from gripcourse.course.read import read_course
from gripcourse.course.source_files import SourceFiles, source_files
from gripcourse.course.unaffected import unaffected
from gripcourse.errors import GripcourseError, Problem, UsageError
from gripcourse.machine.doctor import checks
from gripcourse.machine.process_wide import few_collections
from gripcourse.machine.resources import REQUIRED_FOLDERS, TEMPLATES, template_folders
from gripcourse.policy.load import read_policy
from gripcourse.policy.model import Policy
from gripcourse.proofs.calculations import calculations, differences
from gripcourse.proofs.check_declared import check_declared
from gripcourse.proofs.declared import read_declared_proofs
from gripcourse.proofs.equilibrium.check import check_mechanisms
from gripcourse.proofs.equilibrium.read import read_mechanisms
from gripcourse.proofs.published_cases import PublishedCase, read_published_cases
from gripcourse.simulation.mix import mix_path, read_mix
from gripcourse.text.suggestion import did_you_mean
from gripcourse.text.words import message
from gripcourse.usecases.authoring.check_lists import list_problems
from gripcourse.usecases.authoring.course_notes import course_notes, example_notes
from gripcourse.usecases.authoring.judged_before import (
    FilesSeen,
    files_seen,
    found_before,
    is_known,
    unless_sound,
)
from gripcourse.usecases.authoring.scheme_numbers import (
    computed_problems,
    drawn_problems,
    is_sound_alone,
    numbers_of_schemes,
)
from gripcourse.usecases.authoring.styles import style_problems
from gripcourse.usecases.authoring.template_trial import (
    TemplateTrial,
    begun_apart,
    prepare_apart,
    trial_of,
    trial_problems,
)
from gripcourse.usecases.authoring.templates import all_templates
from gripcourse.usecases.authoring.unread_files import unread_problems
from gripcourse.variants.pays import paying_rules
from gripcourse.variants.range_problems import range_problems
from gripcourse.variants.table import read_table

# What every document of every course needs of a machine; its fonts are asked for by the course.
_NEEDED = ("pango", "harfbuzz-subset", "translation")
_NUMBERS = "numbers"
_BOTH = 2  # processes: one for numbers, one for templates


@dataclass(frozen=True, slots=True)
class Validation:
    """What is wrong with a course.

    Attributes:
        problems: all that were found.
        computed: whether all its examples, variants and documents were tried: what depends on
            declarations or a policy that are wrong would only add noise.
        notes: what an author should know though nothing is wrong with it; none while something is.
    """

    problems: list[Problem]
    computed: bool
    notes: tuple[Problem, ...] = ()


def validated(root: Path, *, thorough: bool = False, processes: int = 1) -> Validation:
    """Find every problem of a course, whatever file it is in, and of this machine with it.

    Args:
        root: of the course.
        thorough: look at every combination of options, and not only at any two choices together:
            some seconds for what three options do to each other.
        processes: that may work at a time; with two, templates are tried while numbers are judged.
    """
    # Nearly everything that is read lives to the end.
    with few_collections():
        return _validated(root, thorough=thorough, is_alone=processes < _BOTH)


def _validated(root: Path, *, thorough: bool, is_alone: bool) -> Validation:
    # All of it as it is before anything is read.
    files = source_files(root)
    own = files_seen(root, [root / name for name in REQUIRED_FOLDERS])
    templates = root / TEMPLATES
    look = files_seen(root, template_folders(templates))
    course, problems = _judged(root, files, thorough=thorough)
    if course is None:
        return Validation([*problems, *unread_problems(root)], computed=False)
    problems += check_equations(course)
    # Spaces, tables and filled pages are about the course: judging them against a broken one only
    # adds noise.
    is_sound = not problems
    trial: TemplateTrial | None = None
    if not is_sound:
        problems += _unaffected_problems(course, problems)
    elif not (is_alone or is_known(_NUMBERS, [own])):
        trial = _to_try_apart(course, files, look)
    policy, unfit = read_policy(course)
    problems += [*unfit, *_mix_problems(course)]
    problems += _list_problems(course, policy)
    read = found_before(
        f"templates in {course.language}",
        [look],
        partial(all_templates, templates, course.language),
        lambda one: not one.problems,
    )
    problems += [*read.problems, *style_problems(templates)]
    fit = None if unfit else policy
    tried = begun_apart(root, files, fit, templates, read) if trial and fit else None
    if is_sound:
        problems += unless_sound(_NUMBERS, [own], partial(_number_problems, course, files, fit))
    if is_sound and fit is not None:

        def filled() -> list[Problem]:
            tried_with = trial or trial_of(course, files)
            return trial_problems(tried_with, fit, templates, look, read, tried)

        problems += unless_sound("templates", [own, look], filled)
    computed = is_sound and fit is not None
    # A file that nobody reads may be what a problem misses, but spoils no number.
    problems += [*unread_problems(root), *_machine_problems(root)]
    notes = () if problems else _notes(course, own)
    return Validation(problems, computed=computed, notes=notes)


def _notes(course: Course, own: FilesSeen) -> tuple[Problem, ...]:
    """Return what is to be known of a sound course; found out once for the same files."""
    found = found_before("notes", [own], partial(course_notes, course), lambda _: True)
    return tuple(found)


def _to_try_apart(
    course: Course, files: SourceFiles | None, look: FilesSeen
) -> TemplateTrial | None:
    """Return what another process is to try templates with, and start it; None: they are known."""
    trial = trial_of(course, files)
    if trial.is_known(look):
        return None
    prepare_apart()
    return trial


def _judged(
    root: Path, files: SourceFiles | None, *, thorough: bool
) -> tuple[Course | None, list[Problem]]:
    """Read and check a course; one that was found sound is not read again but for more."""
    if not thorough:
        course, problems, _ = judge_course(root, files)
        return course, problems
    course, problems = read_course(root)
    return course, problems if course is None else [*problems, *check_course(course, thorough=True)]


def _number_problems(
    course: Course, files: SourceFiles | None, policy: Policy | None
) -> list[Problem]:
    """Return the problems of all that a sound course prints, draws and lists.

    Without a policy nobody can tell what its tables would pay.
    """
    cases, problems = _declared_problems(course)
    judged = numbers_of_schemes(course, files)
    if judged is None or not all(is_sound_alone(judged, one, cases) for one in judged.alone):
        waiting = course.schemes if judged is None else judged.alone
        problems += computed_problems(course, waiting, cases)
        # Where an example does not come out nothing may be left for that alone.
        believed = [one for one in waiting if not _is_about(course.schemes[one], problems)]
        problems += drawn_problems(course, believed)
    if judged is not None and not problems:
        judged.remember()
    return [*problems, *([] if policy is None else _table_problems(course, policy))]


def _is_about(scheme: Scheme, problems: Iterable[Problem]) -> bool:
    """Tell whether a problem stands in the folder of a scheme."""
    return any(one.file.startswith(scheme.file.removesuffix("scheme.toml")) for one in problems)


def scheme_problems(root: Path, scheme: str) -> list[Problem]:
    """Return the problems of one scheme, its parts and its printed numbers; in a moment.

    Args:
        root: of the course.
        scheme: its id.

    Raises:
        UsageError: the course has no such scheme.
    """
    own = files_seen(root, [root / name for name in REQUIRED_FOLDERS])
    course = kept_course(root)
    if course is not None:  # every scheme of it was checked
        with_scheme(course, scheme)
        printed = partial(_printed_problems, course, scheme)
        return unless_sound(f"numbers of {scheme}", [own], printed)
    course, problems = read_course(root)
    if course is None:
        return problems
    problems += check_course(with_scheme(course, scheme), whole=course)
    return problems or _printed_problems(course, scheme)


def scheme_notes(root: Path, scheme: str) -> list[Problem]:
    """Return what is to be known of one scheme of a course; nothing while something is wrong.

    Args:
        root: of the course.
        scheme: its id.
    """
    course = kept_course(root) or read_course(root)[0]
    return [] if course is None else list(example_notes(course, [course.schemes[scheme]]))


def with_scheme(course: Course, scheme: str) -> Course:
    """Return a course as if it had one scheme only, with the parts that it uses.

    Raises:
        UsageError: it has no such scheme.
    """
    if scheme not in course.schemes:
        what = message("The course has no scheme '{scheme}'.", scheme=scheme)
        raise UsageError([Problem("", "", what, did_you_mean(scheme, course.schemes))])
    one = course.schemes[scheme]
    used = all_part_ids(one)
    parts = {name: part for name, part in course.parts.items() if name in used}
    # Notes speak of quantities of any scheme: they are checked with the whole course.
    return replace(course, schemes={scheme: one}, parts=parts, notes=())


def _printed_problems(course: Course, scheme: str) -> list[Problem]:
    """Check what the course declares; compute what is printed of one scheme."""
    cases, problems = _declared_problems(course)
    return [*problems, *computed_problems(course, {scheme}, cases)]


def _declared_problems(course: Course) -> tuple[tuple[PublishedCase, ...], list[Problem]]:
    """Check what a course declares, about several schemes maybe; return its published cases."""
    cases, problems = read_published_cases(course)
    declared, found = read_declared_proofs(course)
    problems += [*found, *check_declared(course, declared)]
    mechanisms, found = read_mechanisms(course)
    problems += [*found, *check_mechanisms(course, mechanisms)]
    return cases, problems


def _unaffected_problems(course: Course, found: Sequence[Problem]) -> list[Problem]:
    """Compute the examples as far as no problem touches them, and judge each range by itself."""
    wrong = [
        one
        for part in unaffected(course, found)
        for calculation in calculations(part, ())
        for one in differences(calculation)
    ]
    return [*wrong, *range_problems(course, found)]


def _machine_problems(root: Path) -> Iterator[Problem]:
    for check in checks(root):
        if not check.ok and check.name.split()[0] in _NEEDED:
            what = message("{fault}.", fault=check.message)
            yield Problem("", check.name, what, check.remedy)


def _list_problems(course: Course, policy: Policy | None) -> list[Problem]:
    """Return what is wrong with the lists of students and their deadlines."""
    return list_problems(course, policy)


def _mix_problems(course: Course) -> list[Problem]:
    """A course that nobody measures needs no virtual students."""
    return read_mix(course)[1] if mix_path(course.root).exists() else []


def _table_problems(course: Course, policy: Policy) -> list[Problem]:
    """Look into every table: whether it can be read, and whether guessing would pay in it."""
    problems: list[Problem] = []
    for path in sorted((course.root / "variants" / "tables").glob("*.csv")):
        name = path.relative_to(course.root).as_posix()
        try:
            problems += paying_rules(course, policy, read_table(path, course), name)
        except GripcourseError as error:
            problems += [
                replace(one, file=name) if one.file == str(path) else one for one in error.problems
            ]
    return problems
