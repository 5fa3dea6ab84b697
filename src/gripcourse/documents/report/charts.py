"""Plots of the cohort report, as SVG text that is the same for the same numbers.

Text stays text: WeasyPrint sets it with the fonts of the document, it can be searched and copied.
The bars are grey with dark edges, so that a grey printer loses nothing.
"""

import io
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gripcourse.formula.prose import subscript_runs
from gripcourse.machine.process_wide import without_advice, without_strange_date
from gripcourse.text.words import Words, message

# matplotlib costs 0.4 s to import: only a cohort report pays for it.
# ruff: noqa: PLC0415

_STYLE: Final[dict[Any, Any]] = {
    "svg.fonttype": "none",
    "svg.hashsalt": "gripcourse",
    "font.family": ["PT Sans", "DejaVu Sans"],
    "font.size": 8,
    "text.parse_math": False,  # a course's titles are text, whatever signs they have
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.6,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
}
_FILL, _EDGE, _GRID = "#b9c7d6", "#1d3b5c", "#d5dae0"
_WIDTH = 6.8  # inches; the text column is 173 mm
_BINS = 10
_DASHES = ("-", "--", "-.", ":")
_NUMBER: Final[dict[str, Any]] = {
    "fontsize": 7,
    "ha": "center",
    "va": "center",
    "bbox": {"boxstyle": "circle,pad=0.15", "fc": "white", "ec": _EDGE, "lw": 0.5},
}
_LEGEND = re.compile(r"(?<=>)[^<>]+ — [^<>]+(?=</text>)")  # a line of the legend, in the SVG text
_SMALL, _DOWN = 5.6, 1.6  # size of a subscript and how deep it stands, in pixels
_LETTERS = 46  # of a label; longer titles end with an ellipsis


@dataclass(frozen=True, slots=True)
class ChartLine:
    """A curve of a line plot: its number, its legend, and its ordinates (NaN where it has none)."""

    name: str
    label: str
    values: NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Bar:
    """A bar of the facility plot: a name in the reader's language and two shares of one.

    Attributes:
        label: the name.
        share: the length of the bar.
        dark: how much of it is filled darker.
        count: how many it is the mean of; 0 is not printed.
    """

    label: str
    share: float
    dark: float
    count: int = 0


@dataclass(frozen=True, slots=True)
class ChartBox:
    """A row of the box plot: a name in the reader's language and shares of one, at least one."""

    label: str
    shares: Sequence[float]


def score_plot(shares: Sequence[float], words: Words) -> str:
    """Draw how often which score occurs.

    Args:
        shares: scores as shares of the possible points, 0…1, at least one.
        words: the language of the axes.
    """
    counts = [0] * _BINS
    for share in shares:
        counts[min(max(int(share * _BINS + 1e-9), 0), _BINS - 1)] += 1

    def draw(axes: Any) -> None:  # noqa: ANN401 - matplotlib's axes
        step = 100 / _BINS
        places = [step * (number + 0.5) for number in range(_BINS)]
        axes.bar(places, counts, width=step, color=_FILL, edgecolor=_EDGE, linewidth=0.6)
        axes.set_xlim(0, 100)
        axes.set_xticks([step * number for number in range(_BINS + 1)])
        axes.xaxis.set_major_formatter(_whole(words))
        axes.set_xlabel(words.say(message("score, %")))
        axes.set_ylabel(words.say(message("students")))
        axes.yaxis.get_major_locator().set_params(integer=True)
        axes.yaxis.set_major_formatter(_whole(words))
        axes.yaxis.grid(visible=True, color=_GRID, linewidth=0.5)
        axes.set_axisbelow(True)

    return _svg(draw, height=2.2)


def facility_plot(bars: Sequence[Bar], words: Words) -> str:
    """Draw for each quantity how often it was right, in the order given.

    The dark part of a bar is without what only followed from earlier mistakes, its whole length
    with it.
    """

    def draw(axes: Any) -> None:  # noqa: ANN401 - matplotlib's axes
        places = range(len(bars))
        whole, dark = [100 * bar.share for bar in bars], [100 * bar.dark for bar in bars]
        edge: dict[str, Any] = {"height": 0.66, "edgecolor": _EDGE, "linewidth": 0.5}
        axes.barh(places, whole, color="white", label=words.say(message("carried forward")), **edge)
        axes.barh(places, dark, color=_FILL, label=words.say(message("by the reference")), **edge)
        axes.set_yticks(places, list(map(_counted, bars)))
        axes.tick_params(axis="y", length=0)
        axes.set_ylim(len(bars) - 0.4, -0.6)
        axes.set_xlim(0, 100.5)  # the edge of a full bar shows
        axes.set_xticks(range(0, 101, 20))
        axes.xaxis.set_major_formatter(_whole(words))
        axes.set_xlabel(words.say(message("mean share of the points, %")))
        axes.xaxis.grid(visible=True, color=_GRID, linewidth=0.5)
        axes.set_axisbelow(True)
        place = {"loc": "lower right", "bbox_to_anchor": (1, 1), "borderpad": 0}
        axes.legend(ncols=2, frameon=False, reverse=True, **place)

    return _svg(draw, height=0.95 + 0.165 * len(bars))


