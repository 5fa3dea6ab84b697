"""Which schemes of a course were found sound in the same files, whatever became of the others.

What is remembered is digests alone, of the files that a scheme is judged from (see `source_files`)
and of what else the judgement depends on: whatever changes, the digest is another one.
"""

import hashlib
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Final

from gripcourse.course.model import Course
from gripcourse.course.source_files import SourceFiles
from gripcourse.machine.kept import keep, read_kept

NOT_READ: Final = (
    *("variants/atlas/", "variants/equilibrium/", "variants/spaces/", "variants/tables/"),
    *("variants/proofs.toml", "variants/published_cases.toml", "variants/roster.csv"),
    *("grader/policy.toml", "grader/slips.toml", "grader/virtual.toml"),
)
"""What neither declares anything nor is read to check what does."""
_REMEMBERED: Final = hashlib.sha256(b"digests of sound schemes").hexdigest()
_MOST: Final = 2048  # digests; the oldest are forgotten


@dataclass(frozen=True, slots=True)
class SchemeJudgement:
    """A judgement of single schemes of a course that was read.

    Attributes:
        course: as it was read.
        files: of it; taken before it was read.
        digests: of what each scheme is judged from, by its id.
        alone: the course as each scheme that waits is judged in it, by its id: with nothing of
            which a change would leave the digest as it is.
    """

    course: Course
    files: SourceFiles
    digests: Mapping[str, str]
    alone: Mapping[str, Course]

    def remember(self) -> None:
        """Remember that all schemes were found sound, unless a file changed meanwhile."""
        known = _remembered()
        new = dict.fromkeys(self.digests.values())
        if not known.keys() >= new.keys() and self.files.are_unchanged(self.course.root):
            keep(_REMEMBERED, tuple(known | new)[-_MOST:])


def judgement(
    course: Course, files: SourceFiles, left_out: Collection[str], *subject: str
) -> SchemeJudgement:
    """Find out which schemes were not found sound in the same files.

    Args:
        course: as it was read.
        files: of it; taken before it was read.
        left_out: what the judgement does not depend on; see `SourceFiles.shared`.
        subject: what is judged, and all that it depends on besides these files and the program.
    """
    shared = files.shared(left_out)
    known = _remembered()
    digests: dict[str, str] = {}
    alone: dict[str, Course] = {}
    for scheme in course.schemes.values():
        judged_from = files.of_scheme(scheme, shared, left_out)
        digests[scheme.id] = files.digest(judged_from, *subject)
        if digests[scheme.id] not in known:
            alone[scheme.id] = files.alone(course, [scheme], judged_from)
    return SchemeJudgement(course, files, digests, alone)


def _remembered() -> dict[str, None]:
    """Return the digests that are remembered, the newest last."""
    found = read_kept(_REMEMBERED)
    return dict.fromkeys(found) if isinstance(found, tuple) else {}
