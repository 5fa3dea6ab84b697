"""How long a kinematic diagram takes: laid out, as a document, as SVG and as DXF."""

from collections.abc import Callable
from time import perf_counter
from typing import TYPE_CHECKING

from gripcourse.course.load import load_course
from gripcourse.drawing.diagram.kinematic_diagram import kinematic_diagram
from gripcourse.drawing.diagram.layout import lay_out
from gripcourse.machine.resources import course_root
from gripcourse.solver.plan import make_plan
from gripcourse.variants.table import read_table

if TYPE_CHECKING:
    from gripcourse.variants.model import Variant

RUNS = 3
LANGUAGE = "ru"


def main() -> None:
    """Draw the first issued variant of every scheme."""
    course = load_course(course_root())
    first: dict[str, Variant] = {}
    for variant in read_table(course.root / "variants" / "tables" / "main.csv", course):
        first.setdefault(variant.scheme, variant)
    totals = [0.0] * 4
    for scheme, variant in sorted(first.items()):
        plan = make_plan(course, scheme, variant.options)
        diagram = kinematic_diagram(plan, variant.given, LANGUAGE)
        if diagram is None:
            continue

        def placed() -> object:
            return lay_out(plan, variant.given, LANGUAGE)  # noqa: B023 (called in this turn)

        def document() -> object:
            return kinematic_diagram(plan, variant.given, LANGUAGE)  # noqa: B023 (as above)

        times = [_best(one) for one in (placed, document, diagram.svg, diagram.dxf)]
        totals = [total + one for total, one in zip(totals, times, strict=True)]
        print(f"{scheme:<20} {_row(times)}")
    print(f"{'mean':<20} {_row([total / len(first) for total in totals])}")


def _row(seconds: list[float]) -> str:
    names = ("laid out", "document", "SVG", "DXF")
    return ", ".join(
        f"{name} {one * 1e3:6.1f} ms" for name, one in zip(names, seconds, strict=True)
    )


def _best(work: Callable[[], object]) -> float:
    times = []
    for _ in range(RUNS):
        start = perf_counter()
        work()
        times.append(perf_counter() - start)
    return min(times)


if __name__ == "__main__":
    main()
