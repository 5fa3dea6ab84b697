"""Reports folded small: a batch keeps every report until its end, and looks into few at a time.

A finding is some fifty objects; folded, those of a work are one run of bytes, a twentieth of it. On
a shelf these bytes lie in a temporary file, and a place in it is all that is held.
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
from typing import IO, TypeAlias, TypeVar

from gripcourse.grading.model import Finding, Report
from gripcourse.variants.model import Issued

SayFindings: TypeAlias = Callable[[Collection[Finding], str], str]
"""Puts findings into words of a language, as another program reads them."""

_Value = TypeVar("_Value")


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
        report = _with_shared(folded(report), self.register.get(report.student))
        findings = report.findings
        if not isinstance(findings, Folded) or isinstance(findings.held, _Place):
            return report
        place, said = self._put(findings.held), findings.said
        if isinstance(said, bytes) and said:
            said = self._put(said) or said
        if place is None:
            return report
        return replace(report, findings=replace(findings, held=place, said=said))

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
        said: the same, packed, in words for another program; empty where nobody has said them.
        language: of these words.
    """

    held: bytes | _Place
    count: int
    said: bytes | _Place = b""
    language: str = ""

    @property
    def packed(self) -> bytes:
        """The bytes, wherever they are."""
        return _fetched(self.held)

    def said_in(self, language: str) -> str | None:
        """Return the findings in words of a language; None where they are not at hand."""
        packed = _fetched(self.said) if language == self.language else b""
        return zlib.decompress(packed).decode() if packed else None

    def __reduce__(self) -> tuple[type["Folded"], tuple[bytes, int, bytes, str]]:
        # Another process has no part in the shelf.
        return Folded, (self.packed, self.count, _fetched(self.said), self.language)

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


def _fetched(held: bytes | _Place) -> bytes:
    return held if isinstance(held, bytes) else held.shelf.read(held.start, held.size)


def folded(report: Report, language: str = "", say: SayFindings | None = None) -> Report:
    """Return a report that says the same and takes little room.

    Args:
        report: to fold.
        language: in which its findings are to be said, too.
        say: says them; None for nobody.
    """
    if isinstance(report.findings, Folded) or not report.findings:
        return report
    findings = tuple(report.findings)
    said = b"" if say is None else zlib.compress(say(findings, language).encode(), 1)
    packed = zlib.compress(pickle.dumps(findings), 1)
    return replace(report, findings=Folded(packed, len(findings), said, language))


def digest_of_report(report: Report) -> str:
    """Return a digest of all that a report says; a folded one is not unfolded for it.

    The same findings folded by another program may have another one.
    """
    findings = report.findings
    if not isinstance(findings, Folded):
        return hashlib.sha256(repr(report).encode()).hexdigest()
    rest = repr(replace(report, findings=())).encode()
    return hashlib.sha256(b"%d\n%b%b" % (len(rest), rest, findings.packed)).hexdigest()


def _with_shared(report: Report, issued: Issued | None) -> Report:
    """Let what was issued be held once, and else equal names once for all reports."""
    options, given = ({}, {}) if issued is None else (issued.variant.options, issued.variant.given)
    return replace(
        report, options=_shared(report.options, options), givens=_shared(report.givens, given)
    )


def _shared(named: Mapping[str, _Value], held: Mapping[str, _Value]) -> Mapping[str, _Value]:
    return held if named == held else {sys.intern(name): value for name, value in named.items()}


def unfolded(report: Report) -> Report:
    """Return a report whose findings can be looked at many times; see `folded`."""
    return replace(report, findings=tuple(report.findings))
