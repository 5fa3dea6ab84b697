"""Reports folded small: a batch keeps every report until its end, and looks into few at a time.

A finding is some fifty objects; folded, those of a work are one run of bytes, a twentieth of it.
"""

import hashlib
import pickle
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, replace

from gripcourse.grading.model import Finding, Report


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Folded:
    """Findings that are unfolded anew whenever somebody looks at them.

    Attributes:
        packed: of this process or one of its workers, and of nobody else.
        count: how many findings they are.
    """

    packed: bytes
    count: int

    def __len__(self) -> int:
        return self.count

    def __iter__(self) -> Iterator[Finding]:
        found: tuple[Finding, ...] = pickle.loads(zlib.decompress(self.packed))  # noqa: S301 (`folded` wrote it)
        return iter(found)

    def __getitem__(self, place: int) -> Finding:
        return tuple(self)[place]

    def __contains__(self, wanted: object) -> bool:
        return wanted in tuple(self)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, tuple | Folded) and tuple(self) == tuple(other)

    def __hash__(self) -> int:
        return hash(self.count)

    def __repr__(self) -> str:
        # As if they were not folded: of what a document is made from, digests are taken.
        return repr(tuple(self))


def folded(report: Report) -> Report:
    """Return a report that says the same and takes little room."""
    if isinstance(report.findings, Folded) or not report.findings:
        return report
    findings = tuple(report.findings)
    return replace(report, findings=Folded(zlib.compress(pickle.dumps(findings), 1), len(findings)))


def digest_of_report(report: Report) -> str:
    """Return a digest of all that a report says; a folded one is not unfolded for it.

    The same findings folded by another program may have another one.
    """
    findings = report.findings
    if not isinstance(findings, Folded):
        return hashlib.sha256(repr(report).encode()).hexdigest()
    rest = repr(replace(report, findings=())).encode()
    return hashlib.sha256(b"%d\n%b%b" % (len(rest), rest, findings.packed)).hexdigest()


def unfolded(report: Report) -> Report:
    """Return a report whose findings can be looked at many times; see `folded`."""
    return replace(report, findings=tuple(report.findings))
