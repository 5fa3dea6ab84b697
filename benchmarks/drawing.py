"""What a general view costs: making it, DXF and SVG; as ratios to the same with ezdxf's own SVG."""

from collections.abc import Callable
from statistics import median
from time import perf_counter
from typing import TYPE_CHECKING

from ezdxf.addons.drawing.frontend import Frontend
from ezdxf.addons.drawing.layout import Page
from ezdxf.addons.drawing.properties import RenderContext
from ezdxf.addons.drawing.svg import SVGBackend

from gripcourse.course.load import load_course
from gripcourse.drawing.paper.document import dxf_bytes
from gripcourse.drawing.paper.svg import svg_text
from gripcourse.drawing.paper.title_block import TitleBlock
from gripcourse.drawing.view.general_view import GeneralView, general_view
from gripcourse.machine.resources import course_root
from gripcourse.solver.plan import make_plan
from gripcourse.solver.solve import solve_variant
from gripcourse.text.words import Words
from gripcourse.variants.table import read_table

if TYPE_CHECKING:
    from gripcourse.variants.model import Variant

RUNS = 7


def main() -> None:
    """Draw the first variant of each scheme several times, each way in turn."""
    course = load_course(course_root())
    block = TitleBlock("001 GA", "gripper", "General arrangement", "Student")
    first: dict[str, Variant] = {}
    for variant in read_table(course.root / "variants" / "tables" / "main.csv", course):
        first.setdefault(variant.scheme, variant)
    times: dict[str, list[float]] = {"make": [], "dxf": [], "svg": [], "ezdxf": []}
    sizes: dict[str, list[int]] = {"dxf": [], "svg": [], "ezdxf": []}
    ratios: list[float] = []
    whole: list[float] = []
    whole_ratios: list[float] = []
    for scheme, variant in first.items():
        view = course.schemes[scheme].view
        if view is None:
            continue
        plan = make_plan(course, scheme, variant.options)
        values = solve_variant(plan, variant.given)
        made = general_view(plan, view, values, block, Words("ru"))
        sheet = made.arranged.sheet
        ways: dict[str, Callable[[], object]] = {
            "make": lambda: general_view(plan, view, values, block, Words("ru")),  # noqa: B023 (called in this round)
            "dxf": lambda: dxf_bytes(made.document),  # noqa: B023 (as above)
            "svg": lambda: svg_text(made.document, sheet.width, sheet.height, ""),  # noqa: B023 (as above)
            "ezdxf": lambda: bare_svg(made),  # noqa: B023 (as above)
        }
        rounds = [{name: timed(way) for name, way in ways.items()} for _ in range(RUNS)]
        for name, found in times.items():
            found.append(median(one[name] for one in rounds))
        ratios.append(median(one["svg"] / one["ezdxf"] for one in rounds))
        whole.append(median(student(one, "svg") for one in rounds))
        whole_ratios.append(median(student(one, "svg") / student(one, "ezdxf") for one in rounds))
        sizes["dxf"].append(len(dxf_bytes(made.document)))
        sizes["svg"].append(len(svg_text(made.document, sheet.width, sheet.height, "")))
        sizes["ezdxf"].append(len(bare_svg(made)))
    for name, said in (
        ("make", "making the document"),
        ("dxf", "writing DXF"),
        ("svg", "writing SVG"),
        ("ezdxf", "SVG by ezdxf's own renderer"),
    ):
        print(
            f"{said:30} {median(times[name]) * 1e3:6.1f} ms (slowest {max(times[name]) * 1e3:.1f})"
        )
    print(f"SVG as a ratio to ezdxf's      {median(ratios):6.2f}")
    slowest = max(whole) * 1e3
    print(f"per student, DXF and SVG       {median(whole) * 1e3:6.1f} ms (slowest {slowest:.1f})")
    print(f"ratio to the same with ezdxf's {median(whole_ratios):6.2f}")
    both = [dxf + svg for dxf, svg in zip(sizes["dxf"], sizes["svg"], strict=True)]
    print(f"bytes per student, DXF and SVG {median(both):,.0f} (most {max(both):,})")
    print("kB: " + ", ".join(f"{name} {median(one) / 1e3:.0f}" for name, one in sizes.items()))


def student(times: dict[str, float], svg: str) -> float:
    """Return what a student's drawing takes in one round with a way of writing SVG, s."""
    return times["make"] + times["dxf"] + times[svg]


def bare_svg(made: GeneralView) -> str:
    """Draw the same document with ezdxf's own renderer."""
    document = made.document
    backend = SVGBackend()
    Frontend(RenderContext(document), backend).draw_layout(document.modelspace())
    sheet = made.arranged.sheet
    return backend.get_string(Page(sheet.width, sheet.height))


def timed(call: Callable[[], object]) -> float:
    """Return how long a call takes, s."""
    start = perf_counter()
    call()
    return perf_counter() - start


if __name__ == "__main__":
    main()
