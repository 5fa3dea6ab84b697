"""The last page of a report holds more than the tail of a table."""

import pytest

from gripcourse.documents.pdf import pdf_from_html
from gripcourse.documents.report.student import STYLES
from gripcourse.machine.resources import course_root
from support.printed import pages_of

ROWS = 14


@pytest.mark.parametrize("before", [20, 24, 28])
def test_a_few_rows_of_the_last_section_do_not_stand_alone(before: int) -> None:
    page = "".join(_section(name, rows) for name, rows in (("A", before), ("B", 30)))
    html = f'<html lang="en"><title>Rows</title><body><div>{page}</div></body></html>'
    *_, last = pages_of(pdf_from_html(html, STYLES, course_root() / "templates"))
    assert last.count("row") >= ROWS


def test_a_short_last_section_goes_to_the_last_page_as_a_whole() -> None:
    page = _section("A", 45) + _section("B", 10)
    html = f'<html lang="en"><title>Rows</title><body><div>{page}</div></body></html>'
    *_, last = pages_of(pdf_from_html(html, STYLES, course_root() / "templates"))
    assert last.count("row B") in {0, 10}
    assert ("Section B" in last) == ("row B" in last)


def _section(name: str, rows: int) -> str:
    cells = "".join(f"<tr><td>row {name} {number}</td></tr>" for number in range(rows))
    head = '<thead><tr><th scope="col">Quantity</th></tr></thead>'
    return f'<h2>Section {name}</h2><table class="answers">{head}<tbody>{cells}</tbody></table>'
