"""Whether issued sheets can be solved by hand, and what one mistake in such a solution costs.

    python benchmarks/by_hand.py [scheme ...] [--count 5] [--seed 271828] [--mistakes]

Variants of each scheme are drawn with the seed and issued; a student's arithmetic (the folder
`hand`, which uses nothing of the solver and its formulas) reads the workbooks, computes, rounds to
five figures, goes on with what it wrote, and hands in; the course grades. A line says how many
answers of a scheme had full points, none, and a part of them. Exit status 1: some had not all.

With `--mistakes` each work has one mistake, made in one step (or the same way in several steps that
are alike) and carried on. A line of each says how many works paid for it once, where it was made;
how many paid elsewhere or more than once; in how many it costs nothing, and why: it is accepted as
an erratum of the sources or as another reading, the size is sound all the same, or what is written
lies in its band; `a gap` is what none of these explains. A mistake is named by a known slip; `said`
of a size is that it is below what is required. Works in which it changes less than twice the band
of every answer, or leads to where no size or angle is left, are not handed in.
"""

import argparse
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from time import process_time

from hand.mistakes import mistakes_of
from hand.notebook import Notebook
from hand.schemes import SCHEMES
from hand.sheet import Sheet, fill_in, read_sheet
from hand.wrong import Mistake

from gripcourse.batch.context import GradingContext
from gripcourse.batch.one_file import grade_file
from gripcourse.course.load import load_course
from gripcourse.grading.model import Against, Finding
from gripcourse.policy.load import load_policy
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words
from gripcourse.usecases.solving.variants import draw_variants
from gripcourse.variants.model import Issued, Student
from gripcourse.workbook.write import answer_workbook

ROOT = Path(__file__).parents[1]
_UNSIGNED = "0" * 64
ERRATUM, READING, SIZE, IN_BAND = "an erratum", "another reading", "a sound size", "in its band"
A_GAP = "a gap"
NOTHING = (ERRATUM, READING, SIZE, IN_BAND, A_GAP)  # why a mistake costs nothing
_SEEN = 0.02  # twice the band of most answers: of less no examiner can tell that it is no rounding


@dataclass(frozen=True)
class Handout:
    """A variant that was issued.

    Attributes:
        context: what its workbook is graded with.
        workbook: as it was issued.
        sheet: what its student reads there.
    """

    context: GradingContext
    workbook: bytes
    sheet: Sheet