def box_plot(boxes: Sequence[ChartBox], words: Words) -> str:
    """Draw how scores are spread in each section: quartiles, median, mean and every extreme."""

    def draw(axes: Any) -> None:  # noqa: ANN401 - matplotlib's axes
        line = {"color": _EDGE, "linewidth": 0.8}
        axes.boxplot(
            [[100 * share for share in box.shares] for box in boxes],
            orientation="horizontal",
            whis=(0, 100),
            widths=0.55,
            patch_artist=True,
            showmeans=True,
            boxprops={"facecolor": _FILL, "edgecolor": _EDGE, "linewidth": 0.6},
            medianprops=line | {"linewidth": 1.8},
            whiskerprops=line,
            capprops=line,
            meanprops={"marker": "D", "markersize": 3.5, "mfc": "white", "mec": _EDGE},
        )
        names = [_short(box.label) for box in boxes]
        axes.set_yticks(range(1, len(boxes) + 1), names)
        axes.tick_params(axis="y", length=0)
        axes.invert_yaxis()
        axes.set_xlim(-1, 101)
        axes.set_xticks(range(0, 101, 20))
        axes.xaxis.set_major_formatter(_whole(words))
        axes.set_xlabel(words.say(message("score, %")))
        axes.xaxis.grid(visible=True, color=_GRID, linewidth=0.5)
        axes.set_axisbelow(True)

    return _svg(draw, height=0.55 + 0.24 * len(boxes))


def share_plot(pairs: Sequence[int], limit: float, words: Words) -> str:
    """Draw how many pairs of variants share which part of the points, and the limit.

    Args:
        pairs: by whole percents of the share, beginning with 0.
        limit: 0 to 1.
        words: the language of the axes.
    """
    last = max((percent for percent, count in enumerate(pairs) if count), default=0)
    shown = max(last + 1, round(100 * limit) + 3)

    def draw(axes: Any) -> None:  # noqa: ANN401 - matplotlib's axes
        places = [percent + 0.5 for percent in range(shown)]
        axes.bar(places, pairs[:shown], width=1, color=_FILL, edgecolor=_EDGE, linewidth=0.6)
        axes.axvline(100 * limit, color=_EDGE, linewidth=1.1, linestyle="--")
        axes.set_yscale("symlog", linthresh=1)
        axes.set_ylim(0, 2 * max(*pairs, 1))
        axes.set_xlim(0, shown)
        axes.xaxis.set_major_formatter(_whole(words))
        axes.yaxis.set_major_formatter(_whole(words))
        axes.set_xlabel(words.say(message("shared points of computed quantities, %")))
        axes.set_ylabel(words.say(message("pairs")))
        axes.yaxis.grid(visible=True, color=_GRID, linewidth=0.5)
        axes.set_axisbelow(True)

    return _svg(draw, height=2.2)


def line_plot(
    along: NDArray[np.float64], lines: Sequence[ChartLine], label: str, ordinate: str, words: Words
) -> str:
    """Draw numbered curves over one abscissa, each with its number at its right end.

    Args:
        along: abscissae.
        lines: the curves.
        label: of the abscissa.
        ordinate: what stands beside the ordinate.
        words: the language of the axes.
    """

    def draw(axes: Any) -> None:  # noqa: ANN401 - matplotlib's axes
        for number, line in enumerate(lines):
            style = _DASHES[number % len(_DASHES)]
            label_text = f"{line.name} — {line.label}"
            axes.plot(
                along, line.values, color=_EDGE, linewidth=0.9, linestyle=style, label=label_text
            )
            drawn = np.flatnonzero(np.isfinite(line.values))
            if len(drawn):
                # Spread along the curve: where two curves meet, their numbers must not.
                place = drawn[int((len(drawn) - 1) * (0.25 + 0.7 * number / len(lines)))]
                axes.annotate(line.name, (along[place], line.values[place]), **_NUMBER)
        axes.set_xlabel(label)
        axes.set_ylabel(ordinate)
        axes.set_xlim(along[0], along[-1])
        axes.set_ylim(bottom=0)
        axes.xaxis.set_major_formatter(_whole(words))
        axes.yaxis.set_major_formatter(_whole(words))
        axes.grid(visible=True, color=_GRID, linewidth=0.5)
        axes.legend(loc="upper left", bbox_to_anchor=(1.02, 1), frameon=False, handlelength=2.6)

    return _LEGEND.sub(lambda found: _lowered(found[0]), _svg(draw, height=3.4))


def _svg(draw: Any, height: float) -> str:  # noqa: ANN401 - a function on matplotlib's axes
    with without_advice("matplotlib"), without_strange_date():
        from matplotlib import rc_context
        from matplotlib.figure import Figure

        with rc_context(_STYLE):
            figure = Figure(figsize=(_WIDTH, height), layout="constrained")
            draw(figure.subplots())
            stream = io.StringIO()
            figure.savefig(stream, format="svg", metadata={"Date": None, "Creator": None})
    return stream.getvalue()


def _lowered(escaped: str) -> str:
    """Let the subscripts of the symbols of a text stand below its line."""
    parts, deep = [], False
    for run, low in subscript_runs(escaped):
        look = f' style="font-size: {_SMALL}px"' if low else ""
        move = (low - deep) * _DOWN
        parts.append(f'<tspan dy="{move:g}"{look}>{run}</tspan>' if low or deep else run)
        deep = low
    return "".join(parts)


def _whole(words: Words) -> Any:  # noqa: ANN401 - matplotlib's formatter
    from matplotlib.ticker import FuncFormatter

    return FuncFormatter(lambda value, _place: words.number(value, 4))


def _counted(bar: Bar) -> str:
    return f"{_short(bar.label)} ({bar.count})" if bar.count else _short(bar.label)


def _short(label: str) -> str:
    """End a long label after a word, or inside one that is longer than a label may be."""
    if len(label) <= _LETTERS:
        return label
    kept = label[:_LETTERS].rpartition(" ")[0] or label[: _LETTERS - 1]
    return f"{kept.rstrip(' ,;:(')}…"
