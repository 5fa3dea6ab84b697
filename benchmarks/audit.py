"""How long the audit of a table takes, and how its parts grow with the number of variants."""

import resource
from collections.abc import Callable
from time import process_time
from typing import TypeVar

from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.course.quantity import Kind
from gripcourse.machine.resources import course_root
from gripcourse.policy.load import load_policy
from gripcourse.policy.model import Policy
from gripcourse.variants.answers import items_of, section_totals, solve_groups
from gripcourse.variants.apart import limits_of, measure
from gripcourse.variants.audit import audit
from gripcourse.variants.draw import draw
from gripcourse.variants.screening import sifter
from gripcourse.variants.space import Space, load_spaces

SEED = 7
RUNS = 3

Result = TypeVar("Result")


def main() -> None:
    """Draw tables of all schemes without limits and audit them; draw one with all limits."""
    course = load_course(course_root())
    policy, spaces = load_policy(course), load_spaces(course)
    _draw_apart(course, policy, spaces)
    whole, apart = zip(
        *(_audit(course, policy, spaces, count) for count in (1_000, 10_000)), strict=True
    )
    print(
        f"ten times as many variants: the audit takes {whole[1] / whole[0]:.1f} times as long, the"
        f" measure of apartness {apart[1] / apart[0]:.1f} times"
    )


def _draw_apart(course: Course, policy: Policy, spaces: tuple[Space, ...]) -> None:
    rules = sifter(policy, len(course.sections))
    drawn, seconds = _timed(lambda: draw(course, spaces, 300, SEED, rules))
    aside = sum(one.count for tally in drawn.tallies for one in tally.set_aside)
    print(f"draw 300 variants that keep all rules: {seconds:.1f} s, {aside} candidates set aside")


def _audit(
    course: Course, policy: Policy, spaces: tuple[Space, ...], count: int
) -> tuple[float, float]:
    drawn, drawing = _timed(lambda: draw(course, spaces, count, SEED).variants)
    _, whole = _timed(lambda: audit(course, policy, drawn, spaces))
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    groups, solving = _timed(lambda: solve_groups(course, drawn, spaces))
    items = items_of(groups, policy, Kind.FORMULA)
    totals = section_totals(items, count, len(course.sections))
    timed = [_timed(lambda: measure(items, totals, limits_of(policy))) for _ in range(RUNS)]
    found, measuring = timed[0][0], min(seconds for _, seconds in timed)
    naive = sum(len(item.rows) * (len(item.rows) - 1) for item in items)
    compositions = sum(len(group.family.compositions) for group in groups)
    print(
        f"audit {count:>6} variants in {compositions} compositions: {whole:.1f} s in all, of it"
        f" solving {solving:.2f} s, apartness {measuring:.2f} s; drawing them {drawing:.1f} s;"
        f" {found.coincidences:.2e} coincidences of {naive:.2e} comparisons"
        f" ({found.coincidences / naive:.1%}); at most {memory:.0f} MB so far"
    )
    return whole, measuring


def _timed(run: Callable[[], Result]) -> tuple[Result, float]:
    """Return a result and the seconds of the processor: other work does not count."""
    start = process_time()
    result = run()
    return result, process_time() - start


if __name__ == "__main__":
    main()
