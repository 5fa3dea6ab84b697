"""A table that fits is laid out as the library does it that also breaks lines."""

import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gripcourse.cli.table_layout import broken_table, plain_table, table_text
from gripcourse.text.shown import shown

CELLS = st.one_of(
    st.sampled_from(
        ["", "Сидоренко", "日本", "e\u0301", "a  b", " a", "b ", "q\tz", "1\n2", "a\u00a0b"]
    ),
    st.text(max_size=9),
)


@given(
    st.integers(1, 4).flatmap(
        lambda columns: st.lists(
            st.lists(CELLS, min_size=columns, max_size=columns), min_size=1, max_size=4
        )
    ),
    st.sets(st.integers(0, 3)),
)
def test_what_fits_stands_as_if_lines_could_break(lines: list[list[str]], right: set[int]) -> None:
    heads, *rows = [[shown(cell) for cell in line] for line in lines]
    plain = plain_table(heads, rows, right)
    broken = broken_table(heads, rows, right, {})
    assert plain in {None, broken}
    assert table_text(heads, rows, right) == broken


def test_what_does_not_fit_is_left_to_the_library() -> None:
    heads, row = ["file", "flags"], ["u1.xlsx", "wrong signature, " * 9 + "blank"]
    assert plain_table(heads, [row], set()) is None
    assert plain_table(heads, [["u1.xlsx", "two\nlines"]], set()) is None
    assert plain_table(heads, [["u1.xlsx", "blank"]], set()) is not None
    assert table_text(heads, [row], set()).count("\n") == 4


@pytest.mark.parametrize(("columns", "widest"), [(80, 80), (20, 60), (200, 110)])
def test_a_terminal_shows_no_line_that_is_wider_than_it_and_all_of_a_name(
    columns: int, widest: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    monkeypatch.setenv("COLUMNS", str(columns))
    name = "Константинопольский-" * 6 + "Черноризский"
    lines = table_text(["file", "student"], [["s01.xlsx", name]], ()).split("\n")
    assert max(map(len, lines)) <= widest
    *_, shown_name = "".join("".join(lines[3:]).split()).partition("s01.xlsx")
    assert shown_name == name
