"""Automatic results of attempts: what they are, whether two sets say the same, and their digest.

A batch that is graded again finds for nearly every work that nothing has changed. So the digest of
results stands with their attempt and with their report, and where both are the same, nobody reads
either: see `ResultsToRead`.
"""

import hashlib
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial
from sys import intern
from typing import Final

from gripcourse.grading.folded import Derivation, derived
from gripcourse.grading.model import Finding, Outcome, Report

# Points of one policy are the same number on each machine but for the last bits.
POINTS_DECIMALS: Final = 6
_REMEMBERED: Final = 8192  # different ones: some two hundred bytes each


@dataclass(frozen=True, slots=True)
class Result:
    """What the program found out about one item by itself, before any person's mark.

    Attributes:
        quantity: id.
        outcome: what was found.
        points, max_points: earned and possible.
    """

    quantity: str
    outcome: Outcome
    points: float
    max_points: float

    def __reduce__(
        self,
    ) -> "tuple[Callable[[str, Outcome, float, float], Result], tuple[str, Outcome, float, float]]":
        # As findings: half the time that dataclasses take of themselves.
        return result_of, (self.quantity, self.outcome, self.points, self.max_points)


@lru_cache(maxsize=_REMEMBERED)
def result_of(quantity: str, outcome: Outcome, points: float, max_points: float) -> Result:
    """Return a result; a cohort has few different ones, and each is made once."""
    return Result(intern(quantity), outcome, points, max_points)


@dataclass(frozen=True, slots=True, eq=False)
class ResultsToRead:
    """Results that are read anew whenever somebody looks at them, and their digest.

    Attributes:
        digest: of all that they say; empty where it is not known.
        read: reads them.
    """

    digest: str
    read: Callable[[], tuple[Result, ...]]

    def __len__(self) -> int:
        return len(self.read())

    def __iter__(self) -> Iterator[Result]:
        return iter(self.read())

    def __contains__(self, wanted: object) -> bool:
        return wanted in self.read()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, tuple | ResultsToRead) and self.read() == tuple(other)

    def __hash__(self) -> int:
        return hash(self.read())


def results_of(report: Report) -> tuple[Result, ...]:
    """Return the automatic results of a report that no mark of a person has entered yet."""
    return derived(report.findings, RESULTS)


def results_to_read(report: Report) -> ResultsToRead:
    """Return what `results_of` does, read when somebody looks at it."""
    return ResultsToRead(derived(report.findings, RESULTS_DIGEST), partial(results_of, report))


def same_results(some: Collection[Result], others: Collection[Result]) -> bool:
    """Tell whether two sets of results say the same, whatever their order."""
    digests = _known_digest(some), _known_digest(others)
    if all(digests):
        return digests[0] == digests[1]
    return _comparable(some) == _comparable(others)


def digest_is_known(results: Collection[Result]) -> bool:
    """Tell whether the digest of results is known without looking at them."""
    return bool(_known_digest(results))


def digest_of_results(results: Collection[Result]) -> str:
    """Return a digest of all that results say, whatever their order."""
    return _known_digest(results) or _digest(results)


def _known_digest(results: Collection[Result]) -> str:
    return results.digest if isinstance(results, ResultsToRead) else ""


def _digest(results: Collection[Result]) -> str:
    lines = sorted(
        f"{name}\t{outcome.value}\t{points!r}\t{most!r}"
        for name, outcome, points, most in _comparable(results)
    )
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()


def _comparable(results: Collection[Result]) -> frozenset[tuple[str, Outcome, float, float]]:
    # With a nought added, since what is rounded to minus nought is nought.
    return frozenset(
        (
            one.quantity,
            one.outcome,
            round(one.points, POINTS_DECIMALS) + 0.0,
            round(one.max_points, POINTS_DECIMALS) + 0.0,
        )
        for one in results
    )


def _results(findings: Collection[Finding]) -> tuple[Result, ...]:
    return tuple(Result(one.quantity, one.outcome, one.points, one.max_points) for one in findings)


def _digest_of_findings(findings: Collection[Finding]) -> str:
    return _digest(_results(findings))


RESULTS: Final = Derivation("results", _results)
"""What the gradebook keeps of findings."""

RESULTS_DIGEST: Final = Derivation("results digest", _digest_of_findings)
"""The digest of that."""
