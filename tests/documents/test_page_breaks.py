"""Where pages and cells end: nothing stands on another page than what it belongs to."""

from typing import Any

import pytest

from support.laid_out import cells, pages_of, text_edges, texts

COHORT = ("page.css", "cohort.css")
CERTIFICATE = ("page.css", "certificate.css")
HEIGHT = 265  # mm of a page, about
APART = 3.0  # mm between texts that are not one


def page_texts(html: str, styles: tuple[str, ...]) -> list[str]:
    """The text of each page."""
    return [" ".join(texts(page)) for page in pages_of(html, styles)]


def flagged(above: int) -> str:
    """A table of what was noticed of students, so far down on its page."""
    rows = "".join(
        f'<tr><td>name-{n} <br><span class="note">file-{n}</span></td><td>seen-{n}</td></tr>'
        for n in range(6)
    )
    table = f'<table class="flagged"><thead><tr><th>a</th><th>b</th></tr></thead>{rows}</table>'
    return f'<div style="height: {above}mm"></div>{table}'


@pytest.mark.parametrize("above", range(HEIGHT - 45, HEIGHT - 20, 2))
def test_a_student_stands_beside_what_was_noticed(above: int) -> None:
    first, *_ = page_texts(flagged(above), COHORT)
    told = [n for n in range(6) if f"seen-{n}" in first]
    assert told == [n for n in range(6) if f"name-{n}" in first]
    assert told == [n for n in range(6) if f"file-{n}" in first]


@pytest.mark.parametrize("above", range(HEIGHT - 65, HEIGHT - 20, 4))
def test_what_a_table_is_about_stands_above_it(above: int) -> None:
    rows = "<tbody>" + "<tr><td>row</td></tr>" * 8 + "</tbody>"
    table = f"<table><thead><tr><th>column</th></tr></thead>{rows}</table>"
    about = '<h2>heading</h2><p class="note">about the table</p>'
    first, *_ = page_texts(f'<div style="height: {above}mm"></div>{about}{table}', CERTIFICATE)
    assert ("heading" in first) == ("about the table" in first) == ("row" in first)


def test_a_table_of_one_row_does_not_wait_for_the_table_after_it() -> None:
    one, two = (
        f"<h2>{name}</h2><table><thead><tr><th>a</th></tr></thead><tbody>{rows}</tbody></table>"
        for name, rows in (("one", "<tr><td>x</td></tr>"), ("two", "<tr><td>y</td></tr>" * 8))
    )
    first, second = page_texts(f'<div style="height: 230mm"></div>{one}{two}', COHORT)
    assert "one" in first
    assert "two" in second


@pytest.mark.parametrize("above", [x / 4 for x in range(4 * HEIGHT - 80, 4 * HEIGHT - 50)])
def test_what_was_noticed_at_length_goes_on_over_a_page_and_begins_beside_its_student(
    above: float,
) -> None:
    said = "<br>".join(f"seen-{n}" for n in range(40))
    name = 'name <br><span class="note">file</span>'
    row = f'<tr class="long"><td>{name}</td><td>{said}</td></tr>'
    table = f'<table class="flagged"><thead><tr><th>a</th><th>b</th></tr></thead>{row}</table>'
    first, *_ = page_texts(f'<div style="height: {above}mm"></div>{table}', COHORT)
    assert ("seen-0" in first) == ("name" in first) == ("file" in first)
    assert "seen-39" not in first


def test_what_a_variant_is_stands_apart_from_the_next_label() -> None:
    row = "<tr><th>label</th><td>" + "value " * 30 + "</td><th>next</th><td>value</td></tr>"
    columns = '<colgroup><col class="label"><col><col class="label"><col></colgroup>'
    (page,) = pages_of(f'<table class="facts">{columns}{row}</table>', ("page.css",))
    value, beside = next(cells(page, "td")), list(cells(page, "th"))[1]
    (_, end), (begin, _) = edges_of(value), edges_of(beside)
    assert begin - end >= APART


def edges_of(cell: Any) -> tuple[float, float]:  # noqa: ANN401 - WeasyPrint ships no types
    """Where the text of a cell begins and ends, mm."""
    found = text_edges(cell)
    assert found is not None
    return found