def main() -> None:
    """Issue, solve, hand in, and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("scheme", nargs="*", choices=[*SCHEMES, []])
    parser.add_argument("--count", type=int, default=5)
    parser.add_argument("--seed", type=int, default=271828)
    parser.add_argument("--mistakes", action="store_true")
    arguments = parser.parse_args()
    schemes = arguments.scheme or list(SCHEMES)
    start = process_time()
    with tempfile.TemporaryDirectory() as folder:
        handouts = {
            one: tuple(issue(one, arguments.count, arguments.seed, Path(folder))) for one in schemes
        }
        tally = tally_of_mistakes if arguments.mistakes else tally_of_solutions
        refused = tally(handouts, Path(folder))
    print(f"{process_time() - start:.0f} s of the processor, seed {arguments.seed}")
    sys.exit(refused > 0)


def issue(scheme: str, count: int, seed: int, folder: Path) -> Iterator[Handout]:
    """Draw variants of a scheme, issue their workbooks and read these."""
    course = load_course(ROOT)
    policy = load_policy(course)
    student = Student("s1", "Student", "", "", "en", "")
    for variant in draw_variants(course, count, seed, scheme, freely=True).variants:
        issued = Issued(student, variant, date(2026, 9, 1), None, _UNSIGNED)
        workbook = answer_workbook(
            plan_of(course, variant.composition), issued, course, Words("en")
        )
        file = folder / "issued.xlsx"
        file.write_bytes(workbook)
        context = GradingContext(course, policy, {student.id: issued})
        yield Handout(context, workbook, read_sheet(file))


def solve(handout: Handout, mistake: Mistake | None = None) -> Notebook:
    """Solve a sheet; with a mistake, if one is named.

    Raises:
        ValueError, StopIteration, ZeroDivisionError: a mistake leads to where no angle or size is.
    """
    notebook = Notebook(handout.sheet, mistake.steps if mistake else {})
    SCHEMES[handout.sheet.scheme](notebook)
    return notebook


def hand_in(handout: Handout, notebook: Notebook, folder: Path) -> tuple[Finding, ...]:
    """Type the answers into the workbook and return what the course finds in it."""
    file = folder / "s1.xlsx"
    file.write_bytes(handout.workbook)
    fill_in(file, notebook.typed, handout.sheet.asked)
    return tuple(
        one
        for one in grade_file(file, handout.context).findings
        if one.quantity in handout.sheet.asked
    )


def tally_of_solutions(handouts: Mapping[str, Sequence[Handout]], folder: Path) -> int:
    """Print a line for each scheme; return how many answers were not paid in full."""
    print(f"{'':18} works answers  right refused half-paid")
    sums = Counter[str]()
    for scheme, given in handouts.items():
        found = [one for handout in given for one in hand_in(handout, solve(handout), folder)]
        counts = Counter(paid(one) for one in found)
        print(line_of_solutions(scheme, len(given), counts))
        sums += counts
        for one in found:
            if paid(one) != "right":
                said = f"typed {one.typed}, expected {one.expected}"
                print(f"    {one.quantity}: {said}, {one.slip or one.outcome}")
    print(line_of_solutions("all", sum(map(len, handouts.values())), sums))
    return sums.total() - sums["right"]


def line_of_solutions(title: str, works: int, counts: Counter[str]) -> str:
    """Return a line of the table of solutions."""
    paid_in_part = counts["half-paid"]
    return (
        f"{title:18} {works:5d} {counts.total():7d}"
        f" {counts['right']:6d} {counts['refused']:7d} {paid_in_part:9d}"
    )


def paid(finding: Finding) -> str:
    """Tell whether an answer has its points."""
    if finding.points >= finding.max_points:
        return "right"
    return "half-paid" if finding.points > 0 else "refused"


def tally_of_mistakes(handouts: Mapping[str, Sequence[Handout]], folder: Path) -> int:
    """Print a line for each mistake of each scheme; return how many works paid more than once."""
    print(f"{'':62} works  once  more  none named  said  names")
    sums = Counter[str]()
    for scheme, given in handouts.items():
        print(scheme)
        right = [solve(one) for one in given]
        of_scheme = Counter[str]()
        for mistake in mistakes_of(scheme):
            counts, names = Counter[str](), Counter[str]()
            for handout, solved in zip(given, right, strict=True):
                notebook = mistaken(handout, mistake, solved)
                if notebook is not None:
                    judge(mistake, hand_in(handout, notebook, folder), counts, names)
            if counts["works"]:
                print(line_of_mistakes(f"  {mistake.what}", counts, names))
            of_scheme += counts
        print(line_of_mistakes(f"{scheme}, all", of_scheme, Counter()))
        sums += of_scheme
    print(line_of_mistakes("all", sums, Counter()))
    print("charged nothing: " + ", ".join(f"{one} {sums[one]}" for one in NOTHING))
    return sums["more"] + sums[A_GAP]


def mistaken(handout: Handout, mistake: Mistake, right: Notebook) -> Notebook | None:
    """Return a solution with a mistake; None where it cannot be seen, or nothing follows."""
    try:
        notebook = solve(handout, mistake)
    except (ValueError, StopIteration, ZeroDivisionError):
        return None
    made = mistake.steps.keys() & notebook.written.keys() & handout.sheet.asked
    changed = any(abs(notebook[one] - right[one]) > _SEEN * abs(right[one]) for one in made)
    return notebook if changed else None


def judge(
    mistake: Mistake, found: Sequence[Finding], counts: Counter[str], names: Counter[str]
) -> None:
    """Count how a work with one mistake was charged, and what it was called."""
    charged = [one for one in found if paid(one) != "right"]
    counts["works"] += 1
    if not charged:
        counts["none"] += 1
        why = {why_nothing(one): None for one in found if one.quantity in mistake.steps}
        reason = next((one for one in NOTHING if one in why), A_GAP)
        counts[reason] += 1
        names[reason] += 1
        return
    roots = [one for one in charged if one.quantity in mistake.steps]
    once = len(charged) == 1 and bool(roots)
    counts["once" if once else "more"] += 1
    slips = [one.slip for one in roots if one.slip is not None]
    counts["named"] += bool(slips)
    counts["said"] += not slips and any(is_said(one) for one in roots)
    names.update(str(one) for one in slips[:1])
    if not once:
        names[f"also {', '.join(one.quantity for one in charged if one not in roots[:1])}"] += 1


def why_nothing(finding: Finding) -> str:
    """Return why an answer that was made wrongly has full points."""
    match finding.against:
        case Against.PRINTED:
            return ERRATUM
        case Against.ALTERNATIVE:
            return READING
    if str(finding.message).startswith("A sound decision"):
        return SIZE
    expected = finding.reference if finding.against is Against.REFERENCE else finding.expected
    if finding.given is None or expected is None:
        return A_GAP
    return IN_BAND if abs(finding.given - expected) <= finding.band else A_GAP


def is_said(finding: Finding) -> bool:
    """Tell whether a size is said to be below the required one."""
    return str(finding.message) == "The size is below the required value."


def line_of_mistakes(title: str, counts: Counter[str], names: Counter[str]) -> str:
    """Return a line of the table of mistakes."""
    said = "; ".join(f"{name} {count}" for name, count in names.most_common(3))
    columns = ("works", "once", "more", "none", "named", "said")
    numbers = " ".join(f"{counts[one]:5d}" for one in columns)
    return f"{title:62} {numbers}  {said}".rstrip()


if __name__ == "__main__":
    main()
