"""Reports folded small: a batch keeps every report until its end, and looks into few at a time.

A finding is some fifty objects; folded, those of a work are one run of bytes, a twentieth of it. On
a shelf these bytes lie in a temporary file, and a place in it is all that is held.

To unfold them takes as long as all that a batch wants to know of them together. So whoever folds
them, a worker, is told beforehand what will be wanted, and lays it beside them: see `Derivation`.
"""

import hashlib
import os
import pickle
import sys
import tempfile
import weakref
import zlib
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace
from threading import Lock
from typing import IO, Any, Generic, TypeVar

from gripcourse.grading.model import Finding, Report
from gripcourse.variants.model import Issued

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


def _new_file() -> IO[bytes] | None:
    try:
        # Without a buffer: what a full disk does not take must not come back at the next reading.
        return tempfile.TemporaryFile(buffering=0)
    except OSError:
        return None


@dataclass(frozen=True, slots=True, eq=False, weakref_slot=True)
class Shelf:
    """A temporary file without a name for what a batch holds; it goes with the last that needs it.

    Attributes:
        file: grows at its end; None where the machine has no room for one.
        lock: for who reads and writes between threads.
        register: by student; what a report holds as it was issued is held once.
    """

    file: IO[bytes] | None = field(default_factory=_new_file)
    lock: Lock = field(default_factory=Lock)
    register: Mapping[str, Issued] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.file is not None:
            weakref.finalize(self, self.file.close)

    def put(self, report: Report) -> Report:
        """Return a report that says the same and leaves its findings here.

        On a full disk they stay in memory, folded.
        """
        findings = folded(report).findings
        if isinstance(findings, Folded):
            if isinstance(findings.held, _Place):
                return report  # it was put on a shelf before
            findings = self._lying(findings, findings.held)
        return _sharing(report, findings, self.register.get(report.student))

    def _lying(self, findings: "Folded", held: bytes) -> "Folded":
        """Return findings that lie here; as they are where there is no room."""
        place, derived = self._put(held), findings.derived
        if isinstance(derived, bytes) and derived:
            derived = self._put(derived) or derived
        return findings if place is None else replace(findings, held=place, derived=derived)

    def read(self, start: int, size: int) -> bytes:
        """Return what lies at a place.

        Raises:
            OSError: it cannot be read.
        """
        if self.file is None:
            return b""
        with self.lock:
            self.file.seek(start)
            return self.file.read(size)

    def _put(self, held: bytes) -> "_Place | None":
        if self.file is None:
            return None
        try:
            with self.lock:
                start = self.file.seek(0, os.SEEK_END)
                written = self.file.write(held)
        except OSError:
            return None
        return _Place(self, start, len(held)) if written == len(held) else None


@dataclass(frozen=True, slots=True, eq=False)
class _Place:
    """Where bytes lie on a shelf."""

    shelf: Shelf
    start: int
    size: int


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Folded:
    """Findings that are unfolded anew whenever somebody looks at them.

    Attributes:
        held: bytes of this process or one of its workers, and of nobody else; or where they lie.
        count: how many findings they are.
        derived: packed, what was derived from them, by name; empty for nothing.
    """

    held: bytes | _Place
    count: int
    derived: bytes | _Place = b""

    @property
    def packed(self) -> bytes:
        """The bytes, wherever they are."""
        return _fetched(self.held)

    def derivation(self, name: str) -> bytes:
        """Return what was derived under a name, packed; empty where nothing was."""
        known = _fetched(self.derived)
        found: Mapping[str, bytes] = pickle.loads(known) if known else {}  # noqa: S301 (as below)
        return found.get(name, b"")

    def __reduce__(self) -> tuple[type["Folded"], tuple[bytes, int, bytes]]:
        # Another process has no part in the shelf.
        return Folded, (self.packed, self.count, _fetched(self.derived))

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


def _fetched(held: bytes | _Place) -> bytes:
    return held if isinstance(held, bytes) else held.shelf.read(held.start, held.size)


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


def _sharing(report: Report, findings: Collection[Finding], issued: Issued | None) -> Report:
    """Return a report that says the same, with its findings as they lie now.

    What was issued is held once, and so is what many say.
    """
    texts: tuple[str, ...] = ()
    options: Mapping[str, str] = {}
    given: Mapping[str, float] = {}
    if issued is not None:
        texts = (issued.student.id, issued.student.name, issued.variant.id)
        options, given = issued.variant.options, issued.variant.given
    held = {text: text for text in texts}
    return replace(
        report,
        findings=findings,
        student=held.get(report.student, report.student),
        name=held.get(report.name, report.name),
        variant=held.get(report.variant, report.variant),
        scheme=sys.intern(report.scheme),
        language=sys.intern(report.language),
        options=_shared(report.options, options),
        givens=_shared(report.givens, given),
    )


def _shared(named: Mapping[str, _Value], held: Mapping[str, _Value]) -> Mapping[str, _Value]:
    """Let what was issued be held once, and else equal names once for all reports."""
    return held if named == held else {sys.intern(name): value for name, value in named.items()}
