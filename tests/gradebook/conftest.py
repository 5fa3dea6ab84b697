"""Reports, attempts and marks put together by hand, and a gradebook in a file of its own."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest

from gripcourse.gradebook.model import Attempt, Fingerprints, Mark, attempt_of
from gripcourse.gradebook.store import Gradebook, open_gradebook
from gripcourse.grading.flags import not_judged_flags
from gripcourse.grading.model import Against, Finding, Outcome, Report
from gripcourse.text.words import message
from support.databases import either_place

MORNING = datetime(2026, 12, 2, 9, tzinfo=UTC)
FINGERPRINTS = Fingerprints("c" * 64, "d" * 64)
ITEMS: Mapping[str, tuple[Outcome, float, float]] = {
    "grip_force": (Outcome.CORRECT, 3.0, 3.0),
    "bore": (Outcome.WRONG, 0.0, 2.0),
    "stroke": (Outcome.NOT_JUDGED, 0.0, 1.0),
    "drawing": (Outcome.MANUAL, 0.0, 10.0),
}

MakeReport = Callable[..., Report]
MakeMark = Callable[..., Mark]


def _finding(quantity: str, outcome: Outcome, points: float, possible: float) -> Finding:
    return Finding(
        quantity=quantity,
        section="grip",
        outcome=outcome,
        against=Against.NOTHING,
        given=None,
        typed="",
        cell="",
        reference=None,
        expected=None,
        band=0.0,
        inputs={},
        points=points,
        max_points=possible,
        slip=None,
        message=message("No answer."),
        remarks=(),
    )


def _report(
    student: str = "s01", digest: str = "a" * 64, **items: tuple[Outcome, float, float]
) -> Report:
    """The report of one file; `bore=(Outcome.CORRECT, 2, 2)` changes an item."""
    findings = tuple(_finding(name, *one) for name, one in {**ITEMS, **items}.items())
    judged = [one for one in findings if not one.is_open]
    return Report(
        file=f"inbox/{student}.xlsx",
        student=student,
        name="Иванова Анна",
        variant="001",
        scheme="rack_parallelogram",
        options={},
        language="ru",
        score=sum(one.points for one in judged),
        max_score=sum(one.max_points for one in judged),
        open_points=sum(one.max_points for one in findings if one.is_open),
        flags=tuple(not_judged_flags(findings)),
        findings=findings,
        remarks=(),
        judged=True,
        digest=digest,
    )


def _mark(quantity: str = "drawing", credit: float | None = 0.5, **changes: object) -> Mark:
    mark = Mark(
        student="s01",
        quantity=quantity,
        number=0,
        attempt=1,
        credit=credit,
        lines={},
        marker="Петров",
        marked_at=MORNING + timedelta(days=1),
        comment="",
    )
    return replace(mark, **changes)  # type: ignore[arg-type]


def _attempts(*reports: Report) -> list[Attempt]:
    found = [attempt_of(one, MORNING, FINGERPRINTS) for one in reports]
    return [one for one in found if one is not None]


@pytest.fixture(scope="session")
def report() -> MakeReport:
    return _report


@pytest.fixture(scope="session")
def mark() -> MakeMark:
    return _mark


@pytest.fixture(scope="session")
def attempts() -> Callable[..., Sequence[Attempt]]:
    """Attempts of reports, graded in the morning."""
    return _attempts


@pytest.fixture(scope="session")
def morning() -> datetime:
    return MORNING


@pytest.fixture
def book(place: str) -> Gradebook:
    """An empty gradebook, in either kind of database."""
    return open_gradebook(place)
