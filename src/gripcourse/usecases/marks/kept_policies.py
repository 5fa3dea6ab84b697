"""The policies that works were graded by, kept so that a regrade can say what changed in them.

They lie in the course's private folder, as they stood in its files, under their own fingerprint.
Nothing is graded by them: points and credits are always today's.
"""

from collections import Counter
from collections.abc import Container, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from gripcourse.gradebook.fingerprint import fingerprints, policy_files
from gripcourse.gradebook.model import Attempt
from gripcourse.gradebook.policy_changes import PolicyLine, changed_lines
from gripcourse.machine.kept_files import keep_files, kept_files

_KIND: Final = "policies"


@dataclass(frozen=True, slots=True)
class PolicyChange:
    """How today's policy differs from one that works were graded by.

    Attributes:
        fingerprint: of the policy of then.
        works: how many it stands behind.
        lines: that differ; none where only comments or layout do, None where it was not kept.
    """

    fingerprint: str
    works: int
    lines: tuple[PolicyLine, ...] | None


def keep_policy(root: Path) -> None:
    """Keep the policy of a course as it is now; where nothing can be kept, nothing happens.

    A course without a private folder is given none: it has issued nothing.

    Args:
        root: folder of the course.
    """
    if (root / "private").is_dir():
        with suppress(OSError):
            keep_files(root, _KIND, _fingerprint, policy_files(root))


def policy_changes(root: Path, graded_by: Iterable[str]) -> tuple[PolicyChange, ...]:
    """Compare the policies that works were graded by with today's.

    Args:
        root: folder of the course.
        graded_by: the fingerprint of each work's policy.

    Returns:
        One for each policy but today's, those of the most works first.

    Raises:
        OSError: a file of today's policy cannot be read.
    """
    today, now = fingerprints(root).policy, _contents(root)
    counts = Counter(one for one in graded_by if one != today)
    return tuple(
        PolicyChange(one, works, None if before is None else changed_lines(before, now))
        for one, works in counts.most_common()
        for before in (_kept(root, one),)
    )


def changed_by_attempt(
    root: Path, attempts: Iterable[Attempt], undone: Container[int | None]
) -> Mapping[tuple[str, int], tuple[PolicyLine, ...]]:
    """Return what had changed in the policy since the same work was graded before.

    What was taken back is nothing that a later grading is compared with.

    Args:
        root: folder of the course.
        attempts: in the order in which they were kept.
        undone: numbers of the regrades that were taken back.

    Returns:
        By the key of the attempt; without those of which a policy was not kept.
    """
    before: dict[str, str] = {}
    found: dict[tuple[str, int], tuple[PolicyLine, ...]] = {}
    for one in attempts:
        policy = one.fingerprints.policy
        earlier = before.get(one.digest, policy)
        if earlier != policy:
            old, new = (_kept(root, each) for each in (earlier, policy))
            if old is not None and new is not None:
                found[one.key] = changed_lines(old, new)
        if one.regrade not in undone:
            before[one.digest] = policy
    return found


def _kept(root: Path, fingerprint: str) -> Mapping[str, bytes] | None:
    # Why a regrade changes something is no reason to fail.
    with suppress(OSError), kept_files(root, _KIND, fingerprint, _fingerprint) as folder:
        return None if folder is None else _contents(folder)
    return None


def _fingerprint(root: Path) -> str:
    return fingerprints(root).policy


def _contents(root: Path) -> dict[str, bytes]:
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in policy_files(root)}
