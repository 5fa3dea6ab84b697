"""Numbers of a column stand with their decimal marks one below the other."""

from dataclasses import dataclass

from gripcourse.documents.report.columns import aligned, aligned_cells, aligned_rows


@dataclass(frozen=True, slots=True)
class Row:
    """A line of a table: a name, points, and shares of two sections."""

    name: str
    points: str
    shares: tuple[str, str]


def test_all_numbers_of_a_column_have_as_many_decimals_as_the_longest() -> None:
    assert aligned(["20", "9,5", "0,25"]) == ["20,00", "9,50", "0,25"]
    assert aligned(["100%", "37.5%"]) == ["100.0%", "37.5%"]


def test_whole_numbers_stay_whole() -> None:
    assert aligned(["2 / 2", "12 / 15"]) == ["2 / 2", "12 / 15"]


def test_what_is_no_number_stays_as_it_is() -> None:
    assert aligned(["—", "", "1,5", "2"]) == ["—", "", "1,5", "2,0"]


def test_each_number_of_a_text_is_aligned_with_those_in_its_place() -> None:
    assert aligned(["0 / 1,56", "10 / 20"]) == ["0 / 1,56", "10 / 20,00"]
    assert aligned(["−7 ± 10,5", "+1,92 ± 3"]) == ["−7,00 ± 10,5", "+1,92 ± 3,0"]


def test_both_ends_of_a_range_have_as_many_decimals() -> None:
    assert aligned(["66,7 … 100", "100 … 100"]) == ["66,7 … 100,0", "100,0 … 100,0"]


def test_rows_are_aligned_by_their_fields() -> None:
    rows = [Row("a", "1", ("1,5", "2")), Row("b", "2,25", ("10", "3"))]
    first, second = aligned_rows(rows, "points", "shares")
    assert first == Row("a", "1,00", ("1,5", "2"))
    assert second == Row("b", "2,25", ("10,0", "3"))
    assert aligned_rows([], "points") == []


def test_the_first_cell_of_a_line_is_its_name() -> None:
    assert aligned_cells([("2 jaws", "1"), ("3 jaws", "1,5")]) == [
        ("2 jaws", "1,0"),
        ("3 jaws", "1,5"),
    ]
    assert aligned_cells([]) == []
