"""What the gradebook keeps: attempts with their automatic results, and marks of persons."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from datetime import datetime

from gripcourse.gradebook.results import POINTS_DECIMALS, Result, results_to_read, same_results
from gripcourse.grading.model import Outcome, Report


@dataclass(frozen=True, slots=True)
class Fingerprints:
    """What graded: SHA-256 over the files of each, hexadecimal.

    Attributes:
        course, policy: of the course's folder.
        engine: of this program; empty where a program graded that did not keep it.
    """

    course: str
    policy: str
    engine: str = ""


@dataclass(frozen=True, slots=True)
class Attempt:
    """One file of one student, graded to one set of results.

    Attributes:
        student: id.
        number: counts the student's attempts from 1; 0 before it is kept.
        variant, scheme: ids.
        file: path under which it was graded first.
        digest: SHA-256 of the file's bytes, hexadecimal.
        graded_at: when these results were found first.
        fingerprints: of course, policy and engine at that time.
        judged: False for a file that could not be judged; it has no results.
        results: one for each item, in the order of the report.
        regrade: number of the regrade that it belongs to; None where it was graded by itself.
        handed_in: when, by the file or the platform, or as a person says; None where unknown.
        handed_in_said: whether a person says so.
        version: of the student's assignment, that it was judged by.
        either_version: whether several versions were tried, of which the best one counts.
        kept_as: id under which it is kept, where that was joined with the student's; else empty.
        outranked: whether another one of the same bytes stands, that is kept under another id of
            the student.
        other_time: the earlier of two times at which the same bytes were handed in, as was said
            under two ids of the student; None where they agree, or somebody has said it since.
    """

    student: str
    number: int
    variant: str
    scheme: str
    file: str
    digest: str
    graded_at: datetime
    fingerprints: Fingerprints
    judged: bool
    results: Collection[Result]
    regrade: int | None = None
    handed_in: datetime | None = None
    handed_in_said: bool = False
    version: int = 1
    either_version: bool = False
    kept_as: str = ""
    outranked: bool = False
    other_time: datetime | None = None

    @property
    def key(self) -> tuple[str, int]:
        """The id under which it is kept, and its number there."""
        return self.kept_as or self.student, self.number

    @property
    def by_quantity(self) -> Mapping[str, Result]:
        """Return the results by quantity."""
        return {one.quantity: one for one in self.results}


@dataclass(frozen=True, slots=True)
class Mark:
    """What a person decided about one item; it is never changed, only superseded by the next.

    Attributes:
        student, quantity: ids.
        number: counts the marks of this item from 1, the highest counts; 0 before it is kept.
        attempt: number of the attempt that it was entered against.
        credit: share of the item's points, 0…1; None withdraws the marks before it.
        lines: share of its points that each line of the rubric earns; empty without a rubric.
        marker: who decided.
        marked_at: when.
        comment: for the student, in the marker's words; empty for none.
        kept_as: id under which it is kept, where that was joined with the student's; else empty. It
            is the id under which the attempt is kept.
    """

    student: str
    quantity: str
    number: int
    attempt: int
    credit: float | None
    lines: Mapping[str, float]
    marker: str
    marked_at: datetime
    comment: str
    kept_as: str = ""

    @property
    def kept_under(self) -> str:
        """The id under which it is kept."""
        return self.kept_as or self.student

    @property
    def key(self) -> tuple[str, int]:
        """The id under which its attempt is kept, and the number of that."""
        return self.kept_under, self.attempt

    @property
    def supersedes(self) -> int | None:
        """Return the number of the mark that this one replaces; None for the first."""
        return self.number - 1 if self.number > 1 else None


@dataclass(frozen=True, slots=True)
class GradebookEntry:
    """A mark with the attempt that it was entered against.

    Attributes:
        mark, attempt: these.
        rivals: other marks of the same item of the same person, who had two ids when they were
            given: this one counts until a person decides.
    """

    mark: Mark
    attempt: Attempt
    rivals: tuple["GradebookEntry", ...] = ()


def attempt_of(report: Report, graded_at: datetime, fingerprints: Fingerprints) -> Attempt | None:
    """Return what the gradebook keeps of a report without persons' marks.

    Returns:
        The attempt; None where nobody knows whose file it is, or where its bytes could not be read.
    """
    if not report.student or not report.digest:
        return None
    return Attempt(
        student=report.student,
        number=0,
        variant=report.variant,
        scheme=report.scheme,
        file=report.file,
        digest=report.digest,
        graded_at=graded_at,
        fingerprints=replace(fingerprints, course=report.declarations or fingerprints.course),
        judged=report.judged,
        results=results_to_read(report),
        version=report.version,
        either_version=report.either_version,
    )


def says_the_same(one: Attempt, other: Attempt) -> bool:
    """Tell whether an attempt came to the same as an earlier one, and says no other time."""
    same_time = not other.handed_in_said or (
        other.handed_in == one.handed_in and one.other_time is None
    )
    same_version = (one.version, one.either_version) == (other.version, other.either_version)
    same_judgement = same_version and one.judged == other.judged
    return same_time and same_judgement and same_results(one.results, other.results)


def latest_marks(entries: Iterable[GradebookEntry]) -> dict[str, GradebookEntry]:
    """Return the entry that counts for each quantity of one student; withdrawn ones are left out.

    Args:
        entries: of one student, in any order.
    """
    latest: dict[str, GradebookEntry] = {}
    for entry in entries:
        before = latest.get(entry.mark.quantity)
        if before is None or before.mark.number < entry.mark.number:
            latest[entry.mark.quantity] = entry
    return {name: entry for name, entry in latest.items() if entry.mark.credit is not None}


def latest_marks_of_all(entries: Iterable[GradebookEntry]) -> dict[str, dict[str, GradebookEntry]]:
    """Return for each student what `latest_marks` returns; who has no marks is left out."""
    by_student: dict[str, list[GradebookEntry]] = defaultdict(list)
    for entry in entries:
        by_student[entry.mark.student].append(entry)
    return {student: latest_marks(all_) for student, all_ in by_student.items()}


def same_decision(one: Mark, other: Mark) -> bool:
    """Tell whether two marks earn the same."""
    return one.credit == other.credit and dict(one.lines) == dict(other.lines)


def share_given(entry: GradebookEntry) -> str:
    """Write under which id a mark was given, and the share of the points that it earns."""
    share = (entry.mark.credit or 0.0) * 100
    return f"{entry.mark.kept_under} {share:.4g}\N{NO-BREAK SPACE}%"


def is_outdated(
    entry: GradebookEntry,
    digest: str,
    results: Collection[Result],
    since: tuple[str, int] | None = None,
) -> bool:
    """Tell whether what a mark rests on is another than when it was entered.

    A mark rests on the files that were there and on what the program found about its own item. What
    other items came to, or how many points the item is worth, is no reason to look again: a mark is
    a share. Another mark that was given to the same person under another id is one.

    A mark is entered against the student's last work, and counts for an earlier one too, where the
    policy lets that count: whoever marked could see both, and would have nothing new to see.

    Args:
        entry: the mark.
        digest: of the file that is graded now.
        results: automatic results of that file.
        since: key of the attempt by which that file was judged first; None where it comes new.
    """
    if entry.rivals or (entry.attempt.digest != digest and not _was_there(entry, since)):
        return True
    name = entry.mark.quantity
    now = next((one for one in results if one.quantity == name), None)
    return now is not None and _finding_of(entry.attempt.by_quantity.get(name)) != _finding_of(now)


def _was_there(entry: GradebookEntry, since: tuple[str, int] | None) -> bool:
    """Tell whether a file was judged before a mark was entered; numbers are those of one id."""
    kept_as, number = entry.attempt.key
    return since is not None and since[0] == kept_as and since[1] < number


def _finding_of(result: Result | None) -> tuple[Outcome, float] | None:
    """Return what was found about an item, whatever it is worth."""
    if result is None:
        return None
    share = result.points / result.max_points if result.max_points else 0.0
    return result.outcome, round(share, POINTS_DECIMALS)
