"""How many freely drawn variants have bodies that go through one another, pair by pair.

    python benchmarks/interference.py [scheme ...] [--count 200]

A view that does not say that it shows bodies is read as if it did. Variants are drawn without the
rules that keep a table apart. A line of a pair says in how many of them it overlaps, at which
position, and the median and the largest overlap in mm.
"""

import argparse
import time
from collections import Counter, defaultdict
from dataclasses import replace
from pathlib import Path

import numpy as np

from gripcourse.course.catalogue import columns_of
from gripcourse.course.composition import Composition
from gripcourse.course.load import load_course
from gripcourse.course.model import Course
from gripcourse.drawing.view.interference import interference, together
from gripcourse.errors import GripcourseError
from gripcourse.solver.plan import plan_of
from gripcourse.solver.solve import evaluate
from gripcourse.text.units import factor
from gripcourse.usecases.solving.variants import draw_variants
from gripcourse.variants.model import Variant

ROOT = Path(__file__).parents[1]


def main() -> None:
    """Draw and report scheme by scheme."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scheme", nargs="*")
    parser.add_argument("--count", type=int, default=200)
    arguments = parser.parse_args()
    course = load_course(ROOT)
    for scheme in arguments.scheme or course.schemes:
        try:
            drawn = draw_variants(course, arguments.count, 1, scheme, freely=True).variants
        except GripcourseError as error:
            print(f"{scheme}: {error}")
            continue
        report(course, scheme, drawn)


def report(course: Course, scheme: str, variants: tuple[Variant, ...]) -> None:
    """Print what interferes in variants of one scheme."""
    groups: dict[Composition, list[Variant]] = defaultdict(list)
    for one in variants:
        groups[Composition.of(one.scheme, one.options)].append(one)
    solved = []
    for composition, group in groups.items():
        plan = plan_of(course, composition)
        known = {
            name: np.array([one.given[name] for one in group]) * factor(plan.quantities[name].unit)
            for name in group[0].given
        }
        solved.append((evaluate(plan, known).values, len(group)))
    start = time.perf_counter()
    declared = course.schemes[scheme]
    if declared.view is None:
        return
    declared = replace(declared, view=replace(declared.view, bodies=True))
    values = together(declared, solved)
    found = interference(declared, columns_of(course.catalogues), values)
    spent = time.perf_counter() - start
    bad = int((~found.clear).sum())
    depths: dict[tuple[str, str], dict[str, list[float]]] = defaultdict(dict)
    hits: Counter[tuple[str, str]] = Counter()
    for pair, depth in found.pairs.items():
        depths[pair.first, pair.second][pair.position] = list(depth[depth > 0])
    for key in depths:
        both = [depth for pair, depth in found.pairs.items() if (pair.first, pair.second) == key]
        hits[key] = int((np.max(both, axis=0) > 0).sum())
    share = bad / len(variants)
    print(f"{scheme}: {bad} of {len(variants)} ({share:.0%}) interfere; {spent:.2f} s")
    for key, number in hits.most_common():
        parts = [
            f"{position or '-'} {len(found)} (median {np.median(found):.2f}, {max(found):.1f} mm)"
            for position, found in depths[key].items()
            if found
        ]
        print(f"    {number:4d}  {key[0]} / {key[1]}: " + ", ".join(parts))


if __name__ == "__main__":
    main()
