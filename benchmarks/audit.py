"""How long the audit of a table takes, and how its parts grow with the number of variants."""

import resource
from collections.abc import Callable
from time import perf_counter
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
    seconds = {count: _audit(course, policy, spaces, count) for count in (1_000, 10_000)}
    growth = seconds[10_000] / seconds[1_000]
    print(f"ten times as many variants: the measure of apartness takes {growth:.1f} times as long")


def _draw_apart(course: Course, policy: Policy, spaces: tuple[Space, ...]) -> None:
    rules = sifter(policy, len(course.sections))
    drawn, seconds = _timed(lambda: draw(course, spaces, 300, SEED, rules))
    aside = sum(one.count for tally in drawn.tallies for one in tally.set_aside)
    print(f"draw 300 variants that keep all rules: {seconds:.1f} s, {aside} candidates set aside")


def _audit(course: Course, policy: Policy, spaces: tuple[Space, ...], count: int) -> float:
    variants = draw(course, spaces, count, SEED).variants
    groups, solving = _timed(lambda: solve_groups(course, variants, spaces))
    items = items_of(groups, policy, Kind.FORMULA)
    totals = section_totals(items, count, len(course.sections))
    timed = [_timed(lambda: measure(items, totals, limits_of(policy))) for _ in range(RUNS)]
    found, measuring = timed[0][0], min(seconds for _, seconds in timed)
    _, whole = _timed(lambda: audit(course, policy, variants, spaces))
    naive = sum(len(item.rows) * (len(item.rows) - 1) for item in items)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(
        f"audit {count:>6} variants in {len(groups)} compositions: {whole:.1f} s in all, of it"
        f" solving {solving:.2f} s, apartness {measuring:.2f} s;"
        f" {found.coincidences:.2e} coincidences of {naive:.2e} comparisons"
        f" ({found.coincidences / naive:.1%}); at most {memory:.0f} MB so far"
    )
    return measuring


def _timed(run: Callable[[], Result]) -> tuple[Result, float]:
    start = perf_counter()
    result = run()
    return result, perf_counter() - start


if __name__ == "__main__":
    main()
