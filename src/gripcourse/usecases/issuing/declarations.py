"""The declarations that were issued with, kept for works on versions that were corrected since.

A corrected course judges everybody by what it says today: that is what a regrade shows. Only
where a student was issued a version anew, by other declarations, is a work on the one before judged
by those of that day. They lie in the course's private folder, as they stood in its files, under
their own fingerprint: what has another one is not used.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from itertools import chain
from pathlib import Path
from typing import Final

from gripcourse.course.digest import RUBRICS
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.quantity import Quantity
from gripcourse.errors import CourseError
from gripcourse.gradebook.fingerprint import declaring_files, fingerprints
from gripcourse.machine.kept_files import keep_files, kept_files
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Texts
from gripcourse.variants.model import Issued

_KIND: Final = "declarations"


def keep_declarations(root: Path) -> str:
    """Keep the declarations of a course as they are now.

    Args:
        root: folder of the course.

    Returns:
        Their fingerprint.

    Raises:
        OSError: a file cannot be read or written.
    """
    return keep_files(root, _KIND, _fingerprint, chain(declaring_files(root), _rubrics(root)))


def kept_declarations(
    root: Path, last: Mapping[str, Issued], earlier: Iterable[Issued]
) -> dict[str, Course]:
    """Load the declarations that works on corrected versions are judged by.

    Args:
        root: folder of the course.
        last: by student id, the versions that count.
        earlier: all versions that these replaced.

    Returns:
        By fingerprint; without those that were not kept, or that this program cannot use any more.

    Raises:
        OSError: a file cannot be read.
    """
    found = {name: _loaded(root, name) for name in sorted(set(_superseded(last, earlier)))}
    return {name: course for name, course in found.items() if course is not None}


def declared_otherwise(course: Course) -> Callable[[Issued], Sequence[Texts]]:
    """Return what tells the titles of quantities that a version was issued with other formulas of.

    There are none where the declarations of that day are today's, or were not kept.

    Args:
        course: as it is today.
    """
    loaded = cache(partial(_loaded, course.root))

    def titles(issued: Issued) -> Sequence[Texts]:
        before = loaded(issued.declarations) if issued.declarations else None
        if before is None:
            return ()
        composition = issued.variant.composition
        old, new = (plan_of(one, composition).quantities for one in (before, course))
        changed = (one for id_, one in new.items() if _declared(old.get(id_)) != _declared(one))
        return [one.title for one in changed]

    return titles


def _declared(quantity: Quantity | None) -> Quantity | None:
    """Return a declaration wherever it was read from."""
    return None if quantity is None else replace(quantity, file="")


def _superseded(last: Mapping[str, Issued], earlier: Iterable[Issued]) -> Iterator[str]:
    """Yield the fingerprint of each version that another one by other declarations replaced."""
    for one in earlier:
        if one.declarations and one.declarations != last[one.student.id].declarations:
            yield one.declarations


def _fingerprint(root: Path) -> str:
    return fingerprints(root).course


def _rubrics(root: Path) -> Iterable[Path]:
    """Return what items that persons mark name; the rest of the policy is always today's."""
    return sorted((root / RUBRICS).glob("*.toml"))


def _loaded(root: Path, fingerprint: str) -> Course | None:
    with kept_files(root, _KIND, fingerprint, _fingerprint) as folder:
        if folder is None:
            return None
        try:
            return replace(load_course(folder), root=root)
        except CourseError:
            return None
