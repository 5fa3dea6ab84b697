"""How long the solver takes for many variants, and that its cost grows in proportion."""

from time import perf_counter

import numpy as np

from gripcourse.course.load import load_course
from gripcourse.machine.resources import course_root
from gripcourse.solver.plan import Plan, make_plan
from gripcourse.solver.solve import Values, evaluate, to_si

RUNS = 5
LARGEST = 100_000


def main() -> None:
    """Solve 10³, 10⁴ and 10⁵ variants of every scheme in one call each."""
    course = load_course(course_root())
    total = 0.0
    for scheme in course.schemes.values():
        example = scheme.example
        if example is None:
            continue
        plan = make_plan(course, scheme.id, example.options)
        computed = len(plan.answered)
        generator = np.random.default_rng(1)
        for count in (1_000, 10_000, LARGEST):
            spread = generator.uniform(0.95, 1.05, count)
            known = {
                name: value * spread
                for name, value in to_si(plan, example.given).items()
                if name in plan.quantities
            }
            seconds = min(_timed(plan, known) for _ in range(RUNS))
            total += seconds if count == LARGEST else 0.0
            each = seconds / count / computed * 1e9
            print(
                f"{scheme.id:<20} {count:>7} variants, {computed} quantities: "
                f"{seconds * 1e3:7.1f} ms, {each:6.0f} ns per value"
            )
    print(f"all schemes together, {LARGEST} variants each: {total:.2f} s")


def _timed(plan: Plan, known: Values) -> float:
    start = perf_counter()
    evaluate(plan, known)
    return perf_counter() - start


if __name__ == "__main__":
    main()
