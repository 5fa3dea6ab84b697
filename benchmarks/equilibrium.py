"""Whether what the course computes is in equilibrium, over many freely drawn variants.

    python benchmarks/equilibrium.py [scheme ...] [--count 200] [--seed 26063]

Variants of each scheme are drawn without the rules that keep a table apart, its options mixed, and
serve all free bodies that are about them. A line of a file says with how many variants its bodies
were solved, how many numbers were compared with reactions, and the largest relative error; files
without a line are about other schemes. Exit status 1: something is not in equilibrium.
"""

import argparse
import sys
import time
from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from gripcourse.course.composition import Composition
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.proofs.equilibrium.check import load_mechanisms
from gripcourse.proofs.equilibrium.faults import Fault, problems
from gripcourse.proofs.equilibrium.model import Claim, Mechanism, judged_of, names_used
from gripcourse.proofs.equilibrium.trials import (
    compare,
    faults_of,
    faults_of_solution,
    solved_of,
)
from gripcourse.proofs.samples import Trial, make_trial
from gripcourse.solver.plan import plan_of
from gripcourse.text.words import Words
from gripcourse.usecases.solving.variants import draw_variants

ROOT = Path(__file__).parents[1]
_EXACT = 1e-9  # what counts as agreeing


def main() -> None:
    """Draw, solve and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scheme", nargs="*")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=26063)
    arguments = parser.parse_args()
    course = load_course(ROOT)
    start = time.process_time()
    schemes = arguments.scheme or list(course.schemes)
    trials = [
        trial
        for scheme in schemes
        for trial in trials_of(course, scheme, arguments.count, arguments.seed)
    ]
    drawn = time.process_time() - start
    found = [report(one, trials) for one in load_mechanisms(course)]
    count = sum(len(one.variants) for one in trials)
    compared, wrong = sum(one for one, _ in found), sum(one for _, one in found)
    spent = time.process_time() - start - drawn
    print(
        f"{count} variants of {len(schemes)} schemes in {len(trials)} compositions:"
        f" {compared} numbers compared, {wrong} statements fail;"
        f" drawn in {drawn:.1f} s, solved and compared in {spent:.1f} s"
    )
    sys.exit(wrong > 0)


def trials_of(course: Course, scheme: str, count: int, seed: int) -> Iterator[Trial]:
    """Draw variants of a scheme and solve those of one composition together."""
    groups = defaultdict(list)
    for one in draw_variants(course, count, seed, scheme, freely=True).variants:
        groups[Composition.of(one.scheme, one.options)].append(one)
    for composition, group in groups.items():
        yield make_trial(plan_of(course, composition), tuple(group))


def report(mechanism: Mechanism, trials: Sequence[Trial]) -> tuple[int, int]:
    """Print the line of a file; return how many numbers were compared, how much is wrong."""
    variants = compared = 0
    worst, faults = 0.0, list[Fault]()
    for trial in trials:
        if not is_about(mechanism, trial):
            continue
        judged = [
            one for one in judged_of(mechanism) if names_used(mechanism, one) <= trial.values.keys()
        ]
        if not judged:
            continue
        solved = solved_of(mechanism, trial)
        variants += len(trial.variants)
        faults += faults_of_solution(mechanism, trial, solved)
        for one in judged:
            faults += faults_of(one, trial, solved)
            for _, declared, actual, agrees in (
                compare(one, trial, solved) if isinstance(one, Claim) else ()
            ):
                compared += len(agrees)
                scale = np.maximum(np.abs(declared), np.abs(actual))
                # What agrees but for what cancels out to nothing has no relative error.
                errors = np.abs(declared - actual) / np.where(scale > 0, scale, 1.0)
                worst = max(worst, float(np.max(np.where(agrees & (errors > _EXACT), 0.0, errors))))
    said = tuple(problems(mechanism.file, faults))
    if variants:
        print(
            f"{mechanism.id:24} {variants:5d} variants, {compared:6d} compared,"
            f" largest error {worst:.1e}{', FAILS' if said else ''}"
        )
    for problem in said:
        print(f"    {problem.say(Words('en'))}")
    return compared, len(said)


def is_about(mechanism: Mechanism, trial: Trial) -> bool:
    """Tell whether free bodies are about the scheme and the options of a trial."""
    about = not mechanism.schemes or trial.plan.scheme.id in mechanism.schemes
    return about and mechanism.options.items() <= trial.plan.options.items()


if __name__ == "__main__":
    main()
