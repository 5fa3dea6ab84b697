"""How many letters of kinematic diagrams stand where they mislead, over drawn variants.

    benchmarks/labels.py [COUNT]

COUNT variants of every scheme, 20 where nothing is written, each as wide as a page and as beside a
text. It prints letters that are not nearest to what they name, letters over a line, and letters
over one another; every one of them is a fault. `tests/drawing` asks the same of the issued table.
"""

import sys
from collections import Counter
from collections.abc import Iterator
from itertools import combinations

import numpy as np
import shapely

from gripcourse.course.load import load_course
from gripcourse.drawing.diagram.layout import WIDEST, DiagramLayout, lay_out
from gripcourse.drawing.diagram.letters import Written, covered_lengths, strokes_of
from gripcourse.machine.resources import course_root
from gripcourse.solver.plan import make_plan
from gripcourse.variants.draw import draw
from gripcourse.variants.space import load_spaces

COUNT, SEED = 20, 7
WIDTHS = (WIDEST, 112.0)
LANGUAGE = "ru"
SEEN = 0.1  # mm of line under a letter


def main(count: int) -> None:
    """Draw variants of every scheme and print what is wrong with their letters."""
    course = load_course(course_root())
    for space in load_spaces(course):
        found: Counter[str] = Counter()
        for variant in draw(course, [space], count, SEED).variants:
            plan = make_plan(course, variant.scheme, variant.options)
            for widest in WIDTHS:
                layout = lay_out(plan, variant.given, LANGUAGE, widest)
                if layout is not None:
                    found.update(("diagrams", *_letters(layout)))
        print(f"{space.scheme:<20} {dict(found)}")


def _letters(layout: DiagramLayout) -> Iterator[str]:
    """Yield a word for every letter, and another for everything that is wrong with it."""
    rows = [(one.box.left, one.box.bottom, one.box.right, one.box.top) for one in layout.written]
    things = [_joined(one) for one in layout.written]
    covered = covered_lengths(np.array(rows), strokes_of(layout.marks))
    for row, own, under in zip(rows, things, covered, strict=True):
        box = shapely.box(*row)
        yield "letters"
        if any(box.distance(own) >= box.distance(other) for other in things if other is not own):
            yield "nearer to another thing"
        if under > SEEN:
            yield "over a line"
    for one, other in combinations(layout.written, 2):
        if one.box.overlaps(other.box):
            yield "over another letter"


def _joined(letter: Written) -> shapely.Geometry:
    return shapely.union_all(
        [shapely.LineString(one) if len(one) > 1 else shapely.Point(one) for one in letter.names]
    )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else COUNT)
