"""Where pages of documents end: nothing stands on another page than what it belongs to."""

from collections.abc import Iterator
from typing import Any

import pytest

from support.laid_out import pages_of

COHORT = ("page.css", "cohort.css")
HEIGHT = 265  # mm of a page, about


def texts(tree: Any) -> Iterator[str]:  # noqa: ANN401 - WeasyPrint ships no types
    """Every piece of text below a box."""
    if hasattr(tree, "text"):
        yield tree.text
    for child in getattr(tree, "children", ()):
        yield from texts(child)


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
