"""Plots are the same bytes for the same numbers, and their text stays text."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from gripcourse.documents.report.charts import (
    Bar,
    ChartBox,
    ChartLine,
    box_plot,
    facility_plot,
    line_plot,
    score_plot,
)
from gripcourse.text.words import Words

ENGLISH = Words("en")


def texts(svg: str) -> list[str]:
    return re.findall(r"<text[^>]*>([^<]*)</text>", svg)


def test_the_same_numbers_give_the_same_drawing() -> None:
    assert score_plot([0.2, 0.9], ENGLISH) == score_plot([0.2, 0.9], ENGLISH)


def test_a_drawing_says_nothing_about_the_time() -> None:
    assert not re.search(r"<dc:date>|\d{4}-\d\d-\d\d", score_plot([0.5], ENGLISH))


def test_a_date_to_be_written_that_is_none_costs_no_drawing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    drawing = score_plot([0.5], ENGLISH)
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "abc")
    assert score_plot([0.5], ENGLISH) == drawing


def test_a_home_that_may_not_be_written_is_nothing_to_talk_about(tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.touch()
    code = (
        "from gripcourse.documents.report.charts import score_plot;"
        "from gripcourse.text.words import Words; score_plot([0.5], Words('en'))"
    )
    variables = {**os.environ, "HOME": str(home), "XDG_CACHE_HOME": "", "XDG_CONFIG_HOME": ""}
    variables.pop("MPLCONFIGDIR", None)
    drawn = subprocess.run(  # noqa: S603 (our own text)
        [sys.executable, "-c", code], env=variables, capture_output=True, check=True
    )
    assert (drawn.stdout, drawn.stderr) == (b"", b"")


def test_axes_are_named() -> None:
    assert {"score, %", "students"} <= set(texts(score_plot([0.5], ENGLISH)))
    assert "mean share of the points, %" in texts(facility_plot([Bar("bore", 0.5, 0.4)], ENGLISH))


@pytest.mark.parametrize("share", [0.0, 0.3, 0.6, 0.7, 1.0])
def test_a_score_on_a_boundary_is_counted_once(share: float) -> None:
    ticks = [text for text in texts(score_plot([share], ENGLISH)) if text.isdecimal()]
    assert ticks.count("1") == 1  # the axis of students reaches one and no more


def test_students_are_whole() -> None:
    assert not any("." in text for text in texts(score_plot([0.5], ENGLISH)))


def test_a_title_is_text_and_never_a_formula() -> None:
    title = "цена, $x^$ и $y$"
    assert title in texts(facility_plot([Bar(title, 0.5, 0.4)], ENGLISH))
    along = np.array([0.0, 1.0])
    written = texts(line_plot(along, [ChartLine("1", title, along)], title, title, ENGLISH))
    assert written.count(title) == 2
    assert f"1 — {title}" in written


def test_a_long_title_is_cut() -> None:
    (label,) = [
        text for text in texts(facility_plot([Bar("д" * 90, 0.5, 0.4)], ENGLISH)) if "д" in text
    ]
    assert label.endswith("…")
    assert len(label) < 50


def test_a_long_title_ends_after_a_word() -> None:
    title = "diameter of the piston in the first approximation, by strength"
    written = texts(facility_plot([Bar(title, 0.5, 0.4)], ENGLISH))
    assert "diameter of the piston in the first…" in written


def test_both_parts_of_a_facility_bar_are_named_beside_the_plot() -> None:
    written = texts(facility_plot([Bar("bore", 0.9, 0.4)], ENGLISH))
    assert {"by the reference", "carried forward"} <= set(written)


def test_sections_stand_beside_their_boxes() -> None:
    written = texts(
        box_plot([ChartBox("Drive, $x$ and $y$", (0.2, 0.8)), ChartBox("Grip", (1.0,))], ENGLISH)
    )
    assert {"Drive, $x$ and $y$", "Grip", "score, %"} <= set(written)
