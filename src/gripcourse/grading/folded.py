"""Reports folded small: a batch keeps every report until its end, and looks into few at a time.

A finding is some fifty objects; folded, those of a work are one run of bytes, a twentieth of it. On
a shelf a report lies in a temporary file, its findings beside it, and a place is all that is held.

To unfold them takes as long as all that a batch wants to know of them together. So whoever folds
them, a worker, is told beforehand what will be wanted, and lays it beside them: see `Derivation`.
"""

import hashlib
import pickle
import zlib
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from operator import attrgetter
from typing import Any, Final, Generic, TypeVar

from gripcourse.grading.model import Finding, Report
from gripcourse.machine.shelf import Shelf, ShelfPlace, fetched

_Value = TypeVar("_Value")


@dataclass(frozen=True, slots=True)
class Derivation(Generic[_Value]):
    """Something that follows from the findings of a work, and from nothing else.

    Attributes:
        name: tells it from all others.
        derive: makes it of findings; it must be found by its name in another process.
    """

    name: str
    derive: Callable[[Collection[Finding]], _Value]


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Folded:
    """Findings that are unfolded anew whenever somebody looks at them.

    Attributes:
        held: bytes of this process or one of its workers, and of nobody else; or where they lie.
        count: how many findings they are.
        derived: packed, what was derived from them, by name; empty for nothing.
    """

    held: bytes | ShelfPlace
    count: int
    derived: bytes | ShelfPlace = b""

    @property
    def packed(self) -> bytes:
        """The bytes, wherever they are."""
        return fetched(self.held)

    def derivation(self, name: str) -> bytes:
        """Return what was derived under a name, packed; empty where nothing was."""
        known = fetched(self.derived)
        found: Mapping[str, bytes] = pickle.loads(known) if known else {}  # noqa: S301 (as below)
        return found.get(name, b"")

    def __reduce__(self) -> tuple[type["Folded"], tuple[bytes, int, bytes]]:
        # Another process has no part in the shelf.
        return Folded, (self.packed, self.count, fetched(self.derived))

    def __len__(self) -> int:
        return self.count

    def __iter__(self) -> Iterator[Finding]:
        found: tuple[Finding, ...] = _unpacked(self.packed)
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


@dataclass(frozen=True, slots=True, eq=False)
class ReportShelf:
    """A shelf for reports; their findings lie beside them and are fetched by who looks at them."""

    shelf: Shelf = field(default_factory=Shelf)

    def plain(self, report: Report) -> tuple[object, ...]:
        """Put the findings of a report here, and return the rest of it; see `report`."""
        findings = folded(report).findings
        held: object = findings
        if isinstance(findings, Folded):
            held = self._place(findings.held), findings.count, self._place(findings.derived)
        return held, *_REST(report)

    def report(self, plain: tuple[Any, ...]) -> Report:
        """Return a report that was put here."""
        held = plain[0]
        findings: Collection[Finding] = held
        if held:
            whole, count, known = held
            findings = Folded(self._held(whole), count, self._held(known))
        values = (*plain[1 : _FINDINGS + 1], findings, *plain[_FINDINGS + 1 :])
        return Report(*values)

    def _place(self, held: bytes | ShelfPlace) -> tuple[int, int] | bytes:
        """Put bytes here, where they are not yet; on a full disk they stay with the report."""
        if isinstance(held, ShelfPlace) and held.shelf is self.shelf:
            return held.start, held.size
        data = fetched(held)
        place = self.shelf.put(data) if data else None
        return data if place is None else (place.start, place.size)

    def _held(self, lies: tuple[int, int] | bytes) -> ShelfPlace | bytes:
        return lies if isinstance(lies, bytes) else ShelfPlace(self.shelf, *lies)


_NAMES: Final = tuple(one.name for one in fields(Report))
_FINDINGS: Final = _NAMES.index("findings")
_REST: Final = attrgetter(*(name for name in _NAMES if name != "findings"))


def folded(report: Report, wanted: Collection[Derivation[Any]] = ()) -> Report:
    """Return a report that says the same and takes little room.

    Args:
        report: to fold.
        wanted: what will be asked of its findings.
    """
    if isinstance(report.findings, Folded) or not report.findings:
        return report
    findings = tuple(report.findings)
    known = {one.name: _packed(one.derive(findings)) for one in wanted}
    derived = pickle.dumps(known) if known else b""
    return replace(report, findings=Folded(_packed(findings), len(findings), derived))


def derived(findings: Collection[Finding], wanted: Derivation[_Value]) -> _Value:
    """Return what follows from findings; where it was wanted when they were folded, it is there."""
    if isinstance(findings, Folded) and (known := findings.derivation(wanted.name)):
        value: _Value = _unpacked(known)
        return value
    return wanted.derive(tuple(findings))


def _packed(value: object) -> bytes:
    return zlib.compress(pickle.dumps(value), 1)


def _unpacked(packed: bytes) -> Any:  # noqa: ANN401 (whatever was packed)
    return pickle.loads(zlib.decompress(packed))  # noqa: S301 (`folded` wrote it)


def digest_of_report(report: Report) -> str:
    """Return a digest of all that a report says; a folded one is not unfolded for it.

    The same findings folded by another program may have another one.
    """
    findings = report.findings
    if not isinstance(findings, Folded):
        return hashlib.sha256(repr(report).encode()).hexdigest()
    rest = repr(replace(report, findings=())).encode()
    return hashlib.sha256(b"%d\n%b%b" % (len(rest), rest, findings.packed)).hexdigest()
